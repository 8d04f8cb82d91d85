//! What the tests of the DSL share: inputs, and programs as formulas on one line.

// Each test file is a crate of its own and uses a part of this.
#![allow(dead_code)]

use pavo_shade::{
    BinaryOp, Comparison, Definition, Expr, Graph, Input, Op, Output, Program, Rate, ReturnValue, Type, UnaryOp,
};

/// A number within [-4, 4] at each pixel.
pub fn scalar<'g>(graph: &'g Graph, name: &str) -> Expr<'g> {
    graph.input(Input::scalar(name, "", -4.0, 4.0, Rate::Pixel))
}

/// Numbers of these names.
pub fn scalars<'g, const N: usize>(graph: &'g Graph, names: [&str; N]) -> [Expr<'g>; N] {
    names.map(|name| scalar(graph, name))
}

/// A vector with components within [-4, 4] at each pixel.
pub fn vector<'g>(graph: &'g Graph, name: &str) -> Expr<'g> {
    graph.input(Input { ty: Type::Vec3, ..Input::scalar(name, "", -4.0, 4.0, Rate::Pixel) })
}

/// The program of what a function of numbers gives; its outputs are `output0`, `output1` and so on.
pub fn program<const N: usize>(
    names: [&str; N],
    computation: impl for<'g> Fn([Expr<'g>; N]) -> Vec<Expr<'g>>,
) -> Program {
    let graph = Graph::new();
    for (number, value) in computation(scalars(&graph, names)).into_iter().enumerate() {
        graph.output(&format!("output{number}"), value);
    }
    graph.program()
}

/// The definitions and the outputs of a function of `x`, `y` and `z` are these.
pub fn check_program(
    computation: impl for<'g> Fn([Expr<'g>; 3]) -> Vec<Expr<'g>>,
    expected_functions: &[&str],
    expected_outputs: &[&str],
) {
    let program = program(["x", "y", "z"], computation);
    assert_eq!(functions(&program), expected_functions);
    assert_eq!(outputs(&program), expected_outputs);
}

/// The same number: the same bits, or both zero. Folding keeps values, and the sign of a zero is none.
pub fn same_number(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a == 0.0 && b == 0.0)
}

/// The names of the functions of a program, callees first.
pub fn function_names(program: &Program) -> Vec<&str> {
    program.functions().iter().map(|function| function.name.as_str()).collect()
}

/// The names of the inputs that a program needs.
pub fn input_names(program: &Program) -> Vec<&str> {
    program.inputs().iter().map(|input| input.name.as_str()).collect()
}

/// Each output as a formula.
pub fn outputs(program: &Program) -> Vec<String> {
    program.outputs().iter().map(|output| returned(program, program.body(), output)).collect()
}

/// A function as one line: `name(parameters) = results`.
pub fn function(program: &Program, definition: &Definition) -> String {
    let parameters: Vec<&str> = definition.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    let results: Vec<String> = definition.results.iter().map(|output| returned(program, definition, output)).collect();
    format!("{}({}) = {}", definition.name, parameters.join(", "), results.join("; "))
}

/// All functions of a program, one line each.
pub fn functions(program: &Program) -> Vec<String> {
    program.functions().iter().map(|definition| function(program, definition)).collect()
}

fn returned(program: &Program, definition: &Definition, output: &Output) -> String {
    match output.value {
        ReturnValue::Literal(value) => format!("{value}"),
        ReturnValue::Literal3([x, y, z]) => format!("vec3({x}, {y}, {z})"),
        ReturnValue::Node(index) => formula(program, definition, index),
    }
}

/// A node with all that it depends on, fully in brackets.
pub fn formula(program: &Program, definition: &Definition, index: u32) -> String {
    let of = |index: u32| formula(program, definition, index);
    let call = |name: &str, operands: &[u32]| {
        format!("{name}({})", operands.iter().map(|&operand| of(operand)).collect::<Vec<_>>().join(", "))
    };
    match definition.nodes[index as usize].op {
        Op::Literal(bits) => format!("{}", f64::from_bits(bits)),
        Op::Literal3(bits) => {
            let [x, y, z] = bits.map(f64::from_bits);
            format!("vec3({x}, {y}, {z})")
        }
        Op::Parameter(index) => definition.parameters[index as usize].name.clone(),
        Op::Unary(UnaryOp::Negate, a) => format!("-{}", of(a)),
        Op::Unary(op, a) => call(&format!("{op:?}").to_lowercase(), &[a]),
        Op::Binary(op, a, b) => match op {
            BinaryOp::Add => format!("({} + {})", of(a), of(b)),
            BinaryOp::Subtract => format!("({} - {})", of(a), of(b)),
            BinaryOp::Multiply => format!("({} * {})", of(a), of(b)),
            BinaryOp::Divide => format!("({} / {})", of(a), of(b)),
            other => call(&format!("{other:?}").to_lowercase(), &[a, b]),
        },
        Op::Compare(Comparison::Less, a, b) => format!("({} < {})", of(a), of(b)),
        Op::Select(mask, a, b) => call("select", &[mask, a, b]),
        Op::Clamp(x, low, high) => call("clamp", &[x, low, high]),
        Op::Mix(a, b, t) => call("mix", &[a, b, t]),
        Op::Vec3(x, y, z) => call("vec3", &[x, y, z]),
        Op::Splat(a) => call("vec3", &[a]),
        Op::Fetch(table, index) => format!("{}[{}]", program.tables()[table as usize].name, of(index)),
        Op::Component(a, component) => format!("{}.{}", of(a), ["x", "y", "z"][usize::from(component)]),
        Op::Call(callee, arguments) => {
            call(&program.functions()[callee as usize].name, &definition.calls[arguments as usize])
        }
        Op::Result(call, result) => {
            let Op::Call(callee, _) = definition.nodes[call as usize].op else { panic!("a result is of a call") };
            let results = &program.functions()[callee as usize].results;
            let field = &results[result as usize].name;
            if results.len() == 1 { of(call) } else { format!("{}.{field}", of(call)) }
        }
    }
}
