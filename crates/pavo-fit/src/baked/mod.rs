//! Quotients of polynomials over the angle, for films of one thickness.
//!
//! In `t = 2 cos(theta1) - 1` each channel is `P(t) / Q(t)`, the constant term of `Q` being 1. [`rational`] fits both by
//! least squares: the equation `P - R Q = 0` is linear in the coefficients, and each row is divided by the `Q` of the round
//! before, so that the residual becomes that of the quotient (Sanathanan and Koerner 1963, "Transfer function synthesis as
//! a ratio of two complex polynomials"). Both are sums of Chebyshev's polynomials while they are fitted.
//!
//! A quotient may have a pole where it is to be used. Each `Q` is proved to stay above [`LEAST_DENOMINATOR`] over all angles
//! with a margin, or else the fit is refused: a polynomial of as many coefficients then serves.

mod chebyshev;
mod denominator;

use core::f64::consts::PI;
use nalgebra::{DMatrix, DVector};
use pavo_optics::BakedFilm;
use pavo_optics::baked::baked;
use thiserror::Error;

use self::chebyshev::{chebyshev, powers};
use self::denominator::place_below;

/// What a denominator stays above, its value at `t = 0` being 1. A resonance at grazing incidence brings it down to some
/// hundredths; `f32` holds a quotient by a thousandth to 1e-4.
pub const LEAST_DENOMINATOR: f64 = 2e-3;

/// The rounds of reweighting; the best is kept.
const ROUNDS: usize = 8;

/// Singular values below this part of the largest count as none.
const SMALLEST_SINGULAR: f64 = 1e-13;

/// Why there is no quotient.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum RationalError {
    /// Fewer samples than coefficients.
    #[error(
        "{given} samples are too few for {needed} coefficients for each channel; take three times as many, or more"
    )]
    Samples {
        /// The number of coefficients.
        needed: usize,
        /// The number of samples.
        given: usize,
    },
    /// A sample, or a coefficient, that is no finite number.
    #[error("a sample or a coefficient is not a finite number")]
    NotFinite,
    /// The denominator vanishes, or nearly.
    #[error(
        "the denominator of channel {channel} falls to {denominator:.4} at cos(theta1) = {cosine:.4}: the quotient has a \
         pole there or close by; take lower degrees, or a polynomial"
    )]
    Pole {
        /// The channel, from 0.
        channel: usize,
        /// The cosine of the angle of incidence.
        cosine: f64,
        /// The denominator there.
        denominator: f64,
    },
}

/// Errors over samples and channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BakedErrors {
    /// Root of the mean square.
    pub rms: f64,
    /// The largest.
    pub max: f64,
}

/// So many cosines of angles of incidence from 0 to 1, both included, denser towards the ends as Chebyshev's points are: for
/// the samples of a fit.
pub fn cosines(count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|index| 0.5 - 0.5 * (PI * index as f64 / last).cos()).collect()
}

/// The quotient of least squares over samples: cosines of angles of incidence within [0, 1] ([`cosines`] gives good ones)
/// with the reflectance at each. A denominator of degree 0 gives a polynomial.
///
/// # Errors
/// Too few samples, a sample that is not finite, or a denominator that vanishes within the range, or nearly.
pub fn rational(
    samples: &[(f64, [f64; 3])],
    numerator_degree: usize,
    denominator_degree: usize,
) -> Result<BakedFilm, RationalError> {
    let needed = numerator_degree + denominator_degree + 1;
    if samples.len() < needed {
        return Err(RationalError::Samples { needed, given: samples.len() });
    }
    if samples.iter().any(|(cosine, values)| !(cosine.is_finite() && values.iter().all(|value| value.is_finite()))) {
        return Err(RationalError::NotFinite);
    }
    let mut film = BakedFilm {
        coefficients: vec![[0.0; 3]; numerator_degree + 1],
        denominator: vec![[0.0; 3]; denominator_degree],
    };
    for channel in 0..3 {
        let values = DVector::from_iterator(samples.len(), samples.iter().map(|(_, values)| values[channel]));
        let places: Vec<f64> = samples.iter().map(|(cosine, _)| 2.0 * cosine - 1.0).collect();
        let (numerator, divisor) = quotient(&places, &values, numerator_degree, denominator_degree);
        let (numerator, divisor) = (powers(&numerator), powers(&divisor));
        let scale = 1.0 / divisor[0];
        if !scale.is_finite() {
            return Err(RationalError::Pole { channel, cosine: 0.5, denominator: 0.0 });
        }
        let divisor: Vec<f64> = divisor.iter().map(|coefficient| coefficient * scale).collect();
        if let Some((t, denominator)) = place_below(&divisor, LEAST_DENOMINATOR) {
            return Err(RationalError::Pole { channel, cosine: 0.5 * (t + 1.0), denominator });
        }
        for (row, coefficient) in film.coefficients.iter_mut().zip(&numerator) {
            row[channel] = coefficient * scale;
        }
        for (row, coefficient) in film.denominator.iter_mut().zip(&divisor[1..]) {
            row[channel] = *coefficient;
        }
    }
    let is_finite = film.coefficients.iter().chain(&film.denominator).flatten().all(|number| number.is_finite());
    if is_finite { Ok(film) } else { Err(RationalError::NotFinite) }
}

/// The quotient or the polynomial with so many coefficients for each channel that comes closest to the samples in `f32`: a
/// quotient whose denominator may vanish is passed over, a polynomial has none.
///
/// # Errors
/// Too few samples, or one that is not finite.
pub fn closest(samples: &[(f64, [f64; 3])], coefficients: usize) -> Result<BakedFilm, RationalError> {
    let degree = coefficients.max(1) - 1;
    let mut best = rational(samples, degree, 0)?;
    let mut least = errors(&best, samples).rms;
    for denominator in 1..=coefficients / 2 {
        let Ok(film) = rational(samples, degree - denominator, denominator) else { continue };
        let rms = errors(&film, samples).rms;
        if rms < least {
            (best, least) = (film, rms);
        }
    }
    Ok(best)
}

/// The errors of a film, evaluated in `f32`, over samples: others than those of its fit show what it is worth.
pub fn errors(film: &BakedFilm, samples: &[(f64, [f64; 3])]) -> BakedErrors {
    let (mut squares, mut max) = (0.0, 0.0_f64);
    for (cosine, values) in samples {
        for (found, value) in baked::<f32>(film, *cosine as f32).to_array().into_iter().zip(values) {
            let error = (f64::from(found) - value).abs();
            squares += error * error;
            max = if error.is_nan() { f64::INFINITY } else { max.max(error) };
        }
    }
    BakedErrors { rms: (squares / (3 * samples.len()).max(1) as f64).sqrt(), max }
}

/// Numerator and denominator of one channel, as coefficients of Chebyshev's polynomials; that of the denominator's first
/// is 1.
fn quotient(places: &[f64], values: &DVector<f64>, numerator: usize, denominator: usize) -> (Vec<f64>, Vec<f64>) {
    let columns = numerator + 1 + denominator;
    let terms: Vec<Vec<f64>> = places.iter().map(|&t| chebyshev(t, numerator.max(denominator))).collect();
    let evaluate = |coefficients: &[f64], row: usize| -> f64 {
        coefficients.iter().zip(&terms[row]).map(|(coefficient, term)| coefficient * term).sum()
    };
    let mut scales = DVector::from_element(places.len(), 1.0);
    let mut best = (f64::INFINITY, vec![0.0; numerator + 1], vec![1.0]);
    for _ in 0..ROUNDS {
        let matrix = DMatrix::from_fn(places.len(), columns, |row, column| {
            let entry = match column.checked_sub(numerator) {
                None | Some(0) => terms[row][column],
                Some(order) => -values[row] * terms[row][order],
            };
            entry * scales[row]
        });
        let decomposition = matrix.svd(true, true);
        let smallest = SMALLEST_SINGULAR * decomposition.singular_values.max();
        let Ok(solution) = decomposition.solve(&values.component_mul(&scales), smallest) else { break };
        let (above, below) = solution.as_slice().split_at(numerator + 1);
        let divisor: Vec<f64> = core::iter::once(1.0).chain(below.iter().copied()).collect();
        let divisors: Vec<f64> = (0..places.len()).map(|row| evaluate(&divisor, row)).collect();
        let error = |row: usize| evaluate(above, row) / divisors[row] - values[row];
        let squares: f64 = (0..places.len()).map(|row| error(row).powi(2)).sum();
        if squares < best.0 {
            best = (squares, above.to_vec(), divisor);
        }
        if denominator == 0 || !squares.is_finite() {
            break;
        }
        scales = DVector::from_iterator(places.len(), divisors.iter().map(|divisor| 1.0 / divisor.abs().max(1e-6)));
    }
    (best.1, best.2)
}
