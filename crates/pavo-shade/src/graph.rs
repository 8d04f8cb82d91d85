//! The shader graph: functions of hash-consed nodes, recorded while a shading function runs on [`Expr`].

use crate::expr::Expr;
use crate::function::{FunctionInfo, Input};
use crate::program::Program;
use crate::table::Table;
use crate::value::LeafInfo;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::panic::Location;

/// The type of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// One number.
    Scalar,
    /// Three numbers.
    Vec3,
    /// A truth value, the result of comparing scalars.
    Mask,
    /// A truth value per component.
    Mask3,
    /// The results of a call of a function.
    Results,
}

/// Operations on one operand, by component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum UnaryOp {
    Negate,
    Sqrt,
    InverseSqrt,
    Sin,
    Cos,
    Exp,
    Abs,
    Floor,
    Fract,
    /// The operand held in half precision.
    Half,
    Normalize,
    Not,
}

/// Operations on two operands, by component (a scalar beside a vector counts for each component).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum BinaryOp {
    Add,
    Subtract,
    Multiply,
    Divide,
    Min,
    Max,
    Dot,
    And,
    Or,
}

/// Comparisons, by component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Comparison {
    Less,
}

/// An operation. Operands are nodes of the same function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// The bits of an `f64`.
    Literal(u64),
    /// The bits of three `f64`.
    Literal3([u64; 3]),
    /// A parameter of the function; in the outermost function, an input.
    Parameter(u32),
    /// An operation on one operand.
    Unary(UnaryOp, u32),
    /// An operation on two operands.
    Binary(BinaryOp, u32, u32),
    /// A comparison.
    Compare(Comparison, u32, u32),
    /// Condition, value where it holds, value elsewhere.
    Select(u32, u32, u32),
    /// `clamp(x, low, high)`.
    Clamp(u32, u32, u32),
    /// `mix(a, b, t)`.
    Mix(u32, u32, u32),
    /// A vector of three scalars.
    Vec3(u32, u32, u32),
    /// A vector with the same number three times.
    Splat(u32),
    /// A row of a table: its number among the program's tables, and the row's index.
    Fetch(u32, u32),
    /// A component of a vector, 0 to 2.
    Component(u32, u8),
    /// A call: the function, and an index into `Definition::calls` with the arguments.
    Call(u32, u32),
    /// A result of a call.
    Result(u32, u32),
}

/// A node: its operation, type, name, and the line of Rust that made it.
#[derive(Clone, Debug)]
pub struct Node {
    /// What it computes.
    pub op: Op,
    /// The type of its value.
    pub ty: Type,
    /// The name of the `let` that bound it.
    pub name: Option<String>,
    /// Where it was written.
    pub location: &'static Location<'static>,
}

/// A node of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NodeId {
    pub(crate) function: u32,
    pub(crate) index: u32,
}

/// What a function gives back at one leaf of its result.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Leaf {
    Literal(f64),
    Literal3([f64; 3]),
    Node(u32),
}

/// A parameter of an instance: a leaf of one of the parameters of the Rust function.
pub(crate) struct FunctionParameter {
    pub leaf: LeafInfo,
    pub ty: Type,
    /// Where it is part of a struct: the name and the meaning of the whole.
    pub whole: Option<(String, String)>,
}

/// One instance of a function, specialised on its literal arguments.
pub(crate) struct Function {
    pub name: String,
    pub doc: Vec<String>,
    /// A parameter for each argument that is not literal.
    pub parameters: Vec<FunctionParameter>,
    pub nodes: Vec<Node>,
    pub interned: HashMap<Op, u32>,
    pub calls: Vec<Vec<u32>>,
    pub interned_calls: HashMap<(u32, Vec<u32>), u32>,
    pub results: Vec<(LeafInfo, Leaf)>,
    pub result_type: Option<String>,
}

impl Function {
    fn new(name: &str, doc: Vec<String>) -> Self {
        Self {
            name: name.to_owned(),
            doc,
            parameters: Vec::new(),
            nodes: Vec::new(),
            interned: HashMap::new(),
            calls: Vec::new(),
            interned_calls: HashMap::new(),
            results: Vec::new(),
            result_type: None,
        }
    }
}

/// What an argument contributes to the identity of an instance.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(crate) enum ArgumentKey {
    Literal(u64),
    Literal3([u64; 3]),
    Typed(Type),
}

#[derive(PartialEq, Eq, Hash)]
struct InstanceKey {
    /// The address of its `FunctionInfo`: two functions may have the same name in the same module.
    function: usize,
    constants: String,
    arguments: Vec<ArgumentKey>,
}

pub(crate) struct State {
    pub functions: Vec<Function>,
    pub inputs: Vec<Input>,
    pub outputs: Vec<(String, Leaf, Type)>,
    pub tables: Vec<Table>,
    instances: HashMap<InstanceKey, u32>,
    open: Vec<u32>,
}

/// A graph under construction: inputs, a computation, outputs.
pub struct Graph {
    pub(crate) state: RefCell<State>,
    /// Where the nodes that are recorded were written, if not where the caller stands.
    origin: Cell<Option<&'static Location<'static>>>,
}

impl Default for Graph {
    fn default() -> Self {
        Self::new()
    }
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        let state = State {
            functions: vec![Function::new("evaluate", Vec::new())],
            inputs: Vec::new(),
            outputs: Vec::new(),
            tables: Vec::new(),
            instances: HashMap::new(),
            open: vec![0],
        };
        Self { state: RefCell::new(state), origin: Cell::new(None) }
    }

    /// Declares a run-time input.
    #[track_caller]
    pub fn input(&self, input: Input) -> Expr<'_> {
        let ty = input.ty;
        let index = {
            let mut state = self.state.borrow_mut();
            state.inputs.push(input);
            state.inputs.len() as u32 - 1
        };
        self.node(Op::Parameter(index), ty)
    }

    /// The number of a table, which is kept if it is not known yet.
    pub(crate) fn table(&self, table: &Table) -> u32 {
        let tables = &mut self.state.borrow_mut().tables;
        let known = tables.iter().position(|other| other == table);
        known.unwrap_or_else(|| {
            tables.push(table.clone());
            tables.len() - 1
        }) as u32
    }

    /// Declares an output.
    pub fn output(&self, name: &str, value: Expr<'_>) {
        let ty = value.ty();
        let leaf = self.leaf(value);
        self.state.borrow_mut().outputs.push((name.to_owned(), leaf, ty));
    }

    /// The finished program: only what the outputs need.
    pub fn program(&self) -> Program {
        Program::new(&self.state.borrow())
    }

    /// The node of this operation in the function that is being recorded, made if there is none yet.
    #[track_caller]
    pub(crate) fn node(&self, op: Op, ty: Type) -> Expr<'_> {
        self.node_at(op, ty, Location::caller())
    }

    /// From here on, nodes carry this location: a program is recorded again.
    pub(crate) fn set_origin(&self, location: &'static Location<'static>) {
        self.origin.set(Some(location));
    }

    fn node_at(&self, op: Op, ty: Type, location: &'static Location<'static>) -> Expr<'_> {
        let location = self.origin.get().unwrap_or(location);
        let mut state = self.state.borrow_mut();
        let function = *state.open.last().expect("the outermost function is always open");
        let body = &mut state.functions[function as usize];
        let nodes = &mut body.nodes;
        let index = *body.interned.entry(op).or_insert_with(|| {
            nodes.push(Node { op, ty, name: None, location });
            nodes.len() as u32 - 1
        });
        Expr::Node(self, NodeId { function, index })
    }

    /// The index of an expression as an operand of the function that is being recorded.
    #[track_caller]
    pub(crate) fn operand(&self, expr: Expr<'_>) -> u32 {
        let made = match expr {
            Expr::Literal(value) => self.node(Op::Literal(value.to_bits()), Type::Scalar),
            Expr::Literal3(value) => self.node(Op::Literal3(value.map(f64::to_bits)), Type::Vec3),
            Expr::Node(..) => expr,
        };
        let Expr::Node(graph, id) = made else { unreachable!("literals were made nodes") };
        assert!(std::ptr::eq(graph, self), "an expression of another graph was used here");
        let open = *self.state.borrow().open.last().expect("the outermost function is always open");
        assert_eq!(id.function, open, "a value reached a function marked #[shade] by another way than its parameters");
        id.index
    }

    pub(crate) fn ty(&self, id: NodeId) -> Type {
        self.state.borrow().functions[id.function as usize].nodes[id.index as usize].ty
    }

    pub(crate) fn op(&self, id: NodeId) -> Op {
        self.state.borrow().functions[id.function as usize].nodes[id.index as usize].op
    }

    /// Names a node, unless it has a name, is an input or a parameter.
    pub(crate) fn name(&self, id: NodeId, name: &str) {
        let mut state = self.state.borrow_mut();
        let node = &mut state.functions[id.function as usize].nodes[id.index as usize];
        if node.name.is_none() && !matches!(node.op, Op::Parameter(_)) {
            node.name = Some(name.to_owned());
        }
    }

    fn leaf(&self, value: Expr<'_>) -> Leaf {
        match value {
            Expr::Literal(value) => Leaf::Literal(value),
            Expr::Literal3(value) => Leaf::Literal3(value),
            Expr::Node(..) => Leaf::Node(self.operand(value)),
        }
    }

    /// Records a call: traces the function the first time, then refers to that instance.
    #[track_caller]
    pub(crate) fn call<'g>(
        &'g self,
        info: &'static FunctionInfo,
        constants: String,
        parameters: Vec<(usize, LeafInfo)>,
        arguments: &[Expr<'g>],
        results: Vec<LeafInfo>,
        result_type: Option<&'static str>,
        body: impl FnOnce(Vec<Expr<'g>>) -> Vec<Expr<'g>>,
    ) -> Vec<Expr<'g>> {
        let specialised = |argument: &Expr<'_>, parameter: usize| match argument {
            Expr::Literal(value) if !info.parameters[parameter].runtime => Some(ArgumentKey::Literal(value.to_bits())),
            Expr::Literal3(value) if !info.parameters[parameter].runtime => {
                Some(ArgumentKey::Literal3(value.map(f64::to_bits)))
            }
            _ => None,
        };
        let keys: Vec<Option<ArgumentKey>> = arguments
            .iter()
            .zip(&parameters)
            .map(|(argument, (parameter, _))| specialised(argument, *parameter))
            .collect();
        let instance = InstanceKey {
            function: std::ptr::from_ref(info).addr(),
            constants,
            arguments: arguments
                .iter()
                .zip(&keys)
                .map(|(argument, key)| key.clone().unwrap_or(ArgumentKey::Typed(argument.ty())))
                .collect(),
        };
        // No closures around what makes nodes: they would hide where the caller stands.
        let mut passed: Vec<u32> = Vec::new();
        for (argument, key) in arguments.iter().zip(&keys) {
            if key.is_none() {
                passed.push(self.operand(*argument));
            }
        }

        let known = self.state.borrow().instances.get(&instance).copied();
        let function = match known {
            Some(function) => function,
            None => {
                let function = self.open(info.name, info.doc.iter().map(|line| (*line).to_owned()).collect());
                let mut inside: Vec<Expr<'g>> = Vec::new();
                let kept: Vec<usize> = parameters
                    .iter()
                    .zip(&keys)
                    .filter(|(_, key)| key.is_none())
                    .map(|((whole, _), _)| *whole)
                    .collect();
                for ((argument, key), (whole, leaf)) in arguments.iter().zip(&keys).zip(parameters) {
                    inside.push(match key {
                        Some(_) => *argument,
                        None => {
                            let is_part = kept.iter().filter(|&&other| other == whole).count() > 1;
                            let info = &info.parameters[whole];
                            let whole = is_part.then(|| (info.name.to_owned(), info.doc.to_owned()));
                            self.parameter(function, FunctionParameter { leaf, ty: argument.ty(), whole })
                        }
                    });
                }
                let returned = body(inside);
                self.close(function, returned, results, result_type.map(str::to_owned));
                self.state.borrow_mut().instances.insert(instance, function);
                function
            }
        };
        self.results(function, passed)
    }

    /// Starts a function; what is recorded until it is closed belongs to it.
    pub(crate) fn open(&self, name: &str, doc: Vec<String>) -> u32 {
        let mut state = self.state.borrow_mut();
        state.functions.push(Function::new(name, doc));
        let function = state.functions.len() as u32 - 1;
        state.open.push(function);
        function
    }

    /// Declares a parameter of the function that is open.
    #[track_caller]
    pub(crate) fn parameter(&self, function: u32, parameter: FunctionParameter) -> Expr<'_> {
        let ty = parameter.ty;
        let index = {
            let mut state = self.state.borrow_mut();
            let parameters = &mut state.functions[function as usize].parameters;
            parameters.push(parameter);
            parameters.len() as u32 - 1
        };
        self.node(Op::Parameter(index), ty)
    }

    /// Ends a function with what it returns.
    pub(crate) fn close(
        &self,
        function: u32,
        returned: Vec<Expr<'_>>,
        results: Vec<LeafInfo>,
        result_type: Option<String>,
    ) {
        let leaves: Vec<Leaf> = returned.into_iter().map(|value| self.leaf(value)).collect();
        let mut state = self.state.borrow_mut();
        let recorded = &mut state.functions[function as usize];
        if results.len() > 1 {
            for (result, leaf) in results.iter().zip(&leaves) {
                name_result(recorded, leaf, &result.name);
            }
        }
        recorded.results = results.into_iter().zip(leaves).collect();
        recorded.result_type = result_type;
        state.open.pop();
    }

    /// The results of a call: literals and arguments that were passed through need no call.
    #[track_caller]
    pub(crate) fn results(&self, function: u32, passed: Vec<u32>) -> Vec<Expr<'_>> {
        let location = Location::caller();
        enum Shape {
            Literal(f64),
            Literal3([f64; 3]),
            Passed(u32),
            Computed(Type),
        }
        let (shapes, caller): (Vec<Shape>, u32) = {
            let state = self.state.borrow();
            let callee = &state.functions[function as usize];
            let shapes = callee.results.iter().map(|(_, leaf)| match *leaf {
                Leaf::Literal(value) => Shape::Literal(value),
                Leaf::Literal3(value) => Shape::Literal3(value),
                Leaf::Node(index) => match callee.nodes[index as usize].op {
                    Op::Parameter(parameter) => Shape::Passed(passed[parameter as usize]),
                    _ => Shape::Computed(callee.nodes[index as usize].ty),
                },
            });
            (shapes.collect(), *state.open.last().expect("the outermost function is always open"))
        };
        let call = shapes.iter().any(|shape| matches!(shape, Shape::Computed(_))).then(|| {
            let arguments = {
                let mut state = self.state.borrow_mut();
                let body = &mut state.functions[caller as usize];
                let calls = &mut body.calls;
                *body.interned_calls.entry((function, passed.clone())).or_insert_with(|| {
                    calls.push(passed.clone());
                    calls.len() as u32 - 1
                })
            };
            let node = self.node_at(Op::Call(function, arguments), Type::Results, location);
            self.operand(node)
        });
        shapes
            .into_iter()
            .enumerate()
            .map(|(result, shape)| match shape {
                Shape::Literal(value) => Expr::Literal(value),
                Shape::Literal3(value) => Expr::Literal3(value),
                Shape::Passed(index) => Expr::Node(self, NodeId { function: caller, index }),
                Shape::Computed(ty) => {
                    self.node_at(Op::Result(call.expect("a computed result has its call"), result as u32), ty, location)
                }
            })
            .collect()
    }
}

/// What a function returns in a field carries the field's name, unless its author gave it another.
fn name_result(function: &mut Function, leaf: &Leaf, name: &str) {
    if let Leaf::Node(index) = leaf {
        let node = &mut function.nodes[*index as usize];
        if node.name.is_none() && !matches!(node.op, Op::Parameter(_) | Op::Result(..)) {
            node.name = Some(name.to_owned());
        }
    }
}
