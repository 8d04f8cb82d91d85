//! Which values change as rarely as a rate says.

use crate::function::Rate;
use crate::graph::Op;
use crate::program::{Definition, Program, ReturnValue, operands};
use std::collections::BTreeSet;

/// The values of a program by their rate. The body counts as a function after all others.
///
/// A function that is called at several places has one set of rates, the highest over all calls, so that it stays one
/// function. A call whose arguments are all rare does not count: it is a rare value as a whole.
pub struct Analysis {
    /// Whether each node of each function is rare, in each call that counts: it depends on nothing more frequent than
    /// the rate.
    pub is_rare: Vec<Vec<bool>>,
    /// Whether the function is called with something that is not rare.
    pub is_mixed: Vec<bool>,
}

/// The function of this number, or the body.
pub fn definition(program: &Program, function: usize) -> &Definition {
    program.functions().get(function).unwrap_or(program.body())
}

impl Analysis {
    /// The values that are as rare as a rate.
    pub fn of(program: &Program, rate: Rate) -> Self {
        let count = program.functions().len() + 1;
        let mut depends: Vec<Vec<BTreeSet<u32>>> = Vec::new();
        for function in 0..count {
            let of_nodes = dependences(program, definition(program, function), &depends);
            depends.push(of_nodes);
        }
        let mut is_mixed = vec![false; count];
        let mut is_frequent: Vec<Vec<bool>> =
            (0..count).map(|function| vec![false; definition(program, function).parameters.len()]).collect();
        is_mixed[count - 1] = true;
        is_frequent[count - 1] = program.inputs().iter().map(|input| input.rate > rate).collect();
        let mut is_rare = vec![Vec::new(); count];
        for function in (0..count).rev() {
            let is_rare_node = |depends: &BTreeSet<u32>| {
                is_mixed[function] && depends.iter().all(|&parameter| !is_frequent[function][parameter as usize])
            };
            let rare: Vec<bool> = depends[function].iter().map(is_rare_node).collect();
            if is_mixed[function] {
                let definition = definition(program, function);
                for node in &definition.nodes {
                    let Op::Call(callee, call) = node.op else { continue };
                    let arguments = &definition.calls[call as usize];
                    if arguments.iter().all(|&argument| rare[argument as usize]) {
                        continue;
                    }
                    is_mixed[callee as usize] = true;
                    for (frequent, &argument) in is_frequent[callee as usize].iter_mut().zip(arguments) {
                        *frequent |= !rare[argument as usize];
                    }
                }
            }
            is_rare[function] = rare;
        }
        Self { is_rare, is_mixed }
    }

    /// Whether a call has arguments that are not rare.
    pub fn is_mixed_call(&self, function: usize, arguments: &[u32]) -> bool {
        arguments.iter().any(|&argument| !self.is_rare[function][argument as usize])
    }
}

/// The parameters that each node depends on; those of a call are what its function needs for anything.
fn dependences(program: &Program, definition: &Definition, callees: &[Vec<BTreeSet<u32>>]) -> Vec<BTreeSet<u32>> {
    let mut known: Vec<BTreeSet<u32>> = Vec::new();
    for node in &definition.nodes {
        let mut depends = BTreeSet::new();
        match node.op {
            Op::Parameter(parameter) => {
                depends.insert(parameter);
            }
            Op::Call(_, call) => {
                for &argument in &definition.calls[call as usize] {
                    depends.extend(&known[argument as usize]);
                }
            }
            Op::Result(call, result) => {
                let Op::Call(callee, arguments) = definition.nodes[call as usize].op else {
                    unreachable!("a result is of a call")
                };
                let callee_results = &program.functions()[callee as usize].results;
                if let ReturnValue::Node(returned) = callee_results[result as usize].value {
                    for &parameter in &callees[callee as usize][returned as usize] {
                        let argument = definition.calls[arguments as usize][parameter as usize];
                        depends.extend(&known[argument as usize]);
                    }
                }
            }
            op => operands(op).for_each(|operand| depends.extend(&known[operand as usize])),
        }
        known.push(depends);
    }
    known
}
