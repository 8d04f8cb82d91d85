//! Programs on the numbers that functions are judged by: as the interpreter has it, and with the errors of functions.

mod common;
mod random;

use common::{scalars, vector};
use pavo_shade::emulated::Contracting;
use pavo_shade::interval::Single;
use pavo_shade::{
    Dual, Emulated, Expr, FunctionErrors, Graph, Input, Program, Rate, Real, bounds_over, evaluate, evaluate_inexact,
    interpret,
};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use random::{Step, Values, program};

/// A random program of which each value is an output.
fn recorded(steps: &[Step]) -> Program {
    let graph = Graph::new();
    let [x, y] = scalars(&graph, ["x", "y"]);
    let values = Values::<Expr<'_>>::new(x, y, vector(&graph, "v")).run(steps);
    values.numbers.into_iter().chain(values.vectors).for_each(|value| graph.output("value", value));
    graph.program()
}

#[test]
fn random_programs_have_the_values_of_the_interpreter_and_lie_within_bounds_of_points() {
    let config = Config { cases: 1000, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let outcome = runner.run(&program(), |(steps, point)| {
        let program = recorded(&steps);
        let expected = interpret::evaluate(&program, &point);
        let found = evaluate(&program, &[point.to_vec()]).remove(0);
        let dual = evaluate(&program, &[Dual::variables(point).to_vec()]).remove(0);
        let inexact = evaluate_inexact(&program, &[point.to_vec()], FunctionErrors::default()).remove(0);
        let bounds = bounds_over::<Single>(&program, &[point.map(|number| [number, number]).to_vec()]).remove(0);
        for (index, expected) in expected.iter().enumerate() {
            for (component, &expected) in expected.iter().enumerate() {
                let found = [found[index][component], dual[index][component].value, inexact[index][component]];
                // A vector is scaled by the same sum in another order.
                let near = |found: f64| {
                    common::same_number(found, expected) || (found - expected).abs() <= 1e-12 * expected.abs()
                };
                prop_assert!(found.into_iter().all(near), "{:?} instead of {:e}", found, expected);
                prop_assert!(bounds[index][component].contains(expected));
            }
        }
        Ok(())
    });
    assert!(outcome.is_ok(), "{}", outcome.err().map_or_else(String::new, |failure| failure.to_string()));
}

/// A program of one number.
fn of(function: fn(Expr<'_>) -> Expr<'_>) -> Program {
    let graph = Graph::new();
    let x = graph.input(Input::scalar("x", "", -100.0, 100.0, Rate::Pixel));
    graph.output("value", function(x));
    graph.program()
}

type Function = fn(Expr<'_>) -> Expr<'_>;

/// A function, the errors of sines, cosines and exponentials, and the largest that its values then have.
const FUNCTIONS: [(&str, Function, FunctionErrors, f64); 6] = [
    ("sin", |x| x.sin(), FunctionErrors { sin: 1e-3, cos: 0.0, exp: 0.0 }, 1e-3),
    ("sin", |x| x.sin(), FunctionErrors { sin: 0.0, cos: 1e-3, exp: 1e-3 }, 0.0),
    ("cos", |x| x.cos(), FunctionErrors { sin: 0.0, cos: 1e-3, exp: 0.0 }, 1e-3),
    ("cos", |x| x.cos(), FunctionErrors { sin: 1e-3, cos: 0.0, exp: 1e-3 }, 0.0),
    ("exp", |x| x.exp() * Expr::lit(0.001), FunctionErrors { sin: 1e-3, cos: 1e-3, exp: 0.0 }, 0.0),
    ("exp", |x| (x * Expr::lit(1e-3)).exp(), FunctionErrors { sin: 0.0, cos: 0.0, exp: 1e-3 }, 1.04e-3),
];

#[test]
fn errors_of_functions_reach_what_they_are_given_and_no_other_function() {
    for (name, function, errors, largest) in FUNCTIONS {
        let program = of(function);
        let points: Vec<Vec<f64>> = (0..1000).map(|step| vec![f64::from(step) * 0.07 - 35.0]).collect();
        let exact = evaluate(&program, &points);
        let found = evaluate_inexact(&program, &points, errors);
        let error = exact.iter().zip(&found).map(|(exact, found)| (exact[0][0] - found[0][0]).abs());
        let error = error.fold(0.0, f64::max);
        assert!(error <= largest && error >= 0.7 * largest, "{name} with {errors:?}: {error}, allowed {largest}");
    }
}

#[test]
fn contraction_reaches_products_of_a_program() {
    let program = of(|x| x * x - x);
    let a = 1.0 + f32::EPSILON;
    let found = evaluate(&program, &[vec![Emulated::<Contracting>::new(a)]])[0][0][0];
    assert_eq!(found.value(), a.mul_add(a, -a));
}
