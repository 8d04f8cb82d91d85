//! Expressions where HLSL and OSL write out each component: HLSL's choice between vectors is another in each of its
//! versions, and OSL has neither vectors of truth values nor a fraction.

use crate::dialect::{Dialect, Syntax};
use crate::expression::{Binding, Expressions};
use crate::rust;
use pavo_shade::{BinaryOp, Comparison, Definition, Node, Op, Type, UnaryOp, operands};

impl Dialect {
    /// The operands of a node, as often as its text names them.
    pub fn named_operands(&self, definition: &Definition, node: &Node) -> Vec<u32> {
        if self.syntax == Syntax::Rust {
            return rust::named_operands(definition, node);
        }
        let times = if self.is_in_parts(definition, node) { 3 } else { 1 };
        operands(node.op).flat_map(|operand| std::iter::repeat_n(operand, times)).collect()
    }

    /// Whether a node is written once for each component.
    fn is_in_parts(&self, definition: &Definition, node: &Node) -> bool {
        let of_masks = node.ty == Type::Mask3;
        match (self.syntax, node.op) {
            (Syntax::Hlsl | Syntax::Osl, Op::Select(condition, ..)) => {
                definition.nodes[condition as usize].ty == Type::Mask3
            }
            (Syntax::Hlsl, Op::Binary(BinaryOp::And | BinaryOp::Or, ..)) | (Syntax::Osl, Op::Compare(..)) => of_masks,
            _ => false,
        }
    }
}

impl Expressions<'_> {
    /// The text of a node where HLSL or OSL writes it in another way than GLSL.
    pub(crate) fn in_parts(&self, node: &Node) -> Option<(String, Binding)> {
        let is_osl = self.dialect.syntax == Syntax::Osl;
        let vector = |component: &dyn Fn(usize) -> String| {
            let [x, y, z] = [0, 1, 2].map(component);
            (format!("{}({x}, {y}, {z})", self.dialect.type_name(node.ty)), Binding::Primary)
        };
        let written = match node.op {
            _ if self.dialect.is_in_parts(self.definition, node) => match node.op {
                Op::Select(condition, a, b) => vector(&|part| {
                    let [a, b] = [a, b].map(|index| self.part(index, part));
                    let is_true = if is_osl { " != 0.0" } else { "" };
                    format!("{}{is_true} ? {a} : {b}", self.part(condition, part))
                }),
                Op::Compare(Comparison::Less, a, b) => {
                    vector(&|part| format!("{} < {}", self.part(a, part), self.part(b, part)))
                }
                Op::Binary(op, a, b) => {
                    let operator = if op == BinaryOp::And { "&&" } else { "||" };
                    vector(&|part| format!("{} {operator} {}", self.part(a, part), self.part(b, part)))
                }
                _ => return None,
            },
            Op::Splat(x) if !is_osl => {
                (format!("({}){}", self.dialect.type_name(node.ty), self.at_least(x, Binding::Primary)), Binding::Unary)
            }
            Op::Component(vector, component) if is_osl => (self.part(vector, usize::from(component)), Binding::Primary),
            Op::Fetch(table, row) if is_osl => {
                (format!("{}(int({}))", self.tables[table as usize].name, self.whole(row)), Binding::Primary)
            }
            Op::Unary(UnaryOp::Fract, x) if is_osl => {
                let one = if node.ty == Type::Vec3 { "vector(1.0)" } else { "1.0" };
                (format!("mod({}, {one})", self.whole(x)), Binding::Primary)
            }
            Op::Unary(UnaryOp::Not, x) if is_osl && node.ty == Type::Mask3 => {
                (format!("1.0 - {}", self.at_least(x, Binding::Product)), Binding::Sum)
            }
            Op::Binary(BinaryOp::And, a, b) if is_osl && node.ty == Type::Mask3 => {
                let operand = |index| self.at_least(index, Binding::Unary);
                (format!("{} * {}", operand(a), operand(b)), Binding::Product)
            }
            Op::Binary(BinaryOp::Or, a, b) if is_osl && node.ty == Type::Mask3 => {
                (format!("max({}, {})", self.whole(a), self.whole(b)), Binding::Primary)
            }
            _ => return None,
        };
        Some(written)
    }

    /// One component of a vector. OSL takes none of a vector that is made on the spot.
    fn part(&self, index: u32, part: usize) -> String {
        match self.definition.nodes[index as usize].op {
            Op::Literal3(bits) => return self.literal(f64::from_bits(bits[part])).0,
            Op::Splat(x) if matches!(self.definition.nodes[x as usize].op, Op::Literal(_)) => return self.whole(x),
            _ => {}
        }
        let name = self.at_least(index, Binding::Primary);
        if self.dialect.syntax == Syntax::Osl {
            format!("{name}[{part}]")
        } else {
            format!("{name}.{}", ["x", "y", "z"][part])
        }
    }
}
