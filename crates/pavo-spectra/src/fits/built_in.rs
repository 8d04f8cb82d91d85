//! The fits that are compiled in.

use std::sync::LazyLock;

use super::text::{read, stored_space};
use super::{FitFamily, SensitivityFit, SpectralTransform, combine_channels};
use crate::illuminant::Illuminant;
use crate::observer::Observer;
use crate::sensitivity::Sensitivities;

/// An observer and an illuminant that fits are built in for.
#[derive(Debug, Clone, PartialEq)]
pub struct BuiltInSpectrum {
    /// The observer.
    pub observer: Observer,
    /// The illuminant.
    pub illuminant: Illuminant,
    /// The data's file under `data/fits`.
    pub file: &'static str,
    text: &'static str,
}

macro_rules! built_in_spectrum {
    ($observer:ident, $illuminant:ident, $file:literal) => {
        BuiltInSpectrum {
            observer: Observer::$observer,
            illuminant: Illuminant::$illuminant,
            file: $file,
            text: include_str!(concat!("../../data/fits/", $file)),
        }
    };
}

/// What fits are built in for.
pub const BUILT_IN_SPECTRA: [BuiltInSpectrum; 5] = [
    built_in_spectrum!(Cie1931TwoDegree, D65, "cie1931-2deg-d65.csv"),
    built_in_spectrum!(Cie1931TwoDegree, E, "cie1931-2deg-e.csv"),
    built_in_spectrum!(Cie1931TwoDegree, D50, "cie1931-2deg-d50.csv"),
    built_in_spectrum!(Cie1931TwoDegree, A, "cie1931-2deg-a.csv"),
    built_in_spectrum!(Cie1964TenDegree, D65, "cie1964-10deg-d65.csv"),
];

impl BuiltInSpectrum {
    /// The fits as they are stored: channels of [`stored_space`].
    pub fn stored_fits(&self) -> Vec<SensitivityFit> {
        read(self.text).expect("the data is compiled in, and the tests read it")
    }
}

/// The built-in fit of a family with `count` terms (per channel for the families that do not share them) that is right up
/// to the optical path difference `max_opd_um`: of those that reach so far the one of the smallest range, and the one of
/// the largest where none does. Its channels are those of the sensitivities' colour space.
///
/// `None` where the data has no such fit: another observer or illuminant, a count outside [`FitFamily::counts`], RGB
/// Gaussians in a space other than linear sRGB.
pub fn built_in(
    family: FitFamily,
    count: usize,
    sensitivities: &Sensitivities,
    max_opd_um: f64,
) -> Option<SensitivityFit> {
    static STORED: LazyLock<Vec<Vec<SensitivityFit>>> =
        LazyLock::new(|| BUILT_IN_SPECTRA.iter().map(BuiltInSpectrum::stored_fits).collect());
    let spectrum = BUILT_IN_SPECTRA.iter().position(|spectrum| {
        spectrum.observer == sensitivities.observer() && spectrum.illuminant == *sensitivities.illuminant()
    })?;
    let candidates = || STORED[spectrum].iter().filter(|fit| fit.family == family && fit.terms.len() == count);
    let reaching = candidates().filter(|fit| fit.max_opd_um >= max_opd_um);
    let by_range = |a: &&SensitivityFit, b: &&SensitivityFit| a.max_opd_um.total_cmp(&b.max_opd_um);
    let fit = reaching.min_by(by_range).or_else(|| candidates().max_by(by_range))?;
    let (stored, asked) = (stored_space(family), sensitivities.space());
    if stored == asked {
        return Some(fit.clone());
    }
    if family == FitFamily::RgbGaussians {
        return None;
    }
    let mut combined = combine_channels(fit, stored, asked).ok()?;
    combined.measure(&SpectralTransform::new(sensitivities));
    Some(combined)
}
