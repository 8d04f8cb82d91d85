//! The proof of claims by branch and bound: where a claim does not follow for a box of the parameters of a function, the
//! box is halved, until it follows for each part or too many parts are made.
//!
//! Bounds lose what connects two numbers, so a claim may follow from the ranges of a function's parameters that does not
//! follow from those of the inputs, and the other way round. Each function through which every way to the claim leads is
//! tried, the innermost first, over the ranges that its parameters take in the whole program.

use super::boxes::{Parameters, halved, halves, points, widest};
use super::claims::{Claim, NOTHING, claims, joined};
use crate::evaluation::{Evaluator, Origin};
use crate::evaluation::{Layout, Slots};
use crate::function::Input;
use crate::interval::{Interval, Precision};

/// How many numbers are computed at most in the boxes of one function.
const EFFORT: usize = 160_000;
/// How many boxes are evaluated at most for one function.
const MOST_BOXES: usize = 768;
/// Among how many parameters boxes are halved at most where each is to be halved more than once.
const MOST_HALVED: u32 = 6;
/// How many boxes the inputs are halved into to find the ranges of the parameters.
const RANGE_BOXES: usize = 16;
/// The share of the effort that goes to single points, to find exceptions to a claim.
const POINT_SHARE: usize = 8;
/// How many points are looked at at most.
const MOST_POINTS: usize = 48;

/// What the last evaluation says of a claim.
#[derive(Clone, Copy)]
struct Outcome {
    /// Whether it follows.
    follows: bool,
    /// Whether it is false.
    fails: bool,
    /// The bounds of its subject.
    bounds: [f64; 2],
}

const UNKNOWN: Outcome = Outcome { follows: true, fails: false, bounds: NOTHING };

pub(crate) struct Search<'a, P> {
    layout: &'a Layout<'a>,
    evaluator: Evaluator<'a, Interval<P>>,
    claims: Vec<Claim>,
    /// The claims on each function.
    by_function: Vec<Vec<usize>>,
    /// By claim, what the last evaluation says.
    outcomes: Vec<Outcome>,
    /// By claim, the bounds of its subject over the boxes of the inputs.
    spans: Vec<[f64; 2]>,
    /// Claims that are neither proven nor known to be false.
    open: Vec<bool>,
    /// Where each claim was tried last, and the parameters there that it depends on.
    tried: Vec<Option<(usize, u64)>>,
    proven: Vec<usize>,
}

impl<'a, P: Precision> Search<'a, P> {
    pub fn new(layout: &'a Layout<'a>) -> Self {
        let claims = claims(layout);
        let mut by_function = vec![Vec::new(); layout.frames.len()];
        for (index, claim) in claims.iter().enumerate() {
            by_function[claim.function].push(index);
        }
        let count = claims.len();
        Self {
            layout,
            evaluator: Evaluator::new(layout),
            claims,
            by_function,
            outcomes: vec![UNKNOWN; count],
            spans: vec![NOTHING; count],
            open: vec![true; count],
            tried: vec![None; count],
            proven: Vec::new(),
        }
    }

    /// The claims that hold for all inputs within their ranges.
    pub fn run(mut self, inputs: &[Input]) -> Vec<Claim> {
        let body = self.layout.body();
        let whole: Parameters<P> = inputs.iter().flat_map(Input::range).collect();
        // What fails at inputs that may come is false.
        for point in points(&whole, self.point_count(body)) {
            self.evaluate(body, &point);
            for (open, outcome) in self.open.iter_mut().zip(&self.outcomes) {
                *open &= !outcome.fails;
            }
        }
        for (root, parameters) in self.parameter_ranges(whole).into_iter().enumerate() {
            if let Some(parameters) = parameters {
                self.prove(root, &parameters);
            }
        }
        self.proven.iter().map(|&index| self.claims[index].clone()).collect()
    }

    fn point_count(&self, root: usize) -> usize {
        (EFFORT / POINT_SHARE / self.layout.frames[root].cost.max(1)).clamp(1, MOST_POINTS)
    }

    /// The ranges that the parameters of each function take; none where a function is not called.
    fn parameter_ranges(&mut self, whole: Parameters<P>) -> Vec<Option<Parameters<P>>> {
        let Self { layout, evaluator, by_function, claims, spans, .. } = self;
        let mut ranges: Vec<Option<Parameters<P>>> = vec![None; layout.frames.len()];
        for part in halved(whole, RANGE_BOXES) {
            evaluator.run(layout.body(), &part, &mut |function, slots| {
                for &index in &by_function[function] {
                    spans[index] = joined(spans[index], claims[index].subject_bounds(slots));
                }
                let values = layout.parameter_slots(function).map(|slot| slots[slot]);
                match &mut ranges[function] {
                    Some(known) => known.iter_mut().zip(values).for_each(|(known, value)| *known = known.hull(value)),
                    none => *none = Some(values.collect()),
                }
            });
        }
        ranges
    }

    /// What follows where the parameters of a function are within these ranges.
    fn evaluate(&mut self, root: usize, parameters: &[Interval<P>]) {
        self.outcomes.fill(UNKNOWN);
        let Self { evaluator, by_function, claims, open, outcomes, .. } = self;
        evaluator.run(root, parameters, &mut |function, slots| {
            for &index in by_function[function].iter().filter(|&&index| open[index]) {
                let (claim, outcome) = (&claims[index], &mut outcomes[index]);
                for component in 0..claim.width {
                    let at = |value: Slots| slots[value.component(component)];
                    for [left, right] in claim.pairs.iter().map(|pair| pair.map(at)) {
                        outcome.follows &= left.is_at_least(right);
                        outcome.fails |= left.is_below(right);
                    }
                }
                outcome.bounds = joined(outcome.bounds, claim.subject_bounds(slots));
            }
        });
    }

    /// Tries to prove all open claims that only this function leads to, over the ranges of its parameters.
    fn prove(&mut self, root: usize, parameters: &[Interval<P>]) {
        let mut candidates = self.candidates(root, parameters.len());
        for point in points(parameters, self.point_count(root)) {
            if candidates.is_empty() {
                return;
            }
            self.evaluate(root, &point);
            candidates.retain(|&claim| self.outcomes[claim].follows);
        }
        // Where a claim depends on many parameters, no number of boxes that can be afforded halves them all often.
        let depends_on = candidates.iter().filter_map(|&claim| self.tried[claim]).fold(0, |all, (_, mask)| all | mask);
        let most = if depends_on.count_ones() > MOST_HALVED { 1 << MOST_HALVED } else { MOST_BOXES };
        let limit = (EFFORT / self.layout.frames[root].cost.max(1)).clamp(1, most);
        let mut given_up = vec![false; self.claims.len()];
        let mut pieces: Vec<(usize, [f64; 2])> = Vec::new();
        let mut level = vec![(parameters.to_vec(), candidates.clone())];
        let mut evaluations = 0;
        while !level.is_empty() {
            let mut next = Vec::new();
            for (part, mut claims) in level {
                claims.retain(|&claim| !given_up[claim]);
                if claims.is_empty() {
                    continue;
                }
                evaluations += 1;
                self.evaluate(root, &part);
                let (following, rest): (Vec<usize>, Vec<usize>) =
                    claims.into_iter().partition(|&claim| self.outcomes[claim].follows);
                pieces.extend(following.into_iter().map(|claim| (claim, self.outcomes[claim].bounds)));
                let mask = rest.iter().filter_map(|&claim| self.tried[claim]).fold(0, |all, (_, mask)| all | mask);
                match widest(&part, parameters, mask) {
                    _ if rest.is_empty() => {}
                    Some(dimension) if evaluations + next.len() < limit => {
                        let [lower, upper] = halves(&part, dimension);
                        next.push((lower, rest.clone()));
                        next.push((upper, rest));
                    }
                    _ => rest.iter().for_each(|&claim| given_up[claim] = true),
                }
            }
            level = next;
        }
        for (claim, piece) in pieces {
            if !given_up[claim] {
                let bounds = &mut self.claims[claim].bounds;
                *bounds = joined(*bounds, piece);
            }
        }
        for claim in candidates.into_iter().filter(|&claim| !given_up[claim]) {
            // Both bound the subject: by the parameters of this function, and by the inputs.
            let ([low, high], [span_low, span_high]) = (self.claims[claim].bounds, self.spans[claim]);
            self.claims[claim].bounds = [low.max(span_low), high.min(span_high)];
            self.open[claim] = false;
            self.proven.push(claim);
        }
    }

    /// The open claims that only this function leads to, but not those that were tried in a function to which this one
    /// just passes its parameters on: they would come out the same.
    fn candidates(&mut self, root: usize, parameters: usize) -> Vec<usize> {
        let led_to = only_through(self.layout, root);
        let mut candidates: Vec<usize> =
            (0..self.claims.len()).filter(|&index| self.open[index] && led_to[self.claims[index].function]).collect();
        if candidates.is_empty() {
            return candidates;
        }
        let computed = self.computed_parameters(root, parameters);
        let depends_on = self.dependence(root, parameters);
        candidates.retain(|&claim| {
            let tried = self.tried[claim].replace((root, depends_on[claim]));
            tried.is_none_or(|(function, mask)| computed[function] & mask != 0)
        });
        candidates
    }

    /// For each claim, the parameters of the function that it depends on, a bit each. Beyond 64, bits are shared.
    fn dependence(&self, root: usize, parameters: usize) -> Vec<u64> {
        let mut depends_on = vec![0; self.claims.len()];
        let bits: Vec<u64> = (0..parameters).map(|index| 1 << (index % 64)).collect();
        Evaluator::<u64>::new(self.layout).run(root, &bits, &mut |function, slots| {
            for &index in &self.by_function[function] {
                let claim = &self.claims[index];
                for component in 0..claim.width {
                    let bits = claim.pairs.iter().flatten().map(|value| slots[value.component(component)]);
                    depends_on[index] |= bits.fold(0, |all, bits| all | bits);
                }
            }
        });
        depends_on
    }

    /// For each function below this one, its parameters that are not just one parameter of this one in all calls.
    fn computed_parameters(&self, root: usize, parameters: usize) -> Vec<u64> {
        let layout = self.layout;
        let mut computed = vec![0; layout.frames.len()];
        let mut first: Vec<Option<Vec<Origin>>> = vec![None; layout.frames.len()];
        let origins: Vec<Origin> = (0..parameters).map(Origin::Parameter).collect();
        Evaluator::<Origin>::new(layout).run(root, &origins, &mut |function, slots| {
            let found: Vec<Origin> = layout.parameter_slots(function).map(|slot| slots[slot]).collect();
            let known = first[function].get_or_insert_with(|| found.clone());
            for (index, (known, found)) in known.iter().zip(&found).enumerate() {
                if *found == Origin::Computed || known != found {
                    computed[function] |= 1 << (index % 64);
                }
            }
        });
        computed
    }
}

/// For each function, whether each way to it from the body leads through this one.
fn only_through(layout: &Layout<'_>, through: usize) -> Vec<bool> {
    let mut elsewhere = vec![false; layout.frames.len()];
    let mut inside = vec![false; layout.frames.len()];
    elsewhere[layout.body()] = true;
    inside[through] = true;
    elsewhere[through] = false;
    for function in (0..layout.frames.len()).rev() {
        for &callee in &layout.frames[function].callees {
            inside[callee] |= inside[function];
            elsewhere[callee] |= elsewhere[function] && callee != through;
        }
    }
    inside.into_iter().zip(elsewhere).map(|(inside, elsewhere)| inside && !elsewhere).collect()
}
