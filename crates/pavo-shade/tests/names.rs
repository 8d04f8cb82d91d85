//! Names and places in the source go with the nodes.

mod common;

use common::{formula, scalars, vector};
use pavo_shade::{BinaryOp, Definition, Expr, Graph, Mask, Node, Op, Program, Real, Scalar, Vector, shade};

/// The program of what a function of two inputs gives.
fn program(computation: impl for<'g> Fn(Expr<'g>, Expr<'g>) -> Expr<'g>) -> Program {
    let graph = Graph::new();
    let [x, y] = scalars(&graph, ["x", "y"]);
    graph.output("value", computation(x, y));
    graph.program()
}

/// Each named node of the definition, in order: `name = formula`.
fn named(program: &Program, definition: &Definition) -> Vec<String> {
    let nodes = (0..).zip(&definition.nodes);
    let named = nodes.filter_map(|(index, node)| Some((index, node.name.as_ref()?)));
    named.map(|(index, name)| format!("{name} = {}", formula(program, definition, index))).collect()
}

/// The names within the first function are these.
fn check(computation: impl for<'g> Fn(Expr<'g>, Expr<'g>) -> Expr<'g>, expected: &[&str]) {
    let program = program(computation);
    assert_eq!(named(&program, &program.functions()[0]), expected);
}

#[test]
fn a_let_gives_its_name() {
    /// Some `let`s.
    #[shade]
    fn lets<R: Real>(x: R, y: R) -> R {
        let sum = x + y;
        let typed: R = sum * sum;
        let in_block = {
            let inside = typed.sqrt();
            inside * 2.0
        };
        in_block.max(0.0)
    }
    check(
        |x, y| lets(x, y),
        &[
            "sum = (x + y)",
            "typed = ((x + y) * (x + y))",
            "inside = sqrt(((x + y) * (x + y)))",
            "in_block = (sqrt(((x + y) * (x + y))) * 2)",
        ],
    );
}

#[test]
fn an_assignment_gives_its_name() {
    /// Some assignments.
    #[shade]
    fn assignments<R: Real>(x: R, y: R) -> R {
        let mut sum = x;
        sum = sum + y;
        sum *= y;
        let later;
        later = sum - x;
        later.sin()
    }
    check(|x, y| assignments(x, y), &["sum = (x + y)", "sum = ((x + y) * y)", "later = (((x + y) * y) - x)"]);
}

/// Two numbers.
#[shade]
struct Pair<R: Real> {
    /// The first.
    first: R,
    /// The second.
    second: R,
}

#[test]
fn patterns_give_their_names() {
    /// Some patterns.
    #[shade]
    fn patterns<R: Real>(x: R, y: R) -> R {
        let (of_tuple, _) = (x + y, x);
        let [of_array, other] = [x * y, y];
        let Pair { first, second: renamed } = Pair { first: x.sin(), second: y.cos() };
        let (nested, [in_array, _]) = (x - y, [x / y, x]);
        of_tuple + of_array + other + first + renamed + nested + in_array
    }
    check(
        |x, y| patterns(x, y),
        &[
            "of_tuple = (x + y)",
            "of_array = (x * y)",
            "first = sin(x)",
            "renamed = cos(y)",
            "nested = (x - y)",
            "in_array = (x / y)",
        ],
    );
}

#[test]
fn masks_take_names() {
    /// A comparison with a name.
    #[shade]
    fn named_masks<R: Real>(x: R, y: R) -> R {
        let is_smaller = x.less_than(y);
        let is_negative_too = is_smaller.and(x.less_than(R::lit(0.0)));
        R::select(is_negative_too, x, y)
    }
    check(|x, y| named_masks(x, y), &["is_smaller = (x < y)", "is_negative_too = and((x < y), (x < 0))"]);
}

#[test]
fn the_first_name_is_kept() {
    /// One value, three names.
    #[shade]
    fn renaming<R: Real>(x: R, y: R) -> R {
        let original = x + y;
        let alias = original;
        let same_again = x + y;
        alias * same_again
    }
    check(|x, y| renaming(x, y), &["original = (x + y)"]);
}

#[test]
fn parameters_inputs_and_literals_take_no_other_name() {
    /// Renames what has a name, and a literal.
    #[shade]
    fn renaming<R: Real>(x: R, y: R) -> R {
        let renamed = x;
        let number = 2.0;
        renamed * number + y
    }
    check(|x, y| renaming(x, y), &[]);
    let renamed = program(|x, y| renaming(x.named_as("a"), y.named_as("b")));
    assert_eq!(renamed.inputs().iter().map(|input| input.name.as_str()).collect::<Vec<_>>(), ["x", "y"]);
}

/// What `#[shade]` does to a `let`.
trait NamedAs: pavo_shade::Value {
    fn named_as(self, name: &str) -> Self {
        self.named(name)
    }
}

impl NamedAs for Expr<'_> {}

#[test]
fn arrays_and_structs_name_their_parts() {
    /// An array and a struct, named as a whole.
    #[shade]
    fn wholes<R: Real>(x: R, y: R) -> R {
        let squares = [x * x, y * y];
        let waves = Pair { first: x.sin(), second: y.sin() };
        squares[0] + squares[1] + waves.first + waves.second
    }
    check(
        |x, y| wholes(x, y),
        &["squares_v0 = (x * x)", "squares_v1 = (y * y)", "waves_first = sin(x)", "waves_second = sin(y)"],
    );
}

/// A function with two results.
#[shade]
fn waves<R: Real>(x: R, y: R) -> Pair<R> {
    Pair { first: x.sin() * y, second: y.cos() * x }
}

#[test]
fn the_results_of_a_call_stay_together_under_one_name() {
    let program = program(|x, y| {
        let both = waves(x, y).named_as("both");
        both.first + both.second
    });
    let names: Vec<_> = program.body().nodes.iter().filter_map(|node| node.name.as_deref()).collect();
    assert_eq!(names, ["both"]);
    let fields: Vec<&str> = program.functions()[0].results.iter().map(|result| result.name.as_str()).collect();
    assert_eq!(fields, ["first", "second"]);
    assert_eq!(program.functions()[0].result_type.as_deref(), Some("Pair"));
}

impl NamedAs for Pair<Expr<'_>> {}

#[test]
fn what_is_not_a_value_passes_through() {
    /// Counts and keeps text beside its values.
    #[shade]
    fn mixed<R: Real>(#[constant] words: &[&str], x: R, y: R) -> R {
        let count = words.len();
        let mut index = 0;
        let mut sum = x;
        while index < count {
            let (word, scale) = (words[index], R::lit(0.5));
            for letter in word.chars() {
                sum = sum + y * R::lit(f64::from(u32::from(letter) - 96)) * scale;
            }
            index += 1;
        }
        sum
    }
    assert_eq!(mixed(&["ab", "c"], 1.0, 2.0), 1.0 + 2.0 * 0.5 + 4.0 * 0.5 + 6.0 * 0.5);
    check(|x, y| mixed(&["b"], x, y), &["sum = (x + ((y * 2) * 0.5))"]);
}

/// The line of this file that holds this text, and only that line.
fn line_of(text: &str) -> u32 {
    let source = include_str!("names.rs");
    let mut lines = (1..).zip(source.lines()).filter(|(_, line)| line.trim_start().starts_with(text));
    let (line, _) = lines.next().expect("the text is in this file");
    assert_eq!(lines.next(), None, "{text:?} is in this file once");
    line
}

/// Each operation on a line of its own.
#[shade]
fn one_operation_a_line<S: Scalar>(x: S, v: S::Vec3) -> S::Vec3 {
    let a_sum = x + x;
    let a_difference = 1.0 - x;
    let a_product = a_sum * 2.0;
    let a_quotient = a_product / core::f64::consts::PI;
    let a_negation = -a_difference;
    let a_root = a_quotient.sqrt();
    let a_maximum = a_root.max(0.5);
    let a_power = a_maximum.powi(2);
    let a_clamp = a_power.clamp(0.0, 1.0);
    let a_mix = S::mix(a_clamp, x, a_negation);
    let a_fraction = a_mix.fract();
    let a_selection = S::select(x.less_than(a_fraction), a_fraction, x);
    let a_folded_sum = a_selection + a_negation;
    let a_folded_magnitude = (-a_folded_sum).abs();
    let a_vector = S::Vec3::new(a_folded_magnitude, x, a_mix);
    let a_scaled_vector = v * a_vector;
    let a_scalar_product = a_scaled_vector.dot(v);
    let a_component = v.y();
    let a_direction = v.normalize();
    let a_call = called(a_scalar_product, a_component);
    let mut an_assigned = v;
    an_assigned = an_assigned + a_direction;
    an_assigned *= a_call;
    an_assigned
}

/// To be called.
#[shade]
fn called<R: Real>(x: R, y: R) -> R {
    x - y.cos() // The line in the function that is called.
}

#[test]
fn a_node_knows_the_line_that_made_it() {
    let graph = Graph::new();
    let [x] = scalars(&graph, ["x"]);
    let v = vector(&graph, "v");
    graph.output("value", one_operation_a_line::<Expr<'_>>(x, v));
    let program = graph.program();
    let [called, definition] = program.functions() else { panic!("two functions") };
    assert_eq!(definition.name, "one_operation_a_line");
    let mut checked = 0;
    for node in &definition.nodes {
        let Some(name) = &node.name else { continue };
        let expected = match name.as_str() {
            "an_assigned" if is_sum(node) => line_of("an_assigned = an_assigned"),
            "an_assigned" => line_of("an_assigned *= a_call"),
            name => line_of(&format!("let {name} = ")),
        };
        assert!(node.location.file().ends_with("names.rs"), "{name}: {}", node.location);
        assert_eq!(node.location.line(), expected, "{name}");
        checked += 1;
    }
    assert_eq!(checked, 22, "each named operation");
    for node in called.nodes.iter().filter(|node| !matches!(node.op, Op::Parameter(_))) {
        assert_eq!(node.location.line(), line_of("x - y.cos() // The line in"));
    }
}

/// Which of the two assignments this is.
fn is_sum(node: &Node) -> bool {
    matches!(node.op, Op::Binary(BinaryOp::Add, ..))
}

#[test]
fn operands_and_parameters_too_stand_in_the_file_that_made_them() {
    let graph = Graph::new();
    let [x] = scalars(&graph, ["x"]);
    let v = vector(&graph, "v");
    graph.output("value", one_operation_a_line::<Expr<'_>>(x, v).max(x.min(Expr::lit(0.25))));
    let program = graph.program();
    for definition in program.functions().iter().chain([program.body()]) {
        for node in &definition.nodes {
            let file = node.location.file();
            // The inputs are declared in the file that the tests share.
            assert!(file.ends_with("names.rs") || file.ends_with("common/mod.rs"), "{:?}: {}", node.op, node.location);
        }
    }
}
