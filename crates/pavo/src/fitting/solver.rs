//! Fits by `pavo-fit`, looked up in the cache first.

use super::{FitCache, GroupsRequest, SceneRequest, SensitivityRequest};
use crate::methods::MethodError;
use crate::variant::FittedForm;
use pavo_fit::baked::{closest, rational};
use pavo_fit::groups;
use pavo_fit::scene::{Form, SceneFitRequest, fit_scene};
use pavo_fit::sensitivity::{BUILT_IN_SEED, FitRequest, built_in_range_um, fit};
use pavo_optics::fitted::FittedFilm;
use pavo_optics::{BakedFilm, Method};
use pavo_spectra::fits::SensitivityFit;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// What the random numbers of the starts begin with: the same scene gives the same fit.
const SEED: u64 = 1;

/// Part of each key: to be changed with what the solver gives for the same request.
const SOLVER: u32 = 1;

/// A fit of sensitivities, for the range of optical path differences that built-in fits have too.
pub(crate) fn sensitivity_fit(
    request: &SensitivityRequest<'_>,
    cache: &dyn FitCache,
) -> Result<SensitivityFit, MethodError> {
    let sensitivities = request.sensitivities;
    let request = FitRequest {
        family: request.family,
        count: request.count,
        observer: sensitivities.observer(),
        illuminant: sensitivities.illuminant().clone(),
        space: sensitivities.space(),
        max_opd_um: built_in_range_um(request.family, request.max_opd_um),
        seed: BUILT_IN_SEED,
    };
    let key = format!("sensitivities {SOLVER} {request:?}");
    cached(cache, &key, || fit(&request).map_err(|error| (error.to_string(), "spectral:n=81 needs no fit".to_owned())))
}

/// What is kept under a key, or else made and kept.
fn cached<T: Serialize + DeserializeOwned>(
    cache: &dyn FitCache,
    key: &str,
    make: impl FnOnce() -> Result<T, MethodError>,
) -> Result<T, MethodError> {
    // That there is no fit is kept too: it takes as long to find out.
    if let Some(kept) = cache.load(key).and_then(|kept| serde_json::from_str(&kept).ok()) {
        return kept;
    }
    let made = make();
    if let Ok(text) = serde_json::to_string(&made) {
        cache.store(key, &text);
    }
    made
}

/// Wave numbers in groups, fitted to a scene.
pub(crate) fn groups_fit(request: &GroupsRequest<'_>, cache: &dyn FitCache) -> Result<Method, MethodError> {
    let request = groups::GroupsRequest {
        ambient_ior: request.media.ambient_ior(),
        film: request.media.film().clone(),
        base: request.media.base().clone(),
        thickness_nm: request.thickness_nm,
        sensitivities: request.sensitivities,
        nodes: request.count,
        groups: request.groups,
    };
    let key = format!("groups {SOLVER} {request:?}");
    let (window, groups) = cached(cache, &key, || {
        let help = "take spectral:n=81, or leave out groups";
        let fit = groups::fit_groups(&request).map_err(|error| (error.to_string(), help.to_owned()))?;
        Ok((fit.window, fit.groups))
    })?;
    Ok(Method::WindowedGroups { window, groups })
}

/// A quotient of polynomials over the angle through samples of the reflectance, or where it would have a pole the best of
/// as many coefficients that has none.
pub(crate) fn rational_fit(
    samples: &[(f64, [f64; 3])],
    degree: usize,
    denominator: usize,
) -> Result<BakedFilm, MethodError> {
    let film = rational(samples, degree, denominator).or_else(|_| closest(samples, degree + denominator + 1));
    film.map_err(|error| (error.to_string(), "take a polynomial: leave out denominator".to_owned()))
}

/// A fit of a scene's reflectance.
pub(crate) fn scene_fit(request: &SceneRequest<'_>, cache: &dyn FitCache) -> Result<FittedFilm, MethodError> {
    let request = SceneFitRequest {
        ambient_ior: request.media.ambient_ior(),
        film: request.media.film().clone(),
        base: request.media.base().clone(),
        thickness_nm: request.thickness_nm,
        sensitivities: request.sensitivities,
        form: request.form.map(form),
        nodes: request.count,
        seed: SEED,
        rms_error: Some(request.rms_error),
        max_error: None,
    };
    let key = format!("scene {SOLVER} {request:?}");
    cached(cache, &key, || {
        let help = "allow more error by rms=.., take more waves, or a method for the run time such as windowed:k=6";
        fit_scene(&request).map(|fit| fit.film).map_err(|error| (error.to_string(), help.to_owned()))
    })
}

/// The solver's name of a form.
pub(crate) fn form(form: FittedForm) -> Form {
    match form {
        FittedForm::AngleOnly => Form::AngleOnly,
        FittedForm::FirstOrder => Form::FirstOrder,
        FittedForm::Kernel => Form::Kernel,
        FittedForm::DampedKernel => Form::DampedKernel,
        FittedForm::CorrectedKernel => Form::CorrectedKernel,
        FittedForm::ThreeOrders => Form::ThreeOrders,
    }
}
