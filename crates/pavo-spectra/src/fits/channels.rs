//! Carrying a fit from one colour space to another of the same observer and illuminant.
//!
//! With X_i the normalised functions X, Y, Z, channel j of a space is S_j = sum_i C_ji X_i, where C_ji is proportional to
//! M_ji W_i (M from XYZ to the space, W the white that the space was made for) and each row of C sums to 1: the
//! illuminant enters X_i only. From space A to space B the map is C_B C_A^-1, whose rows sum to 1 as well.

use super::{FitFamily, FitTerm, SensitivityFit};
use crate::colour_space::ColourSpace;
use crate::matrix3::{Matrix3, inverse, transform};
use crate::sensitivity::{SensitivityError, white_of_space};

/// The fit of the channels of `to`, from one of the channels of `from`, for the same observer and illuminant. Terms that
/// every channel shares keep their number. Terms of their own per channel (XYZ Gaussians) become three times as many, each
/// shared, unless both spaces are the same. The errors are those of `from`: measure them again.
///
/// # Errors
/// A space whose white cannot be made.
pub fn combine_channels(
    fit: &SensitivityFit,
    from: ColourSpace,
    to: ColourSpace,
) -> Result<SensitivityFit, SensitivityError> {
    if from == to {
        return Ok(fit.clone());
    }
    let (from, to) = (from_xyz(from)?, from_xyz(to)?);
    let back = inverse(&from);
    // Column by column: what each channel of `from` becomes in `to`.
    let columns: Matrix3 = [0, 1, 2].map(|i| transform(&to, back.map(|row| row[i])));
    let mut combined = fit.clone();
    combined.terms = match fit.family {
        FitFamily::XyzGaussians | FitFamily::RgbGaussians => separate(&fit.terms, &columns),
        _ => fit.terms.iter().map(|term| shared(term, &columns)).collect(),
    };
    combined.close_weights();
    Ok(combined)
}

fn shared(term: &FitTerm, columns: &Matrix3) -> FitTerm {
    let map = |weights: [f64; 3]| std::array::from_fn(|j| (0..3).map(|i| columns[i][j] * weights[i]).sum());
    FitTerm { weight_re: map(term.weight_re), weight_im: map(term.weight_im), ..*term }
}

fn separate(terms: &[FitTerm], columns: &Matrix3) -> Vec<FitTerm> {
    let of_channel = |channel: usize| {
        terms.iter().map(move |term| FitTerm {
            wave_number: [term.wave_number[channel]; 3],
            decay: [term.decay[channel]; 3],
            weight_re: columns[channel].map(|factor| factor * term.weight_re[channel]),
            weight_im: columns[channel].map(|factor| factor * term.weight_im[channel]),
        })
    };
    (0..3).flat_map(of_channel).collect()
}

/// C of the module's text.
fn from_xyz(space: ColourSpace) -> Result<Matrix3, SensitivityError> {
    if space == ColourSpace::Xyz {
        return Ok(crate::matrix3::IDENTITY);
    }
    let white = white_of_space(space)?;
    Ok(space.xyz_to_rgb().map(|row| {
        let products: [f64; 3] = std::array::from_fn(|i| row[i] * white[i]);
        let sum: f64 = products.iter().sum();
        products.map(|product| product / sum)
    }))
}
