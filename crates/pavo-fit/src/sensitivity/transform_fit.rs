//! Fits of the transforms themselves, for the least maximum error.
//!
//! Several starts are fitted by least squares; the best few are then driven to a small maximum error by Lawson's
//! reweighting (Lawson 1961; Rice and Usow 1968, "The Lawson algorithm and extensions"): after every solution each D's
//! weight is multiplied by its error, so that the largest errors count for more in the next. What is kept is the iterate of
//! least maximum error.

use nalgebra::{DMatrix, DVector};
use pavo_spectra::fits::SpectralTransform;

use super::random::SplitMix64;
use super::transform_basis::{Form, TransformBasis};
use crate::separable::Separable;

/// Starts that get past plain least squares.
const FINALISTS: usize = 3;

/// Rounds of reweighting.
const REWEIGHTINGS: usize = 40;

/// Evaluations per parameter for a first fit, and for each round of reweighting.
const PATIENCE: (usize, usize) = (12, 3);

/// Fits whose weights sum, in absolute value, to more than this are not kept: they would cost a float32 shader digits.
const LARGEST_WEIGHT_SUM: f64 = 12.0;

/// The tail ends at this multiple of the range.
const TAIL: f64 = 4.0;

/// What a square in the tail counts for beside one within the range: for poles, which can die away, and for nodes, which
/// can only put off their return.
const TAIL_IMPORTANCE: (f64, f64) = (1e-3, 1e-4);

/// Where a tail ends at the latest, in micrometres: the transforms of smooth spectra have died away by then.
const LONGEST_TAIL_UM: f64 = 12.0;

/// The exact transform, sampled for a fit: some channels of it.
#[derive(Debug)]
pub(super) struct Samples {
    pub(super) opds_um: Vec<f64>,
    /// How many of them are within the range; those beyond it are the tail.
    in_range: usize,
    tail_importance: f64,
    /// Rows as those of [`TransformBasis`], a column per channel.
    pub(super) values: DMatrix<f64>,
}

impl Samples {
    /// Samples all three channels at equispaced D from 0 up to a range. Free of its carrier the transform turns at most
    /// 0.8 times per micrometre (wave numbers from 1.2 to 2.8 1/um about 2), so that a step of 0.1 um follows it.
    ///
    /// For poles and nodes, whose reflectance has every order in it, a tail goes on from there to [`TAIL`] times the
    /// range, or to [`LONGEST_TAIL_UM`] if that is less: orders above the first reach past the range, so that a fit has
    /// to be roughly right there too.
    pub(super) fn new(form: Form, exact: &SpectralTransform, max_opd_um: f64) -> Self {
        let tail_importance = match form {
            Form::Poles => TAIL_IMPORTANCE.0,
            Form::Nodes => TAIL_IMPORTANCE.1,
            Form::Gaussians | Form::WindowedNodes => 0.0,
        };
        let in_range = ((max_opd_um / 0.1).ceil() as usize).max(60);
        let mut opds_um: Vec<f64> = (1..=in_range).map(|index| max_opd_um * index as f64 / in_range as f64).collect();
        let end_um = if tail_importance > 0.0 { LONGEST_TAIL_UM.min(TAIL * max_opd_um) } else { max_opd_um };
        let tail = ((end_um - max_opd_um) / 0.1).ceil().max(0.0) as usize;
        opds_um.extend((1..=tail).map(|index| max_opd_um + (end_um - max_opd_um) * index as f64 / tail as f64));
        let count = opds_um.len();
        let mut values = DMatrix::zeros(2 * count, 3);
        for (row, &opd_um) in opds_um.iter().enumerate() {
            for (channel, value) in exact.at(opd_um).into_iter().enumerate() {
                values[(row, channel)] = value.re;
                values[(count + row, channel)] = value.im;
            }
        }
        Self { opds_um, in_range, tail_importance, values }
    }

    /// Factors of the rows' squares: those given within the range, and the tail's.
    fn scales(&self, importance: &[f64]) -> DVector<f64> {
        let count = self.opds_um.len();
        let of_opd = |index: usize| importance.get(index).copied().unwrap_or(self.tail_importance);
        DVector::from_fn(2 * count, |row, _| of_opd(row % count).sqrt())
    }

    /// One channel of these.
    pub(super) fn channel(&self, channel: usize) -> Self {
        Self { opds_um: self.opds_um.clone(), values: self.values.columns(channel, 1).into_owned(), ..*self }
    }
}

/// A solved fit.
#[derive(Debug, Clone)]
pub(super) struct Solution {
    pub(super) parameters: Vec<f64>,
    pub(super) weights: DMatrix<f64>,
    /// Largest error over the samples.
    pub(super) max_error: f64,
}

/// The fit of least maximum error that the starts lead to, or `None` where none has bounded weights.
pub(super) fn fit_transform(form: Form, count: usize, samples: &Samples, seed: u64) -> Option<Solution> {
    let basis = TransformBasis { form, count, opds_um: samples.opds_um.clone() };
    let first = first_fits(&basis, samples, seed);
    let mut best: Option<Solution> = None;
    for parameters in first.into_iter().take(FINALISTS) {
        if let Some(solution) = reweight(&basis, samples, parameters)
            && best.as_ref().is_none_or(|best| solution.max_error < best.max_error)
        {
            best = Some(solution);
        }
    }
    best
}

/// Parameters of the least-squares fits that the starts lead to, the best first.
pub(super) fn first_fits(basis: &TransformBasis, samples: &Samples, seed: u64) -> Vec<DVector<f64>> {
    let ones = samples.scales(&vec![1.0; samples.in_range]);
    let mut fits: Vec<(f64, DVector<f64>)> = starts(basis, samples, seed)
        .into_iter()
        .map(|start| {
            let fit = Separable::new(basis, &samples.values, &ones, start).minimise(PATIENCE.0);
            (fit.sum_of_squares(), fit.parameters().clone())
        })
        .filter(|(sum, _)| sum.is_finite())
        .collect();
    fits.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Starts that met in one fit count once.
    fits.dedup_by(|a, b| (a.0 / b.0 - 1.0).abs() < 1e-4);
    fits.into_iter().map(|(_, parameters)| parameters).collect()
}

fn reweight(basis: &TransformBasis, samples: &Samples, start: DVector<f64>) -> Option<Solution> {
    let (count, in_range) = (samples.opds_um.len(), samples.in_range);
    let mut importance = vec![1.0f64; in_range];
    let mut parameters = start;
    let mut best: Option<Solution> = None;
    for _ in 0..REWEIGHTINGS {
        let scales = samples.scales(&importance);
        let fit = Separable::new(basis, &samples.values, &scales, parameters.clone()).minimise(PATIENCE.1);
        parameters = fit.parameters().clone();
        let residuals = fit.unscaled_residuals();
        let errors: Vec<f64> = (0..in_range)
            .map(|row| {
                let of_channel = |channel| residuals[(row, channel)].hypot(residuals[(count + row, channel)]);
                (0..residuals.ncols()).map(of_channel).fold(0.0, f64::max)
            })
            .collect();
        let max_error = errors.iter().copied().fold(0.0, f64::max);
        if !max_error.is_finite() {
            break;
        }
        if best.as_ref().is_none_or(|best| max_error < best.max_error) && weights_are_bounded(basis, fit.weights()) {
            best = Some(Solution {
                parameters: parameters.as_slice().to_vec(),
                weights: fit.weights().clone(),
                max_error,
            });
        }
        // A floor keeps a D whose error happened to be 0 in play.
        let mut sum = 0.0;
        for (importance, error) in importance.iter_mut().zip(&errors) {
            *importance *= (error / max_error).max(1e-3);
            sum += *importance;
        }
        for importance in &mut importance {
            *importance = (*importance * in_range as f64 / sum).max(1e-6);
        }
    }
    best
}

pub(super) fn weights_are_bounded(basis: &TransformBasis, weights: &DMatrix<f64>) -> bool {
    (0..weights.ncols()).all(|channel| {
        let size = |k: usize| {
            let imaginary = if weights.nrows() > basis.count { weights[(basis.count + k, channel)] } else { 0.0 };
            weights[(k, channel)].hypot(imaginary)
        };
        (0..basis.count).map(size).sum::<f64>() <= LARGEST_WEIGHT_SUM
    })
}

fn starts(basis: &TransformBasis, samples: &Samples, seed: u64) -> Vec<DVector<f64>> {
    let mut random = SplitMix64::new(seed ^ ((basis.form as u64) << 32) ^ basis.count as u64);
    let count = basis.count;
    let single = samples.values.ncols() == 1;
    let tries = if single { 24 } else { 14 };
    match basis.form {
        Form::Gaussians | Form::Poles => (0..tries)
            .map(|_| {
                // The sensitivities of RGB have their weight from 1.6 (red) to 2.3 1/um (blue).
                let mut wave_numbers: Vec<f64> = (0..count)
                    .map(|k| {
                        if single {
                            random.between(1.6, 2.3)
                        } else {
                            1.55 + 0.8 * (k as f64 + random.uniform()) / count as f64
                        }
                    })
                    .collect();
                wave_numbers.sort_by(f64::total_cmp);
                let decays: Vec<f64> = (0..count)
                    .map(|_| match basis.form {
                        Form::Poles => random.between(0.3f64.ln(), 1.0f64.ln()),
                        _ => random.between(0.05f64.ln(), 0.4f64.ln()),
                    })
                    .collect();
                DVector::from_iterator(2 * count, wave_numbers.into_iter().chain(decays))
            })
            .collect(),
        Form::Nodes | Form::WindowedNodes => equispaced_starts(basis, samples),
    }
}

/// A coarse scan of mean, spacing and window: the best few by least squares.
fn equispaced_starts(basis: &TransformBasis, samples: &Samples) -> Vec<DVector<f64>> {
    let ones = DVector::from_element(samples.values.nrows(), 1.0);
    let windows: &[f64] = if basis.form == Form::WindowedNodes { &[2.4, 2.9, 3.5, 4.2] } else { &[0.0] };
    let mut scanned = Vec::new();
    for mean in [1.88, 1.94, 2.0] {
        for span in [0.5, 0.58, 0.66, 0.74, 0.82, 0.92, 1.05] {
            for &window in windows {
                let mut start = vec![mean, span / (basis.count - 1).max(1) as f64];
                if window > 0.0 {
                    start.push(f64::ln(window));
                }
                let start = DVector::from_vec(start);
                let sum = Separable::new(basis, &samples.values, &ones, start.clone()).sum_of_squares();
                scanned.push((sum, start));
            }
        }
    }
    scanned.sort_by(|a, b| a.0.total_cmp(&b.0));
    scanned.into_iter().take(6).map(|(_, start)| start).collect()
}
