//! Fits of the sensitivities' Fourier transforms: what the fast methods carry instead of a spectrum.
//!
//! A film's reflectance needs the spectrum only through S^_j(D), the transform of the sensitivity of channel j at the
//! optical path difference D ([`SpectralTransform`]). A fit replaces it by a short sum. Every family is a special case
//! of
//!
//! S^_j(D) ~ g(D) sum_k w_jk exp(-a_jk D^2 or -gamma_k D) exp(2 pi i nu_jk D),  g = exp(-(D / Dc)^2) or 1,
//!
//! with the real parts of w_jk summing to 1 and the imaginary ones to 0 over k in each channel, so that S^_j(0) = 1 and
//! a perfect mirror stays (1, 1, 1). Here D is in micrometres and nu = 1 / lambda in 1/um.
//!
//! The fits under `data/fits` were made by the crate `pavo-fit`, which also makes fits for any other observer,
//! illuminant or count. [`built_in`] finds one.

mod built_in;
mod channels;
pub mod text;
mod transform;

#[cfg(test)]
mod tests;

use std::f64::consts::PI;

use num_complex::Complex64;

use crate::names::UnknownName;

pub use self::built_in::{BUILT_IN_SPECTRA, BuiltInSpectrum, built_in};
pub use self::channels::combine_channels;
pub use self::transform::SpectralTransform;

/// The form of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FitFamily {
    /// Gaussians whose centres and widths serve every channel, with real weights.
    SharedGaussians,
    /// Gaussians of their own for each RGB channel, with real weights.
    RgbGaussians,
    /// Gaussians for each of X, Y and Z, combined linearly into the output space (Belcour and Barla 2017).
    XyzGaussians,
    /// Complex exponentials that decay, shared by the channels, with complex weights: Lorentzians over the wave number.
    Poles,
    /// Equispaced wave numbers under one Gaussian window over D, with real weights.
    WindowedNodes,
    /// Equispaced wave numbers with real weights: a quadrature over the spectrum, right up to a range of D only.
    Nodes,
}

impl FitFamily {
    /// Every family.
    pub const ALL: [FitFamily; 6] = [
        FitFamily::SharedGaussians,
        FitFamily::RgbGaussians,
        FitFamily::XyzGaussians,
        FitFamily::Poles,
        FitFamily::WindowedNodes,
        FitFamily::Nodes,
    ];

    /// The names that [`FitFamily::from_name`] knows, in the order of [`FitFamily::ALL`].
    pub const NAMES: [&'static str; 6] = ["gauss", "rgb-gauss", "xyz-gauss", "poles", "windowed", "nodes"];

    /// The family of that name.
    ///
    /// # Errors
    /// An unknown name, with the known ones.
    pub fn from_name(name: &str) -> Result<Self, UnknownName> {
        Self::ALL
            .into_iter()
            .find(|family| family.name() == name)
            .ok_or_else(|| UnknownName::new("family of fits", name, &Self::NAMES))
    }

    /// The name that [`FitFamily::from_name`] reads.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// Whether one set of wave numbers and decays serves every channel, so that a fit carries over to any other colour
    /// space of the same observer and illuminant by its weights alone.
    pub fn is_shared(self) -> bool {
        !matches!(self, FitFamily::RgbGaussians | FitFamily::XyzGaussians)
    }

    /// Whether the weights are complex.
    pub fn has_complex_weights(self) -> bool {
        self == FitFamily::Poles
    }

    /// Least and largest number of terms that are built in and that can be fitted; per channel for the families that
    /// do not share their terms.
    pub fn counts(self) -> std::ops::RangeInclusive<usize> {
        match self {
            FitFamily::SharedGaussians | FitFamily::RgbGaussians | FitFamily::XyzGaussians => 1..=5,
            FitFamily::Poles => 3..=8,
            FitFamily::WindowedNodes => 4..=10,
            FitFamily::Nodes => 4..=16,
        }
    }
}

/// One term of a fit, for each of the three channels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FitTerm {
    /// Wave number nu = 1 / lambda in 1/um; equal in all channels where the family shares it.
    pub wave_number: [f64; 3],
    /// Decay over the optical path difference D: a of exp(-a D^2) in 1/um^2 for Gaussians, gamma of exp(-gamma D) in
    /// 1/um for poles, 0 for nodes.
    pub decay: [f64; 3],
    /// Real part of the weight.
    pub weight_re: [f64; 3],
    /// Imaginary part of the weight; 0 but for poles.
    pub weight_im: [f64; 3],
}

/// A fit of the sensitivities' transforms.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SensitivityFit {
    /// The form of the fit.
    pub family: FitFamily,
    /// The terms: as many as the count that was asked for, and three times that for XYZ Gaussians in an RGB space,
    /// where every channel draws on those of X, of Y and of Z.
    pub terms: Vec<FitTerm>,
    /// Dc of the window exp(-(D / Dc)^2) in micrometres; windowed nodes only.
    pub window_um: Option<f64>,
    /// Largest optical path difference that the fit was made for, in micrometres.
    pub max_opd_um: f64,
    /// Largest |fit - S^| over the channels and 0 <= D <= `max_opd_um`.
    pub max_error: f64,
    /// Root of the mean of |fit - S^|^2 over the same.
    pub rms_error: f64,
}

impl SensitivityFit {
    /// The fit's value for S^_j(D) in each channel, D in micrometres, 0 or above.
    pub fn transform_at(&self, opd_um: f64) -> [Complex64; 3] {
        let window = self.window_um.map_or(1.0, |window| (-(opd_um / window).powi(2)).exp());
        let power = if self.family == FitFamily::Poles { opd_um } else { opd_um * opd_um };
        let mut sums = [Complex64::ZERO; 3];
        for term in &self.terms {
            for (channel, sum) in sums.iter_mut().enumerate() {
                let weight = Complex64::new(term.weight_re[channel], term.weight_im[channel]);
                let size = window * (-term.decay[channel] * power).exp();
                *sum += weight * Complex64::from_polar(size, 2.0 * PI * term.wave_number[channel] * opd_um);
            }
        }
        sums
    }

    /// Measures `max_error` and `rms_error` against the exact transform, over [`ERROR_SAMPLES`] + 1 equispaced D.
    pub fn measure(&mut self, exact: &SpectralTransform) {
        let (mut largest, mut sum) = (0.0f64, 0.0);
        for index in 0..=ERROR_SAMPLES {
            let opd_um = self.max_opd_um * index as f64 / ERROR_SAMPLES as f64;
            for (fitted, exact) in self.transform_at(opd_um).into_iter().zip(exact.at(opd_um)) {
                let square = (fitted - exact).norm_sqr();
                largest = largest.max(square);
                sum += square;
            }
        }
        self.max_error = largest.sqrt();
        self.rms_error = (sum / (3 * (ERROR_SAMPLES + 1)) as f64).sqrt();
    }

    /// Makes the weights of every channel sum to 1 (imaginary parts to 0) to the last bit that summing allows: what is
    /// missing goes to the channel's last term that has a weight there.
    pub fn close_weights(&mut self) {
        for channel in 0..3 {
            let used = |term: &FitTerm| term.weight_re[channel] != 0.0 || term.weight_im[channel] != 0.0;
            let Some(last) = self.terms.iter().rposition(used) else { continue };
            let others = |part: fn(&FitTerm) -> [f64; 3]| -> f64 {
                self.terms.iter().enumerate().filter(|&(k, _)| k != last).map(|(_, term)| part(term)[channel]).sum()
            };
            let (re, im) = (others(|term| term.weight_re), others(|term| term.weight_im));
            self.terms[last].weight_re[channel] = 1.0 - re;
            self.terms[last].weight_im[channel] = 0.0 - im;
        }
    }
}

/// Number of steps over the range at which a fit's errors are measured.
pub const ERROR_SAMPLES: usize = 1200;
