//! Punctual light.

use core::f64::consts::PI;
use pavo_shade::{Scalar, shade};

/// Radiance that a punctual light leaves towards the view.
///
/// Source: the reflection equation for one direction, `L_o(v) = pi f(l, v) c_light (n.l)`, `c_light = intensity * color`.
#[shade]
pub fn punctual_light<S: Scalar>(
    /// The BRDF for this light, 1/sr, by channel.
    brdf: S::Vec3,
    /// Cosine of the angle between normal and light, [0, 1].
    n_dot_l: S,
    /// Colour of the light, linear, [0, 1].
    light_color: S::Vec3,
    /// Intensity of the light, >= 0.
    light_intensity: S,
) -> S::Vec3 {
    brdf * light_color * (S::lit(PI) * light_intensity * n_dot_l)
}
