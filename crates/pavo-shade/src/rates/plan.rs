//! What a split passes, and the programs that it makes.

use super::analysis::Analysis;
use super::cut::{Cut, cut};
use super::part::Part;
use super::slots::{Slot, Slots, slots};
use super::trace::trace;
use super::{Prepared, Split, recorded_again};
use crate::bounds::bounds;
use crate::expr::Expr;
use crate::function::{Input, Rate};
use crate::graph::{FunctionParameter, Graph};
use crate::interval::Single;
use crate::program::Program;
use crate::specialise::Facts;
use crate::specialise::replay::{Replay, Replayed};
use crate::value::LeafInfo;
use core::panic::Location;

/// Which values of a program are passed from the rare part to the rest.
pub struct Plan<'a> {
    program: &'a Program,
    part: &'static Part,
    analysis: Analysis,
    cut: Cut,
    /// Whether each slot of the body is read by the rest.
    is_used: Vec<bool>,
    pixel: Program,
}

impl<'a> Plan<'a> {
    /// Nothing where no value is worth passing.
    pub fn of(program: &'a Program, rate: Rate) -> Option<Self> {
        let part = Part::at(rate)?;
        let analysis = Analysis::of(program, rate);
        let graph = Graph::new();
        let contexts = trace(program, &analysis, &graph, rare_inputs(program, rate, &graph));
        let rarer = (rate > Rate::Material).then(|| Analysis::of(program, Rate::Material));
        let cut = cut(program, &analysis, rarer.as_ref(), &contexts);
        let (slots, values) = slots(program, part, &cut, &contexts);
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
        let graph = Graph::new();
        let inputs = inputs(program, &graph);
        let passed: Vec<Expr<'_>> = slots
            .body()
            .iter()
            .zip(&ranges)
            .map(|(slot, &[low, high])| {
                graph.input(Input { name: slot.name.clone(), ty: slot.ty, unit: String::new(), low, high, rate })
            })
            .collect();
        Replay::new(program, &Facts::new(), Some(&slots), &graph).body(&inputs, Some(&passed));
        let pixel = graph.program();
        let is_read = |slot: &Slot| pixel.inputs().iter().any(|input| input.name == slot.name);
        let is_used: Vec<bool> = slots.body().iter().map(is_read).collect();
        is_used.contains(&true).then_some(Self { program, part, analysis, cut, is_used, pixel })
    }

    /// The programs; `given` are the inputs that a rarer part has passed.
    pub fn split(self, given: &[Prepared]) -> Split {
        let graph = Graph::new();
        let contexts = trace(self.program, &self.analysis, &graph, rare_inputs(self.program, self.part.rate, &graph));
        let (slots, values) = slots(self.program, self.part, &self.cut, &contexts);
        let used = || slots.body().iter().zip(&values).zip(&self.is_used).filter(|(_, used)| **used);
        for ((slot, value), _) in used() {
            graph.output(&slot.name, *value);
        }
        let prepared = used().map(|((slot, _), _)| Prepared { name: slot.name.clone(), ty: slot.ty }).collect();
        Split {
            prepare: Some(graph.program()),
            joined: self.joined(given),
            prepared,
            // Recording once more may share more: that is not spared by the split.
            saved: recorded_again(self.program).operations().without(self.pixel.operations()),
            pixel: self.pixel,
        }
    }

    /// Both in one program: the function of the rare part, and the body that calls it.
    fn joined(&self, given: &[Prepared]) -> Program {
        let graph = Graph::new();
        let inputs = inputs(self.program, &graph);
        let (slots, passed) = self.call(&graph, &inputs, given);
        Replay::new(self.program, &Facts::new(), Some(&slots), &graph).body(&inputs, Some(&passed));
        graph.program()
    }

    /// Records the function of the rare part and a call of it: a value for each slot of the body.
    pub fn call<'g>(&self, graph: &'g Graph, inputs: &[Expr<'g>], given: &[Prepared]) -> (Slots, Vec<Expr<'g>>) {
        let Self { program, part, .. } = self;
        graph.set_origin(Location::caller());
        let is_rare = |input: &Input| input.rate <= part.rate;
        let rare = program.inputs().iter().zip(inputs).filter(|(input, _)| is_rare(input));
        let arguments: Vec<u32> = rare.map(|(_, value)| graph.operand(*value)).collect();
        let function = graph.open(part.function, part.function_doc.iter().map(|line| (*line).to_owned()).collect());
        let inside = program.inputs().iter().map(|input| match is_rare(input) {
            true => Replayed::Number(graph.parameter(function, parameter(program, input, given))),
            false => Replayed::Absent,
        });
        let contexts = trace(program, &self.analysis, graph, inside.collect());
        let (slots, values) = slots(program, part, &self.cut, &contexts);
        let used = || slots.body().iter().zip(&values).zip(&self.is_used).filter(|(_, used)| **used);
        let leaves = used().map(|((slot, _), _)| LeafInfo { name: slot.name.clone(), doc: String::new() });
        let returned = used().map(|((_, value), _)| *value).collect();
        graph.close(function, returned, leaves.collect(), Some(part.result.to_owned()));
        let mut results = graph.results(function, arguments).into_iter();
        let passed = self.is_used.iter().map(|used| match used {
            true => results.next().expect("a result for each used value"),
            // Nothing takes it.
            false => Expr::Literal(0.0),
        });
        let passed = passed.collect();
        (slots, passed)
    }
}

/// The inputs of a program, declared in a graph.
pub fn inputs<'g>(program: &Program, graph: &'g Graph) -> Vec<Expr<'g>> {
    program.inputs().iter().map(|input| graph.input(input.clone())).collect()
}

/// The inputs that are as rare as a rate; the others are absent.
fn rare_inputs<'g>(program: &Program, rate: Rate, graph: &'g Graph) -> Vec<Replayed<'g>> {
    let value = |input: &Input| match input.rate <= rate {
        true => Replayed::Number(graph.input(input.clone())),
        false => Replayed::Absent,
    };
    program.inputs().iter().map(value).collect()
}

/// The parameter of the rare part for an input. Those that a rarer part has passed come as its struct.
fn parameter(program: &Program, input: &Input, given: &[Prepared]) -> FunctionParameter {
    let is_given = given.iter().any(|given| given.name == input.name);
    let (doc, whole) = match Part::at(Rate::Material) {
        Some(part) if is_given => {
            let whole = (given.len() > 1).then(|| (part.parameter.to_owned(), part.parameter_doc.to_owned()));
            (part.value_doc.to_owned(), whole)
        }
        _ => (doc_of(program, input), None),
    };
    FunctionParameter { leaf: LeafInfo { name: input.name.clone(), doc }, ty: input.ty, whole }
}

/// What the parameter of this name means where a function of the program takes it.
fn doc_of(program: &Program, input: &Input) -> String {
    let mut parameters = program.functions().iter().flat_map(|function| &function.parameters);
    parameters.find(|parameter| parameter.name == input.name).map_or_else(String::new, |found| found.doc.clone())
}
