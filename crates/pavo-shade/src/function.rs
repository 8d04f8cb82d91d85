//! What is known of functions, parameters and inputs besides their computation.

use crate::graph::Type;

/// A function written with `#[shade]`.
#[derive(Debug)]
pub struct FunctionInfo {
    /// Its name, the same in every language.
    pub name: &'static str,
    /// The module it is in; with the name, its identity.
    pub module: &'static str,
    /// Its doc comment, a line each.
    pub doc: &'static [&'static str],
    /// Its parameters, without the build-time ones.
    pub parameters: &'static [ParameterInfo],
}

/// A parameter of a function written with `#[shade]`.
#[derive(Debug)]
pub struct ParameterInfo {
    /// Its name.
    pub name: &'static str,
    /// Its doc comment in one line: meaning, unit, range.
    pub doc: &'static str,
    /// Whether it stays a parameter where the argument is literal (`#[runtime]`).
    pub runtime: bool,
}

/// How often an input changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rate {
    /// Once a material: a uniform.
    Material,
    /// At each vertex.
    Vertex,
    /// At each pixel.
    Pixel,
}

impl Rate {
    /// All rates, the rarest first.
    pub const ALL: [Rate; 3] = [Rate::Material, Rate::Vertex, Rate::Pixel];

    /// The rate as it is written in a manifest.
    pub fn name(self) -> &'static str {
        match self {
            Rate::Material => "material",
            Rate::Vertex => "vertex",
            Rate::Pixel => "pixel",
        }
    }
}

/// A run-time input of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Its name, the same in every language.
    pub name: String,
    /// One number or three.
    pub ty: Type,
    /// Its unit, empty for a plain number.
    pub unit: String,
    /// The smallest value it takes (of each component).
    pub low: f64,
    /// The largest value it takes (of each component).
    pub high: f64,
    /// How often it changes.
    pub rate: Rate,
}

impl Input {
    /// A number within `[low, high]`.
    pub fn scalar(name: &str, unit: &str, low: f64, high: f64, rate: Rate) -> Self {
        Self { name: name.to_owned(), ty: Type::Scalar, unit: unit.to_owned(), low, high, rate }
    }

    /// A linear colour with components within `[0, 1]`.
    pub fn colour(name: &str, rate: Rate) -> Self {
        Self { name: name.to_owned(), ty: Type::Vec3, unit: String::new(), low: 0.0, high: 1.0, rate }
    }

    /// How many numbers it takes in a table of points: 1, or 3 for a vector.
    pub fn components(&self) -> usize {
        if self.ty == Type::Vec3 { 3 } else { 1 }
    }
}
