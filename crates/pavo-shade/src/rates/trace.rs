//! The rare values, recorded call by call: calls that mix rates are written out, the others stay calls.

use super::analysis::{Analysis, definition};
use crate::expr::{Expr, ExprMask};
use crate::graph::{Graph, Op, Type};
use crate::program::{Program, ReturnValue, operands};
use crate::real::Scalar;
use crate::specialise::Facts;
use crate::specialise::replay::{Replay, Replayed, call_of, condition, is_literal, number, operation, returned};
use std::collections::HashMap;

/// A function in one chain of calls from the body.
pub struct Context<'g> {
    /// Its number.
    pub function: usize,
    /// What is rare, by node; the rest is absent.
    pub values: Vec<Replayed<'g>>,
    /// The contexts of the calls that mix rates, by node.
    pub calls: HashMap<u32, usize>,
    results: Vec<Replayed<'g>>,
}

struct Tracer<'a, 'g> {
    program: &'a Program,
    analysis: &'a Analysis,
    graph: &'g Graph,
    replay: Replay<'a, 'g>,
    contexts: Vec<Context<'g>>,
}

/// All contexts of a program, callees before callers, given the rare inputs (others are absent).
pub fn trace<'g>(
    program: &Program,
    analysis: &Analysis,
    graph: &'g Graph,
    inputs: Vec<Replayed<'g>>,
) -> Vec<Context<'g>> {
    let facts = Facts::new();
    let replay = Replay::new(program, &facts, None, graph);
    let mut tracer = Tracer { program, analysis, graph, replay, contexts: Vec::new() };
    tracer.context(program.functions().len(), inputs);
    tracer.contexts
}

fn is_present(value: &Replayed<'_>) -> bool {
    !matches!(value, Replayed::Absent)
}

impl<'g> Tracer<'_, 'g> {
    /// The number of the context of a function with these arguments.
    fn context(&mut self, function: usize, arguments: Vec<Replayed<'g>>) -> usize {
        let program = self.program;
        let definition = definition(program, function);
        let mut values: Vec<Replayed<'g>> = Vec::new();
        let mut calls = HashMap::new();
        for (node, index) in definition.nodes.iter().zip(0_u32..) {
            self.graph.set_origin(node.location);
            let value = match node.op {
                Op::Parameter(parameter) => arguments[parameter as usize].clone(),
                Op::Call(callee, call) => {
                    let arguments = &definition.calls[call as usize];
                    if self.analysis.is_mixed_call(function, arguments) {
                        let given = arguments.iter().map(|&argument| values[argument as usize].clone()).collect();
                        calls.insert(index, self.context(callee as usize, given));
                        Replayed::Absent
                    } else {
                        let of = |&argument: &u32| {
                            (number(&values, argument), is_literal(definition.nodes[argument as usize].op))
                        };
                        let arguments: Vec<(Expr<'g>, bool)> = arguments.iter().map(of).collect();
                        let results = self.replay.call(callee, &arguments, None, node.location);
                        if let (Some(name), Some(call)) =
                            (&node.name, results.iter().find_map(|&result| call_of(result)))
                        {
                            self.graph.name(call, name);
                        }
                        Replayed::Results(results)
                    }
                }
                Op::Result(call, result) => match (calls.get(&call), &values[call as usize]) {
                    (Some(&context), _) => self.contexts[context].results[result as usize].clone(),
                    (None, Replayed::Results(results)) => Replayed::Number(results[result as usize]),
                    (None, _) => unreachable!("a call is written out or recorded"),
                },
                op if operands(op).any(|operand| !is_present(&values[operand as usize])) => Replayed::Absent,
                Op::Fetch(table, row) => {
                    Replayed::Number(Expr::fetch(&program.tables()[table as usize], number(&values, row)))
                }
                op if matches!(node.ty, Type::Mask | Type::Mask3) => Replayed::Mask(condition(op, &[], &values)),
                op => Replayed::Number(operation(op, &[], &values)),
            };
            if let (
                Some(name),
                Replayed::Number(Expr::Node(_, id)) | Replayed::Mask(ExprMask::Node(Expr::Node(_, id))),
            ) = (&node.name, &value)
            {
                self.graph.name(*id, name);
            }
            values.push(value);
        }
        let result = |output: &crate::program::Output| match output.value {
            ReturnValue::Node(index) if !is_present(&values[index as usize]) => Replayed::Absent,
            _ => Replayed::Number(returned(output, &values)),
        };
        let results = definition.results.iter().map(result).collect();
        self.contexts.push(Context { function, values, calls, results });
        self.contexts.len() - 1
    }
}
