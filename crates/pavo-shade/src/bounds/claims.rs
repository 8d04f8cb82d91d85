//! What may be proven of a program: that one operand of a guard never is the smaller one, or that a condition is
//! always the same.

use crate::evaluation::{Layout, Slots, width};
use crate::graph::{BinaryOp, Op, Type, UnaryOp};
use crate::interval::{Interval, Precision};

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

/// That some values are at least others, in each component, whenever a node of a function is evaluated.
#[derive(Clone, Debug)]
pub(crate) struct Claim {
    pub function: usize,
    pub node: u32,
    pub fact: Fact,
    /// Pairs of values, of which the first is said to be at least the second.
    pub pairs: Vec<[Slots; 2]>,
    pub width: usize,
    /// The value of which the record gives the bounds.
    pub subject: Slots,
    /// The bounds of the subject, as far as the claim is proven.
    pub bounds: [f64; 2],
}

/// The bounds of no number.
pub(super) const NOTHING: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

/// The bounds of what is within either.
pub(super) fn joined(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

impl Claim {
    /// The bounds of the subject over all components.
    pub(super) fn subject_bounds<P: Precision>(&self, slots: &[Interval<P>]) -> [f64; 2] {
        let components = (0..self.width).map(|component| slots[self.subject.component(component)]);
        components.fold(NOTHING, |bounds, value| joined(bounds, [value.low(), value.high()]))
    }
}

/// All claims on a program.
pub(super) fn claims(layout: &Layout<'_>) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (function, definition) in layout.definitions.iter().enumerate() {
        let slots = &layout.frames[function].nodes;
        let of = |index: u32| slots[index as usize];
        for (node, index) in definition.nodes.iter().zip(0..) {
            let own = of(index);
            let found: Vec<(Fact, Vec<[Slots; 2]>, Slots)> = match node.op {
                Op::Binary(BinaryOp::Max, a, b) => {
                    let (a, b) = (of(a), of(b));
                    vec![(Fact::First, vec![[a, b]], a), (Fact::Second, vec![[b, a]], a)]
                }
                Op::Binary(BinaryOp::Min, a, b) => {
                    let (a, b) = (of(a), of(b));
                    vec![(Fact::First, vec![[b, a]], a), (Fact::Second, vec![[a, b]], a)]
                }
                Op::Clamp(x, low, high) => {
                    let (x, low, high) = (of(x), of(low), of(high));
                    // The upper limit acts on the lower one too.
                    vec![(Fact::AboveLow, vec![[x, low]], x), (Fact::BelowHigh, vec![[high, x], [high, low]], x)]
                }
                Op::Unary(UnaryOp::Abs, a) => {
                    let (a, zero) = (of(a), layout.zero);
                    vec![(Fact::NotNegative, vec![[a, zero]], a), (Fact::NotPositive, vec![[zero, a]], a)]
                }
                _ if matches!(node.ty, Type::Mask | Type::Mask3) => {
                    let subject = if let Op::Compare(_, a, _) = node.op { of(a) } else { own };
                    let holds = (Fact::Holds, vec![[own, layout.one]], subject);
                    vec![holds, (Fact::Fails, vec![[layout.zero, own]], subject)]
                }
                _ => Vec::new(),
            };
            claims.extend(found.into_iter().map(|(fact, pairs, subject)| Claim {
                function,
                node: index,
                fact,
                pairs,
                width: width(node.ty),
                subject,
                bounds: NOTHING,
            }));
        }
    }
    claims
}
