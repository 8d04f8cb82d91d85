//! The error of a variant over a scene's ranges: at points spread over them, and at the worst point that a search finds.

use crate::inputs::ShadingQuantity;
use crate::media::MediaError;
use crate::points::spread;
use crate::scene::Scene;
use crate::shading::{Shading, ShadingError};
use crate::statistics::Difference;
use crate::variant::Variant;
use pavo_shade::Input;
use pavo_spectra::ColourSpace;
use pavo_spectra::delta_e::delta_e_of_linear;
use serde::{Deserialize, Serialize};

pub(super) const QUANTITY: ShadingQuantity = ShadingQuantity::Reflectance;

/// How many points are spread over the ranges, and along each edge of the angle.
const POINTS: usize = 3000;
const EDGE_POINTS: usize = 200;
/// The smallest cosine: closer to grazing incidence no light is left to see.
pub(super) const LEAST_COSINE: f64 = 0.01;
/// How many of the worst points a search starts from, how often it halves its steps, and its first step as a part of the
/// range.
const STARTS: usize = 6;
const HALVINGS: usize = 7;
const FIRST_STEP: f64 = 0.02;
/// Two of the worst points that are listed differ in some input by more than this part of its range.
const CLOSE: f64 = 0.04;

/// How far a variant is from the exact reference.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct VariantErrors {
    /// The largest absolute difference in any channel.
    pub max: f64,
    /// The root of the mean square difference over points and channels.
    pub rms: f64,
    /// The mean of CIEDE2000 under the scene's white.
    pub mean_delta_e: f64,
    /// Its 95th percentile.
    pub p95_delta_e: f64,
    /// The largest, that of the search included.
    pub max_delta_e: f64,
    /// The point with the largest, a number for each component of each input.
    pub worst_point: Vec<f64>,
}

/// A point where a variant is far from the exact reference.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorstPoint {
    /// The point, a number for each component of each input of the reflectance.
    pub inputs: Vec<f64>,
    /// The reflectance by the exact reference.
    pub exact: [f64; 3],
    /// The reflectance by the variant.
    pub found: [f64; 3],
    /// CIEDE2000 between them.
    pub delta_e: f64,
}

/// Compares variants of one scene with the exact reference, which is evaluated once.
pub struct Judge {
    space: ColourSpace,
    inputs: Vec<Input>,
    points: Vec<Vec<f64>>,
    expected: Vec<[f64; 3]>,
}

impl Judge {
    /// A judge of the variants of a scene.
    ///
    /// # Errors
    /// If the scene's data cannot be had.
    pub fn new(scene: &Scene) -> Result<Self, ShadingError> {
        // Any method has the same inputs.
        let shading = Shading::new(scene, &Variant::Spectral { count: 81 })?;
        let inputs = with_least_cosine(shading.inputs(QUANTITY));
        let mut points = spread(&inputs, POINTS, 11);
        for cosine in [LEAST_COSINE, 1.0] {
            let mut edge = inputs.clone();
            edge.iter_mut().filter(|input| input.name == "cos_theta1").for_each(|input| {
                (input.low, input.high) = (cosine, cosine);
            });
            points.extend(spread(&edge, EDGE_POINTS, 12));
        }
        let expected = shading.reference_each(QUANTITY, &points)?;
        let space = space(&shading);
        Ok(Self { space, inputs, points, expected })
    }

    /// The errors of a variant of the scene.
    ///
    /// # Errors
    /// If a point cannot be evaluated.
    pub fn errors(&self, shading: &Shading) -> Result<VariantErrors, MediaError> {
        let found = shading.evaluate_each(QUANTITY, &self.points);
        let difference = Difference::between(&found, &self.expected, 1);
        let differences = delta_e(&found, &self.expected, self.space);
        let order = descending(&differences);
        let mut summits = self.summits(shading, &differences, &order[..STARTS.min(order.len())])?;
        let (max_delta_e, worst_point) = if summits.is_empty() { (0.0, Vec::new()) } else { summits.swap_remove(0) };
        let at = |fraction: f64| differences[order[((1.0 - fraction) * order.len() as f64) as usize]];
        Ok(VariantErrors {
            max: difference.max,
            rms: difference.rms,
            mean_delta_e: self.mean_delta_e(&found),
            p95_delta_e: at(0.95),
            max_delta_e,
            worst_point,
        })
    }

    /// Points where a variant is furthest off, the worst first and none close to another: those that the search for the
    /// largest dE2000 finds.
    ///
    /// # Errors
    /// If a point cannot be evaluated.
    pub fn worst_points(&self, shading: &Shading, count: usize) -> Result<Vec<WorstPoint>, MediaError> {
        let found = shading.evaluate_each(QUANTITY, &self.points);
        let differences = delta_e(&found, &self.expected, self.space);
        let order = descending(&differences);
        let (first, rest) = order.split_at(STARTS.min(order.len()));
        let mut starts = first.to_vec();
        for &place in rest {
            if starts.len() == STARTS + count {
                break;
            }
            if starts.iter().all(|&other| self.are_apart(&self.points[place], &self.points[other])) {
                starts.push(place);
            }
        }
        let mut points: Vec<Vec<f64>> = Vec::new();
        for (_, point) in self.summits(shading, &differences, &starts)? {
            if points.len() < count && points.iter().all(|other| self.are_apart(&point, other)) {
                points.push(point);
            }
        }
        let expected = shading.reference_each(QUANTITY, &points)?;
        let found = shading.evaluate_each(QUANTITY, &points);
        let differences = delta_e(&found, &expected, self.space);
        let rows = points.into_iter().zip(expected).zip(found).zip(differences);
        Ok(rows.map(|(((inputs, exact), found), delta_e)| WorstPoint { inputs, exact, found, delta_e }).collect())
    }

    /// The points that are compared.
    pub(super) fn points(&self) -> &[Vec<f64>] {
        &self.points
    }

    /// The mean of CIEDE2000 between the scene's exact colours and others at the same points.
    pub(super) fn mean_delta_e(&self, colors: &[[f64; 3]]) -> f64 {
        let differences = delta_e(colors, &self.expected, self.space);
        differences.iter().sum::<f64>() / differences.len() as f64
    }

    /// The run-time inputs of the reflectance with the ranges that were searched.
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// Whether two points differ in some input by more than a part of its range.
    fn are_apart(&self, point: &[f64], other: &[f64]) -> bool {
        self.ranges()
            .iter()
            .zip(point.iter().zip(other))
            .any(|([low, high], (a, b))| (a - b).abs() > CLOSE * (high - low))
    }

    fn ranges(&self) -> Vec<[f64; 2]> {
        self.inputs.iter().flat_map(|input| std::iter::repeat_n([input.low, input.high], input.components())).collect()
    }

    /// Where the search ends that starts at each of some places; the largest difference comes first.
    fn summits(
        &self,
        shading: &Shading,
        differences: &[f64],
        starts: &[usize],
    ) -> Result<Vec<(f64, Vec<f64>)>, MediaError> {
        let ends = starts.iter().map(|&start| self.climb(shading, &self.points[start], differences[start]));
        let mut ends = ends.collect::<Result<Vec<_>, _>>()?;
        ends.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        Ok(ends)
    }

    /// Goes from a point to neighbours with a larger difference, by steps that halve where there are none.
    fn climb(&self, shading: &Shading, start: &[f64], value: f64) -> Result<(f64, Vec<f64>), MediaError> {
        let ranges = self.ranges();
        let (mut best, mut point) = (value, start.to_vec());
        let mut step = FIRST_STEP;
        for _ in 0..HALVINGS {
            let mut neighbours = Vec::new();
            for (place, [low, high]) in ranges.iter().enumerate() {
                for sign in [-1.0, 1.0] {
                    let mut neighbour = point.clone();
                    neighbour[place] = (neighbour[place] + sign * step * (high - low)).clamp(*low, *high);
                    neighbours.push(neighbour);
                }
            }
            let expected = shading.reference_each(QUANTITY, &neighbours)?;
            let found = shading.evaluate_each(QUANTITY, &neighbours);
            let differences = delta_e(&found, &expected, self.space);
            let largest = (0..differences.len()).max_by(|&a, &b| differences[a].total_cmp(&differences[b]));
            match largest.filter(|&index| differences[index] > best) {
                Some(index) => (best, point) = (differences[index], neighbours.swap_remove(index)),
                None => step *= 0.5,
            }
        }
        Ok((best, point))
    }
}

/// The largest dE2000 and the root of the mean square error over points that no choice was made by.
pub(super) fn verified(shading: &Shading, count: usize) -> Result<(f64, f64), MediaError> {
    let inputs = with_least_cosine(shading.inputs(QUANTITY));
    let points = spread(&inputs, count, 29);
    let expected = shading.reference_each(QUANTITY, &points)?;
    let found = shading.evaluate_each(QUANTITY, &points);
    let largest = delta_e(&found, &expected, space(shading)).into_iter().fold(0.0, f64::max);
    Ok((largest, Difference::between(&found, &expected, 1).rms))
}

fn delta_e(found: &[[f64; 3]], expected: &[[f64; 3]], space: ColourSpace) -> Vec<f64> {
    found.iter().zip(expected).map(|(found, expected)| delta_e_of_linear(*found, *expected, space)).collect()
}

/// The places of some numbers, that of the largest first.
fn descending(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]));
    order
}

fn space(shading: &Shading) -> ColourSpace {
    shading.sensitivities().space()
}

fn with_least_cosine(mut inputs: Vec<Input>) -> Vec<Input> {
    for input in inputs.iter_mut().filter(|input| input.name == "cos_theta1") {
        input.low = LEAST_COSINE;
    }
    inputs
}
