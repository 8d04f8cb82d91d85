//! Diffuse reflection.

use core::f64::consts::FRAC_1_PI;
use pavo_shade::{Scalar, shade};

/// Lambert's diffuse BRDF, the same in all directions.
///
/// Source: Lambert 1760: `f = c_diff / pi`.
#[shade]
pub fn lambert<S: Scalar>(
    /// Diffuse colour, linear, [0, 1].
    diffuse_color: S::Vec3,
) -> S::Vec3 {
    diffuse_color * S::lit(FRAC_1_PI)
}
