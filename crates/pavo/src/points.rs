//! Points over the ranges of a surface's inputs.

use pavo_shade::Input;

/// `count` points spread evenly over the ranges, each with a number per component of each input. The same seed gives the
/// same points.
///
/// Source: the additive recurrence with the powers of the generalised golden ratio, Roberts 2018, "The Unreasonable
/// Effectiveness of Quasirandom Sequences".
pub fn spread(inputs: &[Input], count: usize, seed: u64) -> Vec<Vec<f64>> {
    let ranges: Vec<[f64; 2]> =
        inputs.iter().flat_map(|input| std::iter::repeat_n([input.low, input.high], input.components())).collect();
    let steps = steps(ranges.len());
    let offset = (seed as f64 * 0.754_877_666_246_692_8).fract();
    let point = |index: usize| {
        let fractions = steps.iter().map(|step| (0.5 + offset + step * (index + 1) as f64).fract());
        fractions.zip(&ranges).map(|(fraction, [low, high])| low + (high - low) * fraction).collect()
    };
    (0..count).map(point).collect()
}

/// The steps of the recurrence: powers of the inverse of the root of `x^(d + 1) = x + 1`.
pub(crate) fn steps(dimensions: usize) -> Vec<f64> {
    let mut root = 2.0_f64;
    for _ in 0..64 {
        root = (1.0 + root).powf(1.0 / (dimensions as f64 + 1.0));
    }
    (1..=dimensions).map(|power| root.powi(-(power as i32))).collect()
}

/// Where each number that a program takes stands in a point of the declared inputs.
#[cfg(feature = "cli")]
pub(crate) fn columns(declared: &[Input], taken: &[Input]) -> Vec<usize> {
    let mut columns = Vec::new();
    let mut offset = 0;
    for input in declared {
        if taken.iter().any(|other| other.name == input.name) {
            columns.extend(offset..offset + input.components());
        }
        offset += input.components();
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::spread;
    use pavo_shade::{Input, Rate};

    #[test]
    fn points_fill_the_ranges_evenly() {
        let inputs = [
            Input::scalar("cos_theta1", "", 0.05, 1.0, Rate::Pixel),
            Input::scalar("thickness_nm", "nm", 0.0, 1200.0, Rate::Pixel),
        ];
        let points = spread(&inputs, 4000, 1);
        let mut cells = [0; 16];
        for point in &points {
            assert!((0.05..=1.0).contains(&point[0]) && (0.0..=1200.0).contains(&point[1]), "{point:?}");
            let column = ((point[0] - 0.05) / 0.95 * 4.0) as usize;
            cells[column.min(3) * 4 + ((point[1] / 300.0) as usize).min(3)] += 1;
        }
        assert!(cells.iter().all(|&count| (240..=260).contains(&count)), "{cells:?}");
        assert_eq!(points, spread(&inputs, 4000, 1));
        assert_ne!(points[0], spread(&inputs, 4000, 2)[0]);
    }
}
