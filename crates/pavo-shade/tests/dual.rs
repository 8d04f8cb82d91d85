//! Dual numbers: their values are those of `f64`, and their derivatives those that differences approach.

mod common;
mod random;

use common::same_number;
use pavo_shade::{Dual, Real, Scalar, Table, Vector};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use random::{Step, Values, program};

/// All values of a program, numbers first.
fn values<S: Scalar>(steps: &[Step], [x, y, v @ ..]: [S; 5]) -> Vec<S> {
    let [a, b, c] = v;
    let Values { numbers, vectors, .. } = Values::new(x, y, S::Vec3::new(a, b, c)).run(steps);
    let components = vectors.into_iter().flat_map(|vector| [vector.x(), vector.y(), vector.z()]);
    numbers.into_iter().chain(components).collect()
}

/// The steps of the differences: a number of jumps that passes for a slope at one of them does not at the other.
const STEPS: [f64; 2] = [1e-4, 3.7e-5];
/// A derivative is known where differences agree to this, relative to the largest value.
const AGREEMENT: f64 = 1e-7;
/// Below this no row of jumps by 1 passes for a slope.
const STEEPEST: f64 = 2000.0;

/// The derivative of each value by a variable from central differences with an error of fourth order. None where the
/// program is not smooth enough around the point to tell.
fn differences(steps: &[Step], point: [f64; 5], variable: usize) -> Vec<Option<f64>> {
    let at = |offset: f64| {
        let mut point = point;
        point[variable] += offset;
        values(steps, point)
    };
    let around = STEPS.map(|step| [-2.0, -1.0, 1.0, 2.0].map(|multiple| at(multiple * step)));
    let of = |index: usize| {
        let [first, second] = [0, 1].map(|which| slope(around[which].each_ref().map(|at| at[index]), STEPS[which]));
        let (first, second) = (first?, second?);
        ((first - second).abs() <= AGREEMENT * (1.0 + first.abs())).then_some(first)
    };
    (0..around[0][0].len()).map(of).collect()
}

/// The slope in the middle of four values, two steps and one to either side.
fn slope(values: [f64; 4], step: f64) -> Option<f64> {
    let [a, b, c, d] = values;
    let (near, far) = ((c - b) / (2.0 * step), (d - a) / (4.0 * step));
    // Around a kink the slopes of the parts do not agree.
    let bend = ((b - a) / step - 2.0 * near + (d - c) / step).abs();
    let allowed = AGREEMENT * values.into_iter().fold(1.0 + near.abs(), |scale, value| scale.max(value.abs()));
    (near.abs() <= STEEPEST && (near - far).abs() <= allowed && bend <= allowed).then_some((4.0 * near - far) / 3.0)
}

#[test]
fn derivatives_of_random_programs_are_those_of_differences() {
    let config = Config { cases: 4000, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let counts = std::cell::Cell::new([0_u64; 2]);
    let outcome = runner.run(&program(), |(steps, point)| {
        let plain = values(&steps, point);
        let dual = values(&steps, Dual::variables(point));
        for (dual, plain) in dual.iter().zip(&plain) {
            prop_assert!(same_number(dual.value, *plain) || plain.is_nan(), "{:e}, not {plain:e}", dual.value);
        }
        for variable in 0..point.len() {
            for (dual, expected) in dual.iter().zip(differences(&steps, point, variable)) {
                let [checked, unknown] = counts.get();
                let Some(expected) = expected else {
                    counts.set([checked, unknown + 1]);
                    continue;
                };
                counts.set([checked + 1, unknown]);
                let found = dual.derivatives[variable];
                let scale = 1.0 + dual.value.abs() + expected.abs();
                prop_assert!(
                    (found - expected).abs() <= 1e-6 * scale,
                    "by {variable}: {found}, not {expected} at {}",
                    dual.value
                );
            }
        }
        Ok(())
    });
    assert!(outcome.is_ok(), "{}", outcome.err().map_or_else(String::new, |failure| failure.to_string()));
    let [checked, unknown] = counts.get();
    println!("{checked} derivatives checked, {unknown} unknown");
    assert!(checked > 10 * unknown, "{checked} derivatives checked, {unknown} unknown");
}

/// A function of a number, where it is taken, its value and its derivative.
type Case = (&'static str, fn(Dual<1>) -> Dual<1>, f64, f64, f64);

fn lit(value: f64) -> Dual<1> {
    Dual::lit(value)
}

#[test]
fn one_side_is_taken_where_there_is_no_derivative() {
    let infinite = f64::INFINITY;
    let cases: [Case; 18] = [
        ("abs at 0", |x| x.abs(), 0.0, 0.0, 1.0),
        ("abs below 0", |x| x.abs(), -2.0, 2.0, -1.0),
        ("floor at a whole number", |x| x.floor(), 3.0, 3.0, 0.0),
        ("fract at a whole number", |x| x.fract(), 3.0, 0.0, 1.0),
        ("max with an equal", |x| (x * lit(2.0)).max(lit(2.0)), 1.0, 2.0, 2.0),
        ("max of an equal", |x| lit(2.0).max(x * lit(2.0)), 1.0, 2.0, 0.0),
        ("min with an equal", |x| (x * lit(2.0)).min(lit(2.0)), 1.0, 2.0, 2.0),
        ("min of an equal", |x| lit(2.0).min(x * lit(2.0)), 1.0, 2.0, 0.0),
        ("clamp at its lower bound", |x| x.clamp(lit(0.0), lit(1.0)), 0.0, 0.0, 1.0),
        ("clamp at its upper bound", |x| x.clamp(lit(0.0), lit(1.0)), 1.0, 1.0, 1.0),
        ("clamp below", |x| x.clamp(lit(0.0), lit(1.0)), -0.1, 0.0, 0.0),
        ("select", |x| Dual::select(x.less_than(lit(1.0)), lit(0.5), x * x), 1.0, 1.0, 2.0),
        ("sqrt at 0", |x| x.sqrt(), 0.0, 0.0, infinite),
        ("sqrt of a constant 0", |_| lit(0.0).sqrt(), 0.0, 0.0, 0.0),
        ("sqrt of a guarded number", |x| x.max(lit(0.0)).sqrt(), -1.0, 0.0, 0.0),
        ("max with no number", |x| lit(f64::NAN).max(x), 1.0, 1.0, 1.0),
        ("min of a number and none", |x| x.min(lit(f64::NAN)), 1.0, 1.0, 1.0),
        ("inverse sqrt", |x| x.inverse_sqrt(), 4.0, 0.5, -1.0 / 16.0),
    ];
    for (name, function, at, value, derivative) in cases {
        let [x] = Dual::variables([at]);
        assert_eq!(function(x), Dual { value, derivatives: [derivative] }, "{name}");
    }
}

#[test]
fn what_is_no_number_passes_through() {
    for special in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0, f64::MAX, f64::MIN_POSITIVE / 4.0] {
        let [x, y] = Dual::variables([special, 2.0]);
        let values = [x + y, x - y, x * y, x / y, y / x, -x, x.sqrt(), x.inverse_sqrt(), x.sin(), x.cos(), x.exp()];
        let z = special;
        let plain =
            [z + 2.0, z - 2.0, z * 2.0, z / 2.0, 2.0 / z, -z, z.sqrt(), 1.0 / z.sqrt(), z.sin(), z.cos(), z.exp()];
        for (index, (value, plain)) in values.into_iter().zip(plain).enumerate() {
            assert!(same_number(value.value, plain) || plain.is_nan(), "{index} at {z}: {value:?}, not {plain}");
        }
    }
}

#[test]
fn rows_of_a_table_do_not_change_and_the_way_between_them_does() {
    let table = Table::new("squares", "", (0..5).map(|row| [f64::from(row * row), 0.0, 1.0]).collect());
    let [x] = Dual::variables([2.25]);
    let row = x.floor();
    let [low, high] = [row, row + lit(1.0)].map(|row| Dual::fetch(&table, row).x());
    assert_eq!(low, lit(4.0));
    assert_eq!(Dual::mix(low, high, x - row), Dual { value: 5.25, derivatives: [5.0] });
}
