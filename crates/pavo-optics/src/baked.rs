//! A uniform film: indices and thickness are fixed, so that the colour depends on the angle alone, and a polynomial
//! stands for it.

use pavo_shade::{Real, Scalar, Value, Vector, shade};

/// A polynomial in `t = 2 cos(theta1) - 1` for each channel, the constant term first.
#[derive(Clone, Debug, PartialEq)]
pub struct BakedFilm {
    /// The coefficients of each power, by channel.
    pub coefficients: Vec<[f64; 3]>,
}

/// Reflectance of this film as a linear colour: a polynomial in `t = 2 cos(theta1) - 1` through the exact spectral
/// reflectance of the surface at Chebyshev's points. It holds for the fixed indices and thickness of the scene only.
#[shade]
pub fn baked_reflectance<S: Scalar>(
    /// The polynomial.
    #[constant]
    film: &BakedFilm,
    /// Cosine of the angle between half vector and light, [0, 1].
    cos_theta1: S,
) -> S::Vec3 {
    let t = 2.0 * cos_theta1 - 1.0;
    let mut powers = film.coefficients.iter().rev();
    let mut color = powers.next().map_or(S::Vec3::lit(0.0), |last| S::Vec3::lit3(*last));
    for coefficient in powers {
        color = (S::Vec3::lit3(*coefficient) + color * t).named("color");
    }
    color
}
