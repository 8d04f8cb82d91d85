//! Without the feature `fit` there is no solver.

use super::{FitCache, SceneRequest, SensitivityRequest};
use crate::methods::MethodError;
use pavo_optics::fitted::FittedFilm;
use pavo_spectra::fits::SensitivityFit;

const HELP: &str = "build pavo with its feature `fit`, or take a method that is built in, such as spectral:n=81";

pub(crate) fn sensitivity_fit(
    request: &SensitivityRequest<'_>,
    _: &dyn FitCache,
) -> Result<SensitivityFit, MethodError> {
    let sensitivities = request.sensitivities;
    let cause = format!(
        "there is no built-in fit of {} {} for the observer {}, the illuminant {} and the space {}",
        request.count,
        request.family.name(),
        sensitivities.observer().name(),
        sensitivities.illuminant().name(),
        sensitivities.space().name()
    );
    Err((cause, HELP.to_owned()))
}

pub(crate) fn scene_fit(_: &SceneRequest<'_>, _: &dyn FitCache) -> Result<FittedFilm, MethodError> {
    Err(("a fit to the scene needs a solver".to_owned(), HELP.to_owned()))
}
