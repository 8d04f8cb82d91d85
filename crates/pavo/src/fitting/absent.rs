//! Without the feature `fit` there is no solver.

use super::{FitCache, GroupsRequest, SceneRequest, SensitivityRequest};
use crate::methods::MethodError;
use pavo_optics::fitted::FittedFilm;
use pavo_optics::{BakedFilm, Method};
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

pub(crate) fn groups_fit(_: &GroupsRequest<'_>, _: &dyn FitCache) -> Result<Method, MethodError> {
    Err(("a fit of groups needs a solver".to_owned(), HELP.to_owned()))
}

pub(crate) fn rational_fit(_: &[(f64, [f64; 3])], _: usize, _: usize) -> Result<BakedFilm, MethodError> {
    Err(("a quotient of polynomials needs a solver".to_owned(), HELP.to_owned()))
}

pub(crate) fn scene_fit(_: &SceneRequest<'_>, _: &dyn FitCache) -> Result<FittedFilm, MethodError> {
    Err(("a fit to the scene needs a solver".to_owned(), HELP.to_owned()))
}
