//! The Airy formula of one film between two half spaces, in complex numbers, as textbooks have it.
//!
//! Source: P. Yeh, "Optical Waves in Layered Media"; M. Born and E. Wolf, "Principles of Optics", section 1.6.
//! Time factor e^{-i w t}; media are 1 ambient (real index), 2 film, 3 base; eps = index^2.
//!
//! With q_i = sqrt(eps_i - eps_1 sin^2(theta_1)), Im q_i >= 0, the admittance a_i is q_i for s polarisation and q_i / eps_i
//! for p; the amplitude at a boundary is r_ij = (a_i - a_j) / (a_i + a_j); z = exp(i 4 pi q_2 d / lambda); and
//!
//! r = (r_12 + r_23 z) / (1 + r_12 r_23 z),  R = (|r_s|^2 + |r_p|^2) / 2.
//!
//! Total internal reflection at either boundary makes q_2 or q_3 imaginary, which the formula carries.

use std::f64::consts::PI;

use num_complex::Complex64;

/// Below this |q_2| (exactly critical incidence into the film) the formula is 0 / 0 to rounding, and its limit is used,
/// whose error is of the order of (q_2 d / lambda)^2.
const CRITICAL: f64 = 1e-7;

/// A film under one angle: what does not depend on its thickness.
pub(super) struct FilmAtAngle {
    q1: f64,
    q2: Complex64,
    polarisations: [Polarisation; 2],
}

/// Admittances and amplitudes for one polarisation.
struct Polarisation {
    a1: Complex64,
    a3: Complex64,
    /// a_2 = q_2 / divisor2: 1 for s, eps_2 for p.
    divisor2: Complex64,
    r12: Complex64,
    r23: Complex64,
}

impl FilmAtAngle {
    /// `ambient` is a real index above 0; `film` and `base` are complex ones; `cos_theta1` is clamped to 0..1.
    pub(super) fn new(ambient: f64, film: Complex64, base: Complex64, cos_theta1: f64) -> Self {
        let q1 = ambient * cos_theta1.clamp(0.0, 1.0);
        let eps1 = ambient * ambient;
        let (eps2, eps3) = (film * film, base * base);
        let q = |eps: Complex64| root_in_upper_half_plane(eps - eps1 + q1 * q1);
        let (q2, q3) = (q(eps2), q(eps3));
        let one = Complex64::new(1.0, 0.0);
        let polarisation = |divisors: [Complex64; 3]| {
            let [a1, a2, a3] = [q1 / divisors[0], q2 / divisors[1], q3 / divisors[2]];
            Polarisation { a1, a3, divisor2: divisors[1], r12: amplitude(a1, a2), r23: amplitude(a2, a3) }
        };
        Self { q1, q2, polarisations: [polarisation([one; 3]), polarisation([one * eps1, eps2, eps3])] }
    }

    /// The reflectance (R_s + R_p) / 2 for a thickness as a multiple of the vacuum wavelength; at or below 0 the
    /// film is absent.
    pub(super) fn reflectance(&self, thickness_over_wavelength: f64) -> f64 {
        let power = |amplitude: &dyn Fn(&Polarisation) -> Complex64| -> f64 {
            self.polarisations.iter().map(|polarisation| amplitude(polarisation).norm_sqr()).sum::<f64>() / 2.0
        };
        if thickness_over_wavelength <= 0.0 {
            return power(&|p| amplitude(p.a1, p.a3));
        }
        if self.q1 == 0.0 {
            // At grazing incidence every boundary reflects all; where nothing has contrast, nothing reflects.
            let contrast = self.polarisations.iter().any(|p| p.r12.norm_sqr() + p.r23.norm_sqr() > 0.0);
            return if contrast { 1.0 } else { 0.0 };
        }
        if self.q2.norm() < CRITICAL {
            // The field in the film is linear over its thickness. Relative to the field at the base, that at the ambient
            // side is 1 - i (2 pi d / lambda) a_3 eps_2 (with 1 in place of eps_2 for s).
            let path = Complex64::new(0.0, 2.0 * PI * thickness_over_wavelength);
            return power(&|p| amplitude(p.a1 * (1.0 - path * p.a3 * p.divisor2), p.a3));
        }
        let z = (Complex64::new(0.0, 4.0 * PI * thickness_over_wavelength) * self.q2).exp();
        power(&|p| (p.r12 + p.r23 * z) / (1.0 + p.r12 * p.r23 * z))
    }
}

/// Fresnel's amplitude from two admittances; 0 where they are the same, both 0 included.
fn amplitude(a: Complex64, b: Complex64) -> Complex64 {
    if a == b { Complex64::ZERO } else { (a - b) / (a + b) }
}

/// The square root with Im >= 0: the wave that decays, or runs, away from the boundary.
fn root_in_upper_half_plane(square: Complex64) -> Complex64 {
    let root = square.sqrt();
    if root.im < 0.0 { -root } else { root }
}
