//! What is evaluated, and the run-time inputs that it reads.

use pavo_shade::{Expr, Graph, Input, Rate, Scalar, Type, Vector};
use std::collections::BTreeMap;

/// What is evaluated of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShadingQuantity {
    /// The specular reflectance by colour channel, over the cosine of the angle at the half vector.
    Reflectance,
    /// The BRDF by colour channel, 1/sr, over the cosines between the directions.
    Brdf,
    /// The radiance under a punctual light by colour channel, over the cosines between the directions.
    Radiance,
    /// The radiance under a punctual light by colour channel, over the directions themselves.
    Directions,
}

impl ShadingQuantity {
    /// The quantities that a table of points can be evaluated for.
    pub const NAMED: [(&'static str, ShadingQuantity); 3] = [
        ("reflectance", ShadingQuantity::Reflectance),
        ("brdf", ShadingQuantity::Brdf),
        ("radiance", ShadingQuantity::Radiance),
    ];

    /// The name of what comes out.
    pub fn name(self) -> &'static str {
        match self {
            ShadingQuantity::Reflectance => "reflectance",
            ShadingQuantity::Brdf => "brdf",
            ShadingQuantity::Radiance | ShadingQuantity::Directions => "radiance",
        }
    }
}

/// Where the run-time inputs of an evaluation come from, in the order in which it reads them.
pub(crate) trait InputReader<S: Scalar> {
    /// A number within `[low, high]`.
    fn number(&mut self, name: &str, unit: &str, range: [f64; 2], rate: Rate) -> S;
    /// A colour or a direction with components within `[low, high]`.
    fn vector(&mut self, name: &str, range: [f64; 2], rate: Rate) -> S::Vec3;
}

/// Reads numbers off a point.
pub(crate) struct PointReader<'a, S> {
    pub numbers: std::slice::Iter<'a, S>,
}

impl<S: Scalar> PointReader<'_, S> {
    fn next(&mut self) -> S {
        *self.numbers.next().expect("a point has a number for each component of each input")
    }
}

impl<S: Scalar> InputReader<S> for PointReader<'_, S> {
    fn number(&mut self, _: &str, _: &str, _: [f64; 2], _: Rate) -> S {
        self.next()
    }
    fn vector(&mut self, _: &str, _: [f64; 2], _: Rate) -> S::Vec3 {
        let [x, y, z] = [self.next(), self.next(), self.next()];
        S::Vec3::new(x, y, z)
    }
}

/// Declares the inputs of a graph.
pub(crate) struct GraphReader<'g> {
    pub graph: &'g Graph,
}

impl<'g> InputReader<Expr<'g>> for GraphReader<'g> {
    fn number(&mut self, name: &str, unit: &str, [low, high]: [f64; 2], rate: Rate) -> Expr<'g> {
        self.graph.input(Input::scalar(name, unit, low, high, rate))
    }
    fn vector(&mut self, name: &str, [low, high]: [f64; 2], rate: Rate) -> Expr<'g> {
        self.graph.input(Input { low, high, ..Input::colour(name, rate) })
    }
}

/// Reads inputs with the rates that a scene gives.
pub(crate) struct Rated<'a, R> {
    pub reader: R,
    pub rates: &'a BTreeMap<String, Rate>,
}

impl<R> Rated<'_, R> {
    fn rate(&self, name: &str, default: Rate) -> Rate {
        self.rates.get(name).copied().unwrap_or(default)
    }
}

impl<S: Scalar, R: InputReader<S>> InputReader<S> for Rated<'_, R> {
    fn number(&mut self, name: &str, unit: &str, range: [f64; 2], rate: Rate) -> S {
        self.reader.number(name, unit, range, self.rate(name, rate))
    }
    fn vector(&mut self, name: &str, range: [f64; 2], rate: Rate) -> S::Vec3 {
        self.reader.vector(name, range, self.rate(name, rate))
    }
}

/// Lists the inputs.
#[derive(Default)]
pub(crate) struct InputList {
    pub inputs: Vec<Input>,
}

impl InputReader<f64> for InputList {
    fn number(&mut self, name: &str, unit: &str, [low, high]: [f64; 2], rate: Rate) -> f64 {
        self.inputs.push(Input::scalar(name, unit, low, high, rate));
        low
    }
    fn vector(&mut self, name: &str, [low, high]: [f64; 2], rate: Rate) -> glam::DVec3 {
        self.inputs.push(Input { name: name.to_owned(), ty: Type::Vec3, unit: String::new(), low, high, rate });
        glam::DVec3::splat(low)
    }
}
