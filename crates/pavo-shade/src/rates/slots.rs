//! How passed values come to where they are used: the further parameters of each function.

use super::analysis::definition;
use super::cut::Cut;
use super::part::Part;
use super::trace::Context;
use crate::expr::Expr;
use crate::graph::{BinaryOp, FunctionParameter, NodeId, Op, Type, UnaryOp};
use crate::program::{Definition, Program, operands};
use crate::specialise::replay::number;
use crate::value::LeafInfo;
use std::collections::{BTreeSet, HashMap, HashSet};

/// A further parameter of a function; of the body, a passed value.
#[derive(Clone, Debug)]
pub(crate) struct Slot {
    pub name: String,
    pub ty: Type,
}

impl Slot {
    /// The parameter of a function that takes so many of them.
    pub fn parameter(&self, part: &Part, count: usize) -> FunctionParameter {
        let leaf = LeafInfo { name: self.name.clone(), doc: part.value_doc.to_owned() };
        let whole = (count > 1).then(|| (part.parameter.to_owned(), part.parameter_doc.to_owned()));
        FunctionParameter { leaf, ty: self.ty, whole }
    }
}

/// The further parameters of all functions, and what is passed for them.
pub(crate) struct Slots {
    /// The part that computes them.
    pub part: &'static Part,
    /// The slots of each function, those of the body last.
    pub of_function: Vec<Vec<Slot>>,
    /// The slot that stands for a node: by function and node.
    pub own: HashMap<(usize, u32), usize>,
    /// The slots that are passed to a call: by function and node.
    pub passed: HashMap<(usize, u32), Vec<usize>>,
}

/// What a slot stands for in one context: the node that was traced.
fn identity(value: Expr<'_>) -> NodeId {
    match value {
        Expr::Node(_, id) => id,
        Expr::Literal(_) | Expr::Literal3(_) => unreachable!("what is known at build time is not passed"),
    }
}

/// The slots for these passed values, and for each slot of the body its value as it was traced.
pub fn slots<'g>(
    program: &Program,
    part: &'static Part,
    cut: &Cut,
    contexts: &[Context<'g>],
) -> (Slots, Vec<Expr<'g>>) {
    let body = program.functions().len();
    let mut slots = Slots { part, of_function: Vec::new(), own: HashMap::new(), passed: HashMap::new() };
    // For each context, the values of the slots of its function.
    let mut values: Vec<Vec<Expr<'g>>> = vec![Vec::new(); contexts.len()];
    for function in 0..=body {
        let definition = definition(program, function);
        let of_function: Vec<usize> =
            (0..contexts.len()).filter(|&context| contexts[context].function == function).collect();
        let mut made: Vec<Slot> = Vec::new();
        let mut known: HashMap<Vec<NodeId>, usize> = HashMap::new();
        let mut slot_of = |of_contexts: Vec<Expr<'g>>, values: &mut [Vec<Expr<'g>>], slot: Slot| {
            *known.entry(of_contexts.iter().copied().map(identity).collect()).or_insert_with(|| {
                for (&context, &value) in of_function.iter().zip(&of_contexts) {
                    values[context].push(value);
                }
                made.push(slot);
                made.len() - 1
            })
        };
        for (node, index) in definition.nodes.iter().zip(0_u32..) {
            if cut.contains(&(function, index)) {
                let of_contexts = of_function.iter().map(|&context| number(&contexts[context].values, index)).collect();
                let slot = Slot { name: name(program, definition, index), ty: node.ty };
                slots.own.insert((function, index), slot_of(of_contexts, &mut values, slot));
            }
            if let Op::Call(callee, _) = node.op
                && of_function.first().is_some_and(|&context| contexts[context].calls.contains_key(&index))
            {
                let mut passed = Vec::new();
                for (number, slot) in slots.of_function[callee as usize].iter().enumerate() {
                    let inside = |&context: &usize| values[contexts[context].calls[&index]][number];
                    let of_contexts = of_function.iter().map(inside).collect();
                    passed.push(slot_of(of_contexts, &mut values, slot.clone()));
                }
                slots.passed.insert((function, index), passed);
            }
        }
        slots.of_function.push(made);
    }
    let mut taken: HashSet<String> = program.inputs().iter().map(|input| input.name.clone()).collect();
    for slot in &mut slots.of_function[body] {
        let base = slot.name.clone();
        let mut count = 1;
        while !taken.insert(slot.name.clone()) {
            count += 1;
            slot.name = format!("{base}_{count}");
        }
    }
    let last = values.pop().unwrap_or_default();
    (slots, last)
}

impl Slots {
    /// The slots of the body: the values that are passed.
    pub fn body(&self) -> &[Slot] {
        self.of_function.last().map_or(&[], Vec::as_slice)
    }
}

/// How deep a name looks into what has none.
const NAME_DEPTH: usize = 3;

/// The names of what a value is computed from.
fn names_in(definition: &Definition, index: u32, depth: usize, names: &mut BTreeSet<String>) {
    for operand in operands(definition.nodes[index as usize].op) {
        let node = &definition.nodes[operand as usize];
        match (&node.name, node.op) {
            (Some(name), _) => {
                names.insert(name.clone());
            }
            (None, Op::Parameter(parameter)) => {
                names.insert(definition.parameters[parameter as usize].name.clone());
            }
            _ if depth > 0 => names_in(definition, operand, depth - 1, names),
            _ => {}
        }
    }
}

/// What a value is called: as its author called it, or from what it is.
fn name(program: &Program, definition: &Definition, index: u32) -> String {
    let node = &definition.nodes[index as usize];
    if let Some(name) = &node.name {
        return name.clone();
    }
    let operand = |index: u32| {
        let node = &definition.nodes[index as usize];
        match (&node.name, node.op) {
            (Some(name), _) => Some(name.clone()),
            (None, Op::Parameter(parameter)) => Some(definition.parameters[parameter as usize].name.clone()),
            _ => None,
        }
    };
    let is_one = |index: u32| definition.nodes[index as usize].op == Op::Literal(1.0_f64.to_bits());
    let of = |kind: &str, index: u32| operand(index).map_or_else(|| kind.to_owned(), |name| format!("{kind}_{name}"));
    match node.op {
        Op::Result(call, result) => match definition.nodes[call as usize].op {
            Op::Call(callee, _) => {
                let callee = &program.functions()[callee as usize];
                let result = &callee.results[result as usize].name;
                if result.is_empty() { callee.name.clone() } else { result.clone() }
            }
            _ => unreachable!("a result is of a call"),
        },
        Op::Unary(UnaryOp::Sqrt, a) => of("root", a),
        Op::Unary(op, a) => of(&format!("{op:?}").to_lowercase(), a),
        Op::Binary(BinaryOp::Multiply, a, b) if a == b => {
            operand(a).map_or_else(|| "square".to_owned(), |name| format!("{name}_squared"))
        }
        Op::Binary(BinaryOp::Subtract, one, a) if is_one(one) => of("one_minus", a),
        Op::Binary(BinaryOp::Divide, one, a) if is_one(one) => of("inverse", a),
        Op::Binary(op, ..) => {
            let kind = match op {
                BinaryOp::Add => "sum",
                BinaryOp::Subtract => "difference",
                BinaryOp::Multiply => "product",
                BinaryOp::Divide => "ratio",
                BinaryOp::Min => "smaller",
                BinaryOp::Max => "larger",
                BinaryOp::Dot => "cosine",
                BinaryOp::And | BinaryOp::Or => "value",
            };
            let mut of = BTreeSet::new();
            names_in(definition, index, NAME_DEPTH, &mut of);
            match of.len() {
                1 | 2 => format!("{}_{kind}", of.into_iter().collect::<Vec<_>>().join("_")),
                _ => kind.to_owned(),
            }
        }
        Op::Clamp(x, ..) => of("clamped", x),
        Op::Select(..) => "chosen".to_owned(),
        Op::Mix(..) => "mixed".to_owned(),
        Op::Fetch(..) => "row".to_owned(),
        _ => "value".to_owned(),
    }
}
