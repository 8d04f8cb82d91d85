//! How the parts of a program are called in emitted text, by the rate at which they are run.

use crate::function::Rate;

/// The name of the struct that `prepare_surface` returns, where it returns more than one value.
pub const PREPARED_SURFACE: &str = "PreparedSurface";

/// The function that computes the rare values, and what takes them.
#[derive(Debug)]
pub struct Part {
    /// How often it is run.
    pub rate: Rate,
    /// Its name.
    pub function: &'static str,
    /// What it does.
    pub function_doc: &'static [&'static str],
    /// The struct that it returns, where it returns more than one value.
    pub result: &'static str,
    /// A parameter of this struct.
    pub parameter: &'static str,
    /// What the parameter means.
    pub parameter_doc: &'static str,
    /// What a single value means.
    pub value_doc: &'static str,
}

static MATERIAL: Part = Part {
    rate: Rate::Material,
    function: "prepare_surface",
    function_doc: &["Prepares a material: what depends on nothing else, computed once for all its pixels."],
    result: PREPARED_SURFACE,
    parameter: "prepared",
    parameter_doc: "what was prepared for the material",
    value_doc: "prepared once for the material",
};

static VERTEX: Part = Part {
    rate: Rate::Vertex,
    function: "vertex_surface",
    function_doc: &[
        "Computes at a vertex what depends on nothing that changes more often, to be interpolated.",
        "",
        "Between the vertices the interpolated values approximate what would be computed at the pixel.",
    ],
    result: "VertexSurface",
    parameter: "interpolated",
    parameter_doc: "what was computed at the vertices, interpolated",
    value_doc: "computed at the vertices, interpolated",
};

impl Part {
    /// The part that is run at a rate; nothing at the rate of the pixels, which is the rest.
    pub fn at(rate: Rate) -> Option<&'static Self> {
        match rate {
            Rate::Material => Some(&MATERIAL),
            Rate::Vertex => Some(&VERTEX),
            Rate::Pixel => None,
        }
    }
}
