//! A program in `f64` whose sines, cosines and exponentials have errors of a given size.

use super::numbers::Number;
use super::{Evaluator, Layout, evaluator::Domain};
use crate::emulated::noise::noise;
use crate::graph::{Op, UnaryOp};
use crate::program::Program;
use crate::table::Table;

/// The largest errors of functions that devices compute inexactly.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FunctionErrors {
    /// Of a sine, absolute.
    pub sin: f64,
    /// Of a cosine, absolute.
    pub cos: f64,
    /// Of an exponential, relative.
    pub exp: f64,
}

impl FunctionErrors {
    fn larger(self, other: Self) -> Self {
        Self { sin: self.sin.max(other.sin), cos: self.cos.max(other.cos), exp: self.exp.max(other.exp) }
    }
}

/// The outputs of a program at many points in `f64`, but for the errors of its functions: three numbers each, a scalar
/// repeated. Errors look random, spread evenly up to the largest, and are a function of the operand: of the same sign
/// for each size of the error, so that what they do grows with it.
///
/// # Panics
/// If the numbers of a point are not [`Program::input_components`].
pub fn evaluate_inexact(program: &Program, points: &[Vec<f64>], errors: FunctionErrors) -> Vec<Vec<[f64; 3]>> {
    let layout = Layout::new(program);
    let mut evaluator = Evaluator::<Inexact>::new(&layout);
    let at_point = |point: &Vec<f64>| {
        assert_eq!(point.len(), program.input_components(), "one number per component of each input");
        let inputs: Vec<Inexact> = point.iter().map(|&value| Inexact { value, errors }).collect();
        evaluator.outputs(&inputs).into_iter().map(|output| output.map(|number| number.value)).collect()
    };
    points.iter().map(at_point).collect()
}

/// A number, and the errors of functions of it. Constants have none: functions of them are computed before emission.
#[derive(Clone, Copy)]
struct Inexact {
    value: f64,
    errors: FunctionErrors,
}

impl Domain for Inexact {
    fn literal(value: f64) -> Self {
        Self { value, errors: FunctionErrors::default() }
    }

    fn apply(op: Op, operands: &[Self]) -> Self {
        let errors = operands.iter().fold(FunctionErrors::default(), |all, operand| all.larger(operand.errors));
        let mut values = [Number(0.0); 6];
        values.iter_mut().zip(operands).for_each(|(value, operand)| value.0 = operand.value);
        let Number(exact) = Number::<f64>::apply(op, &values[..operands.len()]);
        let noise = || noise([operands[0].value as f32, 0.0, exact as f32]);
        let value = match op {
            Op::Unary(UnaryOp::Sin, _) => exact + errors.sin * noise(),
            Op::Unary(UnaryOp::Cos, _) => exact + errors.cos * noise(),
            Op::Unary(UnaryOp::Exp, _) => exact * (1.0 + errors.exp * noise()),
            _ => exact,
        };
        Self { value, errors }
    }

    fn fetch(table: &Table, component: usize, operands: &[Self; 3]) -> Self {
        let value = table.row(operands[0].value)[component];
        Self { value, errors: operands[0].errors }
    }
}
