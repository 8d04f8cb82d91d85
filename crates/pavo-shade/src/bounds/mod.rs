//! Bounds of what a program computes, over the ranges of its inputs.

mod boxes;
mod claims;
mod search;

pub(crate) use claims::{Claim, Fact};

use crate::evaluation::{Evaluator, Frame, Layout, Slots, width};
use crate::graph::{Node, Type};
use crate::interval::{Interval, Precision};
use crate::program::{Definition, Program};
use boxes::halved;
use search::Search;

/// The bounds of each node of a function, by component; a node that stands for all results of a call may be anything.
pub type FunctionBounds<P> = Vec<[Interval<P>; 3]>;

/// The bounds of a program's values, over all calls of each function.
#[derive(Clone, Debug)]
pub struct Bounds<P> {
    /// The nodes of each function, in the order of [`Program::functions`], then those of the body.
    pub functions: Vec<FunctionBounds<P>>,
    /// The outputs, by component.
    pub outputs: Vec<[Interval<P>; 3]>,
}

/// The bounds of each node and output of a program, over the ranges of its inputs. The ranges are halved into up to
/// `parts` boxes, each bounded by itself: the more boxes, the closer the bounds.
pub fn bounds<P: Precision>(program: &Program, parts: usize) -> Bounds<P> {
    let layout = Layout::new(program);
    let mut evaluator = Evaluator::<Interval<P>>::new(&layout);
    let mut joined: Vec<Option<Interval<P>>> = vec![None; layout.slot_count];
    let whole =
        program.inputs().iter().flat_map(|input| vec![Interval::new(input.low, input.high); input.components()]);
    for part in halved(whole.collect(), parts) {
        evaluator.run(layout.body(), &part, &mut |function, slots| {
            let frame = &layout.frames[function];
            let nodes = frame.nodes.iter().zip(&layout.definitions[function].nodes);
            for (at, node) in nodes.filter(|(_, node)| node.ty != Type::Results) {
                for slot in (0..width(node.ty)).map(|component| at.component(component)) {
                    joined[slot] = Some(joined[slot].map_or(slots[slot], |known| known.hull(slots[slot])));
                }
            }
        });
    }
    // Constants are in no node's bounds that was not evaluated.
    let at = |slot: usize| joined[slot].unwrap_or(evaluator.slots[slot]);
    let value = |slots: Slots| [0, 1, 2].map(|component| at(slots.component(component)));
    let body = layout.body();
    let of_function = |(frame, definition): (&Frame, &&Definition)| {
        let nodes = frame.nodes.iter().zip(&definition.nodes);
        let of_node = |(&slots, node): (&Slots, &Node)| match node.ty {
            Type::Results => [Interval::anything(); 3],
            _ => value(slots),
        };
        nodes.map(of_node).collect()
    };
    Bounds {
        functions: layout.frames.iter().zip(&layout.definitions).map(of_function).collect(),
        outputs: layout.frames[body].results.iter().map(|&slots| value(slots)).collect(),
    }
}

/// The bounds of a program's outputs, by component, over each of some boxes: for each number of its inputs the smallest
/// and the largest, in the order of [`Program::inputs`].
///
/// # Panics
/// If the number of ranges of a box is not [`Program::input_components`].
pub fn bounds_over<P: Precision>(program: &Program, boxes: &[Vec<[f64; 2]>]) -> Vec<Vec<[Interval<P>; 3]>> {
    let layout = Layout::new(program);
    let mut evaluator = Evaluator::<Interval<P>>::new(&layout);
    let of_box = |ranges: &Vec<[f64; 2]>| {
        assert_eq!(ranges.len(), program.input_components(), "one range per component of each input");
        let part: Vec<Interval<P>> = ranges.iter().map(|&[low, high]| Interval::new(low, high)).collect();
        evaluator.outputs(&part)
    };
    boxes.iter().map(of_box).collect()
}

/// The claims on a program's guards that hold for all inputs within their ranges.
pub(crate) fn proven<P: Precision>(program: &Program) -> Vec<Claim> {
    Search::<P>::new(&Layout::new(program)).run(program.inputs())
}
