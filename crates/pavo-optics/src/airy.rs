//! The film's reflectance at one wavelength: Airy's summation of all orders in closed form, with real numbers only.
//!
//! With `q_i` the normal wave vector components (for p polarisation each over its permittivity), `x` half the phase of
//! one round trip, `x = 2 pi d q_2 / lambda`, and `q3 = q3.re + i q3.im`:
//!
//! `R = 1 - T / (O + K sin^2(x) + A sin(x) cos(x))`, where `T = 4 q1 q2^2 q3.re`, `O = q2^2 |q1 + q3|^2`,
//! `K = (q1^2 - q2^2) (|q3|^2 - q2^2)` and `A = 2 q2 q3.im (q1^2 - q2^2)`.
//!
//! It is `|(r12 + r23 z) / (1 + r12 r23 z)|^2`, `z = e^(2 i x)`, multiplied out. Under total internal reflection into
//! the film `q2` is imaginary and the sines become hyperbolic: frustrated total reflection.

use crate::wave::NormalComponent;
use pavo_shade::{Real, Value, shade};

/// The terms of Airy's closed form for one polarisation; they do not depend on thickness or wavelength.
#[shade]
pub struct AiryTerms<R: Real> {
    /// `T`: what gets through, before interference.
    pub transmitted: R,
    /// `O`: the denominator at zero phase.
    pub offset: R,
    /// `K`: how strongly the round trip interferes.
    pub contrast: R,
    /// `A`: the part of the interference that absorption in the base shifts in phase; 0 for a dielectric base.
    pub absorption: R,
}

/// Terms of Airy's closed form for one polarisation.
///
/// Source: Yeh 2005, section 4.1; Belcour and Barla 2017, equation 3, summed over all orders.
#[shade]
pub fn airy_terms<R: Real>(
    /// Whether the film may reflect totally.
    #[constant]
    total_reflection: bool,
    /// Normal wave vector component in the ambient medium (for p polarisation over the permittivity), >= 0.
    q1: R,
    /// The same in the film, its modulus, >= 0.
    q2: R,
    /// Its square, negative under total internal reflection.
    q2_squared: R,
    /// The same in the base.
    q3: NormalComponent<R>,
) -> AiryTerms<R> {
    let boundary_sum = q1 + q3.re;
    let ambient_difference = q1 * q1 - q2_squared;
    // From the same parts as the offset: near a resonance both all but cancel.
    let base_difference = q3.re * q3.re + q3.im * q3.im - q2_squared;
    let transmitted = 4.0 * q1 * q2_squared * q3.re;
    let offset = q2_squared * (boundary_sum * boundary_sum + q3.im * q3.im);
    let contrast = ambient_difference * base_difference;
    let absorption = 2.0 * q2 * q3.im * ambient_difference;
    if !total_reflection {
        return AiryTerms { transmitted, offset, contrast, absorption };
    }
    // With q2^2 < 0 numerator and denominator are both negative: turn both, so that the guard is the same.
    let turn = R::select(q2_squared.less_than(R::lit(0.0)), R::lit(-1.0), R::lit(1.0));
    AiryTerms {
        transmitted: transmitted * turn,
        offset: offset * turn,
        contrast: contrast * turn,
        absorption: absorption * turn,
    }
}

/// `sin^2(x)` and `sin(x) cos(x)` of half the round-trip phase.
#[shade]
pub struct HalfPhase<R: Real> {
    /// `sin^2(x)`; `-sinh^2(x)` under total internal reflection.
    pub sine_squared: R,
    /// `sin(x) cos(x)`; `-sinh(x) cosh(x)` under total internal reflection.
    pub sine_cosine: R,
}

/// The sines of half the round-trip phase. Squares of the sine instead of the cosine of the whole phase keep thin
/// films exact.
pub fn half_phase<R: Real>(total_reflection: bool, is_total_reflection: R::Mask, phase: R) -> HalfPhase<R> {
    let sine = phase.sin().named("sine");
    let propagating = HalfPhase { sine_squared: sine * sine, sine_cosine: sine * phase.cos() };
    if !total_reflection {
        return propagating;
    }
    let evanescent = evanescent_half_phase(phase).named("evanescent");
    HalfPhase {
        sine_squared: R::select(is_total_reflection, evanescent.sine_squared, propagating.sine_squared),
        sine_cosine: R::select(is_total_reflection, evanescent.sine_cosine, propagating.sine_cosine),
    }
}

/// The sines of half the round-trip phase where the wave decays in the film: hyperbolic, with their sign.
///
/// Source: the sine of an imaginary argument; decay beyond e^-20 is cut off, where nothing gets through.
#[shade]
pub fn evanescent_half_phase<R: Real>(
    /// Decay over the film's thickness, >= 0.
    decay: R,
) -> HalfPhase<R> {
    let growth = decay.min(20.0).exp();
    let shrinkage = 1.0 / growth;
    let hyperbolic_sine = (growth - shrinkage) * 0.5;
    let hyperbolic_cosine = (growth + shrinkage) * 0.5;
    HalfPhase {
        sine_squared: -(hyperbolic_sine * hyperbolic_sine),
        sine_cosine: -(hyperbolic_sine * hyperbolic_cosine),
    }
}

/// Airy reflectance of the film in unpolarised light at one wavelength, the mean of both polarisations.
///
/// Source: Yeh 2005, section 4.1; Belcour and Barla 2017, equation 3, summed over all orders.
#[shade]
pub fn airy_reflectance<R: Real>(
    /// Whether the film may reflect totally.
    #[constant]
    total_reflection: bool,
    /// Terms for s polarisation.
    s: AiryTerms<R>,
    /// Terms for p polarisation.
    p: AiryTerms<R>,
    /// Square of the normal wave vector component in the film.
    q2_squared: R,
    /// Half the phase of one round trip in the film, radians.
    phase: R,
) -> R {
    let is_total_reflection = q2_squared.less_than(R::lit(0.0));
    let half = half_phase(total_reflection, is_total_reflection, phase);
    let transmittance = |terms: AiryTerms<R>| {
        let denominator = terms.offset + terms.contrast * half.sine_squared + terms.absorption * half.sine_cosine;
        terms.transmitted / denominator.max(R::lit(1e-30))
    };
    1.0 - (transmittance(s) + transmittance(p)) * 0.5
}
