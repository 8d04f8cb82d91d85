//! What was left out, and why, for a reader.

use crate::bounds::{Claim, Fact};
use crate::graph::{BinaryOp, Op};
use crate::program::{Definition, Program};

/// A guard that a program does without.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LeftOut {
    /// The function that it was in.
    pub function: String,
    /// The guard, as in `max(q2_squared, 0.000000000001)`.
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

/// A guard as a formula of names.
fn guard(program: &Program, definition: &Definition, op: Op) -> String {
    let of = |index: u32| name(program, definition, index);
    match op {
        Op::Binary(op @ (BinaryOp::And | BinaryOp::Or), a, b) => {
            format!("{} {} {}", of(a), if op == BinaryOp::And { "and" } else { "or" }, of(b))
        }
        Op::Binary(op, a, b) => format!("{}({}, {})", format!("{op:?}").to_lowercase(), of(a), of(b)),
        Op::Clamp(x, low, high) => format!("clamp({}, {}, {})", of(x), of(low), of(high)),
        Op::Compare(_, a, b) => format!("{} < {}", of(a), of(b)),
        Op::Unary(op, a) => format!("{}({})", format!("{op:?}").to_lowercase(), of(a)),
        _ => "condition".to_owned(),
    }
}

/// What a value is called: its name, its number, or that it has none.
fn name(program: &Program, definition: &Definition, index: u32) -> String {
    let node = &definition.nodes[index as usize];
    match (&node.name, node.op) {
        (Some(name), _) => name.clone(),
        (None, Op::Literal(bits)) => format!("{:?}", f64::from_bits(bits)),
        (None, Op::Literal3(bits)) => format!("{:?}", bits.map(f64::from_bits)),
        (None, Op::Parameter(index)) => definition.parameters[index as usize].name.clone(),
        (None, Op::Splat(a)) => name(program, definition, a),
        (None, Op::Unary(crate::UnaryOp::Negate, a)) => format!("-{}", name(program, definition, a)),
        (None, Op::Result(call, result)) => match definition.nodes[call as usize].op {
            Op::Call(callee, _) => program.functions()[callee as usize].results[result as usize].name.clone(),
            _ => unreachable!("a result is of a call"),
        },
        (None, Op::Compare(..)) => guard(program, definition, node.op),
        _ => "..".to_owned(),
    }
}

fn reason(program: &Program, definition: &Definition, op: Op, fact: Fact) -> String {
    let of = |index: u32| name(program, definition, index);
    match (fact, op) {
        (Fact::First, Op::Binary(BinaryOp::Max, _, b)) => format!("it is never below {}", of(b)),
        (Fact::Second, Op::Binary(BinaryOp::Max, _, b)) => format!("it is never above {}, which is the result", of(b)),
        (Fact::First, Op::Binary(_, _, b)) => format!("it is never above {}", of(b)),
        (Fact::Second, Op::Binary(_, _, b)) => format!("it is never below {}, which is the result", of(b)),
        (Fact::AboveLow, Op::Clamp(_, low, _)) => format!("it is never below {}", of(low)),
        (Fact::BelowHigh, Op::Clamp(_, _, high)) => format!("it is never above {}", of(high)),
        (Fact::NotNegative, _) => "it is never negative".to_owned(),
        (Fact::NotPositive, _) => "it is never positive, so that it is negated".to_owned(),
        (Fact::Holds, _) => "it always holds".to_owned(),
        _ => "it never holds".to_owned(),
    }
}
