//! Reflectance of a film by a form that was fitted to one scene: indices fixed, thickness free.
//!
//! With the indices fixed, what the Fresnel formulas give depends on the angle alone, and smoothly: in
//! `y = 1 / (cos(theta1) + a)` it is a polynomial `P(y)` of degree 2 to 4. Waves at a few wave numbers `nu_k`, with a
//! weight `w_k` for each channel and a common window, stand for the integral over the spectrum. One kernel serves both
//! polarisations. With
//!
//! `D = d sqrt(n2^2 - n1^2 sin^2(theta1))`, `phi_k = 4 pi nu_k D`, `g = exp(-decay D^2)`,
//!
//! | form | reflectance |
//! |---|---|
//! | [`FittedForm::AngleOnly`] | `P0` |
//! | [`FittedForm::FirstOrder`] | `P0 - P1 g sum w cos(phi)` |
//! | [`FittedForm::Kernel`] | `P0 - P1 sqrt(1 - X^2) sum w / (1 - X cos(phi))`, `X = P2 g` |
//! | [`FittedForm::DampedKernel`] | `P0 - P1 h sum w (cos(phi) - B) / (1 + B^2 - 2 B cos(phi))`, `B = P2 q`, `q = g^p e^(-s D)`, `h = min(g, t q)` |
//! | the same with a first order of its own | and besides `- P3 h sum w cos(phi)` |
//! | [`FittedForm::ThreeOrders`] | `P0 - sum w sum_(m = 1 .. 3) g^(m^2) (A_m cos(m phi) + B_m sin(m phi))` |
//!
//! The kernels sum all orders of interference, each order damped by a power of the window: [`FittedForm::Kernel`] is
//! Poisson's, with order m as `X^m`; [`FittedForm::DampedKernel`] is the real part of `z / (1 - B z)`, `z = e^(i phi)`, with
//! order m as `h B^(m - 1)`, and loses no digits where the window closes.
//!
//! Source: fitted to the scene, by `pavo-fit`, against the exact spectral reflectance; the sum over orders is that of
//! Belcour and Barla 2017, equation 5.

use core::f64::consts::PI;
use pavo_shade::{Real, Scalar, Value, Vector, shade};

/// Coefficients of a polynomial in `y = 1 / (cos(theta1) + a)`, of ascending degree, at least one.
pub type AnglePolynomial = Vec<f64>;

/// A film whose reflectance was fitted.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FittedFilm {
    /// Refractive index of the ambient medium.
    pub ambient_ior: f64,
    /// Refractive index of the film, above that of the ambient medium.
    pub film_ior: f64,
    /// The thicknesses that were fitted, nm: the smallest and the largest.
    pub thickness_nm: [f64; 2],
    /// `a` in `y = 1 / (cos(theta1) + a)`, above 0.
    pub angle_offset: f64,
    /// Decay of the window with the square of D, 1/nm^2.
    pub window_decay: f64,
    /// `P0`.
    pub mean: FittedMean,
    /// What interferes, and how.
    pub form: FittedForm,
    /// The waves; none in [`FittedForm::AngleOnly`].
    pub nodes: Vec<FittedNode>,
}

/// The part of the reflectance that does not depend on the thickness, as a function of the angle.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FittedMean {
    /// One for all channels.
    Shared(AnglePolynomial),
    /// One for each channel: coefficients of ascending degree.
    PerChannel(Vec<[f64; 3]>),
}

/// One wave of the sum that stands for the integral over the spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FittedNode {
    /// Wave number in vacuum, 1/nm.
    pub wave_number: f64,
    /// What is added to its phase, radians.
    pub phase: f64,
    /// Share in each output channel.
    pub weight: [f64; 3],
}

/// How the interference is written. The names of the polynomials are those of the module's table.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FittedForm {
    /// No interference: for a film of one thickness.
    AngleOnly,
    /// The first order of interference alone.
    FirstOrder {
        /// `P1`.
        contrast: AnglePolynomial,
    },
    /// All orders by a kernel that is damped by the window once.
    Kernel {
        /// `P1`.
        contrast: AnglePolynomial,
        /// `P2`, within -1 and 1 at every angle.
        sharpness: AnglePolynomial,
    },
    /// All orders by a kernel whose higher orders are damped more than the first.
    DampedKernel {
        /// `P1`.
        contrast: AnglePolynomial,
        /// `P2`, the amplitude of a round trip, within -1 and 1 at every angle.
        round_trip: AnglePolynomial,
        /// `p`.
        exponent: f64,
        /// `s`, 1/nm: what a round trip loses with D, beside the window.
        damping_slope: f64,
        /// Logarithm of `t`, above 0: how far the window closes before it closes faster, as `q`.
        log_taper: f64,
        /// `P3`, what the first order has over the kernel's, if that is separate.
        first_order: Option<AnglePolynomial>,
    },
    /// Three orders, each with the phase that an absorbing base gives it.
    ThreeOrders {
        /// `A_1`, `A_2`, `A_3`.
        cosines: [AnglePolynomial; 3],
        /// `B_1`, `B_2`, `B_3`.
        sines: [AnglePolynomial; 3],
    },
}

/// The smallest cosine that fits are made for.
const LEAST_COSINE: f64 = 0.01;

/// Reflectance of a thin film in unpolarised light as a linear colour, with indices and the range of thickness fixed.
///
/// Source: fitted to this scene's exact spectral reflectance, over cos(theta1) from 0.01 to 1 and the scene's range of
/// thickness; it does not hold for other media or thicknesses.
#[shade]
pub fn fitted_reflectance<S: Scalar>(
    /// The coefficients.
    #[constant]
    fit: &FittedFilm,
    /// Cosine of the angle between half vector and light, [0, 1].
    cos_theta1: S,
    /// Thickness of the film, nm, within the range that was fitted.
    thickness_nm: S,
) -> S::Vec3 {
    let y = 1.0 / (cos_theta1 + S::lit(fit.angle_offset));
    let mean = angle_mean(&fit.mean, y);
    if fit.form == FittedForm::AngleOnly {
        return mean;
    }
    let ambient_squared = fit.ambient_ior * fit.ambient_ior;
    let contrast_squared = (fit.film_ior - fit.ambient_ior) * (fit.film_ior + fit.ambient_ior);
    let q2 = (S::lit(ambient_squared) * (cos_theta1 * cos_theta1) + S::lit(contrast_squared)).sqrt();
    let path_nm = thickness_nm * q2;
    let log_window = S::lit(-fit.window_decay) * (path_nm * path_nm);
    match &fit.form {
        FittedForm::AngleOnly => mean,
        FittedForm::FirstOrder { contrast } => {
            let amplitude = polynomial(contrast, y) * log_window.exp();
            let waves = sum::<S>(&fit.nodes, path_nm, |phase| phase.cos());
            mean - waves * amplitude
        }
        FittedForm::Kernel { contrast, sharpness } => {
            let kernel_sharpness = held_polynomial(sharpness, y, fit.angle_offset) * log_window.exp();
            let amplitude = polynomial(contrast, y) * (1.0 - kernel_sharpness * kernel_sharpness).sqrt();
            let kernels = sum::<S>(&fit.nodes, path_nm, |phase| 1.0 / (1.0 - kernel_sharpness * phase.cos()));
            mean - kernels * amplitude
        }
        FittedForm::DampedKernel { contrast, round_trip, exponent, damping_slope, log_taper, first_order } => {
            let log_damping = S::lit(*exponent) * log_window - S::lit(*damping_slope) * path_nm;
            let window = log_window.min(log_damping + S::lit(*log_taper)).exp();
            let amplitude = polynomial(contrast, y) * window;
            let trip = held_polynomial(round_trip, y, fit.angle_offset) * log_damping.exp();
            let offset = 1.0 + trip * trip;
            let doubled = 2.0 * trip;
            let kernel = |cosine: S| (cosine - trip) / (offset - doubled * cosine);
            match first_order {
                None => mean - sum::<S>(&fit.nodes, path_nm, |phase| kernel(phase.cos())) * amplitude,
                Some(first_order) => {
                    let correction = polynomial(first_order, y) * window;
                    mean - sum::<S>(&fit.nodes, path_nm, |phase| {
                        let cosine = phase.cos();
                        amplitude * kernel(cosine) + correction * cosine
                    })
                }
            }
        }
        FittedForm::ThreeOrders { cosines, sines } => {
            // As polynomials in the cosine: cos(2 x) = 2 c^2 - 1, cos(3 x) = 4 c^3 - 3 c, sin(2 x) = 2 s c,
            // sin(3 x) = s (4 c^2 - 1).
            let window = log_window.exp();
            let window_2 = (window * window) * (window * window);
            let window_3 = (window_2 * window_2) * window;
            let cosine_2 = polynomial(&scaled(&cosines[1], 2), y) * window_2;
            let cosine_3 = polynomial(&scaled(&cosines[2], 4), y) * window_3;
            let cosine_1 = polynomial(&cosines[0], y) * window - 0.75 * cosine_3;
            let sine_2 = polynomial(&scaled(&sines[1], 2), y) * window_2;
            let sine_3 = polynomial(&scaled(&sines[2], 4), y) * window_3;
            let sine_1 = polynomial(&sines[0], y) * window - 0.25 * sine_3;
            let cosine_0 = 0.5 * cosine_2;
            let waves = sum::<S>(&fit.nodes, path_nm, |phase| {
                let cosine = phase.cos();
                let even = cosine * (cosine_1 + cosine * (cosine_2 + cosine * cosine_3)) - cosine_0;
                even + phase.sin() * (sine_1 + cosine * (sine_2 + cosine * sine_3))
            });
            mean - waves
        }
    }
}

/// A polynomial by Horner's rule; 0 without coefficients.
fn polynomial<S: Real>(coefficients: &[f64], y: S) -> S {
    let mut descending = coefficients.iter().rev();
    let highest = S::lit(descending.next().copied().unwrap_or(0.0));
    descending.fold(highest, |value, &coefficient| value * y + S::lit(coefficient))
}

/// The same for an amplitude of a kernel, which divides by 0 at 1: closer to grazing than the samples of the fit it is held
/// at the largest that it has among them. Where it does not leave that, nothing is held.
fn held_polynomial<S: Real>(coefficients: &[f64], y: S, angle_offset: f64) -> S {
    const SAMPLES: usize = 256;
    let at = |cosine: f64| polynomial(coefficients, 1.0 / (cosine + angle_offset));
    let over =
        |from: f64, to: f64| (0..=SAMPLES).map(move |index| from + (to - from) * index as f64 / SAMPLES as f64).map(at);
    let largest = over(LEAST_COSINE, 1.0).map(f64::abs).fold(0.0, f64::max);
    let value = polynomial(coefficients, y);
    if over(0.0, LEAST_COSINE).any(|beyond| beyond > largest) {
        value.min(S::lit(largest))
    } else if over(0.0, LEAST_COSINE).any(|beyond| beyond < -largest) {
        value.max(S::lit(-largest))
    } else {
        value
    }
}

fn scaled(coefficients: &[f64], factor: u32) -> AnglePolynomial {
    coefficients.iter().map(|coefficient| coefficient * f64::from(factor)).collect()
}

/// The part that does not depend on the thickness.
fn angle_mean<S: Scalar>(mean: &FittedMean, y: S) -> S::Vec3 {
    match mean {
        FittedMean::Shared(coefficients) => S::Vec3::splat(polynomial(coefficients, y)),
        FittedMean::PerChannel(coefficients) => {
            let mut descending = coefficients.iter().rev();
            let highest = S::Vec3::lit3(descending.next().copied().unwrap_or([0.0; 3]));
            descending.fold(highest, |value, &coefficient| value * y + S::Vec3::lit3(coefficient))
        }
    }
}

/// The sum over the nodes of a function of the phase, times the node's weights.
fn sum<S: Scalar>(nodes: &[FittedNode], path_nm: S, of_phase: impl Fn(S) -> S) -> S::Vec3 {
    let mut reflected = S::Vec3::lit(0.0);
    for node in nodes {
        let phase = (S::lit(4.0 * PI * node.wave_number) * path_nm + S::lit(node.phase)).named("phase");
        reflected = (reflected + S::Vec3::lit3(node.weight) * of_phase(phase).named("wave")).named("reflected");
    }
    reflected
}
