//! A uniform film: indices and thickness are fixed, so that the colour depends on the angle alone, and a polynomial or
//! a quotient of two stands for it.

use pavo_shade::{Real, Scalar, Value, Vector, shade};

/// A polynomial in `t = 2 cos(theta1) - 1` for each channel, the constant term first, or a quotient of two.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BakedFilm {
    /// The coefficients of each power, by channel.
    pub coefficients: Vec<[f64; 3]>,
    /// What the polynomial is divided by: the coefficients of each power from the first on, by channel, after a constant
    /// term of 1. Above 0 at every angle. Empty: nothing.
    pub denominator: Vec<[f64; 3]>,
}

/// Reflectance of this film as a linear colour, by its polynomial or its quotient.
pub fn baked<S: Scalar>(film: &BakedFilm, cos_theta1: S) -> S::Vec3 {
    if film.denominator.is_empty() {
        baked_reflectance::<S>(film, cos_theta1)
    } else {
        rational_reflectance::<S>(film, cos_theta1)
    }
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
    polynomial::<S>(&film.coefficients, t, "reflected")
}

/// Reflectance of this film as a linear colour: a quotient of polynomials in `t = 2 cos(theta1) - 1`, fitted to the exact
/// spectral reflectance of the surface. It holds for the fixed indices and thickness of the scene only.
#[shade]
pub fn rational_reflectance<S: Scalar>(
    /// The quotient.
    #[constant]
    film: &BakedFilm,
    /// Cosine of the angle between half vector and light, [0, 1].
    cos_theta1: S,
) -> S::Vec3 {
    let t = 2.0 * cos_theta1 - 1.0;
    let mut divisor = vec![[1.0; 3]];
    divisor.extend(&film.denominator);
    let numerator = polynomial::<S>(&film.coefficients, t, "numerator");
    numerator / polynomial::<S>(&divisor, t, "denominator")
}

/// A polynomial by Horner's rule; 0 without coefficients.
fn polynomial<S: Scalar>(coefficients: &[[f64; 3]], t: S, name: &str) -> S::Vec3 {
    let mut powers = coefficients.iter().rev();
    let mut value = powers.next().map_or(S::Vec3::lit(0.0), |last| S::Vec3::lit3(*last));
    for coefficient in powers {
        value = (S::Vec3::lit3(*coefficient) + value * t).named(name);
    }
    value
}
