//! Exact folding. Each rule gives the same value as the operation that it replaces, for finite values; literals are
//! combined in `f64` as the CPU would.
//!
//! | operation | becomes |
//! |---|---|
//! | literal, literal | their value |
//! | `x + 0`, `0 + x`, `x - 0` | `x` |
//! | `0 - x` | `-x` |
//! | `x - x` | `0` |
//! | `x + (-y)`, `x - (-y)` | `x - y`, `x + y` |
//! | `x * 1`, `1 * x`, `x / 1` | `x` |
//! | `x * -1`, `-1 * x`, `x / -1` | `-x` |
//! | `x * 0`, `0 * x`, `0 / x` | `0` |
//! | `-(-x)` | `x` |
//! | `abs(abs(x))`, `abs(-x)` | `abs(x)` |
//! | `min(x, x)`, `max(x, x)`, `select(m, x, x)` | `x` |

use crate::expr::{Expr, ExprMask};
use crate::graph::{BinaryOp, Graph, NodeId, Op, UnaryOp};

/// A constant vector; one with equal components is kept as a number.
pub(crate) fn literal3<'g>(value: [f64; 3]) -> Expr<'g> {
    let [x, y, z] = value.map(f64::to_bits);
    if x == y && y == z { Expr::Literal(value[0]) } else { Expr::Literal3(value) }
}

/// The one expression that both are, if they are the same.
pub(crate) fn same<'g>(a: Expr<'g>, b: Expr<'g>) -> Option<Expr<'g>> {
    let equal = match (a, b) {
        (Expr::Literal(a), Expr::Literal(b)) => a.to_bits() == b.to_bits(),
        (Expr::Literal3(a), Expr::Literal3(b)) => a.map(f64::to_bits) == b.map(f64::to_bits),
        (Expr::Node(_, a), Expr::Node(_, b)) => a == b,
        _ => false,
    };
    equal.then_some(a)
}

/// The components of a literal.
fn components(expr: Expr<'_>) -> Option<[f64; 3]> {
    match expr {
        Expr::Literal(value) => Some([value; 3]),
        Expr::Literal3(value) => Some(value),
        Expr::Node(..) => None,
    }
}

fn is(expr: Expr<'_>, number: f64) -> bool {
    matches!(expr, Expr::Literal(value) if value == number)
}

fn negated<'g>(expr: Expr<'g>) -> Option<Expr<'g>> {
    let (graph, op, id) = expr.op()?;
    match op {
        Op::Unary(UnaryOp::Negate, index) => Some(node(graph, id, index)),
        _ => None,
    }
}

fn node(graph: &Graph, id: NodeId, index: u32) -> Expr<'_> {
    Expr::Node(graph, NodeId { index, ..id })
}

fn zip(a: [f64; 3], b: [f64; 3], f: impl Fn(f64, f64) -> f64) -> [f64; 3] {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}

/// The value of an operation on literals.
pub(crate) fn evaluate_unary(op: UnaryOp, x: f64) -> f64 {
    match op {
        UnaryOp::Negate => -x,
        UnaryOp::Sqrt => x.sqrt(),
        UnaryOp::InverseSqrt => 1.0 / x.sqrt(),
        UnaryOp::Sin => x.sin(),
        UnaryOp::Cos => x.cos(),
        UnaryOp::Exp => x.exp(),
        UnaryOp::Abs => x.abs(),
        UnaryOp::Floor => x.floor(),
        UnaryOp::Fract => x - x.floor(),
        UnaryOp::Half => crate::real::Real::half(x),
        UnaryOp::Normalize | UnaryOp::Not => unreachable!("not an operation on a number"),
    }
}

/// The value of an operation on literals.
pub(crate) fn evaluate_binary(op: BinaryOp, a: f64, b: f64) -> f64 {
    match op {
        BinaryOp::Add => a + b,
        BinaryOp::Subtract => a - b,
        BinaryOp::Multiply => a * b,
        BinaryOp::Divide => a / b,
        BinaryOp::Min => a.min(b),
        BinaryOp::Max => a.max(b),
        BinaryOp::Dot | BinaryOp::And | BinaryOp::Or => unreachable!("not an operation on two numbers"),
    }
}

#[track_caller]
pub(crate) fn unary<'g>(op: UnaryOp, x: Expr<'g>) -> Option<Expr<'g>> {
    if let Some(values) = components(x) {
        return Some(literal3(values.map(|value| evaluate_unary(op, value))));
    }
    let (graph, inner, id) = x.op()?;
    match (op, inner) {
        (UnaryOp::Negate, Op::Unary(UnaryOp::Negate, index)) => Some(node(graph, id, index)),
        (UnaryOp::Abs, Op::Unary(UnaryOp::Abs, _)) | (UnaryOp::Half, Op::Unary(UnaryOp::Half, _)) => Some(x),
        (UnaryOp::Abs, Op::Unary(UnaryOp::Negate, index)) => Some(crate::real::Real::abs(node(graph, id, index))),
        _ => None,
    }
}

#[track_caller]
pub(crate) fn binary<'g>(op: BinaryOp, a: Expr<'g>, b: Expr<'g>) -> Option<Expr<'g>> {
    if op == BinaryOp::Dot {
        return None;
    }
    if let (Some(a), Some(b)) = (components(a), components(b)) {
        return Some(literal3(zip(a, b, |a, b| evaluate_binary(op, a, b))));
    }
    match op {
        BinaryOp::Add if is(a, 0.0) => Some(b),
        BinaryOp::Add | BinaryOp::Subtract if is(b, 0.0) => Some(a),
        BinaryOp::Subtract if is(a, 0.0) => Some(-b),
        BinaryOp::Subtract if same(a, b).is_some() => Some(Expr::Literal(0.0)),
        // No closures: they would hide where the caller stands.
        BinaryOp::Add => match (negated(a), negated(b)) {
            (_, Some(b)) => Some(a - b),
            (Some(a), None) => Some(b - a),
            (None, None) => None,
        },
        BinaryOp::Subtract => {
            let b = negated(b)?;
            Some(a + b)
        }
        BinaryOp::Multiply if is(a, 1.0) => Some(b),
        BinaryOp::Multiply | BinaryOp::Divide if is(b, 1.0) => Some(a),
        BinaryOp::Multiply if is(a, -1.0) => Some(-b),
        BinaryOp::Multiply | BinaryOp::Divide if is(b, -1.0) => Some(-a),
        BinaryOp::Multiply if is(a, 0.0) || is(b, 0.0) => Some(Expr::Literal(0.0)),
        BinaryOp::Divide if is(a, 0.0) => Some(Expr::Literal(0.0)),
        BinaryOp::Min | BinaryOp::Max => same(a, b),
        _ => None,
    }
}

/// A constant mask; one with equal components is kept as a truth value.
pub(crate) fn literal_mask<'g>(mask: [bool; 3]) -> ExprMask<'g> {
    let [x, y, z] = mask;
    if x == y && y == z { ExprMask::Literal(x) } else { ExprMask::Literal3(mask) }
}

pub(crate) fn compare_literals<'g>(a: Expr<'g>, b: Expr<'g>) -> ExprMask<'g> {
    let (Some(a), Some(b)) = (components(a), components(b)) else { unreachable!("both are literals") };
    literal_mask([a[0] < b[0], a[1] < b[1], a[2] < b[2]])
}

pub(crate) fn dot_literals<'g>(a: Expr<'g>, b: Expr<'g>) -> Expr<'g> {
    let (Some(a), Some(b)) = (components(a), components(b)) else { unreachable!("both are literals") };
    Expr::Literal(zip(a, b, |a, b| a * b).iter().sum())
}

pub(crate) fn normalize_literal<'g>(vector: Expr<'g>) -> Expr<'g> {
    let Some(vector) = components(vector) else { unreachable!("it is a literal") };
    let scale = 1.0 / vector.iter().map(|component| component * component).sum::<f64>().sqrt();
    literal3(vector.map(|component| component * scale))
}
