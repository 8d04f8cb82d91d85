//! Reflectance of a bare surface: exact Fresnel for dielectrics and conductors, and Schlick's approximation.

use crate::wave::{NormalComponent, normal_component_absorbing, normal_component_squared, p_component_absorbing};
use pavo_shade::{Real, Scalar, Vector, shade};

/// Reflectance at one boundary for one polarisation, `|(q1 - q3) / (q1 + q3)|^2`.
///
/// Source: Born and Wolf, section 1.5.2.
#[shade]
pub fn boundary_reflectance<R: Real>(
    /// Normal wave vector component in the ambient medium (for p polarisation over the permittivity).
    q1: R,
    /// The same in the base.
    q3: NormalComponent<R>,
) -> R {
    let difference = q1 - q3.re;
    let sum = q1 + q3.re;
    let decay = q3.im * q3.im;
    (difference * difference + decay) / (sum * sum + decay).max(1e-30)
}

/// Fresnel reflectance of a dielectric in unpolarised light, with total internal reflection.
///
/// Source: Born and Wolf, section 1.5.2.
#[shade]
pub fn fresnel_dielectric<R: Real>(
    /// Cosine of the angle of incidence, [0, 1].
    cos_theta1: R,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: R,
    /// Refractive index of the base, > 0.
    base_ior: R,
) -> R {
    let q1 = ambient_ior * cos_theta1;
    let q3_squared = normal_component_squared(cos_theta1, ambient_ior, base_ior);
    let zero = R::lit(0.0);
    let (re, im) = (q3_squared.max(zero).sqrt(), (-q3_squared).max(zero).sqrt());
    let q3 = NormalComponent { re, im, modulus: q3_squared.abs() };
    let inverse_permittivity = 1.0 / (base_ior * base_ior);
    let q1_p = q1 * (1.0 / (ambient_ior * ambient_ior));
    let scale = inverse_permittivity * inverse_permittivity;
    let q3_p = NormalComponent {
        re: q3.re * inverse_permittivity,
        im: q3.im * inverse_permittivity,
        modulus: q3.modulus * scale,
    };
    (boundary_reflectance(q1, q3) + boundary_reflectance(q1_p, q3_p)) * 0.5
}

/// Fresnel reflectance of a conductor in unpolarised light.
///
/// Source: Born and Wolf, section 14.2.
#[shade]
pub fn fresnel_conductor<R: Real>(
    /// Cosine of the angle of incidence, [0, 1].
    cos_theta1: R,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: R,
    /// Refractive index of the base, > 0.
    base_ior: R,
    /// Extinction coefficient of the base, >= 0.
    base_kappa: R,
) -> R {
    let q1 = ambient_ior * cos_theta1;
    let q3 = normal_component_absorbing(cos_theta1, ambient_ior, base_ior, base_kappa);
    let q1_p = q1 * (1.0 / (ambient_ior * ambient_ior));
    let q3_p = p_component_absorbing(q3, base_ior, base_kappa);
    (boundary_reflectance(q1, q3) + boundary_reflectance(q1_p, q3_p)) * 0.5
}

/// Schlick's approximation of the Fresnel reflectance, by colour channel.
///
/// Source: Schlick 1994, equation 15.
#[shade]
pub fn fresnel_schlick<S: Scalar>(
    /// Cosine of the angle between half vector and light, [0, 1].
    cos_theta1: S,
    /// Reflectance at normal incidence, linear, [0, 1].
    specular_color: S::Vec3,
) -> S::Vec3 {
    let weight = (1.0 - cos_theta1).powi(5);
    specular_color + (S::Vec3::lit(1.0) - specular_color) * weight
}

/// The largest amplitude of a reflection at normal incidence that an index is made for.
pub(crate) const LARGEST_AMPLITUDE: f64 = 0.9999;

/// Refractive index of the dielectric that reflects this much at normal incidence: `(1 + s) / (1 - s)` times the
/// ambient index, with `s` the root of the reflectance. The root is held below 0.9999, an index of 2e4, which
/// reflects 0.9998 at normal incidence.
///
/// Source: the Fresnel equations at normal incidence, solved for the index.
#[shade]
pub fn ior_from_reflectance<R: Real>(
    /// Reflectance at normal incidence, [0, 1].
    reflectance: R,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: R,
) -> R {
    let amplitude = reflectance.max(R::lit(0.0)).sqrt().min(R::lit(LARGEST_AMPLITUDE));
    ambient_ior * (1.0 + amplitude) / (1.0 - amplitude)
}

/// A colour of the same number in each channel, for a grey reflectance.
pub(crate) fn grey<S: Scalar>(value: S) -> S::Vec3 {
    S::Vec3::splat(value)
}
