//! The points of a fit: spread over angle and thickness, and along the edges.

use pavo_spectra::Point;

/// The smallest cosine that is fitted. Closer to grazing the reflectance goes to 1 faster than any of the forms.
pub(super) const LEAST_COS: f64 = 0.01;

/// The steps of the spread: powers of the inverse of the root of `x^3 = x + 1`.
///
/// Source: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences".
const STEPS: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];

/// `inner` points within the ranges and `edge` along each of three edges: grazing incidence, the smallest and the largest
/// thickness. `shift` moves all of them: other shifts give other points.
pub(super) fn spread(thickness_nm: [f64; 2], inner: usize, edge: usize, shift: f64) -> Vec<Point> {
    let [thinnest, thickest] = thickness_nm;
    let point = |cos: f64, thickness: f64| {
        Point::new(LEAST_COS + (1.0 - LEAST_COS) * cos, thinnest + (thickest - thinnest) * thickness)
    };
    let fraction = |index: usize, step: f64| (shift + step * (index + 1) as f64).fract();
    let within = (0..inner).map(|index| point(fraction(index, STEPS[0]), fraction(index, STEPS[1])));
    let along = |index: usize| (index as f64 + shift.fract()) / edge as f64;
    let edges =
        (0..edge).flat_map(|index| [point(0.0, along(index)), point(along(index), 0.0), point(along(index), 1.0)]);
    within.chain(edges).collect()
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn points_lie_within_the_ranges_and_other_shifts_share_none() {
        let points = spread([100.0, 400.0], 500, 20, 0.1);
        assert_eq!(points.len(), 560);
        for point in &points {
            assert!((0.01..=1.0).contains(&point.cos_theta1) && (100.0..=400.0).contains(&point.thickness_nm));
        }
        let others = spread([100.0, 400.0], 500, 20, 0.6);
        assert!(points.iter().all(|point| !others.contains(point)));
    }
}
