//! Random programs: a series of operations on earlier values, for any number type.

use pavo_shade::{Mask, Real, Scalar, Vector, shade};
use proptest::prelude::*;

/// One step: an operation on earlier values.
#[derive(Clone, Debug)]
pub struct Step {
    operation: u8,
    operands: [prop::sample::Index; 3],
    literal: f64,
}

/// Two numbers of a function.
#[shade]
struct Ends<R: Real> {
    /// The lower end.
    low: R,
    /// The upper end.
    high: R,
}

/// The ends of an interval in order.
#[shade]
fn ordered<R: Real>(a: R, b: R) -> Ends<R> {
    let swapped = b.less_than(a);
    Ends { low: R::select(swapped, b, a), high: R::select(swapped, a, b) }
}

/// A vector on its way to a number, the number at run time.
#[shade]
fn towards<S: Scalar>(from: S::Vec3, #[runtime] to: S, part: S) -> S::Vec3 {
    let Ends { low, high } = ordered(part, to);
    from + (S::Vec3::splat(to) - from) * (high - low)
}

/// The values of a program so far.
pub struct Values<S: Scalar> {
    /// Numbers, the inputs first.
    pub numbers: Vec<S>,
    /// Vectors, the input first.
    pub vectors: Vec<S::Vec3>,
    masks: Vec<S::Mask>,
    vector_masks: Vec<<S::Vec3 as Real>::Mask>,
}

impl<S: Scalar> Values<S> {
    /// The inputs, and what follows from them at once.
    pub fn new(x: S, y: S, v: S::Vec3) -> Self {
        Self {
            numbers: vec![x, y],
            vectors: vec![v, S::Vec3::splat(x)],
            masks: vec![x.less_than(y)],
            vector_masks: vec![v.less_than(S::Vec3::splat(y))],
        }
    }

    fn step(&mut self, step: &Step) {
        let [a, b, c] = step.operands.map(|index| *index.get(&self.numbers));
        let [v, w, u] = step.operands.map(|index| *index.get(&self.vectors));
        let [m, n, _] = step.operands.map(|index| *index.get(&self.masks));
        let [p, q, _] = step.operands.map(|index| *index.get(&self.vector_masks));
        let half = S::lit(0.5);
        match step.operation {
            0..=3 => self.numbers.push(S::lit(step.literal)),
            4 => self.numbers.push(a + b),
            5 => self.numbers.push(a - b),
            6 => self.numbers.push(a * b),
            7 => self.numbers.push(a / (b.abs() + half)),
            8 => self.numbers.push(-a),
            9 => self.numbers.push(a.min(b)),
            10 => self.numbers.push(a.max(b)),
            11 => self.numbers.push(a.abs().sqrt()),
            12 => self.numbers.push((a.abs() + half).inverse_sqrt()),
            13 => self.numbers.push(a.sin()),
            14 => self.numbers.push(a.cos()),
            15 => self.numbers.push((-a.abs()).exp()),
            16 => self.numbers.push(a.floor()),
            17 => self.numbers.push(a.fract()),
            18 => self.numbers.push(a.clamp(b, c)),
            19 => self.numbers.push(S::mix(a, b, c)),
            20 => self.numbers.push(a.powi(3)),
            21 => self.numbers.push(S::select(m, a, b)),
            22 => self.numbers.push(v.dot(w)),
            23 => self.numbers.push(v.y()),
            24 => self.numbers.push(ordered(a, b).low),
            25 => self.numbers.push(ordered(a, b).high),
            26 => self.masks.push(a.less_than(b)),
            27 => self.masks.push(m.and(n)),
            28 => self.masks.push(m.or(n.not())),
            29 => self.vectors.push(S::Vec3::lit3([step.literal, 0.0, 1.0])),
            30 => self.vectors.push(S::Vec3::lit(step.literal)),
            31 => self.vectors.push(S::Vec3::new(a, b, c)),
            32 => self.vectors.push(v + w),
            33 => self.vectors.push(v - w),
            34 => self.vectors.push(v * a),
            35 => self.vectors.push(v * w),
            36 => self.vectors.push(v / (w.abs() + S::Vec3::splat(half))),
            37 => self.vectors.push(v.min(w)),
            38 => self.vectors.push(v.clamp(w, u)),
            39 => self.vectors.push(S::Vec3::mix(v, w, S::Vec3::splat(a))),
            40 => self.vectors.push(v.sin()),
            41 => self.vectors.push(v.abs().sqrt()),
            42 => self.vectors.push(S::Vec3::select(p, v, w)),
            43 => self.vectors.push(S::Vec3::choose(m, v, w)),
            44 => self.vectors.push(towards::<S>(v, a, b)),
            45 => self.vectors.push(ordered(v, w).low),
            46 => self.vector_masks.push(v.less_than(w)),
            47 => self.vector_masks.push(p.and(q)),
            48 => self.vector_masks.push(p.or(q.not())),
            49 => self.vectors.push((v + S::Vec3::lit(20.0)).normalize()),
            _ => unreachable!("operations are below 50"),
        }
    }

    /// The values after all steps.
    pub fn run(mut self, steps: &[Step]) -> Self {
        steps.iter().for_each(|step| self.step(step));
        self
    }
}

/// A program, and a point to run it at.
pub fn program() -> impl Strategy<Value = (Vec<Step>, [f64; 5])> {
    let literal = prop_oneof![Just(0.0), Just(1.0), Just(-1.0), Just(-0.0), Just(0.3), -4.0..4.0];
    let step = (0_u8..50, any::<[prop::sample::Index; 3]>(), literal).prop_map(|(operation, operands, literal)| Step {
        operation,
        operands,
        literal,
    });
    (prop::collection::vec(step, 1..40), prop::array::uniform5(-4.0..4.0))
}
