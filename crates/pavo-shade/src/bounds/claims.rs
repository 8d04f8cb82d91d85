//! What may be proven of a program: that one operand of a guard never is the smaller one, or that a condition is
//! always the same.

use super::layout::{Layout, Slots, width};
use crate::graph::{BinaryOp, Op, Type, UnaryOp};

/// What a proof says of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fact {
    /// Of two operands, the result is the first.
    First,
    /// Of two operands, the result is the second.
    Second,
    /// What is clamped is not below the lower limit.
    AboveLow,
    /// What is clamped is not above the upper limit.
    BelowHigh,
    /// The operand is not negative.
    NotNegative,
    /// The operand is not positive.
    NotPositive,
    /// The condition holds.
    Holds,
    /// The condition fails.
    Fails,
}

/// That one value is at least another, in each component, whenever a node of a function is evaluated.
#[derive(Clone, Debug)]
pub(crate) struct Claim {
    pub function: usize,
    pub node: u32,
    pub fact: Fact,
    /// The value that is said to be at least the other.
    pub left: Slots,
    pub right: Slots,
    pub width: usize,
    /// The value of which the record gives the bounds.
    pub subject: Slots,
    /// The bounds of the subject, as far as the claim is proven.
    pub bounds: [f64; 2],
}

/// All claims on a program.
pub(super) fn claims(layout: &Layout<'_>) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (function, definition) in layout.definitions.iter().enumerate() {
        let slots = &layout.frames[function].nodes;
        let of = |index: u32| slots[index as usize];
        for (node, index) in definition.nodes.iter().zip(0..) {
            let own = of(index);
            let pairs: Vec<(Fact, Slots, Slots, Slots)> = match node.op {
                Op::Binary(BinaryOp::Max, a, b) => {
                    let (a, b) = (of(a), of(b));
                    vec![(Fact::First, a, b, a), (Fact::Second, b, a, a)]
                }
                Op::Binary(BinaryOp::Min, a, b) => {
                    let (a, b) = (of(a), of(b));
                    vec![(Fact::First, b, a, a), (Fact::Second, a, b, a)]
                }
                Op::Clamp(x, low, high) => {
                    let (x, low, high) = (of(x), of(low), of(high));
                    vec![(Fact::AboveLow, x, low, x), (Fact::BelowHigh, high, x, x)]
                }
                Op::Unary(UnaryOp::Abs, a) => {
                    let a = of(a);
                    vec![(Fact::NotNegative, a, layout.zero, a), (Fact::NotPositive, layout.zero, a, a)]
                }
                Op::Compare(_, a, _) => {
                    vec![(Fact::Holds, own, layout.one, of(a)), (Fact::Fails, layout.zero, own, of(a))]
                }
                _ if matches!(node.ty, Type::Mask | Type::Mask3) => {
                    vec![(Fact::Holds, own, layout.one, own), (Fact::Fails, layout.zero, own, own)]
                }
                _ => Vec::new(),
            };
            claims.extend(pairs.into_iter().map(|(fact, left, right, subject)| Claim {
                function,
                node: index,
                fact,
                left,
                right,
                width: width(node.ty),
                subject,
                bounds: [f64::INFINITY, f64::NEG_INFINITY],
            }));
        }
    }
    claims
}
