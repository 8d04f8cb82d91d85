//! The series over orders, truncated, with the sensitivities as equally spaced wave numbers under a Gaussian window: the
//! cheapest sum where the contrast at the film's boundaries is low, and one or two orders are all there is.
//!
//! `R_j = 1 - Q - 2 Q Re sum_(m = 1 .. M) b^m g^(m^2) sum_k w_jk e^(i m omega_k D)`.

use crate::precision::Precision;
use crate::relative::RelativeFilm;
use crate::series::{both_series_terms, multiples, order_amplitudes, order_sum, powers_of_square};
use crate::windowed::{Window, closing, waves};
use pavo_shade::{Lanes, Scalar, Value};

/// Reflectance of the film by a truncated sum of cosines, at the optical path of one pass.
pub fn cosines_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    precision: Precision,
    window: &Window,
    order: usize,
    film: RelativeFilm<R>,
    path_nm: S,
) -> S::Vec3 {
    let [s, p] = both_series_terms(film);
    let average = R::lit(1.0) - (s.transmittance + p.transmittance) * R::lit(0.5);
    let mut reflected = precision.sum(average.into_vec3());
    let [g, _] = closing(window.width_nm, path_nm);
    let damping = powers_of_square(g, order, "window").into_iter().map(R::from_scalar);
    let amplitudes = order_amplitudes(order, s, p).into_iter().zip(damping);
    let damped: Vec<[R; 2]> =
        amplitudes.map(|([re, im], g)| [(re * g).named("damped"), (im * g).named("damped_im")]).collect();
    for ([cosine, sine], weight) in waves(window, path_nm).into_iter().zip(&window.weights) {
        let waves = multiples(cosine, sine, order).into_iter().map(|wave| wave.map(R::from_scalar));
        let node = order_sum(&damped, std::iter::repeat(R::lit(1.0)), waves);
        reflected = precision.sum(reflected - precision.weighted::<S>(*weight, node.into_vec3())).named("reflected");
    }
    reflected
}
