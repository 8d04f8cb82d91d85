//! What was left out, and why, for a reader.

use crate::bounds::{Claim, Fact};
use crate::graph::{BinaryOp, Op, UnaryOp};
use crate::program::{Definition, Program};

/// A guard that a program does without.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LeftOut {
    /// The function that it was in.
    pub function: String,
    /// The guard, as in `max(denominator, 1e-30)`.
    pub what: String,
    /// The file and the line of Rust that made it.
    pub location: String,
    /// The smallest value that what it guards takes, over all inputs within their ranges.
    pub low: f64,
    /// The largest one.
    pub high: f64,
    /// Why it is not needed.
    pub reason: String,
}

/// A row for each guard in the source; where a function has several instances, the bounds are those of all.
pub(super) fn left_out(program: &Program, claims: &[Claim]) -> Vec<LeftOut> {
    let mut rows: Vec<LeftOut> = Vec::new();
    let mut ordered: Vec<&Claim> = claims.iter().collect();
    ordered.sort_by_key(|claim| (claim.function, claim.node));
    for claim in ordered {
        let definition = program.functions().get(claim.function).unwrap_or(program.body());
        let node = &definition.nodes[claim.node as usize];
        let what = guard(program, definition, node.op);
        let location = format!("{}:{}", node.location.file(), node.location.line());
        let [low, high] = claim.bounds;
        let reason = reason(program, definition, node.op, claim.fact);
        let same = |row: &&mut LeftOut| {
            row.function == definition.name && row.what == what && row.location == location && row.reason == reason
        };
        match rows.iter_mut().find(same) {
            Some(row) => (row.low, row.high) = (row.low.min(low), row.high.max(high)),
            None => {
                rows.push(LeftOut { function: definition.name.clone(), what, location, low, high, reason });
            }
        }
    }
    rows
}

/// How deep a formula goes into what has no name.
const DEPTH: usize = 2;

/// A guard as a formula of names.
fn guard(program: &Program, definition: &Definition, op: Op) -> String {
    formula(program, definition, op, DEPTH)
}

fn formula(program: &Program, definition: &Definition, op: Op, depth: usize) -> String {
    let of = |index: u32| name(program, definition, index, depth);
    let call = |name: &str, operands: &[u32]| {
        format!("{name}({})", operands.iter().map(|&operand| of(operand)).collect::<Vec<_>>().join(", "))
    };
    let infix = |a: u32, sign: &str, b: u32| format!("{} {sign} {}", of(a), of(b));
    match op {
        Op::Binary(op, a, b) => match op {
            BinaryOp::Add => infix(a, "+", b),
            BinaryOp::Subtract => infix(a, "-", b),
            BinaryOp::Multiply => infix(a, "*", b),
            BinaryOp::Divide => infix(a, "/", b),
            BinaryOp::And => infix(a, "and", b),
            BinaryOp::Or => infix(a, "or", b),
            BinaryOp::Min | BinaryOp::Max | BinaryOp::Dot => call(&format!("{op:?}").to_lowercase(), &[a, b]),
        },
        Op::Compare(_, a, b) => infix(a, "<", b),
        Op::Unary(UnaryOp::Negate, a) => format!("-{}", of(a)),
        Op::Unary(op, a) => call(&format!("{op:?}").to_lowercase(), &[a]),
        Op::Clamp(x, low, high) => call("clamp", &[x, low, high]),
        Op::Mix(a, b, t) => call("mix", &[a, b, t]),
        Op::Select(mask, a, b) => call("select", &[mask, a, b]),
        Op::Vec3(x, y, z) => call("vec3", &[x, y, z]),
        Op::Fetch(table, index) => format!("{}[{}]", program.tables()[table as usize].name, of(index)),
        Op::Component(a, index) => format!("{}.{}", of(a), ["x", "y", "z"][usize::from(index)]),
        _ => "..".to_owned(),
    }
}

/// What a value is called: its name, its number, or how it is computed where it has none.
fn name(program: &Program, definition: &Definition, index: u32, depth: usize) -> String {
    let node = &definition.nodes[index as usize];
    match (&node.name, node.op) {
        (Some(name), _) => name.clone(),
        (None, Op::Literal(bits)) => number(f64::from_bits(bits)),
        (None, Op::Literal3([x, y, z])) if x == y && y == z => number(f64::from_bits(x)),
        (None, Op::Literal3(bits)) => format!("vec3({})", bits.map(|bits| number(f64::from_bits(bits))).join(", ")),
        (None, Op::Parameter(index)) => definition.parameters[index as usize].name.clone(),
        (None, Op::Splat(a)) => name(program, definition, a, depth),
        (None, Op::Result(call, result)) => match definition.nodes[call as usize].op {
            Op::Call(callee, _) => {
                let callee = &program.functions()[callee as usize];
                let result = &callee.results[result as usize].name;
                if result.is_empty() { callee.name.clone() } else { result.clone() }
            }
            _ => unreachable!("a result is of a call"),
        },
        _ if depth == 0 => "..".to_owned(),
        (None, op @ (Op::Binary(BinaryOp::Add | BinaryOp::Subtract, ..) | Op::Compare(..))) if depth < DEPTH => {
            format!("({})", formula(program, definition, op, depth - 1))
        }
        (None, op) => formula(program, definition, op, depth - 1),
    }
}

/// A number with the digits that `f32` tells apart.
fn number(value: f64) -> String {
    let text = format!("{:?}", value as f32);
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

fn reason(program: &Program, definition: &Definition, op: Op, fact: Fact) -> String {
    let of = |index: u32| name(program, definition, index, DEPTH);
    match (fact, op) {
        (Fact::First, Op::Binary(BinaryOp::Max, _, b)) => format!("never below {}", of(b)),
        (Fact::Second, Op::Binary(BinaryOp::Max, _, b)) => format!("never above {}, which is the result", of(b)),
        (Fact::First, Op::Binary(_, _, b)) => format!("never above {}", of(b)),
        (Fact::Second, Op::Binary(_, _, b)) => format!("never below {}, which is the result", of(b)),
        (Fact::AboveLow, Op::Clamp(_, low, _)) => format!("never below {}", of(low)),
        (Fact::BelowHigh, Op::Clamp(_, _, high)) => format!("never above {}", of(high)),
        (Fact::NotNegative, _) => "never negative".to_owned(),
        (Fact::NotPositive, _) => "never positive, so that it is negated".to_owned(),
        (Fact::Holds, _) => "always true".to_owned(),
        _ => "always false".to_owned(),
    }
}
