//! Gaussian fits of the sensitivities over the wave number.

use crate::colour_space::ColourSpace;
use crate::observer::Observer;
use crate::sensitivity::{SensitivityError, white_of_space};
use std::f64::consts::PI;

/// One Gaussian of a fit as its Fourier transform has it: `weight exp(-decay D^2) cos(angular_wave_number D)`, with the
/// optical path difference D in nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaussian {
    /// Centre, 2 pi / wavelength, radians per nm.
    pub angular_wave_number: f64,
    /// Half the variance over the angular wave number, 1/nm^2.
    pub decay: f64,
    /// Share in each output channel; over a fit the shares of a channel add up to 1.
    pub weight: [f64; 3],
}

/// A row of the fit of Belcour and Barla: which of X, Y, Z it belongs to, peak, centre (1/m), variance (1/m^2).
type PublishedGaussian = (usize, f64, f64, f64);

/// The Gaussian fit of the CIE 1931 sensitivities X, Y, Z for equal energy, two Gaussians for X.
///
/// Source: Belcour and Barla 2017, the constants of the supplemental shader code (`val`, `pos`, `var` there; centres
/// and variances are over the wave number, with the phase 2 pi D as argument of the transform).
const BELCOUR_BARLA_XYZ: [PublishedGaussian; 4] = [
    (0, 5.4856e-13, 1.6810e6, 4.3278e9),
    (0, 9.7470e-14, 2.2399e6, 4.5282e9),
    (1, 4.4201e-13, 1.7953e6, 9.3046e9),
    (2, 5.2481e-13, 2.2084e6, 6.6121e9),
];

/// Why there is no such fit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    /// The fit was made for another observer.
    #[error("the Gaussian fit xyz-gauss was made for the observer {made_for}, not for {wanted}")]
    Observer {
        /// The observer of the fit.
        made_for: &'static str,
        /// The observer that was asked for.
        wanted: &'static str,
    },
    /// The white of the space cannot be made.
    #[error(transparent)]
    White(#[from] SensitivityError),
}

/// The Gaussian fit of Belcour and Barla in an output space.
///
/// The fit holds for equal energy. Each of X, Y, Z is normalised to 1 and scaled to the white of the space before the
/// space's matrix, so that a mirror is (1, 1, 1): what stays unseen is the illuminant's course within each of the three
/// curves.
///
/// # Errors
/// An observer that the fit was not made for.
pub fn belcour_barla(observer: Observer, space: ColourSpace) -> Result<Vec<Gaussian>, FitError> {
    if observer != Observer::Cie1931TwoDegree {
        let made_for = Observer::Cie1931TwoDegree.name();
        return Err(FitError::Observer { made_for, wanted: observer.name() });
    }
    let white = white_of_space(space)?;
    let rows = space.xyz_to_rgb();
    let area = |&(_, peak, _, variance): &PublishedGaussian| peak * (2.0 * PI * variance).sqrt();
    let areas: [f64; 3] =
        std::array::from_fn(|curve| BELCOUR_BARLA_XYZ.iter().filter(|gaussian| gaussian.0 == curve).map(area).sum());
    let white_channels: [f64; 3] =
        std::array::from_fn(|channel| (0..3).map(|curve| rows[channel][curve] * white[curve]).sum());
    let per_nm = 1e-9;
    let gaussians = BELCOUR_BARLA_XYZ.iter().map(|gaussian| {
        let &(curve, _, centre, variance) = gaussian;
        let share = area(gaussian) / areas[curve];
        Gaussian {
            angular_wave_number: 2.0 * PI * centre * per_nm,
            decay: (2.0 * PI * per_nm).powi(2) * variance,
            weight: std::array::from_fn(|channel| {
                share * rows[channel][curve] * white[curve] / white_channels[channel]
            }),
        }
    });
    Ok(gaussians.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weights_of_each_channel_add_up_to_one() {
        for space in ColourSpace::ALL {
            let fit = belcour_barla(Observer::Cie1931TwoDegree, space).expect("the fit is for this observer");
            for channel in 0..3 {
                let sum: f64 = fit.iter().map(|gaussian| gaussian.weight[channel]).sum();
                assert!((sum - 1.0).abs() < 1e-14, "{} channel {channel}: {sum}", space.name());
            }
        }
    }

    #[test]
    fn the_published_areas_are_those_of_their_normalisation() {
        // The published code divides by 1.0685e-7 to make each of X, Y, Z 1 for a mirror.
        for curve in 0..3 {
            let gaussians = BELCOUR_BARLA_XYZ.iter().filter(|gaussian| gaussian.0 == curve);
            let area: f64 = gaussians.map(|&(_, peak, _, variance)| peak * (2.0 * PI * variance).sqrt()).sum();
            assert!((area / 1.0685e-7 - 1.0).abs() < 2e-3, "curve {curve}: {area:e}");
        }
    }

    #[test]
    fn another_observer_is_refused() {
        let error = belcour_barla(Observer::Cie1964TenDegree, ColourSpace::Xyz);
        assert!(matches!(error, Err(FitError::Observer { .. })));
    }
}
