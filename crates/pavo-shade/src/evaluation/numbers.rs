//! A program on the numbers that functions are judged by.

use super::{Evaluator, Layout, evaluator::Domain};
use crate::graph::{BinaryOp, Comparison, Op, UnaryOp};
use crate::program::Program;
use crate::real::{Scalar, Vector};
use crate::table::Table;

/// The outputs of a program at many points, on any number type whose comparisons are decided: three numbers each, a scalar
/// repeated. A point has a number for each component of each input, in the order of [`Program::inputs`].
///
/// The operations are those of the program in its order: of what is emitted, without the guards that
/// [`crate::specialise`] has left out.
///
/// # Panics
/// If the numbers of a point are not [`Program::input_components`].
pub fn evaluate<S: Scalar<Mask = bool>>(program: &Program, points: &[Vec<S>]) -> Vec<Vec<[S; 3]>> {
    let layout = Layout::new(program);
    let mut evaluator = Evaluator::<Number<S>>::new(&layout);
    let at_point = |point: &Vec<S>| {
        assert_eq!(point.len(), program.input_components(), "one number per component of each input");
        let inputs: Vec<Number<S>> = point.iter().copied().map(Number).collect();
        evaluator.outputs(&inputs).into_iter().map(|output| output.map(|Number(value)| value)).collect()
    };
    points.iter().map(at_point).collect()
}

/// A number, or a truth value as 0 and 1.
#[derive(Clone, Copy)]
pub(super) struct Number<S>(pub S);

impl<S: Scalar<Mask = bool>> Number<S> {
    fn truth(truth: bool) -> S {
        S::lit(f64::from(u8::from(truth)))
    }
}

fn holds<S: Scalar<Mask = bool>>(truth: S) -> bool {
    S::lit(0.5).less_than(truth)
}

impl<S: Scalar<Mask = bool>> Domain for Number<S> {
    fn literal(value: f64) -> Self {
        Self(S::lit(value))
    }

    fn apply(op: Op, operands: &[Self]) -> Self {
        Self(match (op, operands) {
            (Op::Unary(op, _), &[Self(x), ref rest @ ..]) => match op {
                UnaryOp::Negate => -x,
                UnaryOp::Sqrt => x.sqrt(),
                UnaryOp::InverseSqrt => x.inverse_sqrt(),
                UnaryOp::Sin => x.sin(),
                UnaryOp::Cos => x.cos(),
                UnaryOp::Exp => x.exp(),
                UnaryOp::Abs => x.abs(),
                UnaryOp::Floor => x.floor(),
                UnaryOp::Half => x.half(),
                UnaryOp::Fract => x.fract(),
                UnaryOp::Normalize => {
                    let vector = S::Vec3::new(x, rest[0].0, rest[1].0);
                    x * vector.dot(vector).inverse_sqrt()
                }
                UnaryOp::Not => Self::truth(!holds(x)),
            },
            (Op::Binary(BinaryOp::Dot, ..), &[ax, ay, az, bx, by, bz]) => {
                S::Vec3::new(ax.0, ay.0, az.0).dot(S::Vec3::new(bx.0, by.0, bz.0))
            }
            (Op::Binary(op, ..), &[Self(a), Self(b)]) => match op {
                BinaryOp::Add => a + b,
                BinaryOp::Subtract => a - b,
                BinaryOp::Multiply => a * b,
                BinaryOp::Divide => a / b,
                BinaryOp::Min => a.min(b),
                BinaryOp::Max => a.max(b),
                BinaryOp::And => Self::truth(holds(a) & holds(b)),
                BinaryOp::Or => Self::truth(holds(a) | holds(b)),
                BinaryOp::Dot => unreachable!("it has six operands"),
            },
            (Op::Compare(Comparison::Less, ..), &[Self(a), Self(b)]) => Self::truth(a.less_than(b)),
            (Op::Select(..), &[Self(mask), Self(a), Self(b)]) => S::select(holds(mask), a, b),
            (Op::Clamp(..), &[Self(x), Self(low), Self(high)]) => x.clamp(low, high),
            (Op::Mix(..), &[Self(a), Self(b), Self(t)]) => S::mix(a, b, t),
            _ => unreachable!("the other operations are no steps"),
        })
    }

    fn fetch(table: &Table, component: usize, &[Self(index), ..]: &[Self; 3]) -> Self {
        let row = S::fetch(table, index);
        Self([row.x(), row.y(), row.z()][component])
    }
}
