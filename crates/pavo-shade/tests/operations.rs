//! How many operations an evaluation takes.

mod common;

use common::{scalars, vector};
use pavo_shade::{Expr, Graph, Operations, Real, Vector, shade};

type Expression = for<'g> fn(Expr<'g>, Expr<'g>, Expr<'g>) -> Expr<'g>;

/// Each expression of two numbers and a vector takes these: arithmetic, roots, transcendental functions.
fn check(cases: &[(Expression, [usize; 3])]) {
    for (number, (expression, expected)) in cases.iter().enumerate() {
        let graph = Graph::new();
        let [x, y] = scalars(&graph, ["x", "y"]);
        graph.output("value", expression(x, y, vector(&graph, "v")));
        let [arithmetic, roots, transcendental] = *expected;
        assert_eq!(
            graph.program().operations(),
            Operations { arithmetic, roots, transcendental, fetches: 0 },
            "case {number}"
        );
    }
}

/// A sine and two products.
#[shade]
fn wave<R: Real>(x: R) -> R {
    x.sin() * x * 2.0
}

#[test]
fn operations_are_counted_by_what_they_cost() {
    check(&[
        (|x, _, _| x, [0, 0, 0]),
        (|x, y, _| x + y, [1, 0, 0]),
        (|x, y, _| (x - y) * (x + y), [3, 0, 0]),
        (|x, y, _| x / y, [0, 1, 0]),
        (|x, _, _| x.sqrt() + x.inverse_sqrt(), [1, 2, 0]),
        (|x, y, _| x.sin() * y.cos() * x.exp(), [2, 0, 3]),
        (|x, y, _| Expr::select(x.less_than(y), x, -y), [2, 0, 0]),
        (|x, y, _| x.clamp(Expr::lit(0.0), y), [2, 0, 0]),
    ]);
}

#[test]
fn a_vector_counts_for_three() {
    check(&[
        (|_, _, v| v + v, [3, 0, 0]),
        (|x, _, v| v / x, [0, 3, 0]),
        (|_, _, v| v.exp(), [0, 0, 3]),
        (|x, _, v| v.min(x), [3, 0, 0]),
        (|_, _, v| v.dot(v), [5, 0, 0]),
        (|x, _, v| Expr::mix(v, v * x, x), [15, 0, 0]),
    ]);
}

#[test]
fn a_shared_value_counts_once_and_each_call_in_full() {
    check(&[
        (|x, y, _| (x * y) + (x * y), [2, 0, 0]),
        (|x, y, _| wave(x) + wave(y), [5, 0, 2]),
        (|x, _, _| wave(x) + wave(x), [3, 0, 1]),
    ]);
}
