//! Shader text of a surface.

use crate::inputs::ShadingQuantity;
use crate::scene::Scene;
use crate::shading::Shading;
use pavo_emit::{EmitError, Form, Language, Options, Sphere, SphereInput};
use pavo_shade::{Input, Program};

/// How a text is made.
#[derive(Clone, Copy, Debug)]
pub struct Emission<'a> {
    /// The language.
    pub language: Language,
    /// The command that makes this text, for the comment at its top; it may be empty.
    pub command: &'a str,
    /// Whether each statement ends with the line of Rust that made it.
    pub source_lines: bool,
}

impl From<Language> for Emission<'_> {
    fn from(language: Language) -> Self {
        Self { language, command: "", source_lines: false }
    }
}

/// The functions of a surface: its reflectance, its BRDF and, where the scene has punctual lights, the radiance under
/// one. Where the scene asks for it and it saves something, what depends on the material alone is computed by a function
/// `prepare_surface`, whose result the others take, and what depends on the vertices by `vertex_surface`, whose result is
/// to be interpolated.
pub fn library<'a>(shading: &Shading, emission: impl Into<Emission<'a>>) -> String {
    let program = library_program(shading);
    pavo_emit::emit_library(&program, &options(shading, emission.into(), Form::Library, program.inputs()))
}

/// The struct of what is uniform over a material, as [`library`] takes it: for a uniform buffer, in Rust with the same
/// layout. Nothing where all that the scene leaves open is given at vertices or pixels.
pub fn uniforms<'a>(shading: &Shading, emission: impl Into<Emission<'a>>) -> Option<String> {
    let program = library_program(shading);
    pavo_emit::emit_uniforms(&program, &options(shading, emission.into(), Form::Library, program.inputs()))
}

/// A method of the Rust struct `PreparedSurface` that gives its bytes in a uniform buffer, where [`library`] has it.
pub fn prepared_bytes(shading: &Shading) -> Option<String> {
    let program = library_program(shading);
    let options = options(shading, Language::Rust.into(), Form::Library, program.inputs());
    pavo_emit::emit_prepared_bytes(&program, &options)
}

fn library_program(shading: &Shading) -> Program {
    let quantity = library_quantity(shading.scene());
    let scene = shading.scene();
    match (scene.emit.vertex, scene.is_prepared()) {
        (true, _) => shading.stages(quantity).joined,
        (false, true) => shading.split(quantity).joined,
        (false, false) => shading.program(quantity),
    }
}

/// The functions of a quantity with a compute entry that evaluates a buffer of points.
///
/// # Errors
/// If the language has no compute shaders.
pub fn compute<'a>(
    shading: &Shading,
    quantity: ShadingQuantity,
    emission: impl Into<Emission<'a>>,
) -> Result<String, EmitError> {
    let program = shading.program(quantity);
    pavo_emit::emit_compute(&program, &options(shading, emission.into(), Form::Compute, program.inputs()))
}

/// The functions of a surface with a fragment entry that shades a sphere.
///
/// # Errors
/// If the template of the entry is broken.
pub fn fragment<'a>(shading: &Shading, emission: impl Into<Emission<'a>>) -> Result<String, EmitError> {
    let program = shading.sphere_program();
    let options = options(shading, emission.into(), Form::Fragment, program.inputs());
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
    let program = shading.program(quantity);
    pavo_emit::emit_points(&program, &options(shading, emission.into(), Form::Fragment, program.inputs()))
}

/// The reflectance behind a signature of somebody else's. `facts` are further lines of the comment at its top.
///
/// # Errors
/// If the template of the wrapper is broken.
#[cfg(feature = "cli")]
pub fn wrapped<'a>(
    shading: &Shading,
    emission: impl Into<Emission<'a>>,
    prefix: &str,
    facts: &[String],
    wrapper: &pavo_emit::Wrapper<'_>,
) -> Result<String, EmitError> {
    let program = shading.program(ShadingQuantity::Reflectance);
    let mut options = options(shading, emission.into(), Form::Library, program.inputs());
    options.prefix.insert_str(0, prefix);
    options.header.extend_from_slice(facts);
    pavo_emit::emit_wrapped(&program, &options, wrapper)
}

/// What a library is of: as far as the scene goes.
pub fn library_quantity(scene: &Scene) -> ShadingQuantity {
    if scene.lights.punctual { ShadingQuantity::Directions } else { ShadingQuantity::Brdf }
}

fn options(shading: &Shading, emission: Emission<'_>, form: Form, inputs: &[Input]) -> Options {
    let Emission { language, command, source_lines } = emission;
    let scene = shading.scene();
    let mut header =
        vec![format!("{}: thin-film iridescence, generated by pavo {}.", scene.name, env!("CARGO_PKG_VERSION"))];
    if !command.is_empty() {
        header.push(format!("Made by: {command}"));
    }
    let colour = &scene.colour;
    header.push(format!("Variant: {}; form: {}.", shading.variant(), form.name()));
    header.push(format!("Colour: {}, observer {}, illuminant {}.", colour.space, colour.observer, colour.illuminant));
    let ranged: Vec<String> =
        inputs.iter().filter(|input| input.unit == "nm" || is_material(input)).map(range).collect();
    if !ranged.is_empty() {
        header.push(format!("Inputs: {}.", ranged.join(", ")));
    }
    Options { language, header, prefix: scene.emit.prefix.clone(), source_lines }
}

fn is_material(input: &Input) -> bool {
    input.rate == pavo_shade::Rate::Material && !input.name.starts_with("light_")
}

fn range(input: &Input) -> String {
    let unit = if input.unit.is_empty() { String::new() } else { format!(" {}", input.unit) };
    format!("{} in [{}, {}]{unit}", input.name, input.low, input.high)
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
