//! Shader text of a surface with something around the functions.

use crate::emission::{Emission, in_language, options};
use crate::inputs::ShadingQuantity;
use crate::shading::Shading;
use pavo_emit::{EmitError, Form, Sphere, SphereInput};
use pavo_shade::Input;

/// The functions of a quantity with a compute entry that evaluates a buffer of points.
///
/// # Errors
/// If the language has no compute shaders.
pub fn compute<'a>(
    shading: &Shading,
    quantity: ShadingQuantity,
    emission: impl Into<Emission<'a>>,
) -> Result<String, EmitError> {
    let emission = emission.into();
    let program = in_language(shading, emission.language).program(quantity);
    pavo_emit::emit_compute(&program, &options(shading, emission, Form::Compute, program.inputs()))
}

/// The functions of a surface with a fragment entry that shades a sphere.
///
/// # Errors
/// If the template of the entry is broken.
pub fn fragment<'a>(shading: &Shading, emission: impl Into<Emission<'a>>) -> Result<String, EmitError> {
    let emission = emission.into();
    let program = in_language(shading, emission.language).sphere_program();
    let options = options(shading, emission, Form::Fragment, program.inputs());
    pavo_emit::emit_fragment(&program, &options, &over_sphere(program.inputs()))
}

/// The functions of a quantity with a fragment entry that evaluates them once, for a compiler to count what they cost.
///
/// # Errors
/// If the language is neither WGSL nor GLSL 4.50.
pub fn cost<'a>(
    shading: &Shading,
    quantity: ShadingQuantity,
    emission: impl Into<Emission<'a>>,
) -> Result<String, EmitError> {
    let program = shading.program(quantity);
    pavo_emit::emit_cost(&program, &options(shading, emission.into(), Form::Fragment, program.inputs()))
}

/// A fragment entry with the inputs of [`cost`] that only adds them up, to be taken away from its cost.
///
/// # Errors
/// If the language is neither WGSL nor GLSL 4.50.
pub fn cost_baseline<'a>(
    shading: &Shading,
    quantity: ShadingQuantity,
    emission: impl Into<Emission<'a>>,
) -> Result<String, EmitError> {
    let program = shading.program(quantity);
    pavo_emit::emit_cost_baseline(&program, &options(shading, emission.into(), Form::Fragment, program.inputs()))
}

/// The functions of a quantity with a fragment entry for OpenGL that evaluates one point at each pixel, from a texture.
///
/// # Errors
/// If the language is neither GLSL 3.30 nor GLSL ES 3.00.
pub fn points_fragment<'a>(
    shading: &Shading,
    quantity: ShadingQuantity,
    emission: impl Into<Emission<'a>>,
) -> Result<String, EmitError> {
    let emission = emission.into();
    let program = in_language(shading, emission.language).program(quantity);
    pavo_emit::emit_points(&program, &options(shading, emission, Form::Fragment, program.inputs()))
}

/// The reflectance behind a signature of somebody else's. `facts` are further lines of the comment at its top.
///
/// # Errors
/// If the template of the wrapper is broken.
pub fn wrapped<'a>(
    shading: &Shading,
    emission: impl Into<Emission<'a>>,
    prefix: &str,
    facts: &[String],
    wrapper: &pavo_emit::Wrapper<'_>,
) -> Result<String, EmitError> {
    let emission = emission.into();
    let program = in_language(shading, emission.language).program(ShadingQuantity::Reflectance);
    let mut options = options(shading, emission, Form::Library, program.inputs());
    options.prefix.insert_str(0, prefix);
    options.header.extend_from_slice(facts);
    pavo_emit::emit_wrapped(&program, &options, wrapper)
}

/// The inputs over the sphere: what is given at each pixel follows the pattern, the rest stands at a likely value.
pub(crate) fn over_sphere(inputs: &[Input]) -> Sphere {
    let value = |input: &Input| {
        let (low, high) = match input.name.as_str() {
            "light_color" => (vec![1.0; 3], vec![1.0; 3]),
            "light_intensity" => (vec![1.5], vec![1.5]),
            "base_color" => (vec![0.10, 0.35, 0.15], vec![0.10, 0.35, 0.15]),
            // Gold, about.
            "f0" => (vec![1.0, 0.71, 0.29], vec![1.0, 0.71, 0.29]),
            "edge_tint" => (vec![0.9, 0.6, 0.5], vec![0.9, 0.6, 0.5]),
            "roughness" => {
                let value = 0.3_f64.clamp(input.low, input.high);
                (vec![value], vec![value])
            }
            _ if input.rate == pavo_shade::Rate::Pixel => (vec![input.low], vec![input.high]),
            _ => {
                let value = f64::midpoint(input.low, input.high);
                (vec![value], vec![value])
            }
        };
        SphereInput { name: input.name.clone(), low, high }
    };
    Sphere { inputs: inputs.iter().map(value).collect() }
}
