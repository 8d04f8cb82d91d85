//! The graph computes what the Rust function computes, bit for bit: random programs, which proptest makes smaller
//! where one fails.

mod common;
mod random;

use common::{same_number, scalars, vector};
use pavo_shade::{Expr, Graph, interpret};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use random::{Values, program};

#[test]
fn random_programs_compute_the_same_natively_and_as_a_graph() {
    let config = Config { cases: 4000, failure_persistence: None, max_global_rejects: 4000, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let outcome = runner.run(&program(), |(steps, point)| {
        let [x, y, vector_at @ ..] = point;
        let native = Values::<f64>::new(x, y, vector_at.into()).run(&steps);
        let numbers = native.numbers.iter().map(|&number| [number; 3]);
        let expected: Vec<[f64; 3]> = numbers.chain(native.vectors.iter().map(|vector| vector.to_array())).collect();
        // Folding takes values to be finite.
        prop_assume!(expected.iter().flatten().all(|value| value.is_finite()));

        let graph = Graph::new();
        let [x, y] = scalars(&graph, ["x", "y"]);
        let recorded = Values::<Expr<'_>>::new(x, y, vector(&graph, "v")).run(&steps);
        recorded.numbers.into_iter().chain(recorded.vectors).for_each(|value| graph.output("value", value));
        let found = interpret::evaluate(&graph.program(), &point);
        prop_assert_eq!(found.len(), expected.len());
        for (found, expected) in found.into_iter().flatten().zip(expected.into_iter().flatten()) {
            prop_assert!(same_number(found, expected), "{:e} as a graph, {:e} natively", found, expected);
        }
        Ok(())
    });
    assert!(outcome.is_ok(), "{}", outcome.err().map_or_else(String::new, |failure| failure.to_string()));
}
