//! The series over orders of interference, with the spectral sensitivities as sums of Gaussians.
//!
//! With `r21`, `r23` the amplitude coefficients inside the film, `b = r21 r23` and
//! `Q = (1 - r12^2)(1 - |r23|^2) / (1 - r12^2 |r23|^2)` for each polarisation:
//!
//! `R_j = 1 - Q - 2 Q Re sum_(m = 1 .. M) b^m S_j(m D)`,
//!
//! where `D` is the optical path difference and `S_j` the Fourier transform of the sensitivity of channel j over the
//! wave number, `S_j(0) = 1`. It is the main result of Belcour and Barla 2017 with `C_0 = 1 - Q`, `C_m = -Q b^m`.

use crate::precision::Precision;
use crate::relative::{RelativeFilm, RelativeWaves};
use pavo_shade::{Lanes, Real, Scalar, Value, Vector, shade};

/// One Gaussian of the sensitivities over the wave number, as it appears in their Fourier transform:
/// `weight exp(-decay D^2) e^(i angular_wave_number D)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaussianTerm {
    /// Centre of the Gaussian for each output channel, 2 pi / wavelength, radians per nm.
    pub angular_wave_number: [f64; 3],
    /// Decay with the square of the optical path difference, 1/nm^2; half the variance of the Gaussian over the
    /// angular wave number. For each output channel.
    pub decay: [f64; 3],
    /// Share in each output channel.
    pub weight: [f64; 3],
}

/// The sensitivities of the output channels as a sum of Gaussians, which the channels may share or have each their own.
/// The weights of a channel add up to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct GaussianFit {
    /// The Gaussians.
    pub terms: Vec<GaussianTerm>,
}

/// Coefficients of the series for one polarisation.
#[shade]
pub struct SeriesTerms<R: Real> {
    /// `Q`: the transmittance of the film, averaged over the phase.
    pub transmittance: R,
    /// Real part of `b`: the amplitude that one more round trip leaves.
    pub round_trip: R,
    /// Imaginary part of `b`; 0 for a dielectric base.
    pub round_trip_im: R,
}

/// Coefficients of the series over orders for one polarisation: the transmittance averaged over the phase, and the
/// amplitude of one round trip.
///
/// Source: Belcour and Barla 2017, equations 6 and 7, for a complex base index.
#[shade]
pub fn series_terms<R: Real>(
    /// Wave vectors outside the film, over that in the film.
    waves: RelativeWaves<R>,
) -> SeriesTerms<R> {
    let ambient_sum = 1.0 + waves.ambient * waves.ambient;
    let base_sum = 1.0 + waves.base_squared;
    let entering = waves.ambient * waves.base;
    let mean = waves.base * ambient_sum + waves.ambient * base_sum;
    let ambient_difference = (2.0 - ambient_sum) / (ambient_sum * base_sum + 4.0 * entering + 2.0 * mean);
    SeriesTerms {
        transmittance: 4.0 * entering / mean,
        round_trip: ambient_difference * (1.0 - waves.base_squared),
        round_trip_im: -(2.0 * waves.base_decay * ambient_difference),
    }
}

/// Coefficients of the series for s and p polarisation.
pub fn both_series_terms<R: Real>(film: RelativeFilm<R>) -> [SeriesTerms<R>; 2] {
    [series_terms(film.s).named("series_s"), series_terms(film.p).named("series_p")]
}

/// Reflectance of the film by the series, up to an order.
pub fn series_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    precision: Precision,
    order: usize,
    fit: &GaussianFit,
    film: RelativeFilm<R>,
    opd_nm: S,
) -> S::Vec3 {
    let [s, p] = both_series_terms(film);
    let average = R::lit(1.0) - (s.transmittance + p.transmittance) * R::lit(0.5);
    let mut reflected = precision.sum(average.into_vec3());
    let amplitudes = order_amplitudes(order, s, p);
    let opd_squared = (opd_nm * opd_nm).named("opd_squared");
    for term in &fit.terms {
        let is_shared = |values: [f64; 3]| values[0] == values[1] && values[1] == values[2];
        let wave = if is_shared(term.angular_wave_number) && is_shared(term.decay) {
            let gaussian = (S::lit(-term.decay[0]) * opd_squared).exp().named("gaussian");
            let phase = (S::lit(term.angular_wave_number[0]) * opd_nm).named("phase");
            let damping = powers_of_square(gaussian, order, "gaussian").into_iter().map(R::from_scalar);
            let (cosine, sine) = (phase.cos().named("cosine"), phase.sin().named("sine"));
            let waves = multiples(cosine, sine, order).into_iter().map(|wave| wave.map(R::from_scalar));
            order_sum(&amplitudes, damping, waves).into_vec3()
        } else {
            let amplitudes: Vec<_> = amplitudes.iter().map(|amplitude| amplitude.map(R::into_vec3)).collect();
            let gaussian = S::Vec3::lit3(term.decay.map(|decay| -decay)) * S::Vec3::splat(opd_squared);
            let gaussian = gaussian.exp().named("gaussian");
            let phase = (S::Vec3::lit3(term.angular_wave_number) * S::Vec3::splat(opd_nm)).named("phase");
            let (cosine, sine) = (phase.cos().named("cosine"), phase.sin().named("sine"));
            let damping = powers_of_square(gaussian, order, "gaussian");
            order_sum(&amplitudes, damping, multiples(cosine, sine, order))
        };
        reflected = precision.sum(reflected - precision.weighted::<S>(term.weight, wave)).named("reflected");
    }
    reflected
}

/// What one wave number adds up to over the orders: the sum of `Re(amplitude_m damping_m e^(i m phase))`.
pub(crate) fn order_sum<R: Real>(
    amplitudes: &[[R; 2]],
    damping: impl IntoIterator<Item = R>,
    waves: impl IntoIterator<Item = [R; 2]>,
) -> R {
    let mut sum = R::lit(0.0);
    for (([re, im], damping), [cosine, sine]) in amplitudes.iter().zip(damping).zip(waves) {
        sum = (sum + damping * (*re * cosine - *im * sine)).named("wave");
    }
    sum
}

/// Cosine and sine of the multiples 1 to `count` of a phase, by `c_(m+1) = 2 c_1 c_m - c_(m-1)` and the same for the sine.
pub(crate) fn multiples<R: Real>(cosine: R, sine: R, count: usize) -> Vec<[R; 2]> {
    let mut waves = vec![[cosine, sine]];
    let doubled = (R::lit(2.0) * cosine).named("doubled_cosine");
    let mut previous = [R::lit(1.0), R::lit(0.0)];
    let mut current = [cosine, sine];
    while waves.len() < count {
        let next = |part: usize| doubled * current[part] - previous[part];
        let following = [next(0).named("cosine"), next(1).named("sine")];
        (previous, current) = (current, following);
        waves.push(following);
    }
    waves
}

/// `x`, `x^4`, `x^9` and so on, `count` of them: each is the one before it times `x^(2 m + 1)`.
pub(crate) fn powers_of_square<R: Real>(x: R, count: usize, name: &str) -> Vec<R> {
    let mut powers = vec![x];
    let square = x * x;
    let mut ratio = x;
    while powers.len() < count {
        ratio = (ratio * square).named(&format!("{name}_ratio"));
        powers.push((powers[powers.len() - 1] * ratio).named(name));
    }
    powers
}

/// `Q b^m` over both polarisations, for each order m from 1 on: real and imaginary part.
pub(crate) fn order_amplitudes<R: Real>(order: usize, s: SeriesTerms<R>, p: SeriesTerms<R>) -> Vec<[R; 2]> {
    let mut power_s = [s.transmittance * s.round_trip, s.transmittance * s.round_trip_im];
    let mut power_p = [p.transmittance * p.round_trip, p.transmittance * p.round_trip_im];
    let mut amplitudes = Vec::new();
    for m in 1..=order {
        if m > 1 {
            power_s = complex_product(power_s, [s.round_trip, s.round_trip_im]);
            power_p = complex_product(power_p, [p.round_trip, p.round_trip_im]);
        }
        power_s = [power_s[0].named("order_s"), power_s[1].named("order_s_im")];
        power_p = [power_p[0].named("order_p"), power_p[1].named("order_p_im")];
        amplitudes.push([(power_s[0] + power_p[0]).named("order"), (power_s[1] + power_p[1]).named("order_im")]);
    }
    amplitudes
}

fn complex_product<R: Real>(a: [R; 2], b: [R; 2]) -> [R; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}
