//! Evaluation of a program node by node, to check that the graph computes what the Rust function computes.
//!
//! It is slow beside the function itself, and meant for tests and for looking into a program.

use crate::fold::{evaluate_binary, evaluate_unary};
use crate::graph::{BinaryOp, Comparison, Op, Type, UnaryOp};
use crate::program::{Definition, Program, ReturnValue};

#[derive(Clone, Debug)]
enum Computed {
    Scalar(f64),
    Vec3([f64; 3]),
    Mask(bool),
    Mask3([bool; 3]),
    Results(Vec<Computed>),
}

/// The outputs of a program in `f64`: three numbers each, a scalar repeated.
///
/// # Panics
/// If the number of inputs is not [`Program::input_components`].
pub fn evaluate(program: &Program, inputs: &[f64]) -> Vec<[f64; 3]> {
    evaluate_rounded(program, inputs, |value| value)
}

/// The outputs of a program with each value of it rounded, as to the nearest `f32`.
///
/// # Panics
/// If the number of inputs is not [`Program::input_components`].
pub fn evaluate_rounded(program: &Program, inputs: &[f64], round: fn(f64) -> f64) -> Vec<[f64; 3]> {
    assert_eq!(inputs.len(), program.input_components(), "one number per component of each input");
    let mut numbers = inputs.iter().copied().map(round);
    let mut next = || numbers.next().expect("counted above");
    let arguments = program
        .inputs()
        .iter()
        .map(|input| match input.ty {
            Type::Vec3 => Computed::Vec3([next(), next(), next()]),
            _ => Computed::Scalar(next()),
        })
        .collect::<Vec<_>>();
    run(program, program.body(), &arguments, round).iter().map(vec3).collect()
}

fn run(program: &Program, function: &Definition, arguments: &[Computed], round: fn(f64) -> f64) -> Vec<Computed> {
    let mut values: Vec<Computed> = Vec::new();
    for node in &function.nodes {
        let at = |index: u32| &values[index as usize];
        let value = match node.op {
            Op::Literal(bits) => Computed::Scalar(f64::from_bits(bits)),
            Op::Literal3(bits) => Computed::Vec3(bits.map(f64::from_bits)),
            Op::Parameter(index) => arguments[index as usize].clone(),
            Op::Unary(UnaryOp::Not, a) => match at(a) {
                Computed::Mask3(mask) => Computed::Mask3(mask.map(|component| !component)),
                mask => Computed::Mask(!truth(mask)),
            },
            Op::Unary(UnaryOp::Normalize, a) => {
                let [x, y, z] = vec3(at(a));
                let scale = 1.0 / (x * x + y * y + z * z).sqrt();
                Computed::Vec3([x * scale, y * scale, z * scale])
            }
            Op::Unary(op, a) => map(node.ty, [at(a)], |[x]| evaluate_unary(op, x)),
            Op::Binary(BinaryOp::Dot, a, b) => {
                let (a, b) = (vec3(at(a)), vec3(at(b)));
                Computed::Scalar(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])
            }
            Op::Binary(op @ (BinaryOp::And | BinaryOp::Or), a, b) => {
                let combine = |a: bool, b: bool| if op == BinaryOp::And { a & b } else { a | b };
                match (at(a), at(b)) {
                    (Computed::Mask3(a), Computed::Mask3(b)) => {
                        Computed::Mask3([combine(a[0], b[0]), combine(a[1], b[1]), combine(a[2], b[2])])
                    }
                    (a, b) => Computed::Mask(combine(truth(a), truth(b))),
                }
            }
            Op::Binary(op, a, b) => map(node.ty, [at(a), at(b)], |[a, b]| evaluate_binary(op, a, b)),
            Op::Compare(Comparison::Less, a, b) => match node.ty {
                Type::Mask3 => {
                    let (a, b) = (vec3(at(a)), vec3(at(b)));
                    Computed::Mask3([a[0] < b[0], a[1] < b[1], a[2] < b[2]])
                }
                _ => Computed::Mask(vec3(at(a))[0] < vec3(at(b))[0]),
            },
            Op::Select(condition, a, b) => match at(condition) {
                Computed::Mask3(mask) => {
                    let (a, b) = (vec3(at(a)), vec3(at(b)));
                    Computed::Vec3(core::array::from_fn(|index| if mask[index] { a[index] } else { b[index] }))
                }
                mask => (if truth(mask) { at(a) } else { at(b) }).clone(),
            },
            Op::Clamp(x, low, high) => map(node.ty, [at(x), at(low), at(high)], |[x, low, high]| x.max(low).min(high)),
            Op::Mix(a, b, t) => map(node.ty, [at(a), at(b), at(t)], |[a, b, t]| a * (1.0 - t) + b * t),
            Op::Vec3(x, y, z) => Computed::Vec3([vec3(at(x))[0], vec3(at(y))[0], vec3(at(z))[0]]),
            Op::Splat(a) => Computed::Vec3(vec3(at(a))),
            Op::Fetch(table, index) => Computed::Vec3(program.tables()[table as usize].row(vec3(at(index))[0])),
            Op::Component(a, index) => Computed::Scalar(vec3(at(a))[usize::from(index)]),
            Op::Call(callee, call) => {
                let arguments: Vec<Computed> =
                    function.calls[call as usize].iter().map(|&index| at(index).clone()).collect();
                Computed::Results(run(program, &program.functions()[callee as usize], &arguments, round))
            }
            Op::Result(call, index) => match at(call) {
                Computed::Results(results) => results[index as usize].clone(),
                _ => unreachable!("a result is of a call"),
            },
        };
        values.push(match value {
            Computed::Scalar(value) => Computed::Scalar(round(value)),
            Computed::Vec3(value) => Computed::Vec3(value.map(round)),
            other => other,
        });
    }
    let results = function.results.iter().map(|result| match result.value {
        ReturnValue::Literal(value) => Computed::Scalar(value),
        ReturnValue::Literal3(value) => Computed::Vec3(value),
        ReturnValue::Node(index) => values[index as usize].clone(),
    });
    results.collect()
}

fn vec3(value: &Computed) -> [f64; 3] {
    match value {
        Computed::Scalar(value) => [*value; 3],
        Computed::Vec3(value) => *value,
        _ => unreachable!("a number is expected here"),
    }
}

fn truth(value: &Computed) -> bool {
    match value {
        Computed::Mask(value) => *value,
        _ => unreachable!("a truth value is expected here"),
    }
}

fn map<const N: usize>(ty: Type, operands: [&Computed; N], f: impl Fn([f64; N]) -> f64) -> Computed {
    let operands = operands.map(vec3);
    let at = |component: usize| f(operands.map(|operand| operand[component]));
    if ty == Type::Vec3 { Computed::Vec3([at(0), at(1), at(2)]) } else { Computed::Scalar(at(0)) }
}
