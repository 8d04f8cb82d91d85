//! Where each parameter of a form stands in the vector that is fitted, and the film that a vector stands for.
//!
//! Lengths are in micrometres here, so that all parameters are of the order of 1.

use super::plan::{Form, Plan};
use core::ops::Range;
use pavo_optics::fitted::{AnglePolynomial, FittedFilm, FittedForm, FittedMean, FittedNode};

/// The indices that are fixed, and the range of thickness in nm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fixed {
    pub ambient_ior: f64,
    pub film_ior: f64,
    pub thickness_nm: [f64; 2],
}

/// The places of the parameters.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub plan: Plan,
    /// Coefficients of the mean: by degree, within it by channel.
    pub mean: Range<usize>,
    /// Coefficients of the other polynomials.
    pub polynomials: Vec<Range<usize>>,
    pub wave_numbers: Range<usize>,
    pub phases: Range<usize>,
    /// By wave, within it by channel.
    pub weights: Range<usize>,
    /// The damping of a round trip, where it has its own.
    pub damping: Option<Damping>,
    pub count: usize,
}

/// The places of what damps a round trip.
#[derive(Clone, Copy, Debug)]
pub(super) struct Damping {
    /// The window's exponent.
    pub exponent: usize,
    /// The loss with D, 1/um.
    pub slope: usize,
    /// The logarithm of the taper.
    pub log_taper: usize,
}

impl Layout {
    /// The place of `a` in `y = 1 / (cos + a)`.
    pub const ANGLE_OFFSET: usize = 0;
    /// The place of the root of the window's decay, 1/um.
    pub const WINDOW: usize = 1;

    pub fn new(plan: Plan) -> Self {
        let mut count = 2;
        let mut take = |length: usize| {
            let range = count..count + length;
            count += length;
            range
        };
        let damping = plan.has_damping().then(|| {
            let places = take(3).start;
            Damping { exponent: places, slope: places + 1, log_taper: places + 2 }
        });
        let mean = take((plan.mean_degree + 1) * if plan.mean_per_channel { 3 } else { 1 });
        let polynomials = plan.degrees.iter().map(|degree| take(degree + 1)).collect();
        let wave_numbers = take(plan.nodes);
        let phases = take(if plan.has_phases() { plan.nodes } else { 0 });
        let weights = take(3 * plan.nodes);
        Self { plan, mean, polynomials, wave_numbers, phases, weights, damping, count }
    }

    /// The weight of a wave in a channel.
    pub fn weight(&self, parameters: &[f64], node: usize, channel: usize) -> f64 {
        parameters[self.weights.start + 3 * node + channel]
    }

    /// The film that the parameters stand for.
    pub fn film(&self, parameters: &[f64], fixed: Fixed) -> FittedFilm {
        let mean = &parameters[self.mean.clone()];
        let mut polynomials = self.polynomials.iter().map(|range| parameters[range.clone()].to_vec());
        let mut next = || -> AnglePolynomial { polynomials.next().unwrap_or_default() };
        let form = match self.plan.form {
            Form::AngleOnly => FittedForm::AngleOnly,
            Form::FirstOrder => FittedForm::FirstOrder { contrast: next() },
            Form::Kernel => FittedForm::Kernel { contrast: next(), sharpness: next() },
            Form::DampedKernel | Form::CorrectedKernel => {
                let of_damping = |place: fn(Damping) -> usize| self.damping.map_or(0.0, |at| parameters[place(at)]);
                FittedForm::DampedKernel {
                    contrast: next(),
                    round_trip: next(),
                    exponent: of_damping(|at| at.exponent),
                    damping_slope: of_damping(|at| at.slope) / 1000.0,
                    log_taper: of_damping(|at| at.log_taper),
                    first_order: (self.plan.form == Form::CorrectedKernel).then(next),
                }
            }
            Form::ThreeOrders => {
                FittedForm::ThreeOrders { cosines: [next(), next(), next()], sines: [next(), next(), next()] }
            }
        };
        let node = |index: usize| FittedNode {
            wave_number: parameters[self.wave_numbers.start + index] / 1000.0,
            phase: if self.plan.has_phases() { parameters[self.phases.start + index] } else { 0.0 },
            weight: core::array::from_fn(|channel| self.weight(parameters, index, channel)),
        };
        FittedFilm {
            ambient_ior: fixed.ambient_ior,
            film_ior: fixed.film_ior,
            thickness_nm: fixed.thickness_nm,
            angle_offset: parameters[Self::ANGLE_OFFSET],
            window_decay: parameters[Self::WINDOW].powi(2) / 1e6,
            mean: if self.plan.mean_per_channel {
                FittedMean::PerChannel(mean.chunks_exact(3).map(|chunk| [chunk[0], chunk[1], chunk[2]]).collect())
            } else {
                FittedMean::Shared(mean.to_vec())
            },
            form,
            nodes: (0..self.plan.nodes).map(node).collect(),
        }
    }
}
