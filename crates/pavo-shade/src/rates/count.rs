//! How many operations an evaluation takes at each rate, if each were computed as rarely as its operands allow.

use super::analysis::definition;
use crate::function::Rate;
use crate::graph::Op;
use crate::operations::{Operations, of_node};
use crate::program::{Program, ReturnValue, operands};
use std::collections::HashMap;

/// Operations by the rate of what they depend on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OperationsByRate {
    /// What depends on the material alone.
    pub material: Operations,
    /// What depends on an input of the vertices, and on nothing more frequent.
    pub vertex: Operations,
    /// What depends on an input of the pixels.
    pub pixel: Operations,
}

impl OperationsByRate {
    fn at(&mut self, rate: Rate) -> &mut Operations {
        match rate {
            Rate::Material => &mut self.material,
            Rate::Vertex => &mut self.vertex,
            Rate::Pixel => &mut self.pixel,
        }
    }

    fn add(&mut self, other: Self) {
        for (rate, operations) in Rate::ALL.into_iter().zip([other.material, other.vertex, other.pixel]) {
            *self.at(rate) = *self.at(rate) + operations;
        }
    }
}

impl Program {
    /// The operations of one evaluation by their rates; every call is counted in full.
    pub fn operations_by_rate(&self) -> OperationsByRate {
        let inputs: Vec<Rate> = self.inputs().iter().map(|input| input.rate).collect();
        let mut known = HashMap::new();
        evaluation(self, self.functions().len(), &inputs, &mut known).operations
    }
}

/// What a call takes, and the rates of its results.
#[derive(Clone)]
struct Evaluation {
    operations: OperationsByRate,
    results: Vec<Rate>,
}

/// A call of a function with arguments of these rates.
fn evaluation(
    program: &Program,
    function: usize,
    arguments: &[Rate],
    known: &mut HashMap<(usize, Vec<Rate>), Evaluation>,
) -> Evaluation {
    let key = (function, arguments.to_vec());
    if let Some(known) = known.get(&key) {
        return known.clone();
    }
    let definition = definition(program, function);
    let mut operations = OperationsByRate::default();
    let mut rates: Vec<Rate> = Vec::new();
    let mut calls: HashMap<u32, Vec<Rate>> = HashMap::new();
    for (node, index) in definition.nodes.iter().zip(0_u32..) {
        let rate = match node.op {
            Op::Parameter(parameter) => arguments[parameter as usize],
            Op::Call(callee, call) => {
                let given: Vec<Rate> =
                    definition.calls[call as usize].iter().map(|&argument| rates[argument as usize]).collect();
                let called = evaluation(program, callee as usize, &given, known);
                operations.add(called.operations);
                calls.insert(index, called.results);
                Rate::Material
            }
            Op::Result(call, result) => calls[&call][result as usize],
            op => operands(op).map(|operand| rates[operand as usize]).max().unwrap_or(Rate::Material),
        };
        if !matches!(node.op, Op::Call(..)) {
            *operations.at(rate) = *operations.at(rate) + of_node(node, &[]);
        }
        rates.push(rate);
    }
    let result = |value: ReturnValue| match value {
        ReturnValue::Node(index) => rates[index as usize],
        _ => Rate::Material,
    };
    let results = definition.results.iter().map(|output| result(output.value)).collect();
    let evaluation = Evaluation { operations, results };
    known.insert(key, evaluation.clone());
    evaluation
}
