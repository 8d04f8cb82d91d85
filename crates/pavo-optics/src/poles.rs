//! The series over orders summed to infinity, with the spectral sensitivities as sums of complex exponentials (poles).
//!
//! With `S_j(D) = sum_k w_jk e^((i omega_k - gamma_k) D)` each order of the series is a power of one complex number,
//! `y_k = b e^((i omega_k - gamma_k) D)`, and all orders add up in closed form:
//!
//! `R_j = 1 - Q - 2 Q Re sum_k w_jk y_k / (1 - y_k)`, averaged over both polarisations.
//!
//! `b` and `Q` are those of [`crate::series`].

use crate::precision::Precision;
use crate::relative::RelativeFilm;
use crate::series::{SeriesTerms, both_series_terms};
use pavo_shade::{Lanes, Real, Scalar, Value, shade};

/// One pole of the sensitivities: `weight e^((i angular_wave_number - decay) D)`, `D` in nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pole {
    /// Angular wave number, 2 pi / wavelength, radians per nm.
    pub angular_wave_number: f64,
    /// Decay with the optical path difference, 1/nm, > 0.
    pub decay: f64,
    /// Real part of the share in each output channel; over all poles the shares of a channel add up to 1.
    pub weight_re: [f64; 3],
    /// Imaginary part of the share; over all poles it adds up to 0.
    pub weight_im: [f64; 3],
}

/// The orders of interference at one pole, summed: `Q y / (1 - y)` over both polarisations.
#[shade]
pub struct Resonance<R: Real> {
    /// Real part.
    pub re: R,
    /// Imaginary part.
    pub im: R,
}

/// All orders of interference at one pole of the sensitivities, for both polarisations together: the sum of
/// `Q y / (1 - y)` with `y = b e^((i omega - gamma) D)`.
///
/// Source: the geometric series over orders of Belcour and Barla 2017, equation 9, for an exponential sensitivity.
#[shade]
pub fn pole_resonance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    /// Coefficients of the series for s polarisation.
    s: SeriesTerms<R>,
    /// Coefficients of the series for p polarisation.
    p: SeriesTerms<R>,
    /// Optical path difference, nm.
    opd_nm: S,
    /// Angular wave number omega of the pole, radians per nm.
    #[runtime]
    angular_wave_number: S,
    /// Decay gamma of the pole, 1/nm.
    #[runtime]
    decay: S,
) -> Resonance<R> {
    let damping = (-(decay * opd_nm)).exp();
    let phase = angular_wave_number * opd_nm;
    let cosine = damping * phase.cos();
    let sine = damping * phase.sin();
    let (cosine, sine) = (R::from_scalar(cosine), R::from_scalar(sine));
    let [s_re, s_im] = order_sum(s, cosine, sine, ["s_round_trip", "s_round_trip_im", "s_scale"]);
    let [p_re, p_im] = order_sum(p, cosine, sine, ["p_round_trip", "p_round_trip_im", "p_scale"]);
    Resonance { re: s_re + p_re, im: s_im + p_im }
}

/// `Q y / (1 - y)` for one polarisation, `y = b (cosine + i sine)`.
fn order_sum<R: Real>(terms: SeriesTerms<R>, cosine: R, sine: R, names: [&str; 3]) -> [R; 2] {
    let re = (terms.round_trip * cosine - terms.round_trip_im * sine).named(names[0]);
    let im = (terms.round_trip * sine + terms.round_trip_im * cosine).named(names[1]);
    let rest = R::lit(1.0) - re;
    let squares = im * im;
    let scale = (terms.transmittance / (rest * rest + squares).max(R::lit(1e-12))).named(names[2]);
    [scale * (re * rest - squares), scale * im]
}

/// Reflectance of the film by poles, all orders.
pub fn poles_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    precision: Precision,
    poles: &[Pole],
    film: RelativeFilm<R>,
    opd_nm: S,
) -> S::Vec3 {
    let [s, p] = both_series_terms(film);
    let average = R::lit(1.0) - (s.transmittance + p.transmittance) * R::lit(0.5);
    let mut reflected = precision.sum(average.into_vec3());
    for pole in poles {
        let omega = S::lit(pole.angular_wave_number);
        let resonance = pole_resonance::<S, R>(s, p, opd_nm, omega, S::lit(pole.decay)).named("resonance");
        let weighted = precision.sum(
            precision.weighted::<S>(pole.weight_re, resonance.re.into_vec3())
                - precision.weighted::<S>(pole.weight_im, resonance.im.into_vec3()),
        );
        reflected = precision.sum(reflected - weighted).named("reflected");
    }
    reflected
}
