//! How much a reflectance depends on each of its inputs.

use super::{POINTS, QUANTITY, inputs, on_all_cores, single};
use crate::points::{columns, spread};
use crate::shading::Shading;
use pavo_shade::{Dual, Program, Real, evaluate};
use serde::Serialize;

/// The condition of the reflectance by one number: of a channel, the one that depends on it most.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Condition {
    /// The input, or the fixed number of the scene.
    pub input: String,
    /// Its unit.
    pub unit: String,
    /// Whether the scene fixes it.
    pub fixed: bool,
    /// `|df / dx|`: by how much the reflectance changes with a unit of the input.
    pub absolute: Spread,
    /// `|x df / dx|`: by how much the reflectance changes where the input changes by its own size.
    pub relative: Spread,
}

/// A figure over the points of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// Where it is largest.
    pub max: f64,
    /// Half of the points have less.
    pub median: f64,
}

impl Spread {
    fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        Self {
            max: values.last().copied().unwrap_or(0.0),
            median: values.get(values.len() / 2).copied().unwrap_or(0.0),
        }
    }
}

/// The condition by each number that the reflectance depends on. The indices and the thickness that a scene fixes are
/// taken along where the variant computes with them; a polynomial, a table or a fit made for them does not.
pub fn condition(shading: &Shading) -> Vec<Condition> {
    let opened = shading.with_all_inputs();
    let varying = shading.inputs(QUANTITY);
    let all = inputs(&opened);
    let program = opened.general_program(QUANTITY);
    let columns = columns(&all, program.inputs());
    let points = single(spread(&all, POINTS, 5));
    let points: Vec<Vec<f64>> =
        points.iter().map(|point| columns.iter().map(|&column| point[column]).collect()).collect();
    let mut rows = Vec::new();
    let mut place = 0;
    for input in program.inputs() {
        for component in 0..input.components() {
            let slopes = on_all_cores(&points, |points| slopes(&program, points, place));
            let absolute: Vec<f64> = slopes.iter().map(largest).collect();
            let relative = absolute.iter().zip(&points).map(|(slope, point)| slope * point[place].abs()).collect();
            rows.push(Condition {
                input: match input.components() {
                    1 => input.name.clone(),
                    _ => format!("{}.{}", input.name, ["r", "g", "b"][component]),
                },
                unit: input.unit.clone(),
                fixed: varying.iter().all(|other| other.name != input.name),
                absolute: Spread::of(absolute),
                relative: Spread::of(relative),
            });
            place += 1;
        }
    }
    rows
}

/// The derivatives of the reflectance by one number of the points, in `f64`: by channel. The points have a number for
/// each component of each input of the surface; an input that the reflectance does not depend on has derivatives of 0.
pub fn derivatives(shading: &Shading, points: &[Vec<f64>], place: usize) -> Vec<[f64; 3]> {
    let program = shading.general_program(QUANTITY);
    let columns = columns(&shading.inputs(QUANTITY), program.inputs());
    let Some(taken) = columns.iter().position(|&column| column == place) else { return vec![[0.0; 3]; points.len()] };
    let points: Vec<Vec<f64>> =
        points.iter().map(|point| columns.iter().map(|&column| point[column]).collect()).collect();
    on_all_cores(&points, |points| slopes(&program, points, taken))
}

fn slopes(program: &Program, points: &[Vec<f64>], place: usize) -> Vec<[f64; 3]> {
    let dual = |point: &Vec<f64>| -> Vec<Dual<1>> {
        let number = |(index, &value): (usize, &f64)| match index == place {
            true => Dual::variables([value])[0],
            false => Dual::lit(value),
        };
        point.iter().enumerate().map(number).collect()
    };
    let points: Vec<Vec<Dual<1>>> = points.iter().map(dual).collect();
    let outputs = evaluate(program, &points).into_iter();
    outputs.map(|outputs| outputs[0].map(|channel| channel.derivatives[0])).collect()
}

fn largest(slopes: &[f64; 3]) -> f64 {
    slopes.iter().fold(0.0, |largest, slope| f64::max(largest, slope.abs()))
}
