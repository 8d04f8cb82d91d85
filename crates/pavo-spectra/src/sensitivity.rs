//! Spectral sensitivities of the output channels: observer and illuminant, combined to a colour space.
//!
//! # White
//! A perfect mirror under the illuminant is (1, 1, 1) in every space: the illuminant becomes the white. With the
//! observer's functions c(lambda), the illuminant's power I(lambda), the matrix M from XYZ to the space, the
//! illuminant's own white W_I = integral c I / integral y I, and the white W_S that the space was made for, the density
//! of channel j is
//!
//! s_j = sum_i M_ji (W_S / W_I)_i c_i I,
//!
//! and each channel is then normalised to integrate to 1. W_S is that of illuminant D65, integrated under the 2 degree
//! observer, for the spaces whose white is D65, so that with D65 itself the factor is exactly 1; for ACEScg it is the
//! white that the standard prints. The factor is the plainest adaptation of white, a diagonal one in XYZ. Without it a
//! channel's integral could vanish or change its sign under light far from the space's white.

use std::sync::LazyLock;

use crate::colour_space::{ColourSpace, xyz_of_chromaticity};
use crate::illuminant::Illuminant;
use crate::matrix3::{Matrix3, scale_columns, transform};
use crate::observer::Observer;
use crate::wavelength::fine_grid;

/// A channel whose sum is below this part of its absolute sum is not normalised: rounding would decide its sign.
const LEAST_RELATIVE_SUM: f64 = 1e-6;

/// Why sensitivities cannot be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SensitivityError {
    /// The illuminant does not excite one of the observer's functions, so that it has no colour to call white.
    #[error(
        "illuminant {illuminant}: it has (next to) no power where the {function} function of the observer sees; \
         a white needs power from about 430 to 620 nm"
    )]
    NoWhite {
        /// Name of the illuminant.
        illuminant: String,
        /// The function: X, Y or Z.
        function: &'static str,
    },
    /// The samples of a channel do not sum to a positive number.
    #[error(
        "channel {channel} cannot be normalised over the {count} given wavelength(s): its samples sum to {sum:e}; \
         wavelengths spread over 400 to 700 nm are needed"
    )]
    NotNormalisable {
        /// Name of the channel.
        channel: &'static str,
        /// Number of wavelengths.
        count: usize,
        /// Sum of the unnormalised samples.
        sum: f64,
    },
}

/// The spectral sensitivities of three output channels.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivities {
    observer: Observer,
    illuminant: Illuminant,
    space: ColourSpace,
    /// From the observer's functions to the channels.
    combine: Matrix3,
    fine_weights: Vec<[f64; 3]>,
}

impl Sensitivities {
    /// The sensitivities of `space` for an observer and an illuminant.
    ///
    /// # Errors
    /// An illuminant without a white: no power where one of the observer's functions sees.
    pub fn new(observer: Observer, illuminant: Illuminant, space: ColourSpace) -> Result<Self, SensitivityError> {
        let white = white_xyz(observer, &illuminant)?;
        let target = white_of_space(space)?;
        let adaptation = std::array::from_fn(|i| target[i] / white[i]);
        let combine = scale_columns(&space.xyz_to_rgb(), adaptation);
        let mut sensitivities = Self { observer, illuminant, space, combine, fine_weights: Vec::new() };
        sensitivities.fine_weights = sensitivities.normalised_weights(&fine_grid())?;
        Ok(sensitivities)
    }

    /// The observer.
    pub fn observer(&self) -> Observer {
        self.observer
    }

    /// The illuminant.
    pub fn illuminant(&self) -> &Illuminant {
        &self.illuminant
    }

    /// The colour space.
    pub fn space(&self) -> ColourSpace {
        self.space
    }

    /// The channels' densities over the wavelength (nanometres), not normalised: only ratios mean anything. They may be
    /// negative; they are zero outside 360 to 830 nm.
    pub fn at(&self, wavelength_nm: f64) -> [f64; 3] {
        let power = self.illuminant.power(wavelength_nm);
        transform(&self.combine, self.observer.at(wavelength_nm)).map(|value| value * power)
    }

    /// Point samples at the given wavelengths (nanometres, any order), each channel normalised to sum to 1: the weights of
    /// a reflectance at those wavelengths, for equispaced ones.
    ///
    /// # Errors
    /// A channel whose samples do not sum to a positive number.
    pub fn normalised_weights(&self, wavelengths_nm: &[f64]) -> Result<Vec<[f64; 3]>, SensitivityError> {
        let mut weights: Vec<[f64; 3]> = wavelengths_nm.iter().map(|&wavelength| self.at(wavelength)).collect();
        for channel in 0..3 {
            let sum: f64 = weights.iter().map(|weight| weight[channel]).sum();
            let size: f64 = weights.iter().map(|weight| weight[channel].abs()).sum();
            if sum.is_nan() || sum <= LEAST_RELATIVE_SUM * size {
                let (channel, count) = (self.space.channels()[channel], wavelengths_nm.len());
                return Err(SensitivityError::NotNormalisable { channel, count, sum });
            }
            for weight in &mut weights {
                weight[channel] /= sum;
            }
        }
        Ok(weights)
    }

    /// [`Sensitivities::normalised_weights`] of the fine grid [`fine_grid`].
    pub fn fine_weights(&self) -> &[[f64; 3]] {
        &self.fine_weights
    }
}

/// The XYZ of an illuminant under an observer, scaled to Y = 1, summed over the fine grid.
///
/// # Errors
/// An illuminant that has (next to) no power where one of the observer's functions sees.
pub fn white_xyz(observer: Observer, illuminant: &Illuminant) -> Result<[f64; 3], SensitivityError> {
    let mut sums = [0.0; 3];
    for wavelength in fine_grid() {
        let power = illuminant.power(wavelength);
        let functions = observer.at(wavelength);
        for (sum, function) in sums.iter_mut().zip(functions) {
            *sum += function * power;
        }
    }
    let largest = sums.into_iter().fold(0.0, f64::max);
    for (sum, function) in sums.into_iter().zip(["X", "Y", "Z"]) {
        if sum.is_nan() || sum <= LEAST_RELATIVE_SUM * largest {
            return Err(SensitivityError::NoWhite { illuminant: illuminant.name().to_owned(), function });
        }
    }
    Ok(sums.map(|sum| sum / sums[1]))
}

/// The XYZ, at Y = 1, of the white that a space was made for.
pub(crate) fn white_of_space(space: ColourSpace) -> Result<[f64; 3], SensitivityError> {
    static D65: LazyLock<Result<[f64; 3], SensitivityError>> =
        LazyLock::new(|| white_xyz(Observer::Cie1931TwoDegree, &Illuminant::D65));
    match space {
        ColourSpace::LinearSrgb | ColourSpace::DisplayP3 | ColourSpace::Rec2020 => D65.clone(),
        ColourSpace::AcesCg | ColourSpace::Xyz => Ok(xyz_of_chromaticity(space.white_chromaticity())),
    }
}
