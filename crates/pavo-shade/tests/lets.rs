//! Forms of `let` that the rewriting must leave alone.

mod common;

use common::{outputs, scalars};
use pavo_shade::{Graph, Real, shade};

/// Takes a pair apart into names that are assigned to later.
#[shade]
fn mutable_names<R: Real>(x: R, y: R) -> R {
    let (mut sum, product) = (x + y, x * y);
    let [mut first, _] = [sum, product];
    sum = sum * product;
    first += 1.0;
    sum - first
}

#[test]
fn names_in_a_pattern_may_be_mutable() {
    assert_eq!(mutable_names(2.0, 3.0), 5.0 * 6.0 - 6.0);
    let graph = Graph::new();
    let [x, y] = scalars(&graph, ["x", "y"]);
    graph.output("value", mutable_names(x, y));
    assert_eq!(outputs(&graph.program()), ["mutable_names(x, y)"]);
}

/// Collects into what the `let` says, which is no value.
#[shade]
fn declared_types<R: Real>(#[constant] numbers: &[f64], x: R) -> R {
    let doubled: Vec<f64> = numbers.iter().map(|number| number * 2.0_f64).collect();
    let sum: f64 = doubled.iter().sum();
    let product: R = x * R::lit(sum);
    product + 1.0
}

#[test]
fn the_declared_type_of_a_let_holds() {
    assert_eq!(declared_types(&[1.0, 2.0], 10.0), 61.0);
}
