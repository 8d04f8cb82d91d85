//! The families' terms as functions of the optical path difference D.

use std::f64::consts::PI;

use nalgebra::DMatrix;
use num_complex::Complex64;

use crate::separable::Basis;

/// Wave numbers stay within this range, in 1/um: past the visible ones (1.2 to 2.8) no term has anything to fit.
const WAVE_NUMBERS: (f64, f64) = (1.1, 2.9);

/// Range of the decay a of a Gaussian, in 1/um^2: from next to constant over 12 um to half a period wide.
const GAUSSIAN_DECAYS: (f64, f64) = (1e-4, 20.0);

/// Range of what the decay gamma of a pole has above its floor, in 1/um.
const POLE_DECAYS: (f64, f64) = (1e-5, 8.0);

/// Least decay gamma of a pole, in 1/um: beyond the fitted range every term still dies away.
pub(super) const POLE_DECAY_FLOOR: f64 = 0.02;

/// What the parameters of a basis mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// exp(-a D^2) exp(2 pi i nu D), real weights; every nu, then every log(a).
    Gaussians,
    /// exp((2 pi i nu - gamma) D), complex weights; every nu, then every log(gamma - floor).
    Poles,
    /// exp(2 pi i nu_k D), real weights, nu_k equispaced: the mean nu and the spacing.
    Nodes,
    /// The same times exp(-(D / Dc)^2): and then log(Dc).
    WindowedNodes,
}

/// The terms of a family at sampled D. Rows: the real parts at every D, then the imaginary ones.
#[derive(Debug)]
pub(super) struct TransformBasis {
    pub(super) form: Form,
    pub(super) count: usize,
    /// D in micrometres.
    pub(super) opds_um: Vec<f64>,
}

impl TransformBasis {
    /// nu of term k in 1/um.
    pub(super) fn wave_number(&self, parameters: &[f64], k: usize) -> f64 {
        match self.form {
            Form::Gaussians | Form::Poles => parameters[k].clamp(WAVE_NUMBERS.0, WAVE_NUMBERS.1),
            Form::Nodes | Form::WindowedNodes => equispaced(parameters[0], parameters[1], self.count, k),
        }
    }

    /// a or gamma of term k; 0 for nodes.
    pub(super) fn decay(&self, parameters: &[f64], k: usize) -> f64 {
        let clamped = |(low, high): (f64, f64)| parameters[self.count + k].exp().clamp(low, high);
        match self.form {
            Form::Gaussians => clamped(GAUSSIAN_DECAYS),
            Form::Poles => POLE_DECAY_FLOOR + clamped(POLE_DECAYS),
            Form::Nodes | Form::WindowedNodes => 0.0,
        }
    }

    fn term(&self, parameters: &[f64], k: usize, opd_um: f64) -> Complex64 {
        let decay = self.decay(parameters, k);
        let exponent = match self.form {
            Form::Gaussians => decay * opd_um * opd_um,
            Form::Poles => decay * opd_um,
            Form::Nodes => 0.0,
            Form::WindowedNodes => (opd_um / parameters[2].exp()).powi(2),
        };
        Complex64::from_polar((-exponent).exp(), 2.0 * PI * self.wave_number(parameters, k) * opd_um)
    }

    /// The derivative of the logarithm of term k by a parameter, or `None` where it does not depend on it.
    fn log_slope(&self, parameters: &[f64], parameter: usize, k: usize, opd_um: f64) -> Option<Complex64> {
        let turn = Complex64::new(0.0, 2.0 * PI * opd_um);
        let count = self.count;
        match (self.form, parameter) {
            (Form::Gaussians | Form::Poles, p) if p < count => (p == k).then_some(turn),
            (Form::Gaussians, p) => (p == k + count).then(|| (-self.decay(parameters, k) * opd_um * opd_um).into()),
            (Form::Poles, p) => {
                (p == k + count).then(|| (-(self.decay(parameters, k) - POLE_DECAY_FLOOR) * opd_um).into())
            }
            (_, 0) => Some(turn),
            (_, 1) => Some(turn * (k as f64 - (count - 1) as f64 / 2.0)),
            _ => Some((2.0 * (opd_um / parameters[2].exp()).powi(2)).into()),
        }
    }
}

/// The wave number of node k of `count` equispaced ones about `mean`.
pub(super) fn equispaced(mean: f64, spacing: f64, count: usize, k: usize) -> f64 {
    mean + spacing * (k as f64 - (count - 1) as f64 / 2.0)
}

impl Basis for TransformBasis {
    fn count(&self) -> usize {
        self.count
    }

    fn has_complex_weights(&self) -> bool {
        self.form == Form::Poles
    }

    fn columns(&self, parameters: &[f64]) -> DMatrix<f64> {
        let samples = self.opds_um.len();
        let groups = if self.has_complex_weights() { 2 } else { 1 };
        let mut columns = DMatrix::zeros(2 * samples, groups * self.count);
        for k in 0..self.count {
            for (row, &opd_um) in self.opds_um.iter().enumerate() {
                let term = self.term(parameters, k, opd_um);
                columns[(row, k)] = term.re;
                columns[(samples + row, k)] = term.im;
                if groups == 2 {
                    columns[(row, self.count + k)] = -term.im;
                    columns[(samples + row, self.count + k)] = term.re;
                }
            }
        }
        columns
    }

    fn slopes(&self, parameters: &[f64], weights: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        let samples = self.opds_um.len();
        let mut slopes = vec![DMatrix::zeros(2 * samples, weights.ncols()); parameters.len()];
        for k in 0..self.count {
            for (row, &opd_um) in self.opds_um.iter().enumerate() {
                let term = self.term(parameters, k, opd_um);
                for (parameter, slope) in slopes.iter_mut().enumerate() {
                    let Some(log_slope) = self.log_slope(parameters, parameter, k, opd_um) else { continue };
                    for channel in 0..weights.ncols() {
                        let imaginary =
                            if self.has_complex_weights() { weights[(self.count + k, channel)] } else { 0.0 };
                        let value = Complex64::new(weights[(k, channel)], imaginary) * term * log_slope;
                        slope[(row, channel)] += value.re;
                        slope[(samples + row, channel)] += value.im;
                    }
                }
            }
        }
        slopes
    }
}
