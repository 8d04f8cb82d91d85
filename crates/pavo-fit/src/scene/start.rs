//! Where a fit begins: polynomials from the Fresnel formulas, waves over the visible range, shifted at random.

use super::layout::Layout;
use super::plan::Form;
use super::random::Random;
use crate::media::Media;
use crate::points::LEAST_COS;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use pavo_optics::series::SeriesTerms;

/// The wave numbers between which the waves are spread, 1/um: 633 to 424 nm. The best fits have theirs there.
const SPREAD_WAVE_NUMBERS: [f64; 2] = [1.58, 2.36];

/// What a round trip loses with D at the start, 1/um: a little, so that it may fall.
const SLOPE: f64 = 0.05;

/// How close the amplitude of a round trip may come to 1 at the start.
const LARGEST_ROUND_TRIP: f64 = 0.97;

/// Parameters to begin with.
pub(super) fn start(layout: &Layout, media: Media, random: &mut Random) -> Vec<f64> {
    let plan = &layout.plan;
    let mut parameters = vec![0.0; layout.count];
    let offset = random.within(0.3, 0.9);
    parameters[Layout::ANGLE_OFFSET] = offset;
    let [low, high] = SPREAD_WAVE_NUMBERS;
    let spacing = (high - low) / plan.nodes.max(1) as f64;
    for node in 0..plan.nodes {
        let centre = low + spacing * (node as f64 + 0.5);
        parameters[layout.wave_numbers.start + node] = centre + spacing * random.within(-0.25, 0.25);
    }
    // Each wave stands for a band of about the spacing's width: the window is that band's transform.
    parameters[Layout::WINDOW] = 2.0 * spacing * random.within(1.6, 2.8);
    if let Some(at) = layout.damping {
        parameters[at.exponent] = random.within(2.5, 4.0);
        parameters[at.slope] = SLOPE;
        parameters[at.log_taper] = random.within(5.0, 14.0);
    }
    for weight in &mut parameters[layout.weights.clone()] {
        *weight = 1.0 / plan.nodes as f64;
    }
    for (index, range) in layout.polynomials.iter().enumerate() {
        let limit = if plan.bounded() == Some(index) { LARGEST_ROUND_TRIP } else { f64::INFINITY };
        let target = |cos: f64| target(plan.form, index, media.series(cos)).clamp(-limit, limit);
        let mut coefficients = interpolate(&target, range.len(), offset);
        if limit.is_finite() {
            keep_within(&mut coefficients, limit, offset);
        }
        parameters[range.clone()].copy_from_slice(&coefficients);
    }
    parameters
}

/// The value that a polynomial should have at an angle, by its place among those of the form.
fn target(form: Form, index: usize, polarisations: [SeriesTerms<f64>; 2]) -> f64 {
    let mean = |part: &dyn Fn(SeriesTerms<f64>) -> f64| polarisations.map(part).iter().sum::<f64>() / 2.0;
    let transmittance = mean(&|polarisation| polarisation.transmittance);
    let round_trip =
        mean(&|polarisation| polarisation.transmittance * polarisation.round_trip) / transmittance.max(1e-9);
    match (form, index) {
        (Form::FirstOrder, _) | (Form::DampedKernel | Form::CorrectedKernel, 0) => 2.0 * transmittance * round_trip,
        (Form::Kernel, 0) => transmittance,
        (Form::Kernel, _) => 2.0 * round_trip / (1.0 + round_trip * round_trip),
        (Form::DampedKernel | Form::CorrectedKernel, 1) => round_trip,
        (Form::ThreeOrders, _) => {
            let order = index as i32 % 3 + 1;
            let power = |polarisation: SeriesTerms<f64>| {
                Complex64::new(polarisation.round_trip, polarisation.round_trip_im).powi(order)
            };
            let part = |polarisation: SeriesTerms<f64>| {
                if index < 3 { power(polarisation).re } else { -power(polarisation).im }
            };
            2.0 * mean(&|polarisation| polarisation.transmittance * part(polarisation))
        }
        _ => 0.0,
    }
}

/// The polynomial in `y` with so many coefficients that is closest to a function of the cosine.
fn interpolate(target: &dyn Fn(f64) -> f64, count: usize, offset: f64) -> Vec<f64> {
    let cosines: Vec<f64> =
        (0..60).map(|step| LEAST_COS + (1.0 - LEAST_COS) * (f64::from(step) + 0.5) / 60.0).collect();
    let powers =
        DMatrix::from_fn(cosines.len(), count, |row, degree| (cosines[row] + offset).recip().powi(degree as i32));
    let values = DVector::from_iterator(cosines.len(), cosines.iter().map(|&cos| target(cos)));
    match powers.svd(true, true).solve(&values, 1e-12) {
        Ok(coefficients) => coefficients.as_slice().to_vec(),
        Err(_) => vec![0.0; count],
    }
}

/// Scales a polynomial so that it stays within `-limit` and `limit` at every angle.
fn keep_within(coefficients: &mut [f64], limit: f64, offset: f64) {
    let value = |step: i32| {
        let y = 1.0 / (f64::from(step) / 64.0 + offset);
        coefficients.iter().rev().fold(0.0, |value, coefficient| value * y + coefficient).abs()
    };
    let largest = (0..=64).map(value).fold(0.0, f64::max);
    if largest > limit {
        coefficients.iter_mut().for_each(|coefficient| *coefficient *= limit / largest);
    }
}
