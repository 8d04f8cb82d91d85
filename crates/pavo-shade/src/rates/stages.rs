//! A program in three: what is prepared, what is computed at the vertices, and what is left for the pixels.

use super::plan::{Plan, inputs};
use super::{Split, split, split_given};
use crate::expr::Expr;
use crate::function::Rate;
use crate::graph::Graph;
use crate::program::Program;
use crate::specialise::Facts;
use crate::specialise::replay::Replay;

/// A program in three.
#[derive(Clone, Debug)]
pub struct Stages {
    /// What is run once a material, and the rest.
    pub material: Split,
    /// That rest in two: what is run at each vertex, and what is run at each pixel.
    pub vertex: Split,
    /// All in one, for an emitter: the functions `prepare_surface` and `vertex_surface`, as far as they save something,
    /// and those of the pixel.
    pub joined: Program,
}

/// Splits a program at the rate of the material, and the rest at that of the vertices.
///
/// Without interpolation all parts together compute the same bits as the whole. With it they approximate the whole
/// between the vertices: a value that does not change linearly along a triangle is not what a pixel would compute.
pub fn stages(program: &Program) -> Stages {
    let material = split(program, Rate::Material);
    let vertex = split_given(&material.pixel, Rate::Vertex, &material.prepared);
    let joined = match Plan::of(program, Rate::Material) {
        Some(plan) if vertex.prepare.is_some() => joined(program, &plan, &vertex),
        Some(_) => material.joined.clone(),
        None => vertex.joined.clone(),
    };
    Stages { material, vertex, joined }
}

/// The body of the rest in two, where what the first part has passed is its result.
fn joined(program: &Program, plan: &Plan<'_>, vertex: &Split) -> Program {
    let graph = Graph::new();
    let inputs = inputs(program, &graph);
    let (slots, prepared) = plan.call(&graph, &inputs, &[]);
    let of_whole = program.inputs().iter().map(|input| input.name.as_str()).zip(inputs.iter().copied());
    let of_slots = slots.body().iter().map(|slot| slot.name.as_str()).zip(prepared.iter().copied());
    let known: Vec<(&str, Expr<'_>)> = of_whole.chain(of_slots).collect();
    let value = |name: &str| known.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
    let rest = vertex.joined.inputs().iter();
    let rest: Vec<Expr<'_>> =
        rest.map(|input| value(&input.name).expect("an input of the whole, or a prepared value")).collect();
    Replay::new(&vertex.joined, &Facts::new(), None, &graph).body(&rest, None);
    graph.program()
}
