//! Each rule of exact folding, and what must be left as it was written.

mod common;

use common::{outputs, scalars, vector};
use pavo_shade::{Expr, Graph, Mask, Real, Vector};

/// Numbers `x`, `y`, `z` and vectors `v`, `w` to build expressions of.
#[derive(Clone, Copy)]
struct Variables<'g> {
    x: Expr<'g>,
    y: Expr<'g>,
    z: Expr<'g>,
    v: Expr<'g>,
    w: Expr<'g>,
}

type Expression = for<'g> fn(Variables<'g>) -> Expr<'g>;

/// Each expression is recorded as this formula.
fn check(cases: &[(Expression, &str)]) {
    for (number, (expression, expected)) in cases.iter().enumerate() {
        let graph = Graph::new();
        let [x, y, z] = scalars(&graph, ["x", "y", "z"]);
        let (v, w) = (vector(&graph, "v"), vector(&graph, "w"));
        graph.output("value", expression(Variables { x, y, z, v, w }));
        let found = outputs(&graph.program());
        assert_eq!(found, [*expected], "case {number}");
    }
}

fn lit<'g>(value: f64) -> Expr<'g> {
    Expr::lit(value)
}

fn lit3<'g>(x: f64, y: f64, z: f64) -> Expr<'g> {
    Expr::lit3([x, y, z])
}

#[test]
fn operations_on_literals_become_their_value() {
    check(&[
        (|_| lit(2.0) + lit(3.0), "5"),
        (|_| lit(2.0) - lit(3.0), "-1"),
        (|_| lit(2.0) * lit(3.0), "6"),
        (|_| lit(1.0) / lit(3.0), "0.3333333333333333"),
        (|_| -lit(2.0), "-2"),
        (|_| lit(2.0).min(lit(3.0)), "2"),
        (|_| lit(2.0).max(lit(3.0)), "3"),
        (|_| lit(2.0).sqrt(), "1.4142135623730951"),
        (|_| lit(4.0).inverse_sqrt(), "0.5"),
        (|_| lit(1.0).sin(), "0.8414709848078965"),
        (|_| lit(1.0).cos(), "0.5403023058681398"),
        (|_| lit(1.0).exp(), "2.718281828459045"),
        (|_| lit(-2.0).abs(), "2"),
        (|_| lit(-2.5).floor(), "-3"),
        (|_| lit(-2.25).fract(), "0.75"),
        (|_| lit(3.0).powi(4), "81"),
        (|_| lit(3.0).clamp(lit(0.0), lit(1.0)), "1"),
        (|_| Expr::mix(lit(2.0), lit(4.0), lit(0.25)), "2.5"),
    ]);
}

#[test]
fn operations_on_literal_vectors_become_their_value() {
    check(&[
        (|_| lit3(1.0, 2.0, 3.0) + lit(1.0), "vec3(2, 3, 4)"),
        (|_| lit3(1.0, 2.0, 3.0) * lit3(2.0, 3.0, 4.0), "vec3(2, 6, 12)"),
        (|_| lit3(1.0, 4.0, 9.0).sqrt(), "vec3(1, 2, 3)"),
        (|_| lit3(1.0, 2.0, 3.0).min(lit(2.0)), "vec3(1, 2, 2)"),
        (|_| lit3(1.0, 2.0, 3.0).dot(lit3(4.0, 5.0, 6.0)), "32"),
        (|_| lit(1.0).dot(lit3(4.0, 5.0, 6.0)), "15"),
        (|_| lit3(0.0, 0.0, 2.0).normalize(), "vec3(0, 0, 1)"),
        (|_| lit3(1.0, 2.0, 3.0).y(), "2"),
        (|_| lit3(1.0, 2.0, 3.0) - lit3(1.0, 2.0, 3.0), "0"),
        (|_| lit3(2.0, 2.0, 2.0), "2"),
        (|_| Expr::new(lit(1.0), lit(2.0), lit(3.0)), "vec3(1, 2, 3)"),
    ]);
}

#[test]
fn zero_disappears_from_sums() {
    check(&[
        (|v| v.x + lit(0.0), "x"),
        (|v| lit(0.0) + v.x, "x"),
        (|v| v.x - lit(0.0), "x"),
        (|v| lit(0.0) - v.x, "-x"),
        (|v| v.v + lit(0.0), "v"),
        (|v| lit3(0.0, 0.0, 0.0) + v.v, "v"),
        (|v| v.x - v.x, "0"),
        (|v| (v.x + v.y) - (v.x + v.y), "0"),
    ]);
}

#[test]
fn one_and_minus_one_disappear_from_products() {
    check(&[
        (|v| v.x * lit(1.0), "x"),
        (|v| lit(1.0) * v.x, "x"),
        (|v| v.x / lit(1.0), "x"),
        (|v| v.x * lit(-1.0), "-x"),
        (|v| lit(-1.0) * v.x, "-x"),
        (|v| v.x / lit(-1.0), "-x"),
        (|v| v.v * lit(1.0), "v"),
        (|v| v.v * lit3(1.0, 1.0, 1.0), "v"),
    ]);
}

#[test]
fn zero_takes_products_with_it() {
    check(&[
        (|v| v.x * lit(0.0), "0"),
        (|v| lit(0.0) * v.x, "0"),
        (|v| lit(0.0) / v.x, "0"),
        (|v| v.v * lit(0.0), "0"),
        (|v| v.y + v.x * lit(0.0), "y"),
    ]);
}

#[test]
fn negations_are_absorbed() {
    check(&[
        (|v| -(-v.x), "x"),
        (|v| v.x + (-v.y), "(x - y)"),
        (|v| (-v.x) + v.y, "(y - x)"),
        (|v| v.x - (-v.y), "(x + y)"),
        (|v| (-v.x) + (-v.y), "(-x - y)"),
        (|v| v.x.abs().abs(), "abs(x)"),
        (|v| (-v.x).abs(), "abs(x)"),
    ]);
}

#[test]
fn a_choice_between_equals_disappears() {
    check(&[
        (|v| v.x.min(v.x), "x"),
        (|v| v.x.max(v.x), "x"),
        (|v| Expr::select(v.x.less_than(v.y), v.z, v.z), "z"),
        (|v| Expr::select(v.x.less_than(v.y), lit(2.0), lit(2.0)), "2"),
        (|v| Expr::select(v.x.less_than(v.y), v.v, v.v), "v"),
    ]);
}

#[test]
fn a_selection_by_a_known_mask_disappears() {
    check(&[
        (|v| Expr::select(lit(1.0).less_than(lit(2.0)), v.x, v.y), "x"),
        (|v| Expr::select(lit(2.0).less_than(lit(1.0)), v.x, v.y), "y"),
        (|v| Expr::select(lit3(1.0, 2.0, 3.0).less_than(lit(4.0)), v.v, v.w), "v"),
        (|v| Expr::select(lit(1.0).less_than(lit(2.0)).not(), v.x, v.y), "y"),
        (|v| Expr::choose(lit(1.0).less_than(lit(2.0)), v.v, v.w), "v"),
    ]);
}

#[test]
fn known_masks_disappear_from_combinations() {
    check(&[
        (|v| Expr::select(truth(true).and(v.x.less_than(v.y)), v.x, v.y), "select((x < y), x, y)"),
        (|v| Expr::select(v.x.less_than(v.y).and(truth(true)), v.x, v.y), "select((x < y), x, y)"),
        (|v| Expr::select(truth(false).and(v.x.less_than(v.y)), v.x, v.y), "y"),
        (|v| Expr::select(v.x.less_than(v.y).and(truth(false)), v.x, v.y), "y"),
        (|v| Expr::select(truth(false).or(v.x.less_than(v.y)), v.x, v.y), "select((x < y), x, y)"),
        (|v| Expr::select(v.x.less_than(v.y).or(truth(false)), v.x, v.y), "select((x < y), x, y)"),
        (|v| Expr::select(truth(true).or(v.x.less_than(v.y)), v.x, v.y), "x"),
        (|v| Expr::select(v.x.less_than(v.y).or(truth(true)), v.x, v.y), "x"),
    ]);
}

fn truth<'g>(value: bool) -> <Expr<'g> as Real>::Mask {
    if value { lit(0.0).less_than(lit(1.0)) } else { lit(1.0).less_than(lit(0.0)) }
}

#[test]
fn a_constant_mask_that_differs_by_component_picks_components() {
    check(&[(|v| Expr::select(lit3(0.0, 1.0, 0.0).less_than(lit(0.5)), v.v, v.w), "vec3(v.x, w.y, v.z)")]);
}

#[test]
fn the_ends_of_a_mix_need_no_mix() {
    check(&[(|v| Expr::mix(v.x, v.y, lit(0.0)), "x"), (|v| Expr::mix(v.x, v.y, lit(1.0)), "y")]);
}

#[test]
fn vectors_are_taken_apart_where_they_were_put_together() {
    check(&[
        (|v| Expr::new(v.x, v.y, v.z).y(), "y"),
        (|v| Expr::new(v.x, v.x, v.x), "x"),
        (|v| Expr::splat(v.x).z(), "x"),
        (|v| Expr::splat(v.x) * v.v, "(x * v)"),
    ]);
}

#[test]
fn a_number_in_place_of_a_vector_is_widened_where_both_must_be_vectors() {
    check(&[
        (|v| v.v.min(v.x), "min(v, vec3(x))"),
        (|v| v.v.max(lit(0.0)), "max(v, vec3(0, 0, 0))"),
        (|v| v.v.clamp(lit(0.0), v.x), "clamp(v, vec3(0, 0, 0), vec3(x))"),
        (|v| Expr::mix(v.v, v.w, v.x), "mix(v, w, vec3(x))"),
        (|v| Expr::splat(v.x).dot(Expr::splat(v.y)), "dot(vec3(x), vec3(y))"),
        (|v| Expr::splat(v.x).normalize(), "normalize(vec3(x))"),
        (|v| Expr::select(v.v.less_than(v.w), v.x, v.y), "select((v < w), vec3(x), vec3(y))"),
        (|v| Expr::choose(v.x.less_than(v.y), v.v, v.z), "select((x < y), v, vec3(z))"),
        (|v| Expr::select(v.v.less_than(v.x), v.v, v.w), "select((v < vec3(x)), v, w)"),
    ]);
}

#[test]
fn sums_and_products_keep_the_order_in_which_they_were_written() {
    check(&[
        (|v| v.x + (v.y + v.z), "(x + (y + z))"),
        (|v| (v.x + v.y) + v.z, "((x + y) + z)"),
        (|v| v.y + v.x, "(y + x)"),
        (|v| v.x * (v.y * v.z), "(x * (y * z))"),
        (|v| (v.x + lit(1.0)) + lit(2.0), "((x + 1) + 2)"),
        (|v| (v.x * lit(2.0)) * lit(3.0), "((x * 2) * 3)"),
        (|v| lit(2.0) * (lit(3.0) * v.x), "(2 * (3 * x))"),
        (|v| v.x * v.y + v.x * v.z, "((x * y) + (x * z))"),
        (|v| v.x * (v.y + v.z), "(x * (y + z))"),
    ]);
}

#[test]
fn what_would_change_the_rounding_is_kept() {
    check(&[
        (|v| v.x / lit(3.0), "(x / 3)"),
        (|v| v.x / lit(2.0), "(x / 2)"),
        (|v| lit(1.0) / v.x, "(1 / x)"),
        (|v| v.x * v.x / v.x, "((x * x) / x)"),
        (|v| v.x / v.x, "(x / x)"),
        (|v| (v.x + v.y) - v.y, "((x + y) - y)"),
        (|v| v.x + v.x, "(x + x)"),
        (|v| (v.x * v.x).sqrt(), "sqrt((x * x))"),
        (|v| v.x.sqrt() * v.x.sqrt(), "(sqrt(x) * sqrt(x))"),
        (|v| lit(1.0) / v.x.sqrt(), "(1 / sqrt(x))"),
        (|v| -(v.x - v.y), "-(x - y)"),
        (|v| (-v.x) * (-v.y), "(-x * -y)"),
        (|v| (-v.x) - v.y, "(-x - y)"),
        (|v| v.x.min(v.y).max(v.x), "max(min(x, y), x)"),
        (|v| Expr::mix(v.x, v.x, v.y), "mix(x, x, y)"),
        (|v| v.v * lit3(1.0, 1.0, 0.0), "(v * vec3(1, 1, 0))"),
        (|v| v.v + lit3(0.0, 0.0, 1.0), "(v + vec3(0, 0, 1))"),
    ]);
}

#[test]
fn whole_powers_are_products() {
    check(&[
        (|v| v.x.powi(0), "1"),
        (|v| v.x.powi(1), "x"),
        (|v| v.x.powi(2), "(x * x)"),
        (|v| v.x.powi(3), "(x * (x * x))"),
        (|v| v.x.powi(5), "(x * ((x * x) * (x * x)))"),
    ]);
}

#[test]
fn the_same_operation_on_the_same_operands_is_one_node() {
    let graph = Graph::new();
    let [x, y] = scalars(&graph, ["x", "y"]);
    let power = (x * y).powi(8);
    graph.output("value", power + (x * y).powi(8) * (y * x));
    let program = graph.program();
    assert_eq!(program.body().nodes.len(), 9, "x, y, xy, its 2nd, 4th and 8th power, yx, the product, the sum");
}

#[test]
fn positive_and_negative_zero_are_different_literals_of_the_same_value() {
    check(&[
        (|v| v.x + lit(-0.0), "x"),
        (|v| v.x * lit(-0.0), "0"),
        (|v| v.x.max(lit(-0.0)), "max(x, -0)"),
        (|v| v.x.max(lit(0.0)), "max(x, 0)"),
    ]);
}
