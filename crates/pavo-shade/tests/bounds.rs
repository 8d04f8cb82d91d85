//! The bounds of a program enclose what it computes, in `f64` and in `f32`, and closer the more boxes there are.

mod common;
mod random;

use common::{scalars, vector};
use pavo_shade::interval::{Double, Interval, IntervalVec3, Precision, Single};
use pavo_shade::{Bounds, Expr, Graph, Input, Program, Rate, Real, Scalar, Vector, bounds, interpret, specialise};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use random::{Step, Values, program};

const POINTS: usize = 12;

/// A random program of which each value is an output.
fn recorded(steps: &[Step]) -> Program {
    let graph = Graph::new();
    let [x, y] = scalars(&graph, ["x", "y"]);
    let values = Values::<Expr<'_>>::new(x, y, vector(&graph, "v")).run(steps);
    values.numbers.into_iter().chain(values.vectors).for_each(|value| graph.output("value", value));
    graph.program()
}

fn enclose<P: Precision>(bounds: &Bounds<P>, values: &[[f64; 3]]) -> Result<(), TestCaseError> {
    for (number, (bounds, values)) in bounds.outputs.iter().zip(values).enumerate() {
        for (bounds, value) in bounds.iter().zip(values) {
            prop_assert!(bounds.contains(*value), "output {}: {:e} is outside of {:?}", number, value, bounds);
        }
    }
    Ok(())
}

fn check_random(cases: u32, check: impl Fn(Vec<Step>, Vec<[f64; 5]>) -> Result<(), TestCaseError>) {
    let config = Config { cases, failure_persistence: None, max_global_rejects: 4000, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let points = prop::collection::vec(prop::array::uniform5(-4.0..4.0), POINTS);
    let outcome = runner.run(&(program(), points), |((steps, point), mut points)| {
        points.push(point);
        check(steps, points)
    });
    assert!(outcome.is_ok(), "{}", outcome.err().map_or_else(String::new, |failure| failure.to_string()));
}

#[test]
fn bounds_of_random_programs_enclose_their_values() {
    check_random(2000, |steps, points| {
        let program = recorded(&steps);
        let single = bounds::<Single>(&program, 8);
        let double = bounds::<Double>(&program, 8);
        for point in points {
            let values = interpret::evaluate(&program, &point);
            enclose(&double, &values)?;
            enclose(&single, &values)?;
            enclose(&single, &interpret::evaluate_rounded(&program, &point, |value| f64::from(value as f32)))?;
        }
        Ok(())
    });
}

/// All numbers of a random program's values.
fn numbers<S: Scalar>(values: Values<S>) -> Vec<S> {
    values.numbers.into_iter().chain(values.vectors.into_iter().flat_map(|v| [v.x(), v.y(), v.z()])).collect()
}

#[test]
fn a_function_that_runs_on_intervals_encloses_what_it_gives_on_numbers() {
    check_random(2000, |steps, points| {
        let range = |middle: f64| Interval::<Single>::new(middle - 0.125, middle + 0.125);
        for [x, y, vector @ ..] in points {
            let intervals = Values::new(range(x), range(y), IntervalVec3(vector.map(range))).run(&steps);
            let bounds = numbers(intervals);
            for shift in [-0.125, 0.0, 0.125] {
                let [x, y, vector] = [[x; 3], [y; 3], vector].map(|values| values.map(|value| value + shift));
                let (x, y) = (x[0], y[0]);
                let in_f64 = numbers(Values::<f64>::new(x, y, vector.into()).run(&steps));
                let vector = vector.map(|value| value as f32);
                let in_f32 = numbers(Values::<f32>::new(x as f32, y as f32, vector.into()).run(&steps));
                for ((bounds, in_f64), in_f32) in bounds.iter().zip(in_f64).zip(in_f32) {
                    prop_assert!(bounds.contains(in_f64), "{:e} is outside of {:?}", in_f64, bounds);
                    prop_assert!(bounds.contains(f64::from(in_f32)), "{:e} is outside of {:?}", in_f32, bounds);
                }
            }
        }
        Ok(())
    });
}

#[test]
fn random_programs_compute_the_same_without_their_unnecessary_guards() {
    check_random(2000, |steps, points| {
        let program = recorded(&steps);
        let specialised = specialise(&program).program;
        let taken = |point: [f64; 5]| {
            let all = [("x", &point[..1]), ("y", &point[1..2]), ("v", &point[2..])];
            let taken = all.iter().filter(|(name, _)| specialised.inputs().iter().any(|input| input.name == *name));
            taken.flat_map(|(_, numbers)| numbers.iter().copied()).collect::<Vec<f64>>()
        };
        for point in points {
            let expected = interpret::evaluate(&program, &point);
            // Folding takes values to be finite.
            prop_assume!(expected.iter().flatten().all(|value| value.is_finite()));
            let found = interpret::evaluate(&specialised, &taken(point));
            for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
                prop_assert!(common::same_number(*found, *expected), "{:e} instead of {:e}", found, expected);
            }
            let round = |value| f64::from(value as f32);
            let expected = interpret::evaluate_rounded(&program, &point, round);
            let found = interpret::evaluate_rounded(&specialised, &taken(point), round);
            for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
                // Literals that only meet now are combined in f64.
                let near = (found - expected).abs() <= 1e-5 * (1.0 + expected.abs());
                prop_assert!(near || !expected.is_finite(), "in f32 {:e} instead of {:e}", found, expected);
            }
        }
        Ok(())
    });
}

#[test]
fn more_boxes_give_closer_bounds() {
    let graph = Graph::new();
    let x = graph.input(Input::scalar("x", "", 0.0, 1.0, Rate::Pixel));
    // Its values are within 0 and 0.25.
    graph.output("value", x * (Expr::lit(1.0) - x));
    let program = graph.program();
    let high = |parts: usize| bounds::<Single>(&program, parts).outputs[0][0].high();
    let found = [1, 2, 16, 1024].map(high);
    for (found, expected) in found.into_iter().zip([1.0, 0.5, 0.282, 0.2505]) {
        assert!((found - expected).abs() < 1e-3, "{found} instead of {expected}");
    }
}
