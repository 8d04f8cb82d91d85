//! Functions that only pass on to another one.

mod common;

use common::{function_names, functions, input_names, program, scalar, vector};
use pavo_shade::{Expr, Graph, Real, Scalar, interpret, shade};

/// Only passes on, in order.
#[shade]
fn front<S: Scalar>(v: S::Vec3, x: S) -> S::Vec3 {
    back::<S>(v, x)
}

/// Does the work.
#[shade]
fn back<S: Scalar>(v: S::Vec3, x: S) -> S::Vec3 {
    v * x.sin()
}

#[test]
fn a_function_that_only_passes_on_is_left_out() {
    let graph = Graph::new();
    let (v, x) = (vector(&graph, "v"), scalar(&graph, "x"));
    graph.output("value", front::<Expr<'_>>(v, x));
    let program = graph.program();
    assert_eq!(program.functions().len(), 1);
    assert_eq!(function_names(&program), ["front"]);
    assert_eq!(input_names(&program), ["v", "x"]);
    let native = front::<f64>([1.0, 2.0, 3.0].into(), 0.5);
    assert_eq!(interpret::evaluate(&program, &[1.0, 2.0, 3.0, 0.5]), [native.to_array()]);
}

/// Reads only one of its parameters when the other factor is literal 0.
#[shade]
fn sum_of_products<R: Real>(a: R, b: R, c: R, d: R) -> R {
    a * b + c * d
}

/// Only passes on, in order.
#[shade]
fn forwarded_sum_of_products<R: Real>(a: R, b: R, c: R, d: R) -> R {
    sum_of_products(a, b, c, d)
}

#[test]
fn definitions_behind_a_function_that_only_passes_on_are_merged_too() {
    let program = program(["x", "y", "z"], |[x, y, _]| {
        let zero = Expr::lit(0.0);
        let once = forwarded_sum_of_products(x, y, Expr::lit(5.0), zero);
        vec![once, forwarded_sum_of_products(y, x, Expr::lit(6.0), zero)]
    });
    assert_eq!(functions(&program), ["forwarded_sum_of_products(a, b) = (a * b)"]);
}

#[test]
fn a_function_that_is_also_called_by_itself_keeps_its_name() {
    let graph = Graph::new();
    let (v, x) = (vector(&graph, "v"), scalar(&graph, "x"));
    graph.output("front", front::<Expr<'_>>(v, x));
    graph.output("back", back::<Expr<'_>>(v + v, x));
    let program = graph.program();
    assert!(function_names(&program).contains(&"back"), "{:?}", function_names(&program));
}
