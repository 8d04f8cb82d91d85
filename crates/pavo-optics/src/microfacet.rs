//! Microfacets: the distribution of their normals, and shadowing and masking among them.

use core::f64::consts::PI;
use pavo_shade::{Real, shade};

/// GGX distribution of the microfacet normals, per steradian. The difference `1 - (n.h)^2` is taken as a product, which
/// keeps smooth surfaces exact.
///
/// Source: Walter et al. 2007, equation 33, as `D(h) = alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2)`.
#[shade]
pub fn ggx_distribution<R: Real>(
    /// Cosine of the angle between normal and half vector, [0, 1].
    n_dot_h: R,
    /// Width alpha, the square of the roughness, (0, 1].
    alpha: R,
) -> R {
    let alpha_squared = alpha * alpha;
    let sine_squared = (1.0 - n_dot_h) * (1.0 + n_dot_h);
    let spread = sine_squared + alpha_squared * (n_dot_h * n_dot_h);
    alpha_squared / (R::lit(PI) * spread * spread).max(1e-30)
}

/// Smith's shadowing for one direction in Schlick's form, over the cosine: `G1(v) / (n.v) = 1 / ((n.v)(1 - k) + k)`.
///
/// Source: Schlick 1994, equation 19.
#[shade]
pub fn smith_schlick_over_cosine<R: Real>(
    /// Cosine of the angle between normal and direction, [0, 1].
    cosine: R,
    /// The parameter k, (0, 1].
    k: R,
) -> R {
    1.0 / (cosine * (1.0 - k) + k)
}

/// The parameter k of Smith-Schlick for punctual lights: `(roughness + 1)^2 / 8`.
///
/// Source: Karis 2013, "Real Shading in Unreal Engine 4".
#[shade]
pub fn smith_schlick_k_punctual<R: Real>(
    /// Roughness, the root of alpha, [0, 1].
    roughness: R,
) -> R {
    let widened = roughness + 1.0;
    widened * widened * 0.125
}

/// The parameter k of Smith-Schlick for light from an image all around: `alpha / 2`.
///
/// Source: Karis 2013, "Real Shading in Unreal Engine 4".
#[shade]
pub fn smith_schlick_k_image_based<R: Real>(
    /// Roughness, the root of alpha, [0, 1].
    roughness: R,
) -> R {
    roughness * roughness * 0.5
}

/// Specular reflection of the microfacets without the Fresnel factor: `G D / (4 (n.l)(n.v))`.
///
/// Source: Cook and Torrance 1982, with `G = G1(l) G1(v)` of Smith.
#[shade]
pub fn cook_torrance<R: Real>(
    /// Cosine of the angle between normal and light, [0, 1].
    n_dot_l: R,
    /// Cosine of the angle between normal and view, [0, 1].
    n_dot_v: R,
    /// Cosine of the angle between normal and half vector, [0, 1].
    n_dot_h: R,
    /// Width alpha, the square of the roughness, (0, 1].
    alpha: R,
    /// The parameter k of Smith-Schlick, (0, 1].
    k: R,
) -> R {
    let visibility = smith_schlick_over_cosine(n_dot_l, k) * smith_schlick_over_cosine(n_dot_v, k) * 0.25;
    visibility * ggx_distribution(n_dot_h, alpha)
}
