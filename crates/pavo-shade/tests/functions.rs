//! Which definitions a program has: one for each function and each set of literal arguments, shared by all calls.

mod common;

use common::{check_program, function_names, functions, program, scalar, vector};
use pavo_shade::{Expr, Graph, Real, Type, interpret, shade};

const XYZ: [&str; 3] = ["x", "y", "z"];

/// A straight line.
#[shade]
fn line<R: Real>(slope: R, intercept: R, x: R) -> R {
    slope * x + intercept
}

#[test]
fn calls_with_other_values_share_one_definition() {
    check_program(
        |[x, y, z]| vec![line(x, y, z), line(y, z, x), line(x, y, z)],
        &["line(slope, intercept, x) = ((slope * x) + intercept)"],
        &["line(x, y, z)", "line(y, z, x)", "line(x, y, z)"],
    );
}

#[test]
fn the_same_call_is_one_node() {
    let program = program(XYZ, |[x, y, z]| vec![line(x, y, z) * line(x, y, z)]);
    assert_eq!(program.body().calls.len(), 1);
    assert_eq!(program.body().nodes.len(), 6, "x, y, z, the call, its result, the square");
}

#[test]
fn each_literal_argument_makes_a_definition_in_which_it_is_folded() {
    check_program(
        |[x, y, _]| vec![line(x, Expr::lit(2.0), y), line(x, Expr::lit(3.0), y), line(x, Expr::lit(0.0), y)],
        &["line(slope, x) = ((slope * x) + 2)", "line(slope, x) = ((slope * x) + 3)", "line(slope, x) = (slope * x)"],
        &["line(x, y)", "line(x, y)", "line(x, y)"],
    );
}

#[test]
fn the_same_literal_argument_makes_no_further_definition() {
    check_program(
        |[x, y, _]| vec![line(x, Expr::lit(2.0), y), line(y, Expr::lit(2.0), x)],
        &["line(slope, x) = ((slope * x) + 2)"],
        &["line(x, y)", "line(y, x)"],
    );
}

/// A parameter that stays one.
#[shade]
fn weighted<R: Real>(#[runtime] weight: R, x: R) -> R {
    weight * x.sin()
}

#[test]
fn a_runtime_parameter_stays_a_parameter() {
    check_program(
        |[x, y, _]| vec![weighted(Expr::lit(0.25), x), weighted(Expr::lit(0.75), x), weighted(y, x)],
        &["weighted(weight, x) = (weight * sin(x))"],
        &["weighted(0.25, x)", "weighted(0.75, x)", "weighted(y, x)"],
    );
}

/// A table known at build time.
#[derive(Debug)]
struct Table(Vec<f64>);

/// A polynomial with known coefficients.
#[shade]
fn polynomial<R: Real>(#[constant] table: &Table, x: R) -> R {
    table.0.iter().fold(R::lit(0.0), |sum, coefficient| sum * x + R::lit(*coefficient))
}

#[test]
fn a_constant_makes_a_definition_for_each_value() {
    let [a, b, same_as_a] = [vec![2.0, 1.0], vec![1.0, 2.0], vec![2.0, 1.0]].map(Table);
    check_program(
        |[x, y, _]| vec![polynomial(&a, x), polynomial(&b, x), polynomial(&same_as_a, y)],
        &["polynomial(x) = ((2 * x) + 1)", "polynomial(x) = (x + 2)"],
        &["polynomial(x)", "polynomial(x)", "polynomial(y)"],
    );
}

#[test]
fn constants_that_differ_in_the_last_bit_are_different() {
    let [a, b] = [0.1, 0.1_f64.next_up()].map(|number| Table(vec![number, 0.0]));
    assert_eq!(program(XYZ, |[x, _, _]| vec![polynomial(&a, x), polynomial(&b, x)]).functions().len(), 2);
}

/// Reads only one of its parameters when the other factor is literal 0.
#[shade]
fn sum_of_products<R: Real>(a: R, b: R, c: R, d: R) -> R {
    a * b + c * d
}

#[test]
fn parameters_that_literals_make_useless_are_stripped() {
    check_program(
        |[x, y, z]| vec![sum_of_products(x, y, z, Expr::lit(0.0)), sum_of_products(x, Expr::lit(0.0), y, z)],
        &["sum_of_products(a, b) = (a * b)", "sum_of_products(c, d) = (c * d)"],
        &["sum_of_products(x, y)", "sum_of_products(y, z)"],
    );
}

#[test]
fn definitions_that_come_out_alike_are_merged() {
    // The literal 5 is never used, nor is the literal 6.
    check_program(
        |[x, y, _]| {
            let zero = Expr::lit(0.0);
            vec![sum_of_products(x, y, Expr::lit(5.0), zero), sum_of_products(y, x, Expr::lit(6.0), zero)]
        },
        &["sum_of_products(a, b) = (a * b)"],
        &["sum_of_products(x, y)", "sum_of_products(y, x)"],
    );
}

#[test]
fn a_call_on_literals_alone_is_their_value() {
    check_program(|[x, _, _]| vec![x + line(Expr::lit(2.0), Expr::lit(3.0), Expr::lit(4.0))], &[], &["(x + 11)"]);
}

#[test]
fn a_call_that_gives_back_a_literal_or_an_argument_is_left_out() {
    check_program(
        |[x, y, _]| {
            let zero = Expr::lit(0.0);
            vec![line(zero, Expr::lit(7.0), x), line(zero, y, x), line(Expr::lit(1.0), zero, x)]
        },
        &[],
        &["7", "y", "x"],
    );
}

/// Two numbers.
#[shade]
struct Pair<R: Real> {
    /// The first.
    first: R,
    /// The second.
    second: R,
}

/// The first is computed, the second passed through.
#[shade]
fn half_computed<R: Real>(a: R, b: R) -> Pair<R> {
    Pair { first: a.sin(), second: b }
}

#[test]
fn results_that_pass_an_argument_through_need_no_call() {
    check_program(
        |[x, y, _]| {
            let Pair { first, second } = half_computed(x, y);
            let Pair { second: other, .. } = half_computed(y, Expr::lit(4.0));
            vec![first, second, other]
        },
        &["half_computed(a) = sin(a)"],
        &["half_computed(x)", "y", "4"],
    );
}

/// Works on numbers and on vectors.
#[shade]
fn doubled<R: Real>(x: R) -> R {
    x + x
}

#[test]
fn numbers_and_vectors_have_definitions_of_their_own() {
    let graph = Graph::new();
    let (x, v) = (scalar(&graph, "x"), vector(&graph, "v"));
    graph.output("number", doubled(x));
    graph.output("vector", doubled(v));
    let program = graph.program();
    assert_eq!(functions(&program), ["doubled(x) = (x + x)", "doubled(x) = (x + x)"]);
    let types: Vec<Type> = program.functions().iter().map(|function| function.parameters[0].ty).collect();
    assert_eq!(types, [Type::Scalar, Type::Vec3]);
}

/// Calls itself a known number of times.
#[shade]
fn continued_fraction<R: Real>(#[constant] depth: u32, x: R) -> R {
    if depth == 0 { x } else { 1.0 / (1.0 + continued_fraction(depth - 1, x)) }
}

#[test]
fn recursion_to_a_known_depth_ends() {
    let program = program(XYZ, |[x, _, _]| vec![continued_fraction(3, x), continued_fraction(1, x)]);
    assert_eq!(
        functions(&program),
        [
            "continued_fraction(x) = (1 / (1 + x))",
            "continued_fraction(x) = (1 / (1 + continued_fraction(x)))",
            "continued_fraction(x) = (1 / (1 + continued_fraction(x)))",
        ]
    );
    let golden = |depth| continued_fraction(depth, 1.0_f64);
    assert_eq!(interpret::evaluate(&program, &[1.0]), [[golden(3); 3], [golden(1); 3]]);
}

/// The innermost.
#[shade]
fn inner<R: Real>(x: R) -> R {
    x.sin() * 2.0
}

/// In the middle.
#[shade]
fn middle<R: Real>(x: R, y: R) -> R {
    inner(x) + inner(y)
}

/// The outermost.
#[shade]
fn outer<R: Real>(x: R, y: R) -> R {
    middle(y, x) * inner(x)
}

#[test]
fn callees_stand_before_their_callers() {
    let program = program(XYZ, |[x, y, _]| vec![outer(x, y)]);
    assert_eq!(function_names(&program), ["inner", "middle", "outer"]);
}

#[test]
fn a_function_carries_its_doc_comment_and_those_of_its_parameters() {
    /// Attenuation over a distance.
    ///
    /// Source: Bouguer 1729.
    #[shade]
    fn attenuation<R: Real>(
        /// Absorption coefficient, 1/m,
        /// at least 0.
        coefficient: R,
        /// Distance, m.
        distance: R,
    ) -> R {
        (-coefficient * distance).exp()
    }
    let program = program(XYZ, |[x, y, _]| vec![attenuation(x, y)]);
    let [definition] = program.functions() else { panic!("one function") };
    assert_eq!(definition.doc, ["Attenuation over a distance.", "", "Source: Bouguer 1729."]);
    let docs: Vec<&str> = definition.parameters.iter().map(|parameter| parameter.doc.as_str()).collect();
    assert_eq!(docs, ["Absorption coefficient, 1/m, at least 0.", "Distance, m."]);
}

#[test]
fn a_value_of_another_function_cannot_be_used() {
    let graph = Graph::new();
    let x = scalar(&graph, "x");
    /// Takes a value by a constant, which is no way.
    #[shade]
    fn smuggled<R: Real + std::fmt::Debug>(#[constant] smuggled: R, x: R) -> R {
        smuggled + x
    }
    let call = std::panic::AssertUnwindSafe(|| smuggled(x + Expr::lit(1.0), x * x));
    let message = std::panic::catch_unwind(call).expect_err("it must not be recorded");
    let message = message.downcast_ref::<String>().expect("a message");
    assert!(message.contains("by another way than its parameters"), "{message}");
}
