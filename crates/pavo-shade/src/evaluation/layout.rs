//! A program laid out for fast evaluation: each number has a slot, and only what computes something is a step.

use crate::graph::{Op, Type};
use crate::program::{Definition, Program, ReturnValue};
use crate::table::Table;

/// Where a value is: a number, or three of them. The three may be one number that counts for each component.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slots {
    pub at: usize,
    pub stride: usize,
}

impl Slots {
    pub fn component(self, index: usize) -> usize {
        self.at + index * self.stride
    }
}

/// A value that is copied, component by component.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Copying {
    pub from: Slots,
    pub to: usize,
    pub width: usize,
}

#[derive(Debug)]
pub(crate) enum Step {
    /// An operation on so many operands, once for each component.
    Compute { op: Op, operands: [Slots; 3], count: usize, to: usize, width: usize },
    /// A vector of three numbers.
    Gather { from: [Slots; 3], to: usize },
    /// A call: the arguments into the parameters, the function, its results out of it.
    Call { callee: usize, arguments: Vec<Copying>, results: Vec<Copying> },
}

/// A function laid out. A call fills the slots of its function, so that each function has them once.
#[derive(Debug, Default)]
pub(crate) struct Frame {
    /// The slots of the parameters, one after the other; the number of components of each.
    pub parameters: Vec<(Slots, usize)>,
    pub nodes: Vec<Slots>,
    pub steps: Vec<Step>,
    pub results: Vec<Slots>,
    /// How many numbers one evaluation computes, with all that it calls.
    pub cost: usize,
    /// The functions that it calls.
    pub callees: Vec<usize>,
}

/// A program laid out: its functions, callees first, and its body last.
pub(crate) struct Layout<'a> {
    pub definitions: Vec<&'a Definition>,
    pub tables: &'a [Table],
    pub frames: Vec<Frame>,
    pub slot_count: usize,
    /// Constants and where they are; they stay through all evaluations.
    pub literals: Vec<(usize, f64)>,
    pub zero: Slots,
    pub one: Slots,
}

impl<'a> Layout<'a> {
    pub fn new(program: &'a Program) -> Self {
        let mut layout = Self {
            definitions: program.functions().iter().chain([program.body()]).collect(),
            tables: program.tables(),
            frames: Vec::new(),
            slot_count: 0,
            literals: Vec::new(),
            zero: Slots { at: 0, stride: 0 },
            one: Slots { at: 1, stride: 0 },
        };
        layout.literal(&[0.0]);
        layout.literal(&[1.0]);
        for definition in layout.definitions.clone() {
            let frame = layout.frame(definition);
            layout.frames.push(frame);
        }
        layout
    }

    /// The number of the body.
    pub fn body(&self) -> usize {
        self.frames.len() - 1
    }

    /// The slots of all components of a function's parameters.
    pub fn parameter_slots(&self, function: usize) -> impl Iterator<Item = usize> {
        let parameters = self.frames[function].parameters.iter();
        parameters.flat_map(|&(slots, width)| (0..width).map(move |index| slots.component(index)))
    }

    fn take(&mut self, width: usize) -> Slots {
        let at = self.slot_count;
        self.slot_count += width;
        Slots { at, stride: usize::from(width > 1) }
    }

    fn literal(&mut self, values: &[f64]) -> Slots {
        let slots = self.take(values.len());
        self.literals.extend(values.iter().enumerate().map(|(index, &value)| (slots.at + index, value)));
        slots
    }

    fn frame(&mut self, definition: &Definition) -> Frame {
        let mut frame = Frame::default();
        for parameter in &definition.parameters {
            let width = width(parameter.ty);
            let slots = self.take(width);
            frame.parameters.push((slots, width));
        }
        for node in &definition.nodes {
            let slots = self.node(definition, &mut frame, node.op, width(node.ty));
            frame.nodes.push(slots);
        }
        for result in &definition.results {
            let slots = match result.value {
                ReturnValue::Literal(value) => self.literal(&[value]),
                ReturnValue::Literal3(value) => self.literal(&value),
                ReturnValue::Node(index) => frame.nodes[index as usize],
            };
            frame.results.push(slots);
        }
        frame
    }

    fn node(&mut self, definition: &Definition, frame: &mut Frame, op: Op, width: usize) -> Slots {
        let of = |frame: &Frame, index: u32| frame.nodes[index as usize];
        match op {
            Op::Literal(bits) => self.literal(&[f64::from_bits(bits)]),
            Op::Literal3(bits) => self.literal(&bits.map(f64::from_bits)),
            Op::Parameter(index) => frame.parameters[index as usize].0,
            Op::Splat(a) => Slots { stride: 0, ..of(frame, a) },
            Op::Component(a, index) => Slots { at: of(frame, a).component(usize::from(index)), stride: 0 },
            Op::Vec3(x, y, z) => {
                let slots = self.take(3);
                let from = [x, y, z].map(|index| of(frame, index));
                frame.steps.push(Step::Gather { from, to: slots.at });
                slots
            }
            Op::Call(callee, call) => self.call(definition, frame, callee as usize, call as usize),
            Op::Result(call, result) => {
                let Op::Call(callee, _) = definition.nodes[call as usize].op else {
                    unreachable!("a result is of a call")
                };
                let results = &self.definitions[callee as usize].results;
                let before: usize = results[..result as usize].iter().map(|result| self::width(result.ty)).sum();
                Slots { at: of(frame, call).at + before, stride: usize::from(width > 1) }
            }
            Op::Fetch(table, index) => {
                let slots = self.take(width);
                let [low, high] = self.tables[table as usize].extremes();
                let operands = [of(frame, index), self.literal(&low), self.literal(&high)];
                frame.steps.push(Step::Compute { op, operands, count: 3, to: slots.at, width });
                frame.cost += width;
                slots
            }
            _ => {
                let slots = self.take(width);
                let mut operands = [self.zero; 3];
                for (slot, index) in operands.iter_mut().zip(crate::program::operands(op)) {
                    *slot = of(frame, index);
                }
                let count = crate::program::operands(op).count();
                frame.steps.push(Step::Compute { op, operands, count, to: slots.at, width });
                frame.cost += width;
                slots
            }
        }
    }

    fn call(&mut self, definition: &Definition, frame: &mut Frame, callee: usize, call: usize) -> Slots {
        let called = self.definitions[callee];
        let slots = self.take(called.results.iter().map(|result| width(result.ty)).sum());
        let mut to = slots.at;
        let inner = &self.frames[callee];
        let mut results = Vec::new();
        for (result, &from) in called.results.iter().zip(&inner.results) {
            results.push(Copying { from, to, width: width(result.ty) });
            to += width(result.ty);
        }
        let arguments = definition.calls[call].iter().zip(&inner.parameters);
        let arguments = arguments
            .map(|(&index, &(to, width))| Copying { from: frame.nodes[index as usize], to: to.at, width })
            .collect();
        frame.cost += inner.cost;
        frame.callees.push(callee);
        frame.steps.push(Step::Call { callee, arguments, results });
        slots
    }
}

/// How many numbers a value of this type takes.
pub(crate) fn width(ty: Type) -> usize {
    if matches!(ty, Type::Vec3 | Type::Mask3) { 3 } else { 1 }
}
