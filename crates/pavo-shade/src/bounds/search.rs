//! The proof of claims by branch and bound: where a claim does not follow for a box of the parameters of a function, the
//! box is halved, until it follows for each part or too many parts are made.
//!
//! Bounds lose what connects two numbers, so a claim may follow from the ranges of a function's parameters that does not
//! follow from those of the inputs, and the other way round. Each function through which every way to the claim leads is
//! tried, the innermost first, over the ranges that its parameters take in the whole program.

use super::claims::{Claim, claims};
use super::evaluator::Evaluator;
use super::layout::Layout;
use crate::function::Input;
use crate::interval::{Interval, Precision};

/// How many numbers are computed at most for one function.
const EFFORT: usize = 400_000;
/// How many boxes are evaluated at most for one function.
const MOST_BOXES: usize = 1024;
/// How many boxes the inputs are halved into to find the ranges of the parameters.
const RANGE_BOXES: usize = 32;
/// How many points are looked at for an exception to a claim, besides corners.
const POINTS: usize = 24;

/// The ranges of a function's parameters, by component.
type Parameters<P> = Vec<Interval<P>>;

pub(crate) struct Search<'a, P> {
    layout: &'a Layout<'a>,
    evaluator: Evaluator<'a, Interval<P>>,
    claims: Vec<Claim>,
    /// The claims on each function.
    by_function: Vec<Vec<usize>>,
    /// Claims that are neither proven nor known to be false.
    open: Vec<bool>,
    proven: Vec<usize>,
}

impl<'a, P: Precision> Search<'a, P> {
    pub fn new(layout: &'a Layout<'a>) -> Self {
        let claims = claims(layout);
        let mut by_function = vec![Vec::new(); layout.frames.len()];
        for (index, claim) in claims.iter().enumerate() {
            by_function[claim.function].push(index);
        }
        let open = vec![true; claims.len()];
        Self { layout, evaluator: Evaluator::new(layout), claims, by_function, open, proven: Vec::new() }
    }

    /// The claims that hold for all inputs within their ranges.
    pub fn run(mut self, inputs: &[Input]) -> Vec<Claim> {
        let body = self.layout.body();
        let whole: Parameters<P> = inputs.iter().flat_map(input_range).collect();
        // What fails at inputs that may come is false.
        for point in points(&whole) {
            let failing = self.failing(body, &point);
            failing.into_iter().for_each(|claim| self.open[claim] = false);
        }
        let ranges = self.parameter_ranges(whole);
        for root in 0..self.layout.frames.len() {
            if let Some(parameters) = &ranges[root] {
                self.prove(root, parameters);
            }
        }
        let proven: Vec<Claim> = self.proven.iter().map(|&index| self.claims[index].clone()).collect();
        proven
    }

    /// The ranges that the parameters of each function take; none where a function is not called.
    fn parameter_ranges(&mut self, whole: Parameters<P>) -> Vec<Option<Parameters<P>>> {
        let body = self.layout.body();
        let mut ranges: Vec<Option<Parameters<P>>> = vec![None; body + 1];
        for part in halved(whole, RANGE_BOXES) {
            let layout = self.layout;
            self.evaluator.run(body, &part, &mut |function, slots| {
                let parameters = layout.frames[function].parameters.iter();
                let values =
                    parameters.flat_map(|&(at, width)| (0..width).map(move |index| slots[at.component(index)]));
                match &mut ranges[function] {
                    Some(known) => known.iter_mut().zip(values).for_each(|(known, value)| *known = known.hull(value)),
                    none => *none = Some(values.collect()),
                }
            });
        }
        ranges
    }

    /// The open claims that do not follow where the parameters of a function are within these ranges.
    fn failing(&mut self, root: usize, parameters: &[Interval<P>]) -> Vec<usize> {
        let mut failing = Vec::new();
        let Self { evaluator, by_function, claims, open, .. } = self;
        evaluator.run(root, parameters, &mut |function, slots| {
            for &index in &by_function[function] {
                if open[index] && !holds(&claims[index], slots) && !failing.contains(&index) {
                    failing.push(index);
                }
            }
        });
        failing
    }

    /// Widens the bounds of the subjects of claims by the last evaluation from a function.
    fn record(&mut self, root: usize, parameters: &[Interval<P>], holding: &[usize]) {
        let Self { evaluator, claims, .. } = self;
        evaluator.run(root, parameters, &mut |function, slots| {
            for &index in holding {
                let claim = &mut claims[index];
                if claim.function == function {
                    for component in 0..claim.width {
                        let subject = slots[claim.subject.component(component)];
                        claim.bounds = [claim.bounds[0].min(subject.low()), claim.bounds[1].max(subject.high())];
                    }
                }
            }
        });
    }

    /// Tries to prove all open claims that only this function leads to, over the ranges of its parameters.
    fn prove(&mut self, root: usize, parameters: &[Interval<P>]) {
        let led_to = only_through(self.layout, root);
        let candidates: Vec<usize> =
            (0..self.claims.len()).filter(|&index| self.open[index] && led_to[self.claims[index].function]).collect();
        if candidates.is_empty() {
            return;
        }
        let depends_on = self.dependence(root, parameters.len());
        let limit = (EFFORT / self.layout.frames[root].cost.max(1)).clamp(1, MOST_BOXES);
        let mut left: Vec<bool> = self.open.clone();
        let mut pieces: Vec<(usize, Parameters<P>, Vec<usize>)> = Vec::new();
        let mut level = vec![(parameters.to_vec(), candidates.clone())];
        let mut evaluations = 0;
        while !level.is_empty() {
            let mut next = Vec::new();
            for (part, mut claims) in level {
                claims.retain(|&claim| left[claim]);
                if claims.is_empty() {
                    continue;
                }
                evaluations += 1;
                let failing = self.failing(root, &part);
                let (failing, holding): (Vec<usize>, Vec<usize>) =
                    claims.into_iter().partition(|claim| failing.contains(claim));
                let masks = failing.iter().fold(0, |masks, &claim| masks | depends_on[claim]);
                match widest(&part, parameters, masks) {
                    _ if failing.is_empty() => {}
                    Some(dimension) if evaluations + next.len() < limit => {
                        let [lower, upper] = halves(&part, dimension);
                        next.push((lower, failing.clone()));
                        next.push((upper, failing));
                    }
                    _ => failing.iter().for_each(|&claim| left[claim] = false),
                }
                if !holding.is_empty() {
                    pieces.push((root, part, holding));
                }
            }
            level = next;
        }
        let proven: Vec<usize> = candidates.into_iter().filter(|&claim| left[claim]).collect();
        for (root, part, mut holding) in pieces {
            holding.retain(|&claim| left[claim]);
            if !holding.is_empty() {
                self.record(root, &part, &holding);
            }
        }
        proven.iter().for_each(|&claim| self.open[claim] = false);
        self.proven.extend(proven);
    }

    /// For each claim, the parameters of the function that it depends on, a bit each. Beyond 64, bits are shared.
    fn dependence(&self, root: usize, parameters: usize) -> Vec<u64> {
        let mut depends_on = vec![0; self.claims.len()];
        let bits: Vec<u64> = (0..parameters).map(|index| 1 << (index % 64)).collect();
        Evaluator::<u64>::new(self.layout).run(root, &bits, &mut |function, slots| {
            for &index in &self.by_function[function] {
                let claim = &self.claims[index];
                for component in 0..claim.width {
                    depends_on[index] |=
                        slots[claim.left.component(component)] | slots[claim.right.component(component)];
                }
            }
        });
        depends_on
    }
}

fn holds<P: Precision>(claim: &Claim, slots: &[Interval<P>]) -> bool {
    (0..claim.width).all(|index| slots[claim.left.component(index)].is_at_least(slots[claim.right.component(index)]))
}

fn input_range<P: Precision>(input: &Input) -> Vec<Interval<P>> {
    vec![Interval::new(input.low, input.high); input.components()]
}

/// For each function, whether each way to it from the body leads through this one.
fn only_through(layout: &Layout<'_>, through: usize) -> Vec<bool> {
    let mut elsewhere = vec![false; layout.frames.len()];
    if through != layout.body() {
        elsewhere[layout.body()] = true;
    }
    let mut inside = vec![false; layout.frames.len()];
    inside[through] = true;
    for function in (0..layout.frames.len()).rev() {
        for &callee in &layout.frames[function].callees {
            inside[callee] |= inside[function];
            elsewhere[callee] |= elsewhere[function] && callee != through;
        }
    }
    inside.into_iter().zip(elsewhere).map(|(inside, elsewhere)| inside && !elsewhere).collect()
}

/// The parameter of which the most of its range is left, among those in a mask.
fn widest<P: Precision>(part: &[Interval<P>], whole: &[Interval<P>], mask: u64) -> Option<usize> {
    let share = |index: usize| (part[index].high() - part[index].low()) / (whole[index].high() - whole[index].low());
    let wide = (0..part.len()).filter(|&index| mask & (1 << (index % 64)) != 0).filter(|&index| share(index) > 1e-6);
    wide.max_by(|&a, &b| share(a).total_cmp(&share(b)).then(b.cmp(&a)))
}

/// Both halves of a box along one parameter.
fn halves<P: Precision>(part: &[Interval<P>], dimension: usize) -> [Parameters<P>; 2] {
    part[dimension].halves().map(|half| {
        let mut part = part.to_vec();
        part[dimension] = half;
        part
    })
}

/// A box halved along its widest parameters in turn.
pub(super) fn halved<P: Precision>(whole: Parameters<P>, most: usize) -> Vec<Parameters<P>> {
    let mut parts = vec![whole.clone()];
    while parts.len() * 2 <= most {
        let Some(dimension) = widest(&parts[0], &whole, u64::MAX) else { break };
        parts = parts.iter().flat_map(|part| halves(part, dimension)).collect();
    }
    parts
}

/// Corners of a box and points spread within.
fn points<P: Precision>(whole: &[Interval<P>]) -> Vec<Parameters<P>> {
    let at = |fraction: f64, range: &Interval<P>| {
        let value = range.low() + (range.high() - range.low()) * fraction;
        Interval::point(value.clamp(range.low(), range.high()))
    };
    let bits = whole.len().min(5);
    let corners = (0..1_u32 << bits).map(|corner| {
        let of = |(index, range)| at(f64::from(corner >> (index % bits.max(1)) & 1), range);
        whole.iter().enumerate().map(of).collect()
    });
    // Multiples of the golden ratio, another power of it for each parameter.
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let spread = (1..=POINTS).map(|number| {
        let of = |(index, range)| at((number as f64 * (index as f64 + 1.0).sqrt() * GOLDEN).fract(), range);
        whole.iter().enumerate().map(of).collect()
    });
    corners.chain(spread).collect()
}
