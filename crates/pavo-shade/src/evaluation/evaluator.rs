//! Evaluation of a laid-out program on anything that takes the place of a number: on the numbers that functions are
//! judged by, on intervals, or on what a number depends on.

use super::layout::{Copying, Layout, Slots, Step};
use crate::graph::{BinaryOp, Comparison, Op, UnaryOp};
use crate::interval::{Interval, Precision, Truth};
use crate::table::Table;

/// What takes the place of a number.
pub(crate) trait Domain: Copy {
    /// A constant.
    fn literal(value: f64) -> Self;
    /// One component of an operation, from the same component of its operands. A scalar product is given the components
    /// of both vectors, and the scaling to length 1 those of its vector from the wanted one on.
    fn apply(op: Op, operands: &[Self]) -> Self;
    /// One component of a row of a table, from the row's index and the least and the greatest of that component.
    fn fetch(table: &Table, component: usize, operands: &[Self; 3]) -> Self;
}

/// The values of a program at one evaluation.
pub(crate) struct Evaluator<'a, V> {
    layout: &'a Layout<'a>,
    pub slots: Vec<V>,
}

impl<'a, V: Domain> Evaluator<'a, V> {
    pub fn new(layout: &'a Layout<'a>) -> Self {
        let mut slots = vec![V::literal(0.0); layout.slot_count];
        for &(at, value) in &layout.literals {
            slots[at] = V::literal(value);
        }
        Self { layout, slots }
    }

    /// Evaluates a function for the numbers of its parameters, and calls `after` with each function that has run and the
    /// values.
    pub fn run(&mut self, function: usize, parameters: &[V], after: &mut impl FnMut(usize, &[V])) {
        let mut values = parameters.iter();
        for &(slots, width) in &self.layout.frames[function].parameters {
            self.slots[slots.at..slots.at + width].copy_from_slice(&values.as_slice()[..width]);
            values.nth(width - 1);
        }
        self.run_steps(function, after);
    }

    /// The outputs by component, a scalar repeated, for the numbers of the inputs.
    pub fn outputs(&mut self, inputs: &[V]) -> Vec<[V; 3]> {
        let body = self.layout.body();
        self.run(body, inputs, &mut |_, _| {});
        let results = self.layout.frames[body].results.iter();
        results.map(|slots| [0, 1, 2].map(|component| self.slots[slots.component(component)])).collect()
    }

    fn run_steps(&mut self, function: usize, after: &mut impl FnMut(usize, &[V])) {
        let layout = self.layout;
        for step in &layout.frames[function].steps {
            match step {
                Step::Compute { op, operands, count, to, width } => {
                    self.compute(*op, operands, *count, *to, *width);
                }
                Step::Gather { from, to } => {
                    for (index, from) in from.iter().enumerate() {
                        self.slots[to + index] = self.slots[from.at];
                    }
                }
                Step::Call { callee, arguments, results } => {
                    self.copy(arguments);
                    self.run_steps(*callee, after);
                    self.copy(results);
                }
            }
        }
        after(function, &self.slots);
    }

    fn copy(&mut self, values: &[Copying]) {
        for value in values {
            for component in 0..value.width {
                self.slots[value.to + component] = self.slots[value.from.component(component)];
            }
        }
    }

    #[inline]
    fn compute(&mut self, op: Op, operands: &[Slots; 3], count: usize, to: usize, width: usize) {
        let at = |operand: Slots, component: usize| self.slots[operand.component(component)];
        let [a, b, c] = *operands;
        match op {
            Op::Binary(BinaryOp::Dot, ..) => {
                let values = [at(a, 0), at(a, 1), at(a, 2), at(b, 0), at(b, 1), at(b, 2)];
                self.slots[to] = V::apply(op, &values);
            }
            Op::Unary(UnaryOp::Normalize, _) => {
                for component in 0..3 {
                    let values = [0, 1, 2].map(|turn| self.slots[a.component((component + turn) % 3)]);
                    self.slots[to + component] = V::apply(op, &values);
                }
            }
            Op::Fetch(table, _) => {
                let table = &self.layout.tables[table as usize];
                for component in 0..width {
                    let values = [a, b, c].map(|operand| self.slots[operand.component(component)]);
                    self.slots[to + component] = V::fetch(table, component, &values);
                }
            }
            _ => {
                for component in 0..width {
                    let values = [a, b, c].map(|operand| self.slots[operand.component(component)]);
                    self.slots[to + component] = V::apply(op, &values[..count]);
                }
            }
        }
    }
}

/// The parameters that a value depends on, a bit each.
impl Domain for u64 {
    fn literal(_: f64) -> Self {
        0
    }
    fn apply(_: Op, operands: &[Self]) -> Self {
        operands.iter().fold(0, |all, operand| all | operand)
    }
    fn fetch(_: &Table, _: usize, [index, ..]: &[Self; 3]) -> Self {
        *index
    }
}

/// Where a value comes from: whether it is just a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Origin {
    Parameter(usize),
    Computed,
}

impl Domain for Origin {
    fn literal(_: f64) -> Self {
        Origin::Computed
    }
    fn apply(_: Op, _: &[Self]) -> Self {
        Origin::Computed
    }
    fn fetch(_: &Table, _: usize, _: &[Self; 3]) -> Self {
        Origin::Computed
    }
}

/// Truth values are 0 and 1; an undecided one is between.
impl<P: Precision> Domain for Interval<P> {
    fn literal(value: f64) -> Self {
        Self::point(value)
    }

    fn apply(op: Op, operands: &[Self]) -> Self {
        match (op, operands) {
            (Op::Unary(op, _), &[x, ref rest @ ..]) => match op {
                UnaryOp::Negate => -x,
                UnaryOp::Sqrt => x.root(),
                UnaryOp::InverseSqrt => x.inverse_root(),
                UnaryOp::Sin => x.sine(),
                UnaryOp::Cos => x.cosine(),
                UnaryOp::Exp => x.exponential(),
                UnaryOp::Abs => x.absolute(),
                UnaryOp::Floor => x.whole(),
                UnaryOp::Fract => x.fraction(),
                UnaryOp::Half => x.held_in_half(),
                UnaryOp::Normalize => Self::normalized_component([x, rest[0], rest[1]]),
                UnaryOp::Not => Self::new(1.0 - x.high(), 1.0 - x.low()),
            },
            (Op::Binary(BinaryOp::Dot, a, b), &[ax, ay, az, bx, by, bz]) => {
                Self::dot([ax, ay, az], [bx, by, bz], a == b)
            }
            (Op::Binary(op, left, right), &[a, b]) => match op {
                BinaryOp::Add => a + b,
                BinaryOp::Subtract => a - b,
                BinaryOp::Multiply if left == right => a.square(),
                BinaryOp::Multiply => a * b,
                BinaryOp::Divide => a / b,
                BinaryOp::Min | BinaryOp::And => a.smaller(b),
                BinaryOp::Max | BinaryOp::Or => a.larger(b),
                BinaryOp::Dot => unreachable!("it has six operands"),
            },
            (Op::Compare(Comparison::Less, ..), &[a, b]) => match a.is_less(b).decided() {
                Some(holds) => Self::point(f64::from(u8::from(holds))),
                None => Self::new(0.0, 1.0),
            },
            (Op::Select(..), &[mask, a, b]) => Self::chosen(Truth::new(mask.high() > 0.0, mask.low() < 1.0), a, b),
            (Op::Clamp(..), &[x, low, high]) => x.larger(low).smaller(high),
            (Op::Mix(..), &[a, b, t]) => Self::mixed(a, b, t),
            _ => unreachable!("the other operations are no steps"),
        }
    }

    /// Any row may be read.
    fn fetch(_: &Table, _: usize, &[_, low, high]: &[Self; 3]) -> Self {
        low.hull(high)
    }
}
