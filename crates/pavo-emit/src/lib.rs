//! Prints a shader graph as WGSL, GLSL, HLSL, OSL and Rust.
//!
//! One printer serves all languages; what differs between them stands in a table ([`dialect`]). The text is what a
//! careful person would write: the names of the Rust source, a comment per function with meaning, units and source,
//! and nothing that the program does not need. The same program gives the same bytes.

mod comment;
mod cost;
pub mod dialect;
mod entry;
mod expression;
mod function;
mod half;
mod lines;
mod literal;
mod namer;
mod parts;
mod passing;
mod rust;
mod text;
mod uniform;
mod wrapped;

pub use dialect::Dialect;
pub use entry::{Sphere, SphereInput, full_screen_triangle};
use pavo_shade::Program;
use thiserror::Error;
pub use wrapped::Wrapper;

/// A text language that the printer writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Language {
    /// WGSL.
    Wgsl,
    /// GLSL 4.50 core, for Vulkan.
    Glsl450,
    /// GLSL 3.30 core.
    Glsl330,
    /// GLSL ES 3.00.
    Essl300,
    /// HLSL, as Direct3D, Unity and Unreal read it: shader model 5 or newer.
    Hlsl,
    /// The Open Shading Language: functions for shaders of Cycles and other renderers.
    Osl,
    /// Rust with the vectors of glam 0.29 or newer: functions for the CPU.
    Rust,
}

impl Language {
    /// All languages.
    pub const ALL: [Language; 7] = [
        Language::Wgsl,
        Language::Glsl450,
        Language::Glsl330,
        Language::Essl300,
        Language::Hlsl,
        Language::Osl,
        Language::Rust,
    ];

    /// The name as it is written on the command line and in scenes.
    pub fn name(self) -> &'static str {
        Dialect::of(self).name
    }
}

/// What stands around the functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Form {
    /// Functions only, no entry point.
    Library,
    /// A compute entry that evaluates a buffer of points.
    Compute,
    /// A fragment entry that shades a sphere.
    Fragment,
}

impl Form {
    /// All forms.
    pub const ALL: [Form; 3] = [Form::Library, Form::Compute, Form::Fragment];

    /// The name as it is written on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Form::Library => "library",
            Form::Compute => "compute",
            Form::Fragment => "fragment",
        }
    }
}

/// How many points a workgroup of the compute entry evaluates.
pub const WORKGROUP_SIZE: u32 = 64;

/// What a text is printed with.
#[derive(Clone, Debug)]
pub struct Options {
    /// The language.
    pub language: Language,
    /// Lines of the comment at the top.
    pub header: Vec<String>,
    /// What the names of functions and structs begin with; empty for nothing.
    pub prefix: String,
    /// Whether each statement names the line of Rust that made it.
    pub source_lines: bool,
}

/// Why a text cannot be printed.
#[derive(Debug, Error)]
pub enum EmitError {
    /// The language has no such entry point.
    #[error("{} has no {} shaders; use {}, or --target {}", .language.name(), .form.name(), forms_of(*.language),
        languages_with(*.form))]
    NoEntry {
        /// The language.
        language: Language,
        /// The form.
        form: Form,
    },
    /// The language has no entry point whose cost is counted.
    #[error("{language} is not compiled for a graphics card here; the cost is counted of wgsl and glsl450")]
    NoCost {
        /// The name of the language.
        language: &'static str,
    },
    /// The language has no entry point that evaluates points from a texture.
    #[error("{language} is not run by OpenGL; glsl330 and essl300 are")]
    NoPoints {
        /// The name of the language.
        language: &'static str,
    },
    /// A template of what stands around functions is broken.
    #[error("the template {name} cannot be rendered: {message}")]
    Wrapper {
        /// The name of the template.
        name: String,
        /// What is wrong with it.
        message: String,
    },
    /// A template of an entry point is broken.
    #[error("the template of the {form} entry cannot be rendered: {message}")]
    Template {
        /// The form.
        form: &'static str,
        /// What is wrong with it.
        message: String,
    },
}

/// The forms of a language as they are asked for.
fn forms_of(language: Language) -> String {
    let forms: Vec<String> = Dialect::of(language).forms.iter().map(|form| format!("--form {}", form.name())).collect();
    forms.join(" or ")
}

/// The languages that have a form.
fn languages_with(form: Form) -> String {
    let with = Language::ALL.into_iter().filter(|language| Dialect::of(*language).forms.contains(&form));
    with.map(Language::name).collect::<Vec<_>>().join(" or ")
}

/// The functions of a program, with no entry point.
pub fn emit_library(program: &Program, options: &Options) -> String {
    text::library(program, options)
}

/// The struct of the inputs of a program that are uniform over a material, for a uniform buffer; nothing where there are
/// none.
///
/// In Rust it has the same layout, a constructor `new`, and `to_bytes`.
pub fn emit_uniforms(program: &Program, options: &Options) -> Option<String> {
    uniform::uniforms(program, options)
}

/// A method `to_bytes` of the Rust struct that holds what a program prepares for a material; nothing where it prepares
/// nothing.
pub fn emit_prepared_bytes(program: &Program, options: &Options) -> Option<String> {
    uniform::prepared_bytes(program, options)
}

/// The functions of a program with a compute entry that evaluates a buffer of points.
///
/// Binding 0 holds the inputs, binding 1 takes three numbers a point for each output.
///
/// # Errors
/// If the language has no compute shaders.
pub fn emit_compute(program: &Program, options: &Options) -> Result<String, EmitError> {
    entry::compute(program, options)
}

/// The functions of a program with a fragment entry that shades a sphere.
///
/// # Errors
/// If the language has no fragment shaders, or the template of the entry is broken.
pub fn emit_fragment(program: &Program, options: &Options, sphere: &Sphere) -> Result<String, EmitError> {
    entry::fragment(program, options, sphere)
}

/// The functions of a program with a fragment entry that evaluates them once, for a compiler to count what they cost.
///
/// Each input is interpolated: its numbers are packed by fours into the locations from 0 on, in the order of the
/// program's inputs. The sum of the outputs is written to location 0. Take away what [`emit_cost_baseline`] costs.
///
/// # Errors
/// If the language is neither WGSL nor GLSL 4.50.
pub fn emit_cost(program: &Program, options: &Options) -> Result<String, EmitError> {
    cost::whole(program, options)
}

/// A fragment entry with the inputs of [`emit_cost`] that only adds them up: what it costs to read the inputs and to
/// write a colour.
///
/// # Errors
/// If the language is neither WGSL nor GLSL 4.50.
pub fn emit_cost_baseline(program: &Program, options: &Options) -> Result<String, EmitError> {
    cost::baseline(program, options)
}

/// The functions of a program with a fragment entry for OpenGL that evaluates one point at each pixel.
///
/// The texture `inputs` has four numbers a texel, and for the pixel (x, y) texels in row y: those of its inputs, in the
/// order of the program's, from x times their count on. The sum of the outputs is written to location 0.
///
/// # Errors
/// If the language is neither GLSL 3.30 nor GLSL ES 3.00.
pub fn emit_points(program: &Program, options: &Options) -> Result<String, EmitError> {
    cost::points(program, options)
}

/// The functions of a program within a text from a template: a function with a signature of somebody else's, that
/// computes the program's one output from what it is given.
///
/// # Errors
/// If the template is broken.
pub fn emit_wrapped(program: &Program, options: &Options, wrapper: &Wrapper<'_>) -> Result<String, EmitError> {
    wrapped::wrapped(program, options, wrapper)
}
