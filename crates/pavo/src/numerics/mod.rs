//! How a variant's reflectance behaves as numbers: what it needs of a driver, what drivers do to it, within which bounds it
//! lies, and how much it depends on its inputs.

mod bounds;
mod condition;
mod needs;
mod policies;

pub use bounds::{Enclosure, ReflectanceBounds, Summary};
pub use condition::{Condition, Spread, condition, derivatives};
pub use needs::{Added, FunctionNeeds, needs};
pub use policies::{PolicyRow, policies};

use crate::inputs::ShadingQuantity;
use crate::media::MediaError;
use crate::points::{columns, spread};
use crate::shading::Shading;
use crate::statistics::Difference;
use pavo_shade::{Input, Program};
use rayon::prelude::*;
use serde::Serialize;

const QUANTITY: ShadingQuantity = ShadingQuantity::Reflectance;
/// How many points are looked at.
const POINTS: usize = 1_000;
/// How many boxes the ranges of the inputs are divided into for bounds.
const BOXES: usize = 1_024;
/// The smallest cosine: below, the film's finesse amplifies rounding.
const LEAST_COSINE: f64 = 0.05;
/// How many points a core takes at once.
const CHUNK: usize = 128;

/// The numerical behaviour of a variant's reflectance over a scene's ranges, with cosines from 0.05.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Numerics {
    /// The range of the cosine of the angle of incidence.
    pub cos_theta1: [f64; 2],
    /// How many points were looked at.
    pub points: usize,
    /// The error of the variant in f64 against the exact spectral reference: what errors of drivers are held against.
    pub own_error: Added,
    /// What it needs of the sines, cosines and exponentials of a driver.
    pub needs: FunctionNeeds,
    /// What drivers may do to it, by what they depart from exact single precision in.
    pub policies: Vec<PolicyRow>,
    /// Bounds of what it may be in single precision, over boxes of the ranges.
    pub bounds: Summary,
    /// How much it depends on each number of the film, fixed ones included where the variant has them at all.
    pub condition: Vec<Condition>,
}

impl Numerics {
    /// The behaviour of a surface's reflectance. The same surface gives the same figures.
    ///
    /// # Errors
    /// If an index of a point is no index.
    pub fn of(shading: &Shading) -> Result<Self, MediaError> {
        let sample = Sample::of(shading)?;
        Ok(Self {
            cos_theta1: [LEAST_COSINE, 1.0],
            points: sample.points.len(),
            own_error: sample.own_error(),
            needs: needs(&sample),
            policies: policies(&sample),
            bounds: ReflectanceBounds::of(shading, BOXES).summary(),
            condition: condition(shading),
        })
    }
}

/// Points of a scene with what is exact there.
#[derive(Clone, Debug)]
pub struct Sample {
    /// What is emitted.
    program: Program,
    /// Points with a number for each that the program takes, each one of `f32`.
    points: Vec<Vec<f64>>,
    /// The variant in `f64`.
    values: Vec<[f64; 3]>,
    /// The exact spectral reference.
    reference: Vec<[f64; 3]>,
}

impl Sample {
    /// Points spread over the ranges of a surface's inputs, with cosines from 0.05.
    ///
    /// # Errors
    /// If an index of a point is no index.
    pub fn of(shading: &Shading) -> Result<Self, MediaError> {
        let inputs = inputs(shading);
        let points = single(spread(&inputs, POINTS, 5));
        let program = shading.program(QUANTITY);
        let columns = columns(&inputs, program.inputs());
        let reference = shading.reference_each(QUANTITY, &points)?;
        let taken = |point: &Vec<f64>| columns.iter().map(|&column| point[column]).collect();
        let points: Vec<Vec<f64>> = points.iter().map(taken).collect();
        let values = on_all_cores(&points, |chunk| reflectances(pavo_shade::evaluate(&program, chunk)));
        Ok(Self { program, points, values, reference })
    }

    /// How far the variant in `f64` is from the exact reference.
    fn own_error(&self) -> Added {
        Added::between(&self.values, &self.reference)
    }
}

impl Added {
    fn between(found: &[[f64; 3]], expected: &[[f64; 3]]) -> Self {
        let Difference { max, rms, .. } = Difference::between(found, expected, 1);
        Self { max, rms }
    }
}

/// The inputs of the reflectance, with cosines from [`LEAST_COSINE`].
fn inputs(shading: &Shading) -> Vec<Input> {
    let mut inputs = shading.inputs(QUANTITY);
    for input in inputs.iter_mut().filter(|input| input.name == "cos_theta1") {
        input.low = LEAST_COSINE;
    }
    inputs
}

/// The same points in numbers of `f32`.
fn single(points: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    points.into_iter().map(|point| point.into_iter().map(|number| f64::from(number as f32)).collect()).collect()
}

/// The first output at each point.
fn reflectances<T: Copy>(outputs: Vec<Vec<[T; 3]>>) -> Vec<[T; 3]> {
    outputs.into_iter().map(|outputs| outputs[0]).collect()
}

/// The results for points in order, chunk by chunk.
fn on_all_cores<P: Sync, T: Send>(points: &[P], function: impl Fn(&[P]) -> Vec<T> + Send + Sync) -> Vec<T> {
    points.par_chunks(CHUNK).flat_map(function).collect()
}
