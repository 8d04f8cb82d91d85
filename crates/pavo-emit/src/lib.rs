//! Prints a shader graph as WGSL, GLSL, HLSL, OSL and Rust.
//!
//! One printer serves all languages; what differs between them stands in a table ([`dialect`]). The text is what a
//! careful person would write: the names of the Rust source, a comment per function with meaning, units and source,
//! and nothing that the program does not need. The same program gives the same bytes.

mod comment;
#[cfg(feature = "entry")]
mod cost;
pub mod dialect;
#[cfg(feature = "entry")]
mod entries;
#[cfg(feature = "entry")]
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
#[cfg(feature = "entry")]
mod wrapped;

pub use dialect::Dialect;
#[cfg(feature = "entry")]
pub use entries::{emit_compute, emit_cost, emit_cost_baseline, emit_fragment, emit_points, emit_wrapped};
#[cfg(feature = "entry")]
pub use entry::{Sphere, SphereInput, full_screen_triangle};
use pavo_shade::Program;
use thiserror::Error;
#[cfg(feature = "entry")]
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
