//! The graph computes what the Rust function computes, bit for bit: written functions at seeded points.
//!
//! `interpret::evaluate` runs the recorded graph in `f64`; the same function runs on `f64` itself.

mod common;

use common::{same_number, scalars, vector};
use pavo_shade::{Expr, Graph, Mask, Real, Scalar, Vector, interpret, shade};
use proptest::prelude::RngExt;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// A computation over any number type.
trait Computation {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3;
}

/// The computation gives the same on `f64` and as a graph.
fn check<C: Computation>() {
    let graph = Graph::new();
    let [x, y] = scalars(&graph, ["x", "y"]);
    let v = vector(&graph, "v");
    // The second output keeps each input, whatever the computation does with it.
    graph.output("value", C::run::<Expr<'_>>(x, y, v).as_vec3());
    graph.output("inputs", v * (x + y));
    let program = graph.program();
    let mut rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    for _ in 0..1000 {
        let point: [f64; 5] = core::array::from_fn(|_| 8.0 * rng.random::<f64>() - 4.0);
        let [x, y, v @ ..] = point;
        let native = C::run::<f64>(x, y, v.into()).to_array();
        let graph = interpret::evaluate(&program, &point)[0];
        for (native, graph) in native.into_iter().zip(graph) {
            assert!(same_number(native, graph), "at {point:?}: {native:e} natively, {graph:e} as a graph");
        }
    }
}

struct Arithmetic;
impl Computation for Arithmetic {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let ratio = (x - y) / (x * x + S::lit(0.1));
        (v * ratio + S::Vec3::splat(y)) / (S::lit(0.3) + x.abs()) - v / S::Vec3::lit(7.0)
    }
}

#[test]
fn arithmetic_of_numbers_and_vectors_agrees() {
    check::<Arithmetic>();
}

struct Functions;
impl Computation for Functions {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let small = v.abs().sqrt() + (v.abs() + S::Vec3::lit(0.5)).inverse_sqrt();
        let waves = v.sin() * S::Vec3::splat(x.cos()) + S::Vec3::splat((-x.abs()).exp());
        small * waves + v.floor() - v.fract() * S::Vec3::splat(y.fract()) + v.powi(5)
    }
}

#[test]
fn functions_of_numbers_and_vectors_agree() {
    check::<Functions>();
}

struct Choices;
impl Computation for Choices {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let inside = x.less_than(y).and(y.less_than(S::lit(2.0)).not()).or(x.less_than(S::lit(-3.0)));
        let number = S::select(inside, x.clamp(y, S::lit(3.0)), S::mix(x, y, S::lit(0.3)));
        let lanes = v.less_than(S::Vec3::lit(0.5)).or(S::Vec3::lit(2.0).less_than(v)).not();
        let vector = S::Vec3::select(lanes, v.clamp(S::Vec3::lit(-1.0), S::Vec3::splat(number)), v.max(v * x));
        let mixed = S::Vec3::mix(vector, v.min(S::Vec3::splat(y)), S::Vec3::splat(x));
        S::Vec3::choose(inside, mixed, mixed - v)
    }
}

#[test]
fn choices_clamps_and_mixes_agree() {
    check::<Choices>();
}

struct MasksOfNumbersAndVectors;
impl Computation for MasksOfNumbersAndVectors {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let of_numbers = S::Vec3::splat(x).less_than(S::Vec3::splat(y));
        let of_vectors = v.less_than(S::Vec3::lit(1.0));
        let constant = S::Vec3::lit3([0.0, 1.0, 0.0]).less_than(S::Vec3::lit(0.5));
        let both = of_numbers.not().and(of_vectors).or(of_numbers.or(of_numbers.not()).and(constant));
        S::Vec3::select(both, v, S::Vec3::select(constant.not(), v + v, S::Vec3::lit(7.0)))
    }
}

#[test]
fn masks_of_numbers_in_place_of_vectors_combine_with_masks_of_vectors() {
    check::<MasksOfNumbersAndVectors>();
}

struct Components;
impl Computation for Components {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let swapped = S::Vec3::new(v.z(), x, v.x());
        let constant = S::Vec3::lit3([0.25, 0.5, -1.0]);
        S::Vec3::splat(v.dot(swapped))
            + swapped * S::Vec3::splat(constant.dot(v)) * constant.y()
            + S::Vec3::splat(S::Vec3::splat(x).dot(S::Vec3::splat(y)))
    }
}

#[test]
fn components_and_scalar_products_agree() {
    check::<Components>();
}

struct Directions;
impl Computation for Directions {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let constant = S::Vec3::lit3([0.3, -0.5, 0.7]).normalize();
        v.normalize() * x + constant * y + S::Vec3::splat(S::Vec3::splat(x).normalize().dot(constant))
    }
}

#[test]
fn vectors_of_length_one_agree() {
    check::<Directions>();
}

/// Two numbers.
#[shade]
struct Pair<R: Real> {
    /// The first.
    first: R,
    /// The second.
    second: R,
}

/// A vector with a factor, and a pair in it.
#[shade]
struct Parts<S: Scalar> {
    /// A direction.
    direction: S::Vec3,
    /// A factor.
    factor: S,
    /// A pair.
    pair: Pair<S>,
}

/// The sum and the product of both numbers.
#[shade]
fn sum_and_product<R: Real>(pair: Pair<R>) -> Pair<R> {
    Pair { first: pair.first + pair.second, second: pair.first * pair.second }
}

/// Takes a struct of structs and gives one back.
#[shade]
fn mixed_parts<S: Scalar>(parts: Parts<S>, amount: S) -> Parts<S> {
    let Parts { direction, factor, pair } = parts;
    let Pair { first, second } = sum_and_product(pair);
    let direction = direction * first + S::Vec3::splat(amount);
    Parts { direction, factor: factor - 0.5 * second, pair: Pair { first: second, second: amount } }
}

struct Structs;
impl Computation for Structs {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let parts = Parts { direction: v, factor: x, pair: Pair { first: y, second: S::lit(0.25) } };
        let once = mixed_parts::<S>(parts, x);
        let twice = mixed_parts::<S>(once, S::lit(1.0));
        twice.direction * twice.factor + S::Vec3::splat(once.pair.first * twice.pair.second)
    }
}

#[test]
fn structs_in_structs_agree() {
    check::<Structs>();
}

/// Horner's scheme: arrays as parameters, a loop, assignments.
#[shade]
fn polynomial<R: Real>(coefficients: [R; 4], x: R) -> [R; 2] {
    let mut value = R::lit(0.0);
    let mut slope = R::lit(0.0);
    for coefficient in coefficients {
        slope *= x;
        slope += value;
        value = value * x + coefficient;
    }
    [value, slope]
}

struct Arrays;
impl Computation for Arrays {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let [value, slope] = polynomial([x, S::lit(0.5), y, S::lit(-1.0)], y);
        let [on_vector, _] = polynomial([v, v, S::Vec3::lit(1.0), S::Vec3::lit3([1.0, 0.0, 2.0])], S::Vec3::splat(x));
        on_vector * value - v * slope
    }
}

#[test]
fn arrays_and_loops_agree() {
    check::<Arrays>();
}

/// A function of a function.
#[shade]
fn square_plus<R: Real>(x: R, #[constant] summand: f64) -> R {
    x * x + R::lit(summand)
}

/// Calls another function several times, with itself in between.
#[shade]
fn nested<R: Real>(x: R, y: R, #[runtime] weight: R) -> R {
    let inner = square_plus(x, 1.0_f64);
    let outer = square_plus(inner, 1.0_f64) - square_plus(y, 2.5_f64);
    outer * weight + square_plus(x, 1.0_f64)
}

struct NestedFunctions;
impl Computation for NestedFunctions {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        let number = nested(x, y, S::lit(0.1)) + nested(x, y, S::lit(0.2)) + nested(S::lit(2.0), y, x);
        nested(v, S::Vec3::splat(number), S::Vec3::lit(0.01)) + S::Vec3::splat(nested(number, x, y))
    }
}

#[test]
fn functions_that_call_functions_agree() {
    check::<NestedFunctions>();
}

/// Writes its numbers the way `f32` code would.
#[shade]
fn literals<R: Real>(x: R) -> R {
    let third = R::lit(1.0 / 3.0);
    let mut sum = 2.0 * x + 1e-3;
    sum += core::f64::consts::PI;
    sum -= if x_is_doubled() { x * -2.5 } else { x };
    sum / third.max(0.1)
}

fn x_is_doubled() -> bool {
    true
}

struct Literals;
impl Computation for Literals {
    fn run<S: Scalar>(x: S, y: S, v: S::Vec3) -> S::Vec3 {
        v * (literals(x) + literals(S::lit(3.0)) * y)
    }
}

#[test]
fn literals_agree() {
    check::<Literals>();
}

#[test]
fn literals_are_the_nearest_number_of_the_type() {
    assert_eq!(literals(1.0_f64), (2.0 + 1e-3 + std::f64::consts::PI + 2.5) / (1.0 / 3.0));
    assert_eq!(literals(1.0_f32), (2.0 + 1e-3 + std::f32::consts::PI + 2.5) / (1.0 / 3.0));
}
