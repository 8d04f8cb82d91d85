//! Polynomials over the angle for surfaces that are uniform.

use std::f64::consts::PI;

/// The coefficients of the polynomial of a degree through a function at Chebyshev's points, in powers of
/// `t = 2 cos(theta1) - 1`, by channel.
///
/// `values` holds the function at [`chebyshev_cosines`].
pub fn polynomial(values: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let count = values.len();
    let angle = |point: usize| PI * (point as f64 + 0.5) / count as f64;
    let chebyshev = (0..count).map(|order| -> [f64; 3] {
        std::array::from_fn(|channel| {
            let sum: f64 = (0..count).map(|point| values[point][channel] * (order as f64 * angle(point)).cos()).sum();
            sum * if order == 0 { 1.0 } else { 2.0 } / count as f64
        })
    });
    let mut coefficients = vec![[0.0; 3]; count];
    // T_0 = 1, T_1 = t, T_(n+1) = 2 t T_n - T_(n-1), each as its coefficients.
    let (mut before, mut current) = (vec![0.0; count], vec![0.0; count]);
    current[0] = 1.0;
    for (order, weight) in chebyshev.enumerate() {
        for (coefficient, power) in coefficients.iter_mut().zip(&current) {
            for channel in 0..3 {
                coefficient[channel] += weight[channel] * power;
            }
        }
        let doubled = if order == 0 { 1.0 } else { 2.0 };
        let shifted = |power: usize| if power == 0 { 0.0 } else { doubled * current[power - 1] };
        let next = (0..count).map(|power| shifted(power) - before[power]).collect();
        before = std::mem::replace(&mut current, next);
    }
    coefficients
}

/// The cosines at which a polynomial of this many coefficients is taken.
pub fn chebyshev_cosines(count: usize) -> Vec<f64> {
    (0..count).map(|point| 0.5 + 0.5 * (PI * (point as f64 + 0.5) / count as f64).cos()).collect()
}

#[cfg(test)]
mod tests {
    use super::{chebyshev_cosines, polynomial};

    #[test]
    fn a_polynomial_goes_through_a_polynomial() {
        let function = |cosine: f64| {
            let t = 2.0 * cosine - 1.0;
            [1.0 - t + 0.5 * t.powi(3), 0.25 * t.powi(4), 3.0]
        };
        let values: Vec<[f64; 3]> = chebyshev_cosines(6).into_iter().map(function).collect();
        let expected = [[1.0, 0.0, 3.0], [-1.0, 0.0, 0.0], [0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.25, 0.0], [0.0; 3]];
        for (found, expected) in polynomial(&values).iter().zip(expected) {
            for channel in 0..3 {
                assert!((found[channel] - expected[channel]).abs() < 1e-13, "{found:?} instead of {expected:?}");
            }
        }
    }
}
