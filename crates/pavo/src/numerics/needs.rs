//! What a variant needs of a driver's sines, cosines and exponentials.

use super::{Sample, on_all_cores, reflectances};
use pavo_shade::{FunctionErrors, Op, Program, UnaryOp, evaluate_inexact};
use serde::Serialize;

/// Errors of functions that are tried, from the smallest on: three a decade.
const SIZES: [f64; 19] =
    [1e-7, 2e-7, 5e-7, 1e-6, 2e-6, 5e-6, 1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 1e-1];

/// No variant is held to less than what single precision itself does.
const SINGLE_PRECISION: Added = Added { max: 2e-6, rms: 2e-7 };

/// Differences of a reflectance over points and channels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Added {
    /// The largest.
    pub max: f64,
    /// The root of the mean square.
    pub rms: f64,
}

impl Added {
    /// Whether neither figure is above that of a budget.
    pub fn is_within(self, budget: Added) -> bool {
        self.max <= budget.max && self.rms <= budget.rms
    }
}

/// The largest errors of functions, of 1, 2 and 5 times a power of ten from 1e-7 to 0.1, with which all of them together
/// add no more to the reflectance than the budget. Nothing where the variant has no such function.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FunctionNeeds {
    /// Of a sine, absolute.
    pub sin: Option<f64>,
    /// Of a cosine, absolute.
    pub cos: Option<f64>,
    /// Of an exponential, relative.
    pub exp: Option<f64>,
    /// What may be added: the variant's own error against the exact reference, at least 2e-6 and an RMS of 2e-7.
    pub budget: Added,
    /// What these errors add all together.
    pub added: Added,
    /// Whether that is within the budget: not where even the smallest errors add more.
    pub met: bool,
}

/// What a program needs for the points of a sample.
pub fn needs(sample: &Sample) -> FunctionNeeds {
    let own = sample.own_error();
    let budget = Added { max: own.max.max(SINGLE_PRECISION.max), rms: own.rms.max(SINGLE_PRECISION.rms) };
    let functions = [UnaryOp::Sin, UnaryOp::Cos, UnaryOp::Exp];
    let mut sizes = functions.map(|function| takes(&sample.program, function).then_some(0));
    // Each by itself, then all together, smaller until they are within the budget.
    for index in 0..functions.len() {
        if sizes[index].is_some() {
            let alone = |size: usize| {
                let mut alone = [None; 3];
                alone[index] = Some(size);
                added(sample, alone).is_within(budget)
            };
            sizes[index] = Some((1..SIZES.len()).take_while(|&size| alone(size)).last().unwrap_or(0));
        }
    }
    let mut together = added(sample, sizes);
    while !together.is_within(budget) && sizes.iter().flatten().any(|&size| size > 0) {
        sizes = sizes.map(|size| size.map(|size: usize| size.saturating_sub(1)));
        together = added(sample, sizes);
    }
    let [sin, cos, exp] = sizes.map(|size| size.map(|size| SIZES[size]));
    FunctionNeeds { sin, cos, exp, budget, added: together, met: together.is_within(budget) }
}

/// Whether a program takes a function of anything that varies.
fn takes(program: &Program, function: UnaryOp) -> bool {
    let definitions = program.functions().iter().chain([program.body()]);
    let mut nodes = definitions.flat_map(|definition| &definition.nodes);
    nodes.any(|node| matches!(node.op, Op::Unary(op, _) if op == function))
}

/// What errors of these sizes add.
fn added(sample: &Sample, sizes: [Option<usize>; 3]) -> Added {
    let [sin, cos, exp] = sizes.map(|size| size.map_or(0.0, |size| SIZES[size]));
    let errors = FunctionErrors { sin, cos, exp };
    let evaluate = |points: &[Vec<f64>]| reflectances(evaluate_inexact(&sample.program, points, errors));
    Added::between(&on_all_cores(&sample.points, evaluate), &sample.values)
}
