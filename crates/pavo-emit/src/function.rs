//! A function as text: which nodes become variables, their names, the statements.

use crate::dialect::{Dialect, Syntax};
use crate::expression::{Expressions, literal, vector};
use crate::namer::Namer;
use crate::passing::PassedStruct;
use crate::text::{PrintedTable, Struct, WIDTH};
use pavo_shade::{BinaryOp, Definition, Node, Op, Output, ReturnValue, UnaryOp, is_in_half, operands};

/// What stands for a node where it is used.
#[derive(Clone, Debug)]
pub enum Local {
    /// A parameter or a variable.
    Named {
        /// Its name.
        name: String,
        /// For a variable that takes up what another one held: that one, which is changed in place.
        accumulates: Option<u32>,
    },
    /// Its expression is written out.
    Written,
}

/// What a function needs to know of the others.
pub struct Context<'a> {
    pub dialect: &'a Dialect,
    /// The names of all functions of the program.
    pub functions: &'a [String],
    /// The program's tables.
    pub tables: &'a [PrintedTable],
    /// The structs they return, where they return several values.
    pub structs: &'a [Option<Struct>],
    /// The fields of these structs, empty where a function returns one value.
    pub fields: &'a [Vec<String>],
    /// The structs that each function takes in place of their fields.
    pub passed: &'a [Vec<PassedStruct>],
    /// The names that stand outside of functions.
    pub outer: &'a Namer,
    /// Whether each statement names its line of Rust.
    pub source_lines: bool,
}

/// A parameter as it is printed: a leaf, or a struct of several.
pub struct HeadParameter {
    pub name: String,
    pub doc: String,
    pub type_name: String,
}

/// A function's parameters, statements and results.
pub struct Body {
    /// The parameters as they are printed.
    pub head: Vec<HeadParameter>,
    /// What stands for each leaf parameter inside the function.
    #[cfg_attr(not(feature = "entry"), allow(dead_code))]
    pub parameters: Vec<String>,
    /// The statements, a line each, without indentation.
    pub statements: Vec<String>,
    /// The results as expressions.
    pub results: Vec<String>,
    /// A free name for the struct of the results.
    pub returned: String,
}

/// Prints the inside of a function of this number; that of the program itself has none.
pub fn body(context: &Context<'_>, definition: &Definition, number: usize) -> Body {
    let mut namer = context.outer.clone();
    let passed = context.passed.get(number).map_or(&[][..], Vec::as_slice);
    let (head, parameters) = head_parameters(context, definition, passed, &mut namer);
    let returned = if context.dialect.syntax.fills_by_braces() { namer.fresh("returned") } else { String::new() };
    let locals = locals(context, definition, &parameters, namer);
    let expressions = Expressions {
        dialect: context.dialect,
        definition,
        locals: &locals,
        functions: context.functions,
        tables: context.tables,
        fields: context.fields,
        passed: context.passed,
        in_half: false,
    };
    let changed: Vec<u32> = locals
        .iter()
        .filter_map(|local| match local {
            Local::Named { accumulates, .. } => *accumulates,
            Local::Written => None,
        })
        .collect();
    let mut statements = Vec::new();
    for (index, node) in definition.nodes.iter().enumerate() {
        let index = index as u32;
        let Local::Named { name, accumulates } = &locals[index as usize] else { continue };
        if matches!(node.op, Op::Parameter(_)) {
            continue;
        }
        let statement = match accumulates {
            Some(previous) => accumulation(&expressions, index, *previous, name),
            None => {
                let ty = match node.op {
                    Op::Call(callee, _) => context.structs[callee as usize].as_ref().map(|made| made.name.as_str()),
                    _ => None,
                };
                let ty = ty.unwrap_or_else(|| context.dialect.type_name_held(node.ty, expressions.is_half(index)));
                context.dialect.declare(ty, name, &expressions.computed(index).0, changed.contains(&index))
            }
        };
        let place = if context.source_lines {
            let file = node.location.file().rsplit('/').next().unwrap_or_default();
            format!(" // {file}:{}", node.location.line())
        } else {
            String::new()
        };
        statements.push(format!("{statement}{place}"));
    }
    let results = definition.results.iter().map(|result| result_text(&expressions, result)).collect();
    Body { head, parameters, statements, results, returned }
}

fn result_text(expressions: &Expressions<'_>, result: &Output) -> String {
    match result.value {
        ReturnValue::Literal(value) => literal(expressions.dialect, value).0,
        ReturnValue::Literal3(value) => vector(expressions.dialect, value),
        ReturnValue::Node(index) => expressions.whole(index),
    }
}

/// A variable changed in place: `name += ..` where what it held is the first operand, `name = ..` elsewhere.
fn accumulation(expressions: &Expressions<'_>, index: u32, previous: u32, name: &str) -> String {
    let node = &expressions.definition.nodes[index as usize];
    let (expressions, op) = match node.op {
        Op::Unary(UnaryOp::Half, operand) if expressions.is_computed_in_half(operand) => {
            let in_half = expressions.dialect.half.is_some();
            (expressions.with_half(in_half), expressions.definition.nodes[operand as usize].op)
        }
        op => (expressions.with_half(false), op),
    };
    match op {
        Op::Binary(op @ (BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply), first, operand)
            if first == previous =>
        {
            let sign = match op {
                BinaryOp::Add => "+",
                BinaryOp::Subtract => "-",
                _ => "*",
            };
            format!("{name} {sign}= {};", expressions.whole(operand))
        }
        _ => format!("{name} = {};", expressions.computed(index).0),
    }
}

/// How often each node is used.
fn uses(dialect: &Dialect, definition: &Definition) -> Vec<usize> {
    let mut uses = vec![0; definition.nodes.len()];
    let mut count = |index: u32| uses[index as usize] += 1;
    for node in &definition.nodes {
        match node.op {
            Op::Call(_, arguments) => definition.calls[arguments as usize].iter().copied().for_each(&mut count),
            _ => dialect.named_operands(definition, node).into_iter().for_each(&mut count),
        }
    }
    for result in &definition.results {
        if let ReturnValue::Node(index) = result.value {
            count(index);
        }
    }
    uses
}

/// The parameters as they are printed, and what stands for each leaf inside.
fn head_parameters(
    context: &Context<'_>,
    definition: &Definition,
    passed: &[PassedStruct],
    namer: &mut Namer,
) -> (Vec<HeadParameter>, Vec<String>) {
    let mut head = Vec::new();
    let mut names = vec![String::new(); definition.parameters.len()];
    for (index, parameter) in definition.parameters.iter().enumerate() {
        let taken = passed.iter().find(|taken| taken.fields.iter().any(|(leaf, _)| *leaf == index));
        match taken {
            None => {
                let type_name = context.dialect.type_name(parameter.ty).to_owned();
                names[index] = namer.fresh(&parameter.name);
                head.push(HeadParameter { name: names[index].clone(), doc: parameter.doc.clone(), type_name });
            }
            Some(taken) if taken.fields[0].0 == index => {
                let name = namer.fresh(&taken.name);
                for (leaf, field) in &taken.fields {
                    names[*leaf] = format!("{name}.{field}");
                }
                head.push(HeadParameter { name, doc: taken.doc.clone(), type_name: taken.type_name.clone() });
            }
            Some(_) => {}
        }
    }
    (head, names)
}

fn locals(context: &Context<'_>, definition: &Definition, parameters: &[String], mut namer: Namer) -> Vec<Local> {
    let uses = uses(context.dialect, definition);
    let mut locals: Vec<Local> = Vec::new();
    for (index, node) in definition.nodes.iter().enumerate() {
        let returns_struct = |call: u32| match definition.nodes[call as usize].op {
            Op::Call(callee, _) => !context.fields[callee as usize].is_empty(),
            _ => false,
        };
        let is_variable = match node.op {
            Op::Parameter(parameter) => {
                let name = parameters[parameter as usize].clone();
                locals.push(Local::Named { name, accumulates: None });
                continue;
            }
            Op::Literal(_) | Op::Literal3(_) | Op::Component(..) => false,
            Op::Call(..) => returns_struct(index as u32),
            Op::Result(call, _) if returns_struct(call) => false,
            // Where the operands alone say how precise an operation is, what is rounded needs a variable.
            Op::Unary(UnaryOp::Half, operand)
                if context.dialect.half.as_ref().is_some_and(|half| !half.converts)
                    && !is_in_half(definition, operand) =>
            {
                true
            }
            _ => (node.name.is_some() && uses[index] > 0) || uses[index] > 1,
        };
        if !is_variable {
            locals.push(Local::Written);
            continue;
        }
        let accumulates = accumulates(definition, &uses, &locals, index);
        let name = match accumulates.map(|previous| &locals[previous as usize]) {
            Some(Local::Named { name, .. }) => name.clone(),
            _ => namer.fresh(&wanted_name(context, definition, &locals, index)),
        };
        locals.push(Local::Named { name, accumulates });
    }
    locals
}

/// The variable that this node changes in place: one in its expression to which the author gave the same name, if
/// nothing else uses what it held.
fn accumulates(definition: &Definition, uses: &[usize], locals: &[Local], index: usize) -> Option<u32> {
    let node = &definition.nodes[index];
    node.name.as_ref()?;
    let mut pending: Vec<u32> = operands(node.op).collect();
    while let Some(operand) = pending.pop() {
        let other = &definition.nodes[operand as usize];
        match &locals[operand as usize] {
            Local::Written => pending.extend(operands(other.op)),
            Local::Named { .. } => {
                let is_half = |node: &Node| matches!(node.op, Op::Unary(UnaryOp::Half, _));
                let same = other.name == node.name
                    && other.ty == node.ty
                    && is_half(other) == is_half(node)
                    && !matches!(other.op, Op::Parameter(_));
                if same && uses[operand as usize] == 1 {
                    return Some(operand);
                }
            }
        }
    }
    None
}

/// The name that the author gave, or one that says what the node is.
fn wanted_name(context: &Context<'_>, definition: &Definition, locals: &[Local], index: usize) -> String {
    let node = &definition.nodes[index];
    if let Some(name) = &node.name {
        return name.clone();
    }
    let operand = |index: u32| match &locals[index as usize] {
        Local::Named { name, .. } => Some(name.as_str()),
        Local::Written => None,
    };
    let of = |kind: &str, index: u32| operand(index).map_or_else(|| kind.to_owned(), |name| format!("{kind}_{name}"));
    match node.op {
        Op::Unary(op, a) => match op {
            UnaryOp::Negate => of("minus", a),
            UnaryOp::Sqrt => of("root", a),
            UnaryOp::InverseSqrt => of("inverse_root", a),
            UnaryOp::Abs => of("abs", a),
            UnaryOp::Not => of("not", a),
            UnaryOp::Normalize => of("unit", a),
            UnaryOp::Half => of("rounded", a),
            other => of(context.dialect.function_name(other), a),
        },
        Op::Binary(BinaryOp::Multiply, a, b) if a == b => operand(a).map_or_else(|| "square".to_owned(), squared_name),
        Op::Binary(op, ..) => match op {
            BinaryOp::Add => "sum",
            BinaryOp::Subtract => "difference",
            BinaryOp::Multiply => "product",
            BinaryOp::Divide => "ratio",
            BinaryOp::Min => "smaller",
            BinaryOp::Max => "larger",
            BinaryOp::Dot => "cosine",
            BinaryOp::And => "both",
            BinaryOp::Or => "either",
        }
        .to_owned(),
        Op::Compare(..) => "is_less".to_owned(),
        Op::Select(..) => "chosen".to_owned(),
        Op::Clamp(x, ..) => of("clamped", x),
        Op::Mix(..) => "mixed".to_owned(),
        Op::Vec3(..) => "vector".to_owned(),
        Op::Fetch(..) => "row".to_owned(),
        Op::Splat(a) => operand(a).map_or_else(|| "vector".to_owned(), |name| format!("{name}_rgb")),
        Op::Call(callee, _) => format!("{}_result", context.functions[callee as usize]),
        Op::Result(call, _) => match definition.nodes[call as usize].op {
            Op::Call(callee, _) => format!("{}_result", context.functions[callee as usize]),
            _ => "result".to_owned(),
        },
        Op::Literal(_) | Op::Literal3(_) | Op::Parameter(_) | Op::Component(..) => "value".to_owned(),
    }
}

/// The name of a square: `x_squared`, and for the square of a square `x_to_4`, and so on.
fn squared_name(name: &str) -> String {
    if let Some(base) = name.strip_suffix("_squared") {
        return format!("{base}_to_4");
    }
    match name.rsplit_once("_to_").and_then(|(base, power)| Some((base, power.parse::<u32>().ok()?))) {
        Some((base, power)) => format!("{base}_to_{}", 2 * power),
        None => format!("{name}_squared"),
    }
}

/// The head of a function: its name, parameters and result type, broken over lines when long.
pub fn head(dialect: &Dialect, name: &str, parameters: &[HeadParameter], result: &str) -> String {
    let typed: Vec<String> =
        parameters.iter().map(|parameter| dialect.typed(&parameter.type_name, &parameter.name)).collect();
    let (before, after) = match dialect.syntax {
        Syntax::Wgsl => (format!("fn {name}("), format!(") -> {result} {{")),
        Syntax::C | Syntax::Hlsl | Syntax::Osl => (format!("{result} {name}("), ") {".to_owned()),
        Syntax::Rust => (format!("pub fn {name}("), format!(") -> {result} {{")),
    };
    let line = format!("{before}{}{after}", typed.join(", "));
    if line.len() <= WIDTH {
        return line;
    }
    let comma = if dialect.syntax.is_like_c() { "" } else { "," };
    format!("{before}\n    {}{comma}\n{after}", typed.join(",\n    "))
}
