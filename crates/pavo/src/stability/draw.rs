//! Points drawn as the catalogue says: the same for the same case, surface and number of points.

use super::StabilityError;
use super::catalogue::{Case, Catalogue};
use crate::points::steps;
use pavo_shade::{Input, Type};
use rayon::prelude::*;
use serde::Deserialize;

/// How an input is drawn.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub(super) enum Draw {
    Number(f64),
    OneOf(Vec<f64>),
    Even { from: f64, to: f64 },
    Logarithmic { log_from: f64, log_to: f64 },
    Near { near: String, within: f64 },
    Times { times: String, from: f64, to: f64 },
    Critical { critical: String, within: f64 },
    Above { critical: String, squared: f64 },
    Minus { minus: String },
    Grey { grey: Box<Draw> },
}

impl Draw {
    /// The other inputs that it starts from.
    pub(super) fn others(&self) -> Vec<&str> {
        match self {
            Draw::Near { near, .. } => vec![near],
            Draw::Times { times, .. } => vec![times],
            Draw::Critical { critical, .. } | Draw::Above { critical, .. } => vec![critical, "ambient_ior"],
            Draw::Minus { minus } => vec![minus],
            _ => Vec::new(),
        }
    }

    fn value(&self, fraction: f64, [low, high]: [f64; 2], other: impl Fn(&str) -> f64) -> f64 {
        let between = |from: f64, to: f64| from + (to - from) * fraction;
        match self {
            Draw::Number(value) => *value,
            Draw::OneOf(values) => values[((fraction * values.len() as f64) as usize).min(values.len() - 1)],
            Draw::Even { from, to } => {
                // A range that the surface does not share is its nearest end.
                let (from, to) = (from.max(low).min(high), to.min(high).max(low));
                between(from, to)
            }
            Draw::Logarithmic { log_from, log_to } => between(log_from.ln(), log_to.ln()).exp(),
            Draw::Near { near, within } => other(near) * (1.0 + offset(fraction, *within)),
            Draw::Times { times, from, to } => other(times) * between(*from, *to),
            Draw::Critical { critical, within } => {
                let ratio = other(critical) / other("ambient_ior");
                (1.0 - ratio * ratio).max(0.0).sqrt() + offset(fraction, *within)
            }
            Draw::Above { critical, squared } => {
                let [ior, ambient] = [other(critical), other("ambient_ior")];
                ((squared - (ior - ambient) * (ior + ambient)).max(0.0).sqrt() / ambient).next_down()
            }
            Draw::Minus { minus } => -other(minus),
            Draw::Grey { grey } => grey.value(fraction, [low, high], other),
        }
    }
}

/// None for a fifth of the fractions; for the rest an offset of either sign, its logarithm even over seven decades.
fn offset(fraction: f64, within: f64) -> f64 {
    let magnitude = |part: f64| within * 10.0_f64.powf(-7.0 * part);
    if fraction < 0.4 {
        -magnitude(fraction / 0.4)
    } else if fraction < 0.6 {
        0.0
    } else {
        magnitude((fraction - 0.6) / 0.4)
    }
}

/// One number that is drawn.
struct Variable {
    name: String,
    draw: Draw,
    range: [f64; 2],
    /// Where its fraction stands in the sequence: the components of a grey colour share one.
    dimension: usize,
}

/// What draws the points of a case on a surface.
pub(super) struct Drawer {
    variables: Vec<Variable>,
    /// The places of the variables, each behind those that it starts from.
    order: Vec<usize>,
    fixed: Vec<(String, f64)>,
    steps: Vec<f64>,
    from_directions: bool,
    outside: bool,
    /// How many numbers a point has.
    pub width: usize,
}

/// The inputs that stand for three directions.
const DIRECTIONS: [&str; 3] = ["n_dot_l", "n_dot_v", "azimuth"];
const VECTORS: [&str; 3] = ["normal", "light_direction", "view_direction"];

impl Drawer {
    /// For a case; `inputs` are those of the surface, `fixed` what it fixes by name.
    pub fn new(
        catalogue: &Catalogue,
        case: &Case,
        inputs: &[Input],
        fixed: &[(String, f64)],
    ) -> Result<Self, StabilityError> {
        let mut variables: Vec<Variable> = Vec::new();
        let mut dimension = 0;
        let mut add = |name: &str, range: [f64; 2], components: usize| {
            let given = case.inputs.get(name).or_else(|| catalogue.ordinary.get(name));
            let draw = given.cloned().unwrap_or(Draw::Even { from: range[0], to: range[1] });
            let shares = matches!(draw, Draw::Grey { .. });
            for component in 0..components {
                if component == 0 || !shares {
                    dimension += 1;
                }
                variables.push(Variable { name: name.to_owned(), draw: draw.clone(), range, dimension: dimension - 1 });
            }
        };
        let from_directions = case.is_of_radiance();
        if from_directions {
            add("n_dot_l", [-1.0, 1.0], 1);
            add("n_dot_v", [-1.0, 1.0], 1);
            add("azimuth", [0.0, std::f64::consts::PI], 1);
        }
        for input in inputs.iter().filter(|input| !VECTORS.contains(&input.name.as_str())) {
            add(&input.name, [input.low, input.high], input.components());
        }
        let steps = steps(dimension.max(1));
        let mut drawer = Self {
            width: inputs.iter().map(Input::components).sum(),
            order: Vec::new(),
            fixed: fixed.to_vec(),
            variables,
            steps,
            from_directions,
            outside: case.outside,
        };
        drawer.order = drawer.ordered(&case.name)?;
        Ok(drawer)
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.variables.iter().position(|variable| variable.name == name)
    }

    /// Each variable behind those that it starts from.
    fn ordered(&self, case: &str) -> Result<Vec<usize>, StabilityError> {
        let mut order: Vec<usize> = Vec::new();
        while order.len() < self.variables.len() {
            let is_ready = |index: &usize| {
                let others = self.variables[*index].draw.others();
                let known = |name: &str| {
                    self.place(name).map_or(self.fixed.iter().any(|(other, _)| other == name), |at| order.contains(&at))
                };
                !order.contains(index) && others.into_iter().all(known)
            };
            let next = (0..self.variables.len()).find(is_ready).ok_or_else(|| {
                StabilityError::Data(format!("catalogue.toml: {case}: an input starts from one that is not there"))
            })?;
            order.push(next);
        }
        Ok(order)
    }

    /// The point of an index, written to its place.
    fn draw(&self, index: usize, seed: f64, values: &mut [f64], point: &mut [f32]) {
        for &at in &self.order {
            let variable = &self.variables[at];
            let fraction = (0.5 + seed + self.steps[variable.dimension] * (index + 1) as f64).fract();
            let other = |name: &str| {
                let fixed = || self.fixed.iter().find(|(other, _)| other == name).map_or(0.0, |(_, value)| *value);
                self.place(name).map_or_else(fixed, |place| values[place])
            };
            let value = variable.draw.value(fraction, variable.range, other);
            let [low, high] = variable.range;
            values[at] = if self.outside { value } else { value.clamp(low, high) };
        }
        let skipped = if self.from_directions { DIRECTIONS.len() } else { 0 };
        let vectors = if self.from_directions { 9 } else { 0 };
        if self.from_directions {
            let [light, view, azimuth] = [values[0], values[1], values[2]];
            let sine = |cosine: f64| (1.0 - cosine * cosine).max(0.0).sqrt();
            let directions = [
                [0.0, 0.0, 1.0],
                [sine(light), 0.0, light],
                [sine(view) * azimuth.cos(), sine(view) * azimuth.sin(), view],
            ];
            for (number, component) in point.iter_mut().zip(directions.iter().flatten()) {
                *number = *component as f32;
            }
        }
        for (number, value) in point[vectors..].iter_mut().zip(&values[skipped..]) {
            *number = *value as f32;
        }
    }

    /// Points from an index on, one after the other.
    pub fn points(&self, first: usize, count: usize, seed: u64) -> Vec<f32> {
        let mut points = vec![0.0_f32; count * self.width];
        self.fill(first, seed, &mut points);
        points
    }

    /// The same, into a list that is there.
    pub fn fill(&self, first: usize, seed: u64, points: &mut [f32]) {
        let seed = (seed as f64 * 0.754_877_666_246_692_8).fract();
        const PIECE: usize = 4096;
        points.par_chunks_mut(PIECE * self.width).enumerate().for_each(|(piece, points)| {
            let mut values = vec![0.0; self.variables.len()];
            for (place, point) in points.chunks_exact_mut(self.width).enumerate() {
                self.draw(first + piece * PIECE + place, seed, &mut values, point);
            }
        });
    }
}

/// Where the numbers of an input stand in a point.
pub(super) fn column(inputs: &[Input], name: &str) -> Option<usize> {
    let mut offset = 0;
    for input in inputs {
        if input.name == name {
            return (input.ty == Type::Scalar).then_some(offset);
        }
        offset += input.components();
    }
    None
}
