//! Normal components of the wave vector in the three media, in units of the vacuum wave number.

use pavo_shade::{Real, shade};

/// The normal component of a wave vector, `re + i im`, both parts at least 0.
#[shade]
pub struct NormalComponent<R: Real> {
    /// Real part: propagation.
    pub re: R,
    /// Imaginary part: decay.
    pub im: R,
    /// Square of the modulus, `re^2 + im^2`.
    pub modulus: R,
}

/// Square of the normal wave vector component in a dielectric, `n^2 - ambient_ior^2 sin^2(theta1)`, in a form that
/// does not cancel near the critical angle: `(n - ambient_ior)(n + ambient_ior) + ambient_ior^2 cos^2(theta1)`.
/// Negative under total internal reflection. Indices > 0, cosine within [0, 1].
///
/// Source: Snell's law, squared.
pub fn normal_component_squared<R: Real>(cos_theta1: R, ambient_ior: R, ior: R) -> R {
    let ambient_normal = ambient_ior * cos_theta1;
    (ior - ambient_ior) * (ior + ambient_ior) + ambient_normal * ambient_normal
}

/// The same in a medium that is not below the ambient one, and a little above 0: as if the square of the cosine were larger
/// by [`GRAZING_SQUARED`]. What it costs is no operation, as a product and a sum are one.
pub fn normal_component_squared_above_zero<R: Real>(cos_theta1: R, ambient_ior: R, ior: R) -> R {
    let ambient_normal = ambient_ior * cos_theta1;
    let above_zero = ambient_normal * ambient_normal + R::lit(GRAZING_SQUARED);
    (ior - ambient_ior) * (ior + ambient_ior) + above_zero
}

/// The square of the normal component at which a wave that grazes its medium is held.
pub const GRAZING_SQUARED: f64 = 1e-18;

/// Normal wave vector component in an absorbing medium: the root of `(n + i kappa)^2 - ambient_ior^2 sin^2(theta1)`
/// with both parts at least 0, without cancellation.
///
/// Source: Born and Wolf, section 14.2; root by the larger part first.
#[shade]
pub fn normal_component_absorbing<R: Real>(
    /// Cosine of the angle of incidence in the ambient medium, [0, 1].
    cos_theta1: R,
    /// Refractive index of the ambient medium, > 0.
    ambient_ior: R,
    /// Refractive index of the absorbing medium, > 0.
    ior: R,
    /// Extinction coefficient of the absorbing medium, >= 0.
    kappa: R,
) -> NormalComponent<R> {
    let real = normal_component_squared(cos_theta1, ambient_ior, ior) - kappa * kappa;
    let half_imaginary = ior * kappa;
    let modulus = (real * real + 4.0 * (half_imaginary * half_imaginary)).sqrt();
    let larger = ((modulus + real.abs()) * 0.5).max(1e-30).sqrt();
    let smaller = half_imaginary / larger;
    let is_metallic = real.less_than(R::lit(0.0));
    let re = R::select(is_metallic, smaller, larger);
    let im = R::select(is_metallic, larger, smaller);
    NormalComponent { re, im, modulus }
}

/// The normal component for p polarisation, `q / (n + i kappa)^2`. Its imaginary part may be negative.
///
/// Source: Born and Wolf, section 1.5: the boundary conditions for p polarisation.
#[shade]
pub fn p_component_absorbing<R: Real>(
    /// Normal wave vector component.
    q: NormalComponent<R>,
    /// Refractive index of the medium, > 0.
    ior: R,
    /// Extinction coefficient of the medium, >= 0.
    kappa: R,
) -> NormalComponent<R> {
    let permittivity_re = (ior - kappa) * (ior + kappa);
    let permittivity_im = 2.0 * ior * kappa;
    let permittivity_modulus = ior * ior + kappa * kappa;
    let scale = 1.0 / (permittivity_modulus * permittivity_modulus);
    NormalComponent {
        re: (q.re * permittivity_re + q.im * permittivity_im) * scale,
        im: (q.im * permittivity_re - q.re * permittivity_im) * scale,
        modulus: q.modulus * scale,
    }
}
