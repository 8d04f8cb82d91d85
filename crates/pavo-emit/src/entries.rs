//! Texts with something around the functions, by templates.

use crate::{EmitError, Options, Sphere, Wrapper, cost, entry, wrapped};
use pavo_shade::Program;

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
