//! How many operations an evaluation takes, with every call counted in full.

use crate::graph::{BinaryOp, Node, Op, Type, UnaryOp};
use crate::program::{Definition, Program};
use crate::real::Real;
use core::ops::Add;

/// Operations by what they cost. A vector counts for three.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Operations {
    /// Sums, products, comparisons, selections.
    pub arithmetic: usize,
    /// Quotients and roots.
    pub roots: usize,
    /// Sines, cosines and exponentials.
    pub transcendental: usize,
    /// Rows read from tables.
    pub fetches: usize,
}

impl Operations {
    /// What they cost together, in operations of arithmetic: quotients, roots, transcendental functions and reads of
    /// tables count for four.
    pub fn weight(self) -> usize {
        self.arithmetic + 4 * (self.roots + self.transcendental + self.fetches)
    }

    /// What is left of these after those are taken away, none below zero.
    #[must_use]
    pub fn without(self, other: Self) -> Self {
        Self {
            arithmetic: self.arithmetic.saturating_sub(other.arithmetic),
            roots: self.roots.saturating_sub(other.roots),
            transcendental: self.transcendental.saturating_sub(other.transcendental),
            fetches: self.fetches.saturating_sub(other.fetches),
        }
    }
}

impl Add for Operations {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            arithmetic: self.arithmetic + other.arithmetic,
            roots: self.roots + other.roots,
            transcendental: self.transcendental + other.transcendental,
            fetches: self.fetches + other.fetches,
        }
    }
}

impl Program {
    /// The operations of one evaluation.
    pub fn operations(&self) -> Operations {
        count(self.body(), &of_functions(self))
    }
}

impl Program {
    /// Those of [`Program::operations`] that are done in half precision, where a language has it.
    pub fn operations_in_half(&self) -> Operations {
        let in_half = |function: &Definition, callees: &[Operations]| {
            let of = |node: &Node| match node.op {
                Op::Unary(UnaryOp::Half, operand) if is_in_half(function, operand) => {
                    of_node(&function.nodes[operand as usize], callees)
                }
                Op::Call(callee, _) => callees[callee as usize],
                _ => Operations::default(),
            };
            function.nodes.iter().map(of).fold(Operations::default(), Add::add)
        };
        let mut known: Vec<Operations> = Vec::new();
        for function in self.functions() {
            let operations = in_half(function, &known);
            known.push(operations);
        }
        in_half(self.body(), &known)
    }

    /// Whether anything is held in half precision.
    pub fn has_half(&self) -> bool {
        let nodes = self.functions().iter().chain([self.body()]).flat_map(|function| &function.nodes);
        nodes.into_iter().any(|node| matches!(node.op, Op::Unary(UnaryOp::Half, _)))
    }
}

/// Whether a value that is held in half precision is also computed in it: a sum, difference, product or quotient of
/// numbers that are held so. In `f32`, rounded afterwards, it has the same bits.
pub fn is_in_half(function: &Definition, index: u32) -> bool {
    match function.nodes[index as usize].op {
        Op::Binary(BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide, a, b) => {
            [a, b].into_iter().all(|operand| is_held_in_half(function, operand))
        }
        _ => false,
    }
}

/// Whether a value has no more bits than half precision: it is held in it, or a literal that it has.
pub fn is_held_in_half(function: &Definition, index: u32) -> bool {
    let has = |bits: u64| f64::from_bits(bits).half().to_bits() == bits;
    match function.nodes[index as usize].op {
        Op::Unary(UnaryOp::Half, _) => true,
        Op::Literal(bits) => has(bits),
        Op::Literal3(bits) => bits.into_iter().all(has),
        _ => false,
    }
}

/// The operations of a definition, given those of the functions that it may call.
fn count(function: &Definition, callees: &[Operations]) -> Operations {
    function.nodes.iter().map(|node| of_node(node, callees)).fold(Operations::default(), Add::add)
}

/// The operations of each function of a program.
pub(crate) fn of_functions(program: &Program) -> Vec<Operations> {
    let mut known: Vec<Operations> = Vec::new();
    for function in program.functions() {
        let operations = count(function, &known);
        known.push(operations);
    }
    known
}

/// The operations of a node, given those of the functions that it may call.
pub(crate) fn of_node(node: &Node, callees: &[Operations]) -> Operations {
    let width = if matches!(node.ty, Type::Vec3 | Type::Mask3) { 3 } else { 1 };
    let arithmetic = Operations { arithmetic: width, ..Operations::default() };
    match node.op {
        Op::Literal(_)
        | Op::Literal3(_)
        | Op::Parameter(_)
        | Op::Vec3(..)
        | Op::Splat(_)
        | Op::Component(..)
        | Op::Result(..)
        | Op::Unary(UnaryOp::Negate | UnaryOp::Half, _) => Operations::default(),
        Op::Call(callee, _) => callees[callee as usize],
        Op::Unary(UnaryOp::Sqrt | UnaryOp::InverseSqrt, _) | Op::Binary(BinaryOp::Divide, ..) => {
            Operations { roots: width, ..Operations::default() }
        }
        Op::Unary(UnaryOp::Sin | UnaryOp::Cos | UnaryOp::Exp, _) => {
            Operations { transcendental: width, ..Operations::default() }
        }
        Op::Unary(UnaryOp::Normalize, _) => Operations { arithmetic: 8, roots: 1, ..Operations::default() },
        Op::Binary(BinaryOp::Dot, ..) => Operations { arithmetic: 5, ..Operations::default() },
        Op::Fetch(..) => Operations { fetches: 1, ..Operations::default() },
        Op::Clamp(..) => Operations { arithmetic: 2 * width, ..Operations::default() },
        Op::Mix(..) => Operations { arithmetic: 4 * width, ..Operations::default() },
        Op::Unary(..) | Op::Binary(..) | Op::Compare(..) | Op::Select(..) => arithmetic,
    }
}
