//! The series over orders, truncated, with the sensitivities as equally spaced wave numbers under a Gaussian window: the
//! cheapest sum where the contrast at the film's boundaries is low, and one or two orders are all there is.
//!
//! `R_j = 1 - Q - 2 Q Re sum_(m = 1 .. M) b^m g^(m^2) sum_k w_jk e^(i m omega_k D)`.

use crate::film::{BaseWave, FilmTerms, Media};
use crate::poles::both_series_terms;
use crate::series::order_amplitudes;
use crate::windowed::{Window, phases};
use pavo_shade::{Lanes, Scalar, Value, Vector};

/// Reflectance of the film by a truncated sum of cosines.
pub fn cosines_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    window: &Window,
    order: usize,
    terms: FilmTerms<R>,
    media: Media<S>,
    q2: S,
    base: BaseWave<R>,
    opd_nm: S,
) -> S::Vec3 {
    let [s, p] = both_series_terms(terms, media, q2, base);
    let average = R::lit(1.0) - (s.transmittance + p.transmittance) * R::lit(0.5);
    let mut color = average.into_vec3();
    for (index, amplitude) in order_amplitudes(order, s, p).into_iter().enumerate() {
        let m = (index + 1) as f64;
        let spread = (opd_nm * S::lit(m / window.width_nm)).named("spread");
        let g = (-(spread * spread)).exp().named("window");
        let damped = amplitude.map(|part| part * R::from_scalar(g));
        let [re, im] = [damped[0].named("order"), damped[1].named("order_im")];
        for ([cosine, sine], weight) in phases(window, S::lit(m) * opd_nm).into_iter().zip(&window.weights) {
            let node = re * R::from_scalar(cosine) - im * R::from_scalar(sine);
            color = (color - S::Vec3::lit3(*weight) * node.into_vec3()).named("color");
        }
    }
    color
}
