//! Expressions where Rust writes them in another way than the shading languages.

use crate::expression::{Binding, Expressions};
use crate::function::Local;
use crate::text::PrintedTable;
use pavo_shade::{BinaryOp, Comparison, Definition, Node, Op, Type, UnaryOp, operands};

/// The operands of a node, as often as its text in Rust names them.
pub fn named_operands(definition: &Definition, node: &Node) -> Vec<u32> {
    match node.op {
        Op::Mix(a, b, part) => match scalar_part(definition, part) {
            Some(number) => vec![a, b, number],
            None => vec![a, b, part, part],
        },
        op => operands(op).collect(),
    }
}

/// The number that a vector has in each component, as the part of `Vec3::lerp`.
fn scalar_part(definition: &Definition, part: u32) -> Option<u32> {
    match definition.nodes[part as usize].op {
        Op::Splat(number) => Some(number),
        _ => None,
    }
}

impl Expressions<'_> {
    /// The text of a node where Rust writes it in another way than the others.
    pub(crate) fn in_rust(&self, node: &Node) -> Option<(String, Binding)> {
        let is_vector = node.ty == Type::Vec3;
        let written = match node.op {
            Op::Unary(UnaryOp::Negate | UnaryOp::Not | UnaryOp::Half, _) => return None,
            Op::Unary(UnaryOp::InverseSqrt, x) => {
                let root = if is_vector { "map(f32::sqrt)" } else { "sqrt()" };
                (format!("1.0 / {}.{root}", self.receiver(x)), Binding::Product)
            }
            Op::Unary(op, x) => (format!("{}.{}", self.receiver(x), method(op, is_vector)), Binding::Primary),
            Op::Binary(BinaryOp::Min, a, b) => self.method("min", a, &[b]),
            Op::Binary(BinaryOp::Max, a, b) => self.method("max", a, &[b]),
            Op::Binary(BinaryOp::Dot, a, b) => self.method("dot", a, &[b]),
            Op::Compare(Comparison::Less, a, b) if node.ty == Type::Mask3 => self.method("cmplt", a, &[b]),
            Op::Select(condition, a, b) => self.choice(condition, a, b),
            Op::Clamp(x, low, high) if self.is_literal(low) && self.is_literal(high) => {
                self.method("clamp", x, &[low, high])
            }
            // The method of f32 panics where the ends are not in order.
            Op::Clamp(x, low, high) => {
                let text = format!("{}.max({}).min({})", self.receiver(x), self.whole(low), self.whole(high));
                (text, Binding::Primary)
            }
            Op::Mix(a, b, part) => self.mix(a, b, part),
            Op::Vec3(x, y, z) => {
                let [x, y, z] = [x, y, z].map(|index| self.whole(index));
                (format!("Vec3::new({x}, {y}, {z})"), Binding::Primary)
            }
            Op::Splat(x) => (format!("Vec3::splat({})", self.whole(x)), Binding::Primary),
            Op::Fetch(table, row) => {
                // An index beyond the last row would panic.
                let PrintedTable { name, rows } = &self.tables[table as usize];
                let row = self.at_least(row, Binding::Primary);
                (format!("{name}[({row} as usize).min({})]", rows.saturating_sub(1)), Binding::Primary)
            }
            _ => return None,
        };
        Some(written)
    }

    /// What stands before a point; a number there has to say its type.
    fn receiver(&self, index: u32) -> String {
        match (&self.locals[index as usize], self.definition.nodes[index as usize].op) {
            (Local::Written, Op::Literal(bits)) if f64::from_bits(bits).is_sign_negative() => {
                format!("({}_f32)", self.whole(index))
            }
            (Local::Written, Op::Literal(_)) => format!("{}_f32", self.whole(index)),
            _ => self.at_least(index, Binding::Primary),
        }
    }

    fn method(&self, name: &str, x: u32, others: &[u32]) -> (String, Binding) {
        let others: Vec<String> = others.iter().map(|&other| self.whole(other)).collect();
        (format!("{}.{name}({})", self.receiver(x), others.join(", ")), Binding::Primary)
    }

    fn is_literal(&self, index: u32) -> bool {
        matches!(self.definition.nodes[index as usize].op, Op::Literal(_) | Op::Literal3(_))
    }

    fn is_number(&self, index: u32) -> bool {
        let op = self.definition.nodes[index as usize].op;
        matches!((&self.locals[index as usize], op), (Local::Written, Op::Literal(_)))
    }

    /// Whether a number is written as literals alone.
    fn has_no_type(&self, index: u32) -> bool {
        match (&self.locals[index as usize], self.definition.nodes[index as usize].op) {
            _ if self.is_number(index) => true,
            (Local::Written, Op::Select(_, a, b)) => self.has_no_type(a) && self.has_no_type(b),
            _ => false,
        }
    }

    fn choice(&self, condition: u32, a: u32, b: u32) -> (String, Binding) {
        if self.definition.nodes[condition as usize].ty == Type::Mask3 {
            let [condition, a, b] = [condition, a, b].map(|index| self.whole(index));
            return (format!("Vec3::select({condition}, {a}, {b})"), Binding::Primary);
        }
        // Of two numbers one has to say its type, for methods of what is chosen.
        let is_typed = self.is_number(a) && self.has_no_type(b);
        let a = self.whole(a) + if is_typed { "_f32" } else { "" };
        let (condition, b) = (self.whole(condition), self.whole(b));
        let otherwise = if b.starts_with("if ") { b } else { format!("{{ {b} }}") };
        (format!("if {condition} {{ {a} }} else {otherwise}"), Binding::Choice)
    }

    fn mix(&self, a: u32, b: u32, part: u32) -> (String, Binding) {
        if let Some(number) = scalar_part(self.definition, part) {
            let (b, number) = (self.whole(b), self.whole(number));
            return (format!("{}.lerp({b}, {number})", self.receiver(a)), Binding::Primary);
        }
        let [a, b] = [a, b].map(|index| self.at_least(index, Binding::Product));
        let factor = self.at_least(part, Binding::Product.tighter());
        let rest = format!("(1.0 - {})", self.at_least(part, Binding::Product));
        (format!("{a} * {rest} + {b} * {factor}"), Binding::Sum)
    }
}

/// The call of a method without operands.
fn method(op: UnaryOp, is_vector: bool) -> &'static str {
    match (op, is_vector) {
        (UnaryOp::Sqrt, false) => "sqrt()",
        (UnaryOp::Sqrt, true) => "map(f32::sqrt)",
        (UnaryOp::Sin, false) => "sin()",
        (UnaryOp::Sin, true) => "map(f32::sin)",
        (UnaryOp::Cos, false) => "cos()",
        (UnaryOp::Cos, true) => "map(f32::cos)",
        (UnaryOp::Exp, _) => "exp()",
        (UnaryOp::Abs, _) => "abs()",
        (UnaryOp::Floor, _) => "floor()",
        // The method `fract` of Rust cuts towards zero.
        (UnaryOp::Fract, false) => "rem_euclid(1.0)",
        (UnaryOp::Fract, true) => "fract_gl()",
        (UnaryOp::Normalize, _) => "normalize()",
        (UnaryOp::InverseSqrt | UnaryOp::Negate | UnaryOp::Not | UnaryOp::Half, _) => {
            unreachable!("they are no methods")
        }
    }
}
