//! Expressions of half precision.

use crate::expression::{Binding, Expressions, literal, vector};
use crate::function::Local;
use pavo_shade::{Op, Type, UnaryOp, is_in_half};

impl Expressions<'_> {
    /// The same printer for expressions of half precision, or for others.
    pub(crate) fn with_half(&self, in_half: bool) -> Self {
        Self { in_half, ..*self }
    }

    /// Whether a node is held in half precision.
    pub(crate) fn is_half(&self, index: u32) -> bool {
        matches!(self.definition.nodes[index as usize].op, Op::Unary(UnaryOp::Half, _))
    }

    /// Whether what is rounded is written as an operation of half precision.
    pub(crate) fn is_computed_in_half(&self, operand: u32) -> bool {
        matches!(self.locals[operand as usize], Local::Written) && is_in_half(self.definition, operand)
    }

    /// The text of what is held in half precision.
    pub(crate) fn held_in_half(&self, operand: u32, ty: Type) -> (String, Binding) {
        let Some(half) = &self.dialect.half else { return self.standing(operand) };
        if self.is_computed_in_half(operand) {
            return self.with_half(true).computed(operand);
        }
        let wide = self.with_half(false);
        if half.converts {
            let name = self.dialect.type_name_held(ty, true);
            (format!("{name}({})", wide.whole(operand)), Binding::Primary)
        } else {
            wide.standing(operand)
        }
    }

    /// A node by its name, or written out.
    fn standing(&self, index: u32) -> (String, Binding) {
        match &self.locals[index as usize] {
            Local::Named { name, .. } => (name.clone(), Binding::Primary),
            Local::Written => self.computed(index),
        }
    }

    /// A constant number.
    pub(crate) fn literal(&self, value: f64) -> (String, Binding) {
        let (text, binding) = literal(self.dialect, value);
        (text + self.suffix(), binding)
    }

    /// A constant vector.
    pub(crate) fn vector(&self, components: [f64; 3]) -> String {
        match &self.dialect.half {
            Some(half) if self.in_half && half.converts => {
                let [x, y, z] = components.map(|component| self.literal(component).0);
                let name = half.types[1];
                if x == y && y == z { format!("{name}({x})") } else { format!("{name}({x}, {y}, {z})") }
            }
            _ => vector(self.dialect, components),
        }
    }

    fn suffix(&self) -> &'static str {
        self.dialect.half.as_ref().filter(|_| self.in_half).map_or("", |half| half.suffix)
    }
}
