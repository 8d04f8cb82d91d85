//! A program holds what its outputs need, and nothing else.

mod common;

use common::{functions, input_names, outputs, program, scalars};
use pavo_shade::{Expr, Graph, Op, Real, interpret, shade};

const XYZW: [&str; 4] = ["x", "y", "z", "w"];

/// Inputs, functions and outputs are these, and each node is used.
fn check(
    computation: impl for<'g> Fn([Expr<'g>; 4]) -> Vec<Expr<'g>>,
    expected_inputs: &[&str],
    expected_functions: &[&str],
    expected_outputs: &[&str],
) {
    let program = program(XYZW, computation);
    assert_eq!(input_names(&program), expected_inputs);
    assert_eq!(functions(&program), expected_functions);
    assert_eq!(outputs(&program), expected_outputs);
}

/// Two numbers.
#[shade]
struct Pair<R: Real> {
    /// The first.
    first: R,
    /// The second.
    second: R,
}

/// Each result has a parameter of its own.
#[shade]
fn sine_and_cosine<R: Real>(a: R, b: R) -> Pair<R> {
    Pair { first: a.sin(), second: b.cos() }
}

/// Passes on, both results of the other in one of its own.
#[shade]
fn sum_and_first<R: Real>(a: R, b: R) -> Pair<R> {
    let waves = sine_and_cosine(a, b);
    Pair { first: waves.first + waves.second, second: waves.first * 2.0 }
}

#[test]
fn what_no_output_needs_is_gone() {
    check(
        |[x, y, z, _]| {
            let _unused = (x * y).sqrt() + z.exp();
            vec![x + z]
        },
        &["x", "z"],
        &[],
        &["(x + z)"],
    );
    assert_eq!(program(XYZW, |[x, y, z, _]| vec![(x * y, x + z).1]).body().nodes.len(), 3);
}

#[test]
fn a_constant_output_needs_no_input() {
    check(|[x, _, _, _]| vec![Expr::lit(2.0), x - x], &[], &[], &["2", "0"]);
    assert_eq!(interpret::evaluate(&program(XYZW, |_| vec![Expr::lit(2.0)]), &[]), [[2.0; 3]]);
}

#[test]
fn a_result_that_nobody_needs_is_stripped_with_its_parameter() {
    check(
        |[x, y, _, _]| vec![sine_and_cosine(x, y).first],
        &["x"],
        &["sine_and_cosine(a) = sin(a)"],
        &["sine_and_cosine(x)"],
    );
    check(
        |[x, y, _, _]| vec![sine_and_cosine(x, y).second],
        &["y"],
        &["sine_and_cosine(b) = cos(b)"],
        &["sine_and_cosine(y)"],
    );
}

#[test]
fn stripping_reaches_through_calls() {
    check(
        |[x, y, _, _]| vec![sum_and_first(x, y).second],
        &["x"],
        &["sine_and_cosine(a) = sin(a)", "sum_and_first(a) = (sine_and_cosine(a) * 2)"],
        &["sum_and_first(x)"],
    );
}

#[test]
fn a_call_of_which_no_result_is_needed_is_gone() {
    check(
        |[x, y, z, _]| {
            let _unused = sum_and_first(y, z);
            vec![x * x]
        },
        &["x"],
        &[],
        &["(x * x)"],
    );
}

#[test]
fn calls_may_need_different_results_of_one_function() {
    let program = program(XYZW, |[x, y, z, w]| vec![sine_and_cosine(x, y).first, sine_and_cosine(z, w).second]);
    // Both calls pass both parameters: the function has both.
    assert_eq!(functions(&program), ["sine_and_cosine(a, b) = sin(a); cos(b)"]);
    assert_eq!(outputs(&program), ["sine_and_cosine(x, y).first", "sine_and_cosine(z, w).second"]);
    let [x, w] = [0.3_f64, 0.4];
    assert_eq!(interpret::evaluate(&program, &[x, 7.0, 8.0, w]), [[x.sin(); 3], [w.cos(); 3]]);
}

#[test]
fn calls_in_different_functions_may_need_different_results() {
    /// Needs the first only.
    #[shade]
    fn firsts<R: Real>(a: R, b: R) -> R {
        sine_and_cosine(a, b * b).first + a
    }
    /// Needs the second only, of an argument that itself comes from a call.
    #[shade]
    fn seconds<R: Real>(a: R, b: R) -> R {
        sine_and_cosine(sine_and_cosine(b, a).second, b).second
    }
    let program = program(XYZW, |[x, y, z, w]| vec![firsts(x, y), seconds(z, w)]);
    let point = [0.3_f64, 0.4, 0.5, 0.6];
    let [x, y, z, w] = point;
    let of_names = |names: Vec<&str>| -> Vec<f64> {
        names.iter().map(|name| point["xyzw".find(name).expect("one of the inputs")]).collect()
    };
    let expected = [firsts(x, y), seconds(z, w)].map(|value| [value; 3]);
    assert_eq!(interpret::evaluate(&program, &of_names(input_names(&program))), expected);
}

#[test]
fn the_order_of_inputs_and_outputs_is_that_of_their_declaration() {
    let program = program(XYZW, |[x, _, z, w]| vec![w + x, z * z]);
    assert_eq!(input_names(&program), ["x", "z", "w"]);
    let names: Vec<&str> = program.outputs().iter().map(|output| output.name.as_str()).collect();
    assert_eq!(names, ["output0", "output1"]);
    assert_eq!(interpret::evaluate(&program, &[1.0, 2.0, 3.0]), [[4.0; 3], [4.0; 3]]);
}

#[test]
fn operands_stand_before_what_uses_them() {
    let program = program(XYZW, |[x, y, z, w]| vec![sum_and_first(x * y, z).first - w, sine_and_cosine(w, x).second]);
    for definition in program.functions().iter().chain([program.body()]) {
        for (index, node) in (0_u32..).zip(&definition.nodes) {
            let before = |operand: u32| assert!(operand < index, "{}: node {index} is {:?}", definition.name, node.op);
            match node.op {
                Op::Unary(_, a) | Op::Result(a, _) => before(a),
                Op::Binary(_, a, b) => [a, b].into_iter().for_each(before),
                Op::Call(_, call) => definition.calls[call as usize].iter().copied().for_each(before),
                _ => {}
            }
        }
    }
}

#[test]
fn a_program_may_be_taken_before_further_outputs_are_declared() {
    let graph = Graph::new();
    let [x, y, _, _] = scalars(&graph, XYZW);
    graph.output("first", sine_and_cosine(x, y).first);
    let before = graph.program();
    graph.output("second", sine_and_cosine(x, y).second);
    assert_eq!(functions(&before), ["sine_and_cosine(a) = sin(a)"]);
    assert_eq!(functions(&graph.program()), ["sine_and_cosine(a, b) = sin(a); cos(b)"]);
}
