//! Which guards a program does without: those that never act within the ranges of its inputs, and no others.

mod common;

use common::{functions, outputs};
use pavo_shade::{
    Expr, Graph, Input, LeftOut, Mask, Program, Rate, Real, Scalar, Specialised, Type, Vector, shade, specialise,
};

/// Inputs with the ranges of their names.
#[derive(Clone, Copy)]
struct Inputs<'g> {
    /// Within [0, 1].
    cosine: Expr<'g>,
    /// Within [1.2, 2.5].
    index: Expr<'g>,
    /// Within [-1, 1].
    signed: Expr<'g>,
    /// Within [-3, -2].
    negative: Expr<'g>,
    /// Components within [0.1, 0.9].
    color: Expr<'g>,
}

fn input<'g>(graph: &'g Graph, name: &str, low: f64, high: f64) -> Expr<'g> {
    graph.input(Input::scalar(name, "", low, high, Rate::Pixel))
}

fn program(computation: impl for<'g> FnOnce(Inputs<'g>) -> Expr<'g>) -> Program {
    let graph = Graph::new();
    let inputs = Inputs {
        cosine: input(&graph, "cosine", 0.0, 1.0),
        index: input(&graph, "index", 1.2, 2.5),
        signed: input(&graph, "signed", -1.0, 1.0),
        negative: input(&graph, "negative", -3.0, -2.0),
        color: graph.input(Input { ty: Type::Vec3, ..Input::scalar("color", "", 0.1, 0.9, Rate::Material) }),
    };
    graph.output("value", computation(inputs));
    graph.program()
}

fn lit<'g>(value: f64) -> Expr<'g> {
    Expr::lit(value)
}

type Computation = for<'g> fn(Inputs<'g>) -> Expr<'g>;

/// What becomes of each computation.
fn check(cases: &[(Computation, &str)]) {
    for (number, (computation, expected)) in cases.iter().enumerate() {
        let specialised = specialise(&program(computation));
        assert_eq!(outputs(&specialised.program), [*expected], "case {number}: {:?}", specialised.left_out);
    }
}

#[test]
fn guards_that_never_act_are_left_out() {
    check(&[
        (|i| i.index.max(lit(1e-12)), "index"),
        (|i| i.negative.max(lit(0.0)), "0"),
        (|i| i.index.max(i.cosine), "index"),
        (|i| i.cosine.max(i.index), "index"),
        (|i| i.cosine.min(lit(1.0)), "cosine"),
        (|i| i.index.min(i.cosine), "cosine"),
        (|i| i.index.clamp(lit(1.0), lit(3.0)), "index"),
        (|i| i.signed.clamp(lit(0.0), lit(1.0)), "max(signed, 0)"),
        (|i| i.index.clamp(lit(0.0), lit(2.0)), "min(index, 2)"),
        (|i| i.index.abs(), "index"),
        (|i| i.negative.abs(), "-negative"),
        (|i| Expr::select(i.negative.less_than(lit(0.0)), i.cosine, i.index), "cosine"),
        (|i| Expr::select(i.index.less_than(i.cosine), i.cosine, i.index), "index"),
        (|i| Expr::select(i.index.less_than(i.cosine).not(), i.cosine, i.index), "cosine"),
        (
            |i| Expr::select(i.signed.less_than(lit(0.0)).and(i.index.less_than(lit(3.0))), i.cosine, i.index),
            "select((signed < 0), cosine, index)",
        ),
        (|i| i.color.max(lit(0.0)), "color"),
        (|i| i.color.min(Expr::lit3([0.95, 1.0, 2.0])), "color"),
        (|i| Expr::select(i.color.less_than(lit(0.95)), i.color, lit(0.0)), "color"),
    ]);
}

#[test]
fn guards_that_may_act_are_kept() {
    check(&[
        (|i| i.cosine.max(lit(1e-12)), "max(cosine, 0.000000000001)"),
        (|i| i.cosine.min(lit(0.9999)), "min(cosine, 0.9999)"),
        (|i| i.signed.abs(), "abs(signed)"),
        (|i| i.color.max(Expr::lit3([0.0, 0.2, 0.0])), "max(color, vec3(0, 0.2, 0))"),
        (|i| Expr::select(i.signed.less_than(lit(0.0)), i.cosine, i.index), "select((signed < 0), cosine, index)"),
        // Below 1 by less than rounding may add.
        (|i| (i.cosine * lit(1.0 / 3.0) * lit(3.0)).min(lit(1.0)), "min(((cosine * 0.3333333333333333) * 3), 1)"),
        // A root of what may be negative is no number.
        (|i| i.signed.sqrt().max(lit(-1.0)), "max(sqrt(signed), -1)"),
        // A quotient by what may be 0 may be anything.
        (|i| (i.index / i.cosine).max(lit(0.0)), "max((index / cosine), 0)"),
    ]);
}

#[test]
fn bounds_follow_what_is_computed() {
    check(&[
        // A square is not negative.
        (|i| (i.signed * i.signed).max(lit(0.0)), "(signed * signed)"),
        (|i| (lit(1.0) - i.cosine).max(lit(0.0)), "(1 - cosine)"),
        ((|i| i.signed.cos().max(lit(0.5))), "cos(signed)"),
        (|i| (-(i.signed * i.signed)).exp().min(lit(1.1)), "exp(-(signed * signed))"),
        (|i| i.color.dot(i.color).max(lit(0.0)), "dot(color, color)"),
        (|i| i.color.normalize().min(lit(1.1)), "normalize(color)"),
        // It is 0.75 at least, but only small boxes show it.
        (|i| (i.signed * i.signed - i.signed + lit(1.0)).max(lit(0.7)), "(((signed * signed) - signed) + 1)"),
        // What may be no number under a guard that gives one.
        (|i| i.signed.sqrt().max(lit(0.0)).max(lit(-1.0)), "max(sqrt(signed), 0)"),
        // A selection hides the branch that is not defined everywhere.
        (|i| Expr::select(i.index.less_than(lit(1.0)), i.signed.sqrt(), i.index).max(lit(1.0)), "index"),
    ]);
}

#[test]
fn what_folds_then_is_folded() {
    check(&[
        (|i| i.cosine + (-i.index).max(lit(0.0)), "cosine"),
        (|i| i.cosine * i.negative.max(lit(0.0)), "0"),
        (|i| i.cosine / i.index.max(lit(3.0)).min(lit(3.0)), "(cosine / 3)"),
        (|i| i.index.max(lit(0.0)) - i.index, "0"),
    ]);
}

/// A root that is kept from negative numbers.
#[shade]
fn guarded_root<R: Real>(x: R, offset: R) -> R {
    (x + offset).max(0.0).sqrt()
}

/// A way to the root that needs no guard where both numbers are positive.
#[shade]
fn scaled_root<R: Real>(x: R, offset: R) -> R {
    guarded_root(x * 0.25, offset * 0.5)
}

/// One more way to the root.
#[shade]
fn quarter<S: Scalar>(x: S) -> S {
    guarded_root(x * 0.25, S::lit(1.0))
}

#[test]
fn a_function_loses_a_guard_that_no_call_of_it_needs() {
    let both = specialise(&program(|i| guarded_root(i.index, i.cosine) + guarded_root(i.cosine, i.index)));
    assert_eq!(functions(&both.program), ["guarded_root(x, offset) = sqrt((x + offset))"]);
    let one = specialise(&program(|i| guarded_root(i.index, i.cosine) + guarded_root(i.signed, i.cosine)));
    assert_eq!(functions(&one.program), ["guarded_root(x, offset) = sqrt(max((x + offset), 0))"]);
    assert_eq!(one.left_out, []);
}

#[test]
fn a_guard_that_one_way_to_it_needs_is_kept_on_all() {
    let [scaled, guarded, bare] = [
        "scaled_root(x, offset) = guarded_root((x * 0.25), (offset * 0.5))",
        "guarded_root(x, offset) = sqrt(max((x + offset), 0))",
        "guarded_root(x, offset) = sqrt((x + offset))",
    ];
    let safe = specialise(&program(|i| scaled_root(i.index, i.cosine) + guarded_root(i.index, i.index)));
    assert_eq!(functions(&safe.program), [bare, scaled]);
    let unsafe_call = specialise(&program(|i| scaled_root(i.index, i.cosine) + guarded_root(i.signed, i.signed)));
    assert_eq!(functions(&unsafe_call.program), [guarded, scaled]);
    let unsafe_way = specialise(&program(|i| scaled_root(i.index, i.signed) + guarded_root(i.index, i.cosine)));
    assert_eq!(functions(&unsafe_way.program), [guarded, scaled]);
}

#[test]
fn a_guard_that_acts_in_a_narrow_place_is_kept() {
    /// Below 0 near 0.31357 alone, where no point that is tried lies.
    fn root_of_narrow<'g>(i: Inputs<'g>) -> Expr<'g> {
        let distance = i.signed - lit(0.31357);
        guarded_root(distance * distance, i.cosine * lit(1e-6) - lit(1e-6))
    }
    let guarded = "guarded_root(x, offset) = sqrt(max((x + offset), 0))";
    let cases: [Computation; 4] = [
        root_of_narrow,
        |i| root_of_narrow(i) + guarded_root(i.index, i.cosine),
        |i| guarded_root(i.index, i.cosine) + root_of_narrow(i),
        |i| root_of_narrow(i) + scaled_root(i.index, i.cosine),
    ];
    for (number, computation) in cases.into_iter().enumerate() {
        let specialised = specialise(&program(computation));
        assert!(functions(&specialised.program).contains(&guarded.to_owned()), "case {number}");
        assert_eq!(specialised.left_out, [], "case {number}");
    }
}

#[test]
fn an_argument_that_becomes_literal_is_folded_into_the_function() {
    let found = specialise(&program(|i| guarded_root(i.index, i.negative.max(lit(0.0))) + quarter(i.cosine)));
    assert_eq!(
        functions(&found.program),
        ["guarded_root(x) = sqrt(x)", "guarded_root(x) = sqrt((x + 1))", "quarter(x) = guarded_root((x * 0.25))"]
    );
}

#[test]
fn what_is_left_out_is_listed_with_its_place_bounds_and_reason() {
    let Specialised { left_out, .. } = specialise(&program(|i| {
        let sum = (i.index + i.cosine).max(lit(0.0));
        guarded_root(sum, i.cosine) + guarded_root(i.index, i.index)
    }));
    let rows: Vec<(&str, &str, &str)> = left_out
        .iter()
        .map(|LeftOut { function, what, reason, .. }| (function.as_str(), what.as_str(), reason.as_str()))
        .collect();
    assert_eq!(
        rows,
        [
            ("guarded_root", "max(x + offset, 0)", "never below 0"),
            ("evaluate", "max(index + cosine, 0)", "never below 0"),
        ]
    );
    let LeftOut { low, high, location, .. } = &left_out[0];
    assert!((low - 1.2).abs() < 1e-5 && (high - 5.0).abs() < 1e-5, "{low} {high}");
    assert!(location.contains("guards.rs:"), "{location}");
}

#[test]
fn a_program_without_guards_stays_as_it_is() {
    let general = program(|i| i.index * i.cosine + i.signed);
    let specialised = specialise(&general);
    assert_eq!(outputs(&specialised.program), outputs(&general));
    assert_eq!(specialised.left_out, []);
}
