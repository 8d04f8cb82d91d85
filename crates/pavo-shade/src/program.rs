//! A finished program: the functions that the outputs need, stripped of all that they do not.

use crate::function::Input;
use crate::graph::{Function, Leaf, Node, Op, State, Type};
use crate::table::Table;
use std::collections::{BTreeSet, HashMap};

/// What a function or the program gives back at one leaf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ReturnValue {
    /// A constant.
    Literal(f64),
    /// A constant vector.
    Literal3([f64; 3]),
    /// A node of the function.
    Node(u32),
}

/// A parameter of a definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Meaning, unit and range.
    pub doc: String,
    /// Its type.
    pub ty: Type,
    /// Where it is part of a struct: the name and the meaning of the whole.
    pub whole: Option<(String, String)>,
}

/// A result of a definition, or an output of the program.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Its name; the field of the struct where there are several.
    pub name: String,
    /// Meaning, unit and range.
    pub doc: String,
    /// Its value.
    pub value: ReturnValue,
    /// Its type.
    pub ty: Type,
}

/// A function of a program. Its operations refer to its own nodes and parameters; calls refer to definitions that
/// stand before it.
#[derive(Clone, Debug)]
pub struct Definition {
    /// The name of the Rust function.
    pub name: String,
    /// Its doc comment.
    pub doc: Vec<String>,
    /// The parameters that are used.
    pub parameters: Vec<Parameter>,
    /// The nodes in the order in which they were made; each is used.
    pub nodes: Vec<Node>,
    /// Arguments of the calls, as [`Op::Call`] refers to them.
    pub calls: Vec<Vec<u32>>,
    /// The results that are used.
    pub results: Vec<Output>,
    /// The name of the Rust struct that it returns.
    pub result_type: Option<String>,
}

/// A program: functions, callees first, and a body that computes the outputs from the inputs.
#[derive(Clone, Debug)]
pub struct Program {
    functions: Vec<Definition>,
    body: Definition,
    inputs: Vec<Input>,
    tables: Vec<Table>,
}

impl Program {
    /// The functions, callees before callers.
    pub fn functions(&self) -> &[Definition] {
        &self.functions
    }

    /// The outermost computation; its parameters are the inputs, its results the outputs.
    pub fn body(&self) -> &Definition {
        &self.body
    }

    /// The run-time inputs that the outputs depend on, in the order in which they were declared.
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// The tables that are read, as [`Op::Fetch`] numbers them.
    pub fn tables(&self) -> &[Table] {
        &self.tables
    }

    /// The outputs.
    pub fn outputs(&self) -> &[Output] {
        &self.body.results
    }

    /// How many numbers one point takes in a table of inputs.
    pub fn input_components(&self) -> usize {
        self.inputs.iter().map(Input::components).sum()
    }

    pub(crate) fn new(state: &State) -> Self {
        let liveness = Liveness::of(state);
        let mut builder = Builder { state, liveness: &liveness, numbers: HashMap::new(), made: Vec::new() };
        for function in liveness.callees_first() {
            builder.add(function);
        }
        let mut body = builder.compact(0);
        leave_out_forwarders(&mut builder.made, &mut body);
        let inputs = liveness.parameters[&0].iter().map(|&index| state.inputs[index as usize].clone()).collect();
        let mut program = Self { functions: builder.made, body, inputs, tables: state.tables.clone() };
        program.leave_out_tables();
        program
    }
}

impl Program {
    /// Keeps the tables that are read, and numbers them anew.
    fn leave_out_tables(&mut self) {
        let mut read = BTreeSet::new();
        for node in self.functions.iter().chain([&self.body]).flat_map(|definition| &definition.nodes) {
            if let Op::Fetch(table, _) = node.op {
                read.insert(table);
            }
        }
        let numbers = numbering(&read);
        self.tables = read.iter().map(|&table| self.tables[table as usize].clone()).collect();
        let bodies = self.functions.iter_mut().chain([&mut self.body]);
        for node in bodies.flat_map(|definition| &mut definition.nodes) {
            if let Op::Fetch(table, _) = &mut node.op {
                *table = numbers[table];
            }
        }
    }
}

/// Which nodes, parameters and results of each function are needed.
struct Liveness {
    /// Needed nodes, ascending.
    nodes: HashMap<u32, BTreeSet<u32>>,
    /// Needed parameters, ascending.
    parameters: HashMap<u32, BTreeSet<u32>>,
    /// Needed results, ascending.
    results: HashMap<u32, BTreeSet<u32>>,
    /// Callers before callees.
    order: Vec<u32>,
}

impl Liveness {
    fn of(state: &State) -> Self {
        let mut liveness = Self {
            nodes: HashMap::new(),
            parameters: HashMap::new(),
            results: HashMap::new(),
            order: callers_first(state),
        };
        // A call passes all parameters that its function needs anywhere, which may make more nodes, results and
        // parameters needed: repeat until none is added.
        loop {
            let before = (liveness.parameters.clone(), liveness.results.clone());
            for function in liveness.order.clone() {
                let roots = if function == 0 {
                    output_roots(state)
                } else {
                    let results = liveness.results.entry(function).or_default().iter().copied();
                    result_roots(state, function, results)
                };
                let reached = reach(state, &liveness.parameters, function, &roots);
                for (callee, result) in reached.results {
                    liveness.results.entry(callee).or_default().insert(result);
                }
                liveness.nodes.insert(function, reached.nodes);
                liveness.parameters.insert(function, reached.parameters);
            }
            if before.0 == liveness.parameters && before.1 == liveness.results {
                return liveness;
            }
        }
    }

    /// The functions of which a result is needed, callees before callers, without the outermost.
    fn callees_first(&self) -> impl Iterator<Item = u32> {
        let needed = |function: &u32| self.results.get(function).is_some_and(|results| !results.is_empty());
        self.order.iter().rev().copied().filter(move |function| *function != 0 && needed(function))
    }
}

struct Reached {
    nodes: BTreeSet<u32>,
    parameters: BTreeSet<u32>,
    results: BTreeSet<(u32, u32)>,
}

/// All that some nodes of a function depend on, given the parameters that each callee needs.
fn reach(state: &State, parameters: &HashMap<u32, BTreeSet<u32>>, function: u32, roots: &[u32]) -> Reached {
    let body = &state.functions[function as usize];
    let mut reached = Reached { nodes: BTreeSet::new(), parameters: BTreeSet::new(), results: BTreeSet::new() };
    let mut pending = roots.to_vec();
    while let Some(index) = pending.pop() {
        if !reached.nodes.insert(index) {
            continue;
        }
        match body.nodes[index as usize].op {
            Op::Parameter(parameter) => {
                reached.parameters.insert(parameter);
            }
            Op::Result(call, result) => {
                reached.nodes.insert(call);
                let Op::Call(callee, arguments) = body.nodes[call as usize].op else {
                    unreachable!("a result is of a call")
                };
                reached.results.insert((callee, result));
                let arguments = &body.calls[arguments as usize];
                let needed = parameters.get(&callee).into_iter().flatten();
                pending.extend(needed.map(|&parameter| arguments[parameter as usize]));
            }
            op => pending.extend(operands(op)),
        }
    }
    reached
}

/// The operands of an operation: nodes of the same function. The arguments of a call are in [`Definition::calls`].
pub fn operands(op: Op) -> impl Iterator<Item = u32> {
    let (operands, count) = match op {
        Op::Literal(_) | Op::Literal3(_) | Op::Parameter(_) | Op::Call(..) => ([0; 3], 0),
        Op::Unary(_, a) | Op::Splat(a) | Op::Component(a, _) | Op::Result(a, _) | Op::Fetch(_, a) => ([a, 0, 0], 1),
        Op::Binary(_, a, b) | Op::Compare(_, a, b) => ([a, b, 0], 2),
        Op::Select(a, b, c) | Op::Clamp(a, b, c) | Op::Mix(a, b, c) | Op::Vec3(a, b, c) => ([a, b, c], 3),
    };
    operands.into_iter().take(count)
}

fn output_roots(state: &State) -> Vec<u32> {
    state.outputs.iter().filter_map(|(_, leaf, _)| node_of(leaf)).collect()
}

fn result_roots(state: &State, function: u32, results: impl IntoIterator<Item = u32>) -> Vec<u32> {
    let body = &state.functions[function as usize];
    results.into_iter().filter_map(|result| node_of(&body.results[result as usize].1)).collect()
}

fn node_of(leaf: &Leaf) -> Option<u32> {
    match leaf {
        Leaf::Node(index) => Some(*index),
        _ => None,
    }
}

/// The functions that the outermost reaches by calls, each after all that call it.
fn callers_first(state: &State) -> Vec<u32> {
    fn visit(state: &State, function: u32, seen: &mut BTreeSet<u32>, finished: &mut Vec<u32>) {
        if !seen.insert(function) {
            return;
        }
        for node in &state.functions[function as usize].nodes {
            if let Op::Call(callee, _) = node.op {
                visit(state, callee, seen, finished);
            }
        }
        finished.push(function);
    }
    let mut finished = Vec::new();
    visit(state, 0, &mut BTreeSet::new(), &mut finished);
    finished.reverse();
    finished
}

struct Builder<'a> {
    state: &'a State,
    liveness: &'a Liveness,
    /// The number of each function in the program.
    numbers: HashMap<u32, u32>,
    made: Vec<Definition>,
}

impl Builder<'_> {
    /// Adds a function, or finds that one with the same text is there already.
    fn add(&mut self, function: u32) {
        let definition = self.compact(function);
        let same = |other: &Definition| {
            other.name == definition.name
                && other.parameters == definition.parameters
                && other.results == definition.results
                && other.calls == definition.calls
                && other.nodes.iter().map(|node| node.op).eq(definition.nodes.iter().map(|node| node.op))
        };
        let number = self.made.iter().position(same).unwrap_or_else(|| {
            self.made.push(definition);
            self.made.len() - 1
        });
        self.numbers.insert(function, number as u32);
    }

    /// The function with only its needed nodes, parameters and results, renumbered.
    fn compact(&self, function: u32) -> Definition {
        let body = &self.state.functions[function as usize];
        let needed = &self.liveness.nodes[&function];
        let node_numbers: HashMap<u32, u32> = needed.iter().copied().zip(0..).collect();
        let parameter_numbers = numbering(&self.liveness.parameters[&function]);
        let mut calls = Vec::new();
        let nodes = needed
            .iter()
            .map(|&index| {
                let node = &body.nodes[index as usize];
                let op = match node.op {
                    Op::Parameter(parameter) => Op::Parameter(parameter_numbers[&parameter]),
                    Op::Call(callee, arguments) => {
                        let kept = &self.liveness.parameters[&callee];
                        let arguments = &body.calls[arguments as usize];
                        calls.push(kept.iter().map(|&index| node_numbers[&arguments[index as usize]]).collect());
                        Op::Call(self.numbers[&callee], calls.len() as u32 - 1)
                    }
                    Op::Result(call, result) => {
                        let Op::Call(callee, _) = body.nodes[call as usize].op else {
                            unreachable!("a result is of a call")
                        };
                        Op::Result(node_numbers[&call], numbering(&self.liveness.results[&callee])[&result])
                    }
                    other => with_operands(other, |operand| node_numbers[&operand]),
                };
                Node { op, ..node.clone() }
            })
            .collect();
        let value = |leaf: &Leaf| match *leaf {
            Leaf::Literal(value) => ReturnValue::Literal(value),
            Leaf::Literal3(value) => ReturnValue::Literal3(value),
            Leaf::Node(index) => ReturnValue::Node(node_numbers[&index]),
        };
        Definition {
            name: body.name.clone(),
            doc: body.doc.clone(),
            parameters: self.parameters(function, body),
            nodes,
            calls,
            results: self.results(function, body, value),
            result_type: body.result_type.clone(),
        }
    }

    fn parameters(&self, function: u32, body: &Function) -> Vec<Parameter> {
        let kept = self.liveness.parameters[&function].iter().map(|&index| index as usize);
        if function == 0 {
            return kept
                .map(|index| &self.state.inputs[index])
                .map(|input| Parameter { name: input.name.clone(), doc: input.unit.clone(), ty: input.ty, whole: None })
                .collect();
        }
        kept.map(|index| &body.parameters[index])
            .map(|parameter| Parameter {
                name: parameter.leaf.name.clone(),
                doc: parameter.leaf.doc.clone(),
                ty: parameter.ty,
                whole: parameter.whole.clone(),
            })
            .collect()
    }

    fn results(&self, function: u32, body: &Function, value: impl Fn(&Leaf) -> ReturnValue) -> Vec<Output> {
        if function == 0 {
            let outputs = self.state.outputs.iter();
            return outputs
                .map(|(name, leaf, ty)| Output { name: name.clone(), doc: String::new(), value: value(leaf), ty: *ty })
                .collect();
        }
        self.liveness.results[&function]
            .iter()
            .map(|&index| &body.results[index as usize])
            .map(|(info, leaf)| Output {
                name: info.name.clone(),
                doc: info.doc.clone(),
                value: value(leaf),
                ty: match *leaf {
                    Leaf::Literal(_) => Type::Scalar,
                    Leaf::Literal3(_) => Type::Vec3,
                    Leaf::Node(index) => body.nodes[index as usize].ty,
                },
            })
            .collect()
    }
}

/// Leaves out functions that only pass on to another one. That one takes the name, unless others call it too.
fn leave_out_forwarders(functions: &mut Vec<Definition>, body: &mut Definition) {
    let mut index = 0;
    while index < functions.len() {
        let all = || functions.iter().chain([&*body]).flat_map(|definition| &definition.nodes);
        let calls =
            |callee: u32| all().filter(|node| matches!(node.op, Op::Call(called, _) if called == callee)).count();
        let Some(callee) = forwards(&functions[index]).filter(|&callee| calls(callee) == 1) else {
            index += 1;
            continue;
        };
        let left_out = functions.remove(index);
        functions[callee as usize].name = left_out.name;
        for node in functions.iter_mut().chain([&mut *body]).flat_map(|definition| &mut definition.nodes) {
            if let Op::Call(called, _) = &mut node.op {
                *called = match (*called as usize).cmp(&index) {
                    std::cmp::Ordering::Less => *called,
                    std::cmp::Ordering::Equal => callee,
                    std::cmp::Ordering::Greater => *called - 1,
                };
            }
        }
    }
}

/// The function that this one only passes its parameters on to, and whose results it gives back as they are.
fn forwards(definition: &Definition) -> Option<u32> {
    let result_of = |output: &Output| match output.value {
        ReturnValue::Node(index) => match definition.nodes[index as usize].op {
            Op::Result(call, result) => Some((call, result)),
            _ => None,
        },
        _ => None,
    };
    let (call, _) = result_of(definition.results.first()?)?;
    let in_order = definition.results.iter().zip(0..).all(|(output, index)| result_of(output) == Some((call, index)));
    let Op::Call(callee, arguments) = definition.nodes[call as usize].op else { return None };
    let arguments = &definition.calls[arguments as usize];
    let passed_on = arguments
        .iter()
        .zip(0..)
        .all(|(&argument, index)| definition.nodes[argument as usize].op == Op::Parameter(index));
    let nothing_else = definition.nodes.len() == arguments.len() + 1 + definition.results.len();
    (in_order && passed_on && nothing_else && arguments.len() == definition.parameters.len()).then_some(callee)
}

fn numbering(kept: &BTreeSet<u32>) -> HashMap<u32, u32> {
    kept.iter().copied().zip(0..).collect()
}

fn with_operands(op: Op, number: impl Fn(u32) -> u32) -> Op {
    match op {
        Op::Unary(op, a) => Op::Unary(op, number(a)),
        Op::Binary(op, a, b) => Op::Binary(op, number(a), number(b)),
        Op::Compare(op, a, b) => Op::Compare(op, number(a), number(b)),
        Op::Select(a, b, c) => Op::Select(number(a), number(b), number(c)),
        Op::Clamp(a, b, c) => Op::Clamp(number(a), number(b), number(c)),
        Op::Mix(a, b, c) => Op::Mix(number(a), number(b), number(c)),
        Op::Vec3(a, b, c) => Op::Vec3(number(a), number(b), number(c)),
        Op::Splat(a) => Op::Splat(number(a)),
        Op::Fetch(table, a) => Op::Fetch(table, number(a)),
        Op::Component(a, index) => Op::Component(number(a), index),
        other => other,
    }
}
