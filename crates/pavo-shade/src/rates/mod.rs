//! A program in parts: what changes rarely is computed rarely.
//!
//! A value is as rare as the most frequent of the inputs that it depends on. What depends on inputs of
//! [`Rate::Material`] alone can be prepared once for all pixels; what depends on those of [`Rate::Vertex`] besides can be
//! computed at the vertices and interpolated, which approximates what a pixel would compute. Where the rest uses such a
//! value, it is passed if that saves enough. Of all choices the split takes the one that saves the most, by a least cut
//! over the values of all functions. The functions of the rest stay what they were, with the passed values as further
//! parameters.

mod analysis;
mod count;
mod cut;
mod flow;
mod part;
mod plan;
mod slots;
mod stages;
mod trace;

pub use count::OperationsByRate;
pub use part::PREPARED_SURFACE;
pub(crate) use slots::Slots;
pub use stages::{Stages, stages};

use crate::expr::Expr;
use crate::function::{Input, Rate};
use crate::graph::{Graph, Type};
use crate::interpret::evaluate_rounded;
use crate::operations::Operations;
use crate::program::Program;
use crate::specialise::Facts;
use crate::specialise::replay::Replay;
use plan::Plan;

/// How many operations each number that is passed must save at least, by [`Operations::weight`]: what a uniform costs
/// to load, with room for the block of uniforms that it fills.
pub const LEAST_SAVED: usize = 2;

/// A value that is computed by the rare part and passed to the rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Prepared {
    /// Its name: an output of `prepare`, an input of `pixel`.
    pub name: String,
    /// One number or three.
    pub ty: Type,
}

impl Prepared {
    /// How many numbers it is: 1, or 3 for a vector.
    pub fn components(&self) -> usize {
        if self.ty == Type::Vec3 { 3 } else { 1 }
    }
}

/// A program in two.
#[derive(Clone, Debug)]
pub struct Split {
    /// What is run once a material, or at each vertex: its inputs are as rare as that, its outputs are the passed values.
    /// Nothing where no value is worth passing.
    pub prepare: Option<Program>,
    /// What is run at each pixel: its inputs are those that it still needs, then the passed values.
    pub pixel: Program,
    /// Both in one, for an emitter: a function `prepare_surface` or `vertex_surface`, and the functions of the pixel. Its
    /// body calls both and computes what the whole program computes.
    pub joined: Program,
    /// The passed values in the order of the outputs of `prepare`.
    pub prepared: Vec<Prepared>,
    /// The operations that each pixel is spared.
    pub saved: Operations,
}

/// Splits a program at a rate: what changes with nothing more frequent is computed apart. Both parts together compute the
/// same bits as the whole, where the passed values are not interpolated.
///
/// At [`Rate::Vertex`] only values are passed that depend on an input of the vertices, since those of the material alone
/// are better prepared; [`stages`] does both. At [`Rate::Pixel`] nothing is left to split off.
pub fn split(program: &Program, rate: Rate) -> Split {
    split_given(program, rate, &[])
}

/// Splits a program, some inputs of which were passed by a rarer part.
fn split_given(program: &Program, rate: Rate, given: &[Prepared]) -> Split {
    match Plan::of(program, rate) {
        Some(plan) => plan.split(given),
        None => Split {
            prepare: None,
            pixel: program.clone(),
            joined: program.clone(),
            prepared: Vec::new(),
            saved: Operations::default(),
        },
    }
}

impl Split {
    /// The inputs of `pixel` at a point of the whole program: those that it takes from the point, then what `prepare`
    /// makes of the others, each value rounded.
    ///
    /// # Panics
    /// If `point` has not a number for each component of each of these inputs, or they are not those of the whole
    /// program.
    pub fn pixel_point(&self, inputs: &[Input], point: &[f64], round: fn(f64) -> f64) -> Vec<f64> {
        let prepared = self.prepare.as_ref().map_or_else(Vec::new, |prepare| {
            let outputs = evaluate_rounded(prepare, &taken(prepare, inputs, point), round);
            let numbers = outputs
                .into_iter()
                .zip(&self.prepared)
                .flat_map(|(value, prepared)| value.into_iter().take(if prepared.ty == Type::Vec3 { 3 } else { 1 }));
            numbers.collect()
        });
        let mut numbers = taken(&self.pixel, inputs, point);
        numbers.extend(prepared);
        numbers
    }
}

/// The numbers of a point that a program takes.
fn taken(program: &Program, inputs: &[Input], point: &[f64]) -> Vec<f64> {
    let mut rest = point;
    let mut taken = Vec::new();
    for input in inputs {
        let (numbers, after) = rest.split_at(input.components());
        if program.inputs().iter().any(|other| other.name == input.name) {
            taken.extend_from_slice(numbers);
        }
        rest = after;
    }
    taken
}

/// The whole program, recorded once more.
fn recorded_again(program: &Program) -> Program {
    let graph = Graph::new();
    let inputs: Vec<Expr<'_>> = program.inputs().iter().map(|input| graph.input(input.clone())).collect();
    Replay::new(program, &Facts::new(), None, &graph).body(&inputs, None);
    graph.program()
}
