//! A program in two: what depends on the material alone is computed once for all its pixels.
//!
//! A value is as rare as the most frequent of the inputs that it depends on. What depends on inputs of
//! [`Rate::Material`] alone can be prepared; where the pixel uses such a value, it is passed if that saves enough. Of
//! all choices the split takes the one that saves the most, by a least cut over the values of all functions. The
//! functions of the pixel stay what they were, with the prepared values as further parameters.

mod analysis;
mod cut;
mod flow;
mod slots;
mod trace;

pub(crate) use slots::Slots;

use crate::bounds::bounds;
use crate::expr::Expr;
use crate::function::{Input, Rate};
use crate::graph::{FunctionParameter, Graph, Type};
use crate::interpret::evaluate_rounded;
use crate::interval::Single;
use crate::operations::Operations;
use crate::program::Program;
use crate::specialise::Facts;
use crate::specialise::replay::{Replay, Replayed};
use crate::value::LeafInfo;
use analysis::Analysis;
use core::panic::Location;
use cut::{Cut, cut};
use slots::slots;
use trace::trace;

/// How many operations each number that is passed must save at least, by [`Operations::weight`]: what a uniform costs
/// to load, with room for the block of uniforms that it fills.
pub const LEAST_SAVED: usize = 2;

/// The name of the function that prepares, in [`Split::joined`].
const PREPARE: &str = "prepare_surface";
/// The name of the struct that the function that prepares returns, where it returns more than one value.
pub const PREPARED_SURFACE: &str = "PreparedSurface";

/// A value that is computed once a material.
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
    /// What is run once a material: its inputs are those of the material, its outputs are the prepared values. Nothing
    /// where no value is worth passing.
    pub prepare: Option<Program>,
    /// What is run at each pixel: its inputs are those that it still needs, then the prepared values.
    pub pixel: Program,
    /// Both in one, for an emitter: a function `prepare_surface`, and the functions of the pixel. Its body calls both
    /// and computes what the whole program computes.
    pub joined: Program,
    /// The prepared values in the order of the outputs of `prepare`.
    pub prepared: Vec<Prepared>,
    /// The operations that each pixel is spared.
    pub saved: Operations,
}

/// Splits a program by the rates of its inputs. Both parts together compute the same bits as the whole.
///
/// What changes with the vertex stays with the pixel.
pub fn split(program: &Program) -> Split {
    let analysis = Analysis::of(program);
    let graph = Graph::new();
    let contexts = trace(program, &analysis, &graph, material_inputs(program, &graph));
    let cut = cut(program, &analysis, &contexts);
    let (slots, values) = slots(program, &cut, &contexts);
    if slots.body().is_empty() {
        return unsplit(program);
    }
    for (slot, value) in slots.body().iter().zip(&values) {
        graph.output(&slot.name, *value);
    }
    let ranges: Vec<[f64; 2]> = bounds::<Single>(&graph.program(), 1)
        .outputs
        .iter()
        .map(|components| {
            let low = components.iter().map(|bound| bound.low()).fold(f64::INFINITY, f64::min);
            let high = components.iter().map(|bound| bound.high()).fold(f64::NEG_INFINITY, f64::max);
            [low, high]
        })
        .collect();
    let pixel = pixel(program, &slots, &ranges);
    let takes = |slot: &slots::Slot| pixel.inputs().iter().any(|input| input.name == slot.name);
    let is_used: Vec<bool> = slots.body().iter().map(takes).collect();
    if !is_used.contains(&true) {
        return unsplit(program);
    }
    let prepared = slots.body().iter().zip(&is_used).filter(|(_, used)| **used);
    Split {
        prepare: Some(prepare(program, &analysis, &cut, &is_used)),
        joined: joined(program, &analysis, &cut, &is_used),
        prepared: prepared.map(|(slot, _)| Prepared { name: slot.name.clone(), ty: slot.ty }).collect(),
        // Recording once more may share more: that is not spared by the split.
        saved: recorded_again(program).operations().without(pixel.operations()),
        pixel,
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

fn unsplit(program: &Program) -> Split {
    Split {
        prepare: None,
        pixel: program.clone(),
        joined: program.clone(),
        prepared: Vec::new(),
        saved: Operations::default(),
    }
}

/// The whole program, recorded once more.
fn recorded_again(program: &Program) -> Program {
    let graph = Graph::new();
    let inputs: Vec<Expr<'_>> = program.inputs().iter().map(|input| graph.input(input.clone())).collect();
    Replay::new(program, &Facts::new(), None, &graph).body(&inputs, None);
    graph.program()
}

/// The inputs of the material; the others are absent.
fn material_inputs<'g>(program: &Program, graph: &'g Graph) -> Vec<Replayed<'g>> {
    let inputs = program.inputs().iter();
    inputs
        .map(|input| match input.rate {
            Rate::Material => Replayed::Number(graph.input(input.clone())),
            Rate::Vertex | Rate::Pixel => Replayed::Absent,
        })
        .collect()
}

/// The program that prepares what is used.
fn prepare(program: &Program, analysis: &Analysis, cut: &Cut, is_used: &[bool]) -> Program {
    let graph = Graph::new();
    let contexts = trace(program, analysis, &graph, material_inputs(program, &graph));
    let (slots, values) = slots(program, cut, &contexts);
    for ((slot, value), _) in slots.body().iter().zip(values).zip(is_used).filter(|(_, used)| **used) {
        graph.output(&slot.name, value);
    }
    graph.program()
}

/// The program that takes what is prepared.
fn pixel(program: &Program, slots: &Slots, ranges: &[[f64; 2]]) -> Program {
    let graph = Graph::new();
    let inputs: Vec<Expr<'_>> = program.inputs().iter().map(|input| graph.input(input.clone())).collect();
    let of_slots = slots.body().iter().zip(ranges);
    let prepared: Vec<Expr<'_>> = of_slots
        .map(|(slot, &[low, high])| {
            let (name, unit) = (slot.name.clone(), String::new());
            graph.input(Input { name, ty: slot.ty, unit, low, high, rate: Rate::Material })
        })
        .collect();
    Replay::new(program, &Facts::new(), Some(slots), &graph).body(&inputs, Some(&prepared));
    graph.program()
}

/// Both in one program: a function that prepares, and the body that calls it.
fn joined(program: &Program, analysis: &Analysis, cut: &Cut, is_used: &[bool]) -> Program {
    let graph = Graph::new();
    let inputs: Vec<Expr<'_>> = program.inputs().iter().map(|input| graph.input(input.clone())).collect();
    graph.set_origin(Location::caller());
    let passed: Vec<u32> = program
        .inputs()
        .iter()
        .zip(&inputs)
        .filter(|(input, _)| input.rate == Rate::Material)
        .map(|(_, value)| graph.operand(*value))
        .collect();
    let doc = "Prepares a material: what depends on nothing else, computed once for all its pixels.".to_owned();
    let function = graph.open(PREPARE, vec![doc]);
    let inside: Vec<Replayed<'_>> = program
        .inputs()
        .iter()
        .map(|input| match input.rate {
            Rate::Material => {
                let leaf = LeafInfo { name: input.name.clone(), doc: doc_of(program, input) };
                let parameter = FunctionParameter { leaf, ty: input.ty, whole: None };
                Replayed::Number(graph.parameter(function, parameter))
            }
            Rate::Vertex | Rate::Pixel => Replayed::Absent,
        })
        .collect();
    let contexts = trace(program, analysis, &graph, inside);
    let (slots, values) = slots(program, cut, &contexts);
    let used = || slots.body().iter().zip(&values).zip(is_used).filter(|(_, used)| **used).map(|(slot, _)| slot);
    let leaves = used().map(|(slot, _)| LeafInfo { name: slot.name.clone(), doc: String::new() });
    let returned = used().map(|(_, value)| *value).collect();
    graph.close(function, returned, leaves.collect(), Some(PREPARED_SURFACE.to_owned()));
    let mut results = graph.results(function, passed).into_iter();
    let prepared: Vec<Expr<'_>> = is_used
        .iter()
        .map(|used| match used {
            true => results.next().expect("a result for each used value"),
            // Nothing takes it.
            false => Expr::Literal(0.0),
        })
        .collect();
    Replay::new(program, &Facts::new(), Some(&slots), &graph).body(&inputs, Some(&prepared));
    graph.program()
}

/// What the parameter of this name means where a function of the program takes it.
fn doc_of(program: &Program, input: &Input) -> String {
    let mut parameters = program.functions().iter().flat_map(|function| &function.parameters);
    parameters.find(|parameter| parameter.name == input.name).map_or_else(String::new, |found| found.doc.clone())
}
