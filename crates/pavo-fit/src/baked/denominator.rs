//! Whether a denominator stays away from 0.

/// How far past -1 and 1 it must: rounding of a cosine leads that far, and more.
const MARGIN: f64 = 1e-3;

/// The narrowest part of the range that is looked into: there the value in the middle decides.
const NARROWEST: f64 = 1e-7;

/// A place within -1 and 1, with a margin, where a polynomial of ascending coefficients is not above a limit, and its value
/// there; `None` is a proof that there is no such place: over each part of the range the value in the middle exceeds the
/// limit by more than the largest slope allows it to fall.
pub(super) fn place_below(coefficients: &[f64], limit: f64) -> Option<(f64, f64)> {
    let end = 1.0 + MARGIN;
    let value = |t: f64| coefficients.iter().rev().fold(0.0, |value, coefficient| value * t + coefficient);
    let steepest: f64 = coefficients
        .iter()
        .enumerate()
        .skip(1)
        .map(|(power, coefficient)| power as f64 * coefficient.abs() * end.powi(power as i32 - 1))
        .sum();
    let mut parts = vec![(0.0, end)];
    while let Some((middle, half)) = parts.pop() {
        let at = value(middle);
        if at.is_nan() || at <= limit {
            return Some(if at < 0.0 { root(&value, middle) } else { (middle, at) });
        }
        if at - steepest * half > limit {
            continue;
        }
        if half > NARROWEST {
            let quarter = 0.5 * half;
            parts.extend([(middle + quarter, quarter), (middle - quarter, quarter)]);
        }
    }
    None
}

/// A root between 0, where the polynomial is 1, and a place where it is negative, with the value there.
fn root(value: &dyn Fn(f64) -> f64, negative: f64) -> (f64, f64) {
    let (mut above, mut below) = (0.0, negative);
    for _ in 0..60 {
        let middle = 0.5 * (above + below);
        *(if value(middle) > 0.0 { &mut above } else { &mut below }) = middle;
    }
    (above, value(above))
}

#[cfg(test)]
mod tests {
    use super::place_below;

    #[test]
    fn poles_within_the_range_and_close_by_are_found() {
        // 1 - t / 0.8, 1 + t, a double root that is no change of sign, and a narrow dip.
        for (coefficients, root) in [
            (vec![1.0, -1.25], 0.8),
            (vec![1.0, 1.0], -1.0),
            (vec![1.0, -4.0, 4.0], 0.5),
            (vec![1.0, -3.332, 2.778_889], 0.6),
        ] {
            let (place, value) = place_below(&coefficients, 0.05).expect("it has one");
            assert!((place - root).abs() < 0.3 && value <= 0.05, "{coefficients:?}: {place} {value}");
        }
        assert_eq!(place_below(&[1.0, f64::NAN], 0.05).map(|(place, _)| place), Some(0.0));
    }

    #[test]
    fn denominators_away_from_zero_are_proved_to_be() {
        for coefficients in [vec![1.0], vec![1.0, 0.9], vec![1.0, -1.7, 0.8], vec![1.0, 0.0, -0.9, 0.0, 0.3]] {
            assert_eq!(place_below(&coefficients, 0.05), None, "{coefficients:?}");
        }
    }
}
