//! Which values are worth passing: the least cut of the costs.
//!
//! Each value that the pixel needs is either computed there, which costs its operations and needs its operands, or
//! passed, which has a price. Two nodes of a network stand for a value: that it is needed, and that it is computed.

use super::LEAST_SAVED;
use super::analysis::{Analysis, definition};
use super::flow::{Network, UNLIMITED};
use super::trace::Context;
use crate::expr::Expr;
use crate::graph::{Op, Type};
use crate::operations::{of_functions, of_node};
use crate::program::{Program, ReturnValue, operands};
use crate::specialise::replay::Replayed;
use std::collections::HashSet;

/// The values that are passed: the function (or the body, after all others) and the node.
pub type Cut = HashSet<(usize, u32)>;

/// The values whose passing saves the most, of those that are rare and not rarer still: what is given anyway is not passed
/// once more.
pub fn cut(program: &Program, analysis: &Analysis, rarer: Option<&Analysis>, contexts: &[Context<'_>]) -> Cut {
    let count = program.functions().len() + 1;
    let mut first = Vec::new();
    let mut size = 0;
    for function in 0..count {
        first.push(size);
        size += 2 * definition(program, function).nodes.len();
    }
    let needed = |function: usize, node: u32| first[function] + 2 * node as usize;
    let computed = |function: usize, node: u32| needed(function, node) + 1;
    let (source, sink) = (size, size + 1);
    let mut network = Network::new(size + 2);
    for output in program.outputs() {
        if let ReturnValue::Node(node) = output.value {
            network.edge(source, needed(count - 1, node), UNLIMITED);
        }
    }
    let callees = of_functions(program);
    let mut prices = Vec::new();
    for function in (0..count).filter(|&function| analysis.is_mixed[function]) {
        let of_function: Vec<&Context<'_>> = contexts.iter().filter(|context| context.function == function).collect();
        let definition = definition(program, function);
        for (node, index) in definition.nodes.iter().zip(0_u32..) {
            let is_at = |analysis: &Analysis| analysis.is_mixed[function] && analysis.is_rare[function][index as usize];
            let is_passable = is_at(analysis) && !rarer.is_some_and(is_at);
            let price = price(&of_function, is_passable, node.op, node.ty, index);
            network.edge(needed(function, index), computed(function, index), price.unwrap_or(UNLIMITED));
            if price.is_some() {
                prices.push((function, index));
            }
            let from = computed(function, index);
            let mut cost = of_node(node, &callees).weight();
            match node.op {
                Op::Call(callee, call) => {
                    let arguments = &definition.calls[call as usize];
                    if analysis.is_mixed_call(function, arguments) {
                        // Its operations are counted inside. It needs what the parameters need.
                        cost = 0;
                        let callee = callee as usize;
                        for (parameter, inside) in parameters(program, callee) {
                            let argument = arguments[parameter as usize];
                            network.edge(computed(callee, inside), needed(function, argument), UNLIMITED);
                        }
                    } else {
                        for &argument in arguments {
                            network.edge(from, needed(function, argument), UNLIMITED);
                        }
                    }
                }
                Op::Result(call, result) => {
                    let Op::Call(callee, arguments) = definition.nodes[call as usize].op else {
                        unreachable!("a result is of a call")
                    };
                    let results = &program.functions()[callee as usize].results;
                    match results[result as usize].value {
                        ReturnValue::Node(inside)
                            if analysis.is_mixed_call(function, &definition.calls[arguments as usize]) =>
                        {
                            network.edge(from, needed(callee as usize, inside), UNLIMITED);
                        }
                        _ => network.edge(from, needed(function, call), UNLIMITED),
                    }
                }
                op => operands(op).for_each(|operand| network.edge(from, needed(function, operand), UNLIMITED)),
            }
            if cost > 0 {
                network.edge(from, sink, (cost * of_function.len()) as u64);
            }
        }
    }
    let inside = network.source_side(source, sink);
    let is_passed =
        |&(function, node): &(usize, u32)| inside[needed(function, node)] && !inside[computed(function, node)];
    prices.into_iter().filter(is_passed).collect()
}

/// The parameters of a function with the nodes that read them.
fn parameters(program: &Program, function: usize) -> impl Iterator<Item = (u32, u32)> {
    definition(program, function).nodes.iter().zip(0_u32..).filter_map(|(node, index)| match node.op {
        Op::Parameter(parameter) => Some((parameter, index)),
        _ => None,
    })
}

/// What it costs to pass a value to all contexts of its function, where it can be passed and is more than a name.
fn price(contexts: &[&Context<'_>], is_passable: bool, op: Op, ty: Type, node: u32) -> Option<u64> {
    let numbers = match ty {
        Type::Scalar => 1,
        Type::Vec3 => 3,
        _ => return None,
    };
    if !is_passable || matches!(op, Op::Literal(_) | Op::Literal3(_) | Op::Parameter(_)) {
        return None;
    }
    let mut different = HashSet::new();
    for context in contexts {
        match context.values[node as usize] {
            Replayed::Number(Expr::Node(graph, id)) if !matches!(graph.op(id), Op::Parameter(_)) => {
                different.insert(id);
            }
            // What is known at build time stays where its author put it.
            _ => return None,
        }
    }
    Some((numbers * LEAST_SAVED * different.len()) as u64)
}
