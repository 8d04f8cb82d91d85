//! Chebyshev's polynomials: `T_0 = 1`, `T_1 = t`, `T_(n+1) = 2 t T_n - T_(n-1)`.

/// Their values at a place, from the first up to a degree.
pub(super) fn chebyshev(t: f64, degree: usize) -> Vec<f64> {
    let mut values = vec![1.0, t];
    while values.len() <= degree {
        values.push(2.0 * t * values[values.len() - 1] - values[values.len() - 2]);
    }
    values.truncate(degree + 1);
    values
}

/// The coefficients of the powers of t of a sum of Chebyshev's polynomials (Clenshaw's recurrence on polynomials).
pub(super) fn powers(coefficients: &[f64]) -> Vec<f64> {
    let count = coefficients.len();
    let (mut last, mut before) = (vec![0.0; count], vec![0.0; count]);
    for order in (0..count).rev() {
        let factor = if order == 0 { 1.0 } else { 2.0 };
        let shifted = |power: usize| if power == 0 { 0.0 } else { factor * last[power - 1] };
        let mut next: Vec<f64> = (0..count).map(|power| shifted(power) - before[power]).collect();
        next[0] += coefficients[order];
        before = core::mem::replace(&mut last, next);
    }
    last
}

#[cfg(test)]
mod tests {
    use super::{chebyshev, powers};

    #[test]
    fn powers_and_recurrence_agree() {
        let coefficients = [0.3, -0.7, 0.2, 0.05, -0.4, 0.11];
        let powers = powers(&coefficients);
        for t in [-1.0, -0.6, 0.0, 0.31, 1.0] {
            let sum: f64 = coefficients.iter().zip(chebyshev(t, 5)).map(|(a, b)| a * b).sum();
            let horner = powers.iter().rev().fold(0.0, |value, coefficient| value * t + coefficient);
            assert!((sum - horner).abs() < 1e-14, "{sum} {horner}");
        }
    }
}
