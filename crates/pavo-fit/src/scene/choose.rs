//! The fit of a scene: its points, the choice of a form, and the error on points held out.

use super::error::SceneFitError;
use super::layout::{Fixed, Layout};
use super::model::Sample;
use super::plan::{Form, Plan};
use super::request::{SceneFit, SceneFitRequest};
use super::solve::solve;
use crate::media::Media;
use crate::points::spread;
use num_complex::Complex64;
use pavo_optics::fitted::{FittedFilm, fitted_reflectance};
use pavo_spectra::{OpticalConstants, Point, Reference, Stack};

/// Where an index that depends on the wavelength is read for the path in the film and for the starts, nm: the middle of the
/// eye's sensitivity.
const MIDDLE_NM: f64 = 555.0;

/// Points within the ranges, points along each edge, and the shift: of the fit, and of the judgement.
const FITTED: (usize, usize, f64) = (1600, 30, 0.137);
const HELD_OUT: (usize, usize, f64) = (2048, 33, 0.611);

/// Fits the reflectance of a scene, and measures the error in `f32` on points that the fit has not seen: over
/// `cos(theta1)` from 0.01 to 1 and the range of thickness, with the edges.
///
/// # Errors
/// A request that makes no sense, a film that would reflect totally, or a fit that misses the errors asked for.
pub fn fit_scene(request: &SceneFitRequest<'_>) -> Result<SceneFit, SceneFitError> {
    request.check()?;
    let stack = Stack::new(request.ambient_ior, request.film.clone(), request.base.clone())?;
    let (film_ior, _) = request.film.extended_at(MIDDLE_NM);
    let (ior, kappa) = request.base.extended_at(MIDDLE_NM);
    let ambient_ior = request.ambient_ior;
    if film_ior <= ambient_ior {
        return Err(SceneFitError::FilmIndex { ambient_ior, film_ior, wavelength_nm: MIDDLE_NM });
    }
    let fixed = Fixed { ambient_ior, film_ior, thickness_nm: request.thickness_nm };
    let media = Media { ambient: ambient_ior, film: film_ior, base: Complex64::new(ior, kappa) };

    let reference = Reference::new(request.sensitivities);
    let prepared = reference.prepare(&stack);
    let points = |(inner, edge, shift)| spread(request.thickness_nm, inner, edge, shift);
    let fitted = points(FITTED);
    let values = prepared.reflectance_of_each(&fitted);
    let samples: Vec<Sample> =
        fitted.iter().zip(values).map(|(&point, value)| Sample::new(point, fixed, value)).collect();
    let held_out = points(HELD_OUT);
    let expected = prepared.reflectance_of_each(&held_out);

    let mut best: Option<SceneFit> = None;
    for plan in plans(request) {
        let layout = Layout::new(plan);
        let solution = solve(&layout, media, &samples, request.seed, request.rms_error);
        let film = layout.film(&solution.parameters, fixed);
        let (rms, max) = error(&film, &held_out, &expected);
        let (form, cost) = (layout.plan.form, layout.plan.cost());
        let fit = SceneFit { film, form, cost, rms, max, points: held_out.len() };
        let asks = request.rms_error.is_some() || request.max_error.is_some();
        if asks && request.is_met_by(&fit) {
            return Ok(fit);
        }
        if best.as_ref().is_none_or(|best| fit.rms < best.rms) {
            best = Some(fit);
        }
    }
    let best = best.expect("there is at least one plan");
    if request.is_met_by(&best) {
        return Ok(best);
    }
    Err(SceneFitError::Missed { best: Box::new(best), rms_error: request.rms_error, max_error: request.max_error })
}

/// What is tried, the cheapest first.
fn plans(request: &SceneFitRequest<'_>) -> Vec<Plan> {
    let coloured = request.film.as_constant().is_none() || request.base.as_constant().is_none();
    if let Some(form) = request.form {
        return vec![Plan::new(form, request.nodes, coloured)];
    }
    let [thinnest, thickest] = request.thickness_nm;
    if thinnest == thickest {
        return vec![Plan::new(Form::AngleOnly, 0, coloured)];
    }
    let forms: &[(Form, usize)] = if absorbs(&request.base) || absorbs(&request.film) {
        &[(Form::ThreeOrders, 3), (Form::ThreeOrders, 4), (Form::ThreeOrders, 5), (Form::ThreeOrders, 6)]
    } else {
        &[
            (Form::FirstOrder, 3),
            (Form::Kernel, 3),
            (Form::Kernel, 4),
            (Form::DampedKernel, 4),
            (Form::DampedKernel, 5),
            (Form::CorrectedKernel, 5),
            (Form::CorrectedKernel, 6),
            (Form::DampedKernel, 6),
        ]
    };
    let mut plans: Vec<Plan> =
        forms.iter().map(|&(form, nodes)| Plan::new(form, nodes.min(request.nodes), coloured)).collect();
    plans.sort_by_key(Plan::cost);
    plans.dedup();
    plans
}

/// Whether a medium absorbs anywhere in the visible range.
fn absorbs(constants: &OpticalConstants) -> bool {
    (0..=94).any(|step| constants.extended_at(360.0 + 5.0 * f64::from(step)).1 > 0.0)
}

/// The root of the mean square and the largest of the errors of a film in `f32`; infinite where it is not finite.
fn error(film: &FittedFilm, points: &[Point], expected: &[[f64; 3]]) -> (f64, f64) {
    let (mut squares, mut largest) = (0.0, 0.0_f64);
    for (point, expected) in points.iter().zip(expected) {
        let found = fitted_reflectance::<f32>(film, point.cos_theta1 as f32, point.thickness_nm as f32).to_array();
        for (found, expected) in found.into_iter().zip(expected) {
            let difference = (f64::from(found) - expected).abs();
            let difference = if difference.is_nan() { f64::INFINITY } else { difference };
            squares += difference * difference;
            largest = largest.max(difference);
        }
    }
    ((squares / (3 * points.len()) as f64).sqrt(), largest)
}
