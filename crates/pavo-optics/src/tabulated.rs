//! The series over orders of interference with the exact Fourier transform of the sensitivities, read from tables.
//!
//! `S_j(D) = E_j(D) e^(i omega_j D)`: the carrier `omega_j` is the mean wave number of the channel, so that the envelope
//! `E_j` varies slowly and is read between two rows. Beyond the table's end the sensitivities have died away.

use crate::relative::RelativeFilm;
use crate::series::{both_series_terms, order_amplitudes};
use pavo_shade::{Lanes, Real, Scalar, Table, Value, Vector, shade};

/// The transform of the sensitivities at equal steps of the optical path difference.
#[derive(Clone, Debug, PartialEq)]
pub struct TransformTable {
    /// The step from row to row, nm.
    pub step_nm: f64,
    /// The carrier of each channel, radians per nm.
    pub carrier: [f64; 3],
    /// Real part of the envelope, by channel; at least two rows.
    pub re: Table,
    /// Imaginary part of the envelope, as many rows.
    pub im: Table,
}

/// Fourier transform of the sensitivities.
#[shade]
pub struct Sensitivity<V: Real> {
    /// Real part, by channel.
    pub re: V,
    /// Imaginary part, by channel.
    pub im: V,
}

/// Fourier transform of the sensitivities of the three channels over the wave number, at one optical path difference:
/// a slow envelope from tables, times a wave at the centre of each channel.
///
/// Source: Belcour and Barla 2017, section 3.3.
#[shade]
pub fn tabulated_sensitivity<S: Scalar>(
    /// The tables.
    #[constant]
    transform: &TransformTable,
    /// Optical path difference, nm, >= 0.
    opd_nm: S,
) -> Sensitivity<S::Vec3> {
    let last = transform.re.rows.len() as f64 - 1.0_f64;
    let place = (opd_nm * S::lit(1.0 / transform.step_nm)).min(S::lit(last));
    let row = place.floor().min(S::lit(last - 1.0));
    let next = row + 1.0;
    let fraction = S::Vec3::splat(place - row);
    let envelope_re = S::Vec3::mix(S::fetch(&transform.re, row), S::fetch(&transform.re, next), fraction);
    let envelope_im = S::Vec3::mix(S::fetch(&transform.im, row), S::fetch(&transform.im, next), fraction);
    let phase = S::Vec3::lit3(transform.carrier) * S::Vec3::splat(opd_nm);
    let cosine = phase.cos();
    let sine = phase.sin();
    Sensitivity { re: envelope_re * cosine - envelope_im * sine, im: envelope_re * sine + envelope_im * cosine }
}

/// Reflectance of the film by the series with the exact transform, up to an order.
pub fn tabulated_reflectance<S: Scalar, R: Lanes<S> + Value<Leaf = S::Leaf>>(
    order: usize,
    transform: &TransformTable,
    film: RelativeFilm<R>,
    opd_nm: S,
) -> S::Vec3 {
    let [s, p] = both_series_terms(film);
    let average = R::lit(1.0) - (s.transmittance + p.transmittance) * R::lit(0.5);
    let mut reflected = average.into_vec3();
    for (index, [re, im]) in order_amplitudes(order, s, p).into_iter().enumerate() {
        let m = S::lit((index + 1) as f64);
        let sensitivity = tabulated_sensitivity::<S>(transform, m * opd_nm).named("sensitivity");
        let interference = sensitivity.re * re.into_vec3() - sensitivity.im * im.into_vec3();
        reflected = (reflected - interference).named("reflected");
    }
    reflected
}
