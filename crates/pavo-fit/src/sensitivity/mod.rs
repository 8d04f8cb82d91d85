//! Fits of spectral sensitivities: short sums in place of the sensitivities' Fourier transforms.
//!
//! The families, and what a fit consists of, are described in [`pavo_spectra::fits`], which also holds the fits that are
//! built in; [`built_in_files`] makes those again. [`fit`] makes one for any observer, illuminant and colour space.
//!
//! - Poles, Gaussians and nodes are fitted to the transform for the least maximum error up to the range asked for
//!   (variable projection, Levenberg-Marquardt, several starts, Lawson's reweighting). Poles and nodes are also held near
//!   it, less firmly, for a way beyond, since the higher orders of interference reach there.
//! - Windowed nodes start from such a fit by least squares, and are then fitted to the exact reflectance of
//!   [`film_classes`].
//!
//! A fit depends on its request alone, seed included.

mod classes;
mod files;
mod film_samples;
mod random;
mod reflectance_fit;
mod transform_basis;
mod transform_fit;

#[cfg(test)]
mod tests;

use pavo_spectra::fits::text::DECIMALS;
use pavo_spectra::fits::{FitFamily, FitTerm, SensitivityFit, SpectralTransform, combine_channels};
use pavo_spectra::sensitivity::SensitivityError;
use pavo_spectra::{ColourSpace, Illuminant, Observer, Sensitivities};

use self::reflectance_fit::{fit_windowed, training_samples};
use self::transform_basis::{Form, TransformBasis};
use self::transform_fit::{Samples, Solution, fit_transform};

pub use self::classes::{FilmClass, film_classes};
pub use self::files::{BUILT_IN_SEED, built_in_file, built_in_files, built_in_range_um, built_in_requests};
pub use self::film_samples::{FilmSamples, ReflectanceErrors};
pub use crate::media::Media;

/// Range of `max_opd_um`: below it nothing interferes, beyond it the sensitivities' transforms have long died away.
pub const OPD_RANGE_UM: std::ops::RangeInclusive<f64> = 0.5..=40.0;

/// What is to be fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct FitRequest {
    /// The form of the fit.
    pub family: FitFamily,
    /// Number of terms, within [`FitFamily::counts`]; per channel for the families that do not share them.
    pub count: usize,
    /// The observer.
    pub observer: Observer,
    /// The illuminant.
    pub illuminant: Illuminant,
    /// The colour space whose channels are fitted.
    pub space: ColourSpace,
    /// Largest optical path difference that is fitted, in micrometres, within [`OPD_RANGE_UM`].
    pub max_opd_um: f64,
    /// Seed of the starts.
    pub seed: u64,
}

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A number of terms that the family does not have.
    #[error("a fit of the family {family} has {least} to {most} terms; {count} were asked for")]
    Count {
        /// Name of the family.
        family: &'static str,
        /// Least number of terms.
        least: usize,
        /// Largest number of terms.
        most: usize,
        /// The number asked for.
        count: usize,
    },
    /// A range of the optical path difference that cannot be fitted.
    #[error("the largest optical path difference is {max_opd_um} um; it should be from {least} to {most} um")]
    Range {
        /// The range asked for, in micrometres.
        max_opd_um: f64,
        /// Least range.
        least: f64,
        /// Largest range.
        most: f64,
    },
    /// The illuminant has no white.
    #[error(transparent)]
    Sensitivities(#[from] SensitivityError),
    /// No start led to a fit with bounded weights.
    #[error(
        "no fit of the family {family} with {count} term(s) has bounded weights up to {max_opd_um} um; \
         fewer terms or a larger range may have one"
    )]
    NoneFound {
        /// Name of the family.
        family: &'static str,
        /// The number of terms.
        count: usize,
        /// The range in micrometres.
        max_opd_um: f64,
    },
}

/// Makes a fit.
///
/// # Errors
/// A count or a range out of bounds, an illuminant without a white, or no fit with bounded weights.
pub fn fit(request: &FitRequest) -> Result<SensitivityFit, FitError> {
    let &FitRequest { family, count, observer, ref illuminant, space, max_opd_um, seed } = request;
    let counts = family.counts();
    let (least, most) = (*counts.start(), *counts.end());
    if !counts.contains(&count) {
        return Err(FitError::Count { family: family.name(), least, most, count });
    }
    if !OPD_RANGE_UM.contains(&max_opd_um) {
        let (least, most) = (*OPD_RANGE_UM.start(), *OPD_RANGE_UM.end());
        return Err(FitError::Range { max_opd_um, least, most });
    }
    let fitted_space = if family == FitFamily::XyzGaussians { ColourSpace::Xyz } else { space };
    let sensitivities = Sensitivities::new(observer, illuminant.clone(), fitted_space)?;
    let exact = SpectralTransform::new(&sensitivities);
    let form = form_of(family);
    let samples = Samples::new(form, &exact, max_opd_um);
    let none = FitError::NoneFound { family: family.name(), count, max_opd_um };
    let solved = match family {
        FitFamily::WindowedNodes => {
            let reflectance = training_samples(&sensitivities, max_opd_um, seed);
            fit_windowed(count, &samples, &reflectance, seed).map(|solution| vec![solution])
        }
        FitFamily::RgbGaussians | FitFamily::XyzGaussians => {
            (0..3).map(|channel| fit_transform(form, count, &samples.channel(channel), seed)).collect()
        }
        _ => fit_transform(form, count, &samples, seed).map(|solution| vec![solution]),
    };
    let mut fit = assemble(family, count, max_opd_um, &solved.ok_or(none)?);
    fit.measure(&exact);
    if fitted_space != space {
        fit = combine_channels(&fit, fitted_space, space)?;
        fit.measure(&SpectralTransform::new(&Sensitivities::new(observer, illuminant.clone(), space)?));
    }
    Ok(fit)
}

fn form_of(family: FitFamily) -> Form {
    match family {
        FitFamily::SharedGaussians | FitFamily::RgbGaussians | FitFamily::XyzGaussians => Form::Gaussians,
        FitFamily::Poles => Form::Poles,
        FitFamily::WindowedNodes => Form::WindowedNodes,
        FitFamily::Nodes => Form::Nodes,
    }
}

/// The terms of one solution for all channels, or of one for each, by ascending wave number, rounded as they are stored.
fn assemble(family: FitFamily, count: usize, max_opd_um: f64, solutions: &[Solution]) -> SensitivityFit {
    let basis = TransformBasis { form: form_of(family), count, opds_um: Vec::new() };
    let orders: Vec<Vec<usize>> = solutions
        .iter()
        .map(|solution| {
            let mut order: Vec<usize> = (0..count).collect();
            let wave_number = |k: usize| basis.wave_number(&solution.parameters, k);
            order.sort_by(|&a, &b| wave_number(a).total_cmp(&wave_number(b)));
            order
        })
        .collect();
    let term = |k: usize| {
        // The solution, its term and the column of its weights, for a channel.
        let place = |channel: usize| {
            let index = channel.min(solutions.len() - 1);
            (&solutions[index], orders[index][k], if solutions.len() == 1 { channel } else { 0 })
        };
        let of_each = |value: &dyn Fn(&Solution, usize, usize) -> f64| -> [f64; 3] {
            std::array::from_fn(|channel| {
                let (solution, k, column) = place(channel);
                rounded(value(solution, k, column))
            })
        };
        FitTerm {
            wave_number: of_each(&|solution, k, _| basis.wave_number(&solution.parameters, k)),
            decay: of_each(&|solution, k, _| basis.decay(&solution.parameters, k)),
            weight_re: of_each(&|solution, k, column| solution.weights[(k, column)]),
            weight_im: of_each(&|solution, k, column| {
                if family.has_complex_weights() { solution.weights[(count + k, column)] } else { 0.0 }
            }),
        }
    };
    let window_um = (family == FitFamily::WindowedNodes).then(|| rounded(solutions[0].parameters[2].exp()));
    let terms = (0..count).map(term).collect();
    let mut fit = SensitivityFit { family, terms, window_um, max_opd_um, max_error: 0.0, rms_error: 0.0 };
    fit.close_weights();
    fit
}

fn rounded(number: f64) -> f64 {
    let scale = 10f64.powi(DECIMALS as i32);
    (number * scale).round() / scale
}
