//! A program recorded once more, through the same expressions, folding and stripping as the first time, without the
//! guards that are proven unnecessary.

use super::Facts;
use crate::bounds::Fact;
use crate::expr::{Expr, ExprMask};
use crate::fold;
use crate::graph::{ArgumentKey, BinaryOp, FunctionParameter, Graph, NodeId, Op, Type, UnaryOp};
use crate::program::{Definition, Output, Program, ReturnValue};
use crate::rates::Slots;
use crate::real::{Mask, Real, Scalar, Vector};
use crate::value::LeafInfo;
use std::collections::HashMap;

/// What a node became.
#[derive(Clone)]
pub(crate) enum Replayed<'g> {
    Number(Expr<'g>),
    Mask(ExprMask<'g>),
    Results(Vec<Expr<'g>>),
    /// It is not recorded.
    Absent,
}

/// A function, whether it takes prepared values, and the arguments that have become literal in a call of it.
type Instance = (u32, bool, Vec<Option<ArgumentKey>>);

/// Records a program once more.
pub(crate) struct Replay<'a, 'g> {
    program: &'a Program,
    facts: &'a Facts,
    /// Which values of which functions are given instead of computed.
    slots: Option<&'a Slots>,
    graph: &'g Graph,
    instances: HashMap<Instance, u32>,
}

/// The program without what these facts make unnecessary.
pub(super) fn replay(program: &Program, facts: &Facts) -> Program {
    let graph = Graph::new();
    let inputs: Vec<Expr<'_>> = program.inputs().iter().map(|input| graph.input(input.clone())).collect();
    Replay::new(program, facts, None, &graph).body(&inputs, None);
    graph.program()
}

impl<'a, 'g> Replay<'a, 'g> {
    pub(crate) fn new(program: &'a Program, facts: &'a Facts, slots: Option<&'a Slots>, graph: &'g Graph) -> Self {
        Self { program, facts, slots, graph, instances: HashMap::new() }
    }

    /// The body and its outputs, given the inputs and the prepared values.
    pub(crate) fn body(&mut self, inputs: &[Expr<'g>], prepared: Option<&[Expr<'g>]>) {
        let values = self.nodes(self.program.functions().len(), self.program.body(), inputs, prepared);
        for output in self.program.outputs() {
            self.graph.output(&output.name, returned(output, &values));
        }
    }

    /// The nodes of a function, recorded into the one that is open. Where there are prepared values, they take the
    /// place of what computes them.
    fn nodes(
        &mut self,
        function: usize,
        definition: &Definition,
        parameters: &[Expr<'g>],
        prepared: Option<&[Expr<'g>]>,
    ) -> Vec<Replayed<'g>> {
        let given = prepared.zip(self.slots);
        let mut values: Vec<Replayed<'g>> = Vec::new();
        for (node, index) in definition.nodes.iter().zip(0_u32..) {
            self.graph.set_origin(node.location);
            let facts = self.facts.get(&(function, index)).map_or(&[][..], Vec::as_slice);
            if let Some((prepared, slots)) = given
                && let Some(&slot) = slots.own.get(&(function, index))
            {
                values.push(Replayed::Number(prepared[slot]));
                continue;
            }
            let value = match node.op {
                Op::Parameter(parameter) => Replayed::Number(parameters[parameter as usize]),
                Op::Call(callee, call) => {
                    let passed = given.and_then(|(prepared, slots)| {
                        let passed = slots.passed.get(&(function, index))?;
                        Some(passed.iter().map(|&slot| prepared[slot]).collect::<Vec<_>>())
                    });
                    let arguments: Vec<(Expr<'g>, bool)> = definition.calls[call as usize]
                        .iter()
                        .map(|&index| (number(&values, index), is_literal(definition.nodes[index as usize].op)))
                        .collect();
                    let results = self.call(callee, &arguments, passed.as_deref(), node.location);
                    if let (Some(name), Some(call)) = (&node.name, results.iter().find_map(|&result| call_of(result))) {
                        self.graph.name(call, name);
                    }
                    Replayed::Results(results)
                }
                Op::Result(call, result) => match &values[call as usize] {
                    Replayed::Results(results) => Replayed::Number(results[result as usize]),
                    _ => unreachable!("a result is of a call"),
                },
                Op::Fetch(table, index) => {
                    let table = &self.program.tables()[table as usize];
                    Replayed::Number(Expr::fetch(table, number(&values, index)))
                }
                op if matches!(node.ty, Type::Mask | Type::Mask3) => Replayed::Mask(condition(op, facts, &values)),
                op => Replayed::Number(operation(op, facts, &values)),
            };
            if let Some(name) = &node.name {
                match &value {
                    Replayed::Number(Expr::Node(_, id)) | Replayed::Mask(ExprMask::Node(Expr::Node(_, id))) => {
                        self.graph.name(*id, name);
                    }
                    _ => {}
                }
            }
            values.push(value);
        }
        values
    }

    /// A call. Arguments that have become literal are folded into the function; those that were literal before stay
    /// arguments, as their author wants it.
    pub(crate) fn call(
        &mut self,
        callee: u32,
        arguments: &[(Expr<'g>, bool)],
        prepared: Option<&[Expr<'g>]>,
        location: &'static core::panic::Location<'static>,
    ) -> Vec<Expr<'g>> {
        let definition = &self.program.functions()[callee as usize];
        let keys: Vec<Option<ArgumentKey>> = arguments
            .iter()
            .map(|&(argument, was_literal)| match argument {
                Expr::Literal(value) if !was_literal => Some(ArgumentKey::Literal(value.to_bits())),
                Expr::Literal3(value) if !was_literal => Some(ArgumentKey::Literal3(value.map(f64::to_bits))),
                _ => None,
            })
            .collect();
        let mut passed = Vec::new();
        for (((argument, _), key), parameter) in arguments.iter().zip(&keys).zip(&definition.parameters) {
            if key.is_none() {
                passed.push(self.graph.operand(of_type(*argument, parameter.ty)));
            }
        }
        for &value in prepared.unwrap_or_default() {
            passed.push(self.graph.operand(value));
        }
        let instance = (callee, prepared.is_some(), keys.clone());
        let known = self.instances.get(&instance).copied();
        let function = known.unwrap_or_else(|| {
            let function = self.graph.open(&definition.name, definition.doc.clone());
            let mut inside = Vec::new();
            for (((argument, _), key), parameter) in arguments.iter().zip(&keys).zip(&definition.parameters) {
                inside.push(if key.is_some() {
                    *argument
                } else {
                    let leaf = LeafInfo { name: parameter.name.clone(), doc: parameter.doc.clone() };
                    let whole = parameter.whole.clone();
                    self.graph.parameter(function, FunctionParameter { leaf, ty: parameter.ty, whole })
                });
            }
            let prepared_inside: Option<Vec<Expr<'g>>> = prepared.zip(self.slots).map(|(_, slots)| {
                let of_function = &slots.of_function[callee as usize];
                let parameters = of_function.iter().map(|slot| slot.parameter(slots.part, of_function.len()));
                parameters.map(|parameter| self.graph.parameter(function, parameter)).collect()
            });
            let values = self.nodes(callee as usize, definition, &inside, prepared_inside.as_deref());
            let results = definition.results.iter();
            let leaves = results.map(|result| LeafInfo { name: result.name.clone(), doc: result.doc.clone() });
            let returned = definition.results.iter().map(|result| returned(result, &values)).collect();
            self.graph.close(function, returned, leaves.collect(), definition.result_type.clone());
            self.instances.insert(instance, function);
            function
        });
        self.graph.set_origin(location);
        self.graph.results(function, passed)
    }
}

pub(crate) fn is_literal(op: Op) -> bool {
    matches!(op, Op::Literal(_) | Op::Literal3(_))
}

pub(crate) fn call_of(result: Expr<'_>) -> Option<NodeId> {
    match result.op()? {
        (_, Op::Result(index, _), id) => Some(NodeId { index, ..id }),
        _ => None,
    }
}

/// The value written out as a vector where that is its type.
fn of_type(value: Expr<'_>, ty: Type) -> Expr<'_> {
    if ty == Type::Vec3 { value.as_vec3() } else { value }
}

pub(crate) fn returned<'g>(output: &Output, values: &[Replayed<'g>]) -> Expr<'g> {
    let value = match output.value {
        ReturnValue::Literal(value) => Expr::Literal(value),
        ReturnValue::Literal3(value) => Expr::Literal3(value),
        ReturnValue::Node(index) => number(values, index),
    };
    of_type(value, output.ty)
}

pub(crate) fn number<'g>(values: &[Replayed<'g>], index: u32) -> Expr<'g> {
    match &values[index as usize] {
        Replayed::Number(value) => *value,
        _ => unreachable!("a number is expected here"),
    }
}

pub(crate) fn mask<'g>(values: &[Replayed<'g>], index: u32) -> ExprMask<'g> {
    match &values[index as usize] {
        Replayed::Mask(mask) => *mask,
        _ => unreachable!("a condition is expected here"),
    }
}

pub(crate) fn condition<'g>(op: Op, facts: &[Fact], values: &[Replayed<'g>]) -> ExprMask<'g> {
    if facts.contains(&Fact::Holds) || facts.contains(&Fact::Fails) {
        return ExprMask::Literal(facts.contains(&Fact::Holds));
    }
    match op {
        Op::Compare(_, a, b) => number(values, a).less_than(number(values, b)),
        Op::Unary(_, a) => mask(values, a).not(),
        Op::Binary(BinaryOp::And, a, b) => mask(values, a).and(mask(values, b)),
        Op::Binary(_, a, b) => mask(values, a).or(mask(values, b)),
        _ => unreachable!("a mask is a comparison or a combination of masks"),
    }
}

pub(crate) fn operation<'g>(op: Op, facts: &[Fact], values: &[Replayed<'g>]) -> Expr<'g> {
    let of = |index: u32| number(values, index);
    match op {
        Op::Literal(bits) => Expr::Literal(f64::from_bits(bits)),
        Op::Literal3(bits) => fold::literal3(bits.map(f64::from_bits)),
        Op::Unary(UnaryOp::Abs, a) if facts.contains(&Fact::NotNegative) => of(a),
        Op::Unary(UnaryOp::Abs, a) if facts.contains(&Fact::NotPositive) => -of(a),
        Op::Unary(op, a) => match op {
            UnaryOp::Negate => -of(a),
            UnaryOp::Sqrt => of(a).sqrt(),
            UnaryOp::InverseSqrt => of(a).inverse_sqrt(),
            UnaryOp::Sin => of(a).sin(),
            UnaryOp::Cos => of(a).cos(),
            UnaryOp::Exp => of(a).exp(),
            UnaryOp::Abs => of(a).abs(),
            UnaryOp::Floor => of(a).floor(),
            UnaryOp::Fract => of(a).fract(),
            UnaryOp::Half => of(a).half(),
            UnaryOp::Normalize => of(a).normalize(),
            UnaryOp::Not => unreachable!("it is no number"),
        },
        Op::Binary(_, a, _) if facts.contains(&Fact::First) => of(a),
        Op::Binary(_, _, b) if facts.contains(&Fact::Second) => of(b),
        Op::Binary(op, a, b) => match op {
            BinaryOp::Add => of(a) + of(b),
            BinaryOp::Subtract => of(a) - of(b),
            BinaryOp::Multiply => of(a) * of(b),
            BinaryOp::Divide => of(a) / of(b),
            BinaryOp::Min => of(a).min(of(b)),
            BinaryOp::Max => of(a).max(of(b)),
            BinaryOp::Dot => of(a).dot(of(b)),
            BinaryOp::And | BinaryOp::Or => unreachable!("they are no numbers"),
        },
        Op::Clamp(x, low, high) => match (facts.contains(&Fact::AboveLow), facts.contains(&Fact::BelowHigh)) {
            (true, true) => of(x),
            (true, false) => of(x).min(of(high)),
            (false, true) => of(x).max(of(low)),
            (false, false) => of(x).clamp(of(low), of(high)),
        },
        Op::Select(condition, a, b) => Expr::select(mask(values, condition), of(a), of(b)),
        Op::Mix(a, b, t) => Expr::mix(of(a), of(b), of(t)),
        Op::Vec3(x, y, z) => Expr::new(of(x), of(y), of(z)),
        Op::Splat(a) => match of(a) {
            Expr::Literal(value) => Expr::Literal(value),
            value => value.as_vec3(),
        },
        Op::Component(a, 0) => of(a).x(),
        Op::Component(a, 1) => of(a).y(),
        Op::Component(a, _) => of(a).z(),
        Op::Fetch(..) | Op::Compare(..) | Op::Parameter(_) | Op::Call(..) | Op::Result(..) => {
            unreachable!("handled by their kind")
        }
    }
}
