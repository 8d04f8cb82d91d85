//! A form's reflectance at one point with its derivatives by every parameter.

use super::layout::{Fixed, Layout};
use super::wave::{Local, MOST_POLYNOMIALS, Wave};
use core::f64::consts::PI;
use pavo_spectra::Point;

/// A point of the fit: what does not change with the parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub cos_theta1: f64,
    /// `D`, um.
    pub path_um: f64,
    /// The reflectance that the form should have.
    pub reflectance: [f64; 3],
}

impl Sample {
    pub fn new(point: Point, fixed: Fixed, reflectance: [f64; 3]) -> Self {
        let Fixed { ambient_ior, film_ior, .. } = fixed;
        let q2_squared = (film_ior - ambient_ior) * (film_ior + ambient_ior) + (ambient_ior * point.cos_theta1).powi(2);
        Self { cos_theta1: point.cos_theta1, path_um: point.thickness_nm / 1000.0 * q2_squared.sqrt(), reflectance }
    }
}

/// The value of a polynomial and its derivative.
fn polynomial(coefficients: impl DoubleEndedIterator<Item = f64>, y: f64) -> (f64, f64) {
    coefficients.rev().fold((0.0, 0.0), |(value, slope), coefficient| (value * y + coefficient, slope * y + value))
}

/// Whether the polynomial that must stay within -1 and 1 does so at every angle, and the others make sense.
pub(super) fn is_admissible(layout: &Layout, parameters: &[f64]) -> bool {
    let offset = parameters[Layout::ANGLE_OFFSET];
    if parameters.iter().any(|parameter| !parameter.is_finite()) || !(0.05..=4.0).contains(&offset) {
        return false;
    }
    if let Some(at) = layout.damping
        && !((1.0..=20.0).contains(&parameters[at.exponent])
            && (0.0..=20.0).contains(&parameters[at.slope])
            && (0.0..=20.0).contains(&parameters[at.log_taper]))
    {
        return false;
    }
    let Some(bounded) = layout.plan.bounded() else { return true };
    let coefficients = &parameters[layout.polynomials[bounded].clone()];
    (0..=64).all(|step| {
        let y = 1.0 / (f64::from(step) / 64.0 + offset);
        polynomial(coefficients.iter().copied(), y).0.abs() < 0.9999
    })
}

/// The reflectance at a sample. `derivative(channel, parameter, value)` takes its derivatives that are not 0.
pub(super) fn evaluate(
    layout: &Layout,
    parameters: &[f64],
    sample: &Sample,
    mut derivative: Option<&mut dyn FnMut(usize, usize, f64)>,
) -> [f64; 3] {
    let y = 1.0 / (sample.cos_theta1 + parameters[Layout::ANGLE_OFFSET]);
    let mut local = Local {
        form: layout.plan.form,
        polynomials: [0.0; MOST_POLYNOMIALS],
        log_window: -(parameters[Layout::WINDOW] * sample.path_um).powi(2),
        exponent: layout.damping.map_or(0.0, |at| parameters[at.exponent]),
        log_loss: layout.damping.map_or(0.0, |at| -parameters[at.slope] * sample.path_um),
        log_taper: layout.damping.map_or(0.0, |at| parameters[at.log_taper]),
    };
    let mut slopes = [0.0; MOST_POLYNOMIALS];
    for (index, range) in layout.polynomials.iter().enumerate() {
        (local.polynomials[index], slopes[index]) = polynomial(parameters[range.clone()].iter().copied(), y);
    }
    let stride = if layout.plan.mean_per_channel { 3 } else { 1 };
    let mean_of = |channel: usize| {
        let coefficients = &parameters[layout.mean.clone()];
        let own = coefficients.chunks_exact(stride).map(move |chunk| chunk[channel.min(stride - 1)]);
        polynomial(own, y)
    };
    let nodes = layout.plan.nodes;
    let radians = |node: usize| {
        let phase = if layout.plan.has_phases() { parameters[layout.phases.start + node] } else { 0.0 };
        4.0 * PI * parameters[layout.wave_numbers.start + node] * sample.path_um + phase
    };
    let mut waves = [Wave::default(); super::MAX_NODES];
    for (node, wave) in waves.iter_mut().enumerate().take(nodes) {
        *wave = local.wave(radians(node));
    }
    let waves = &waves[..nodes];
    core::array::from_fn(|channel| {
        let (mean, mean_slope) = mean_of(channel);
        let weights: [f64; super::MAX_NODES] =
            core::array::from_fn(|node| if node < nodes { layout.weight(parameters, node, channel) } else { 0.0 });
        let total = |part: &dyn Fn(&Wave) -> f64| {
            -waves.iter().zip(&weights).map(|(wave, weight)| weight * part(wave)).sum::<f64>()
        };
        let value = mean + total(&|wave| wave.value);
        let Some(derivative) = derivative.as_deref_mut() else { return value };
        let mut by_y = mean_slope;
        let mut power = 1.0;
        for place in layout.mean.clone().step_by(stride) {
            derivative(channel, place + if stride == 3 { channel } else { 0 }, power);
            power *= y;
        }
        for (index, range) in layout.polynomials.iter().enumerate() {
            let mut by_coefficient = total(&|wave| wave.by_polynomial[index]);
            by_y += by_coefficient * slopes[index];
            for place in range.clone() {
                derivative(channel, place, by_coefficient);
                by_coefficient *= y;
            }
        }
        derivative(channel, Layout::ANGLE_OFFSET, -y * y * by_y);
        let by_log_window = total(&|wave| wave.by_log_window);
        derivative(
            channel,
            Layout::WINDOW,
            -2.0 * parameters[Layout::WINDOW] * sample.path_um * sample.path_um * by_log_window,
        );
        if let Some(at) = layout.damping {
            derivative(channel, at.exponent, total(&|wave| wave.by_exponent));
            derivative(channel, at.slope, -sample.path_um * total(&|wave| wave.by_log_loss));
            derivative(channel, at.log_taper, total(&|wave| wave.by_log_taper));
        }
        for (node, wave) in waves.iter().enumerate() {
            let by_phase = -weights[node] * wave.by_phase;
            derivative(channel, layout.wave_numbers.start + node, by_phase * 4.0 * PI * sample.path_um);
            if layout.plan.has_phases() {
                derivative(channel, layout.phases.start + node, by_phase);
            }
            derivative(channel, layout.weights.start + 3 * node + channel, -wave.value);
        }
        value
    })
}

#[cfg(test)]
mod tests {
    use super::super::plan::{Form, Plan};
    use super::super::random::Random;
    use super::super::start::start;
    use super::*;
    use crate::media::Media;
    use num_complex::Complex64;
    use pavo_optics::fitted::fitted_reflectance;

    const FIXED: Fixed = Fixed { ambient_ior: 1.0, film_ior: 1.5, thickness_nm: [0.0, 3000.0] };

    fn cases() -> Vec<(Layout, Vec<f64>)> {
        let media = Media { ambient: 1.0, film: 1.5, base: Complex64::new(2.7, 0.4) };
        let mut random = Random::new(5);
        let mut case = |form, coloured| {
            let layout = Layout::new(Plan::new(form, 4, coloured));
            let mut parameters = start(&layout, media, &mut random);
            // Nothing is left at 0, where a wrong derivative may go unseen.
            parameters[layout.mean.start] += 0.1;
            for parameter in &mut parameters {
                *parameter += 0.01 * random.within(0.5, 1.0);
            }
            (layout, parameters)
        };
        Form::ALL.into_iter().flat_map(|form| [case(form, false), case(form, true)]).collect()
    }

    fn samples() -> Vec<(Point, Sample)> {
        [(1.0, 0.0), (0.7, 120.0), (0.31, 480.0), (0.05, 900.0), (0.9, 2600.0)]
            .map(|(cos, thickness)| Point::new(cos, thickness))
            .map(|point| (point, Sample::new(point, FIXED, [0.0; 3])))
            .to_vec()
    }

    #[test]
    fn derivatives_are_those_of_the_values() {
        for (layout, parameters) in cases() {
            for (_, sample) in samples() {
                let mut exact = vec![[0.0; 3]; layout.count];
                let mut take = |channel: usize, place: usize, value: f64| exact[place][channel] = value;
                evaluate(&layout, &parameters, &sample, Some(&mut take));
                for (place, exact) in exact.iter().enumerate() {
                    let at = |step: f64| {
                        let mut moved = parameters.clone();
                        moved[place] += step;
                        evaluate(&layout, &moved, &sample, None)
                    };
                    let (low, high) = (at(-1e-5), at(1e-5));
                    for channel in 0..3 {
                        let difference = (high[channel] - low[channel]) / 2e-5;
                        let allowed = 1e-6 * (1.0 + difference.abs());
                        let form = layout.plan.form;
                        assert!(
                            (difference - exact[channel]).abs() < allowed,
                            "{form:?}, parameter {place}, {sample:?}: {} against {difference}",
                            exact[channel]
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn the_fitted_model_is_the_description() {
        for (layout, parameters) in cases() {
            let film = layout.film(&parameters, FIXED);
            for (point, sample) in samples() {
                let fitted = evaluate(&layout, &parameters, &sample, None);
                let described = fitted_reflectance::<f64>(&film, point.cos_theta1, point.thickness_nm).to_array();
                for (fitted, described) in fitted.into_iter().zip(described) {
                    assert!((fitted - described).abs() < 1e-11, "{:?}: {fitted} {described}", layout.plan.form);
                }
            }
        }
    }
}
