//! Complete texts: the functions of a program with an entry point from a template.

use crate::dialect::{Dialect, Syntax};
use crate::function::{Body, Context, body};
use crate::literal::number;
use crate::passing::structs_passed;
use crate::text::{Names, Tables, functions, header};
use crate::{EmitError, Form, Language, Options, WORKGROUP_SIZE};
use minijinja::{Environment, context};
use pavo_shade::{Program, Type};

const COMPUTE_WGSL: &str = include_str!("../../../templates/entry/compute.wgsl");
const COMPUTE_GLSL: &str = include_str!("../../../templates/entry/compute.glsl");
const COMPUTE_HLSL: &str = include_str!("../../../templates/entry/compute.hlsl");
const SPHERE_WGSL: &str = include_str!("../../../templates/entry/sphere.wgsl");
const SPHERE_GLSL: &str = include_str!("../../../templates/entry/sphere.glsl");
const SPHERE_HLSL: &str = include_str!("../../../templates/entry/sphere.hlsl");
const TRIANGLE_WGSL: &str = include_str!("../../../templates/entry/triangle.wgsl");

/// How the fragment entry fills the inputs of a surface.
#[derive(Clone, Debug, Default)]
pub struct Sphere {
    /// A value for each input that is neither a direction nor `n_dot_v`.
    pub inputs: Vec<SphereInput>,
}

/// The value of an input over the sphere.
#[derive(Clone, Debug)]
pub struct SphereInput {
    /// The name of the input.
    pub name: String,
    /// Its value at the thin end of the pattern, one number or three.
    pub low: Vec<f64>,
    /// Its value at the other end; the same where it does not vary.
    pub high: Vec<f64>,
}

/// The vertex shader that goes with the fragment entry, in WGSL: one triangle over the whole target.
pub fn full_screen_triangle() -> &'static str {
    TRIANGLE_WGSL
}

/// The inputs that the sphere computes itself.
const GEOMETRY: [&str; 4] = ["normal", "light_direction", "view_direction", "n_dot_v"];

pub fn compute(program: &Program, options: &Options) -> Result<String, EmitError> {
    let dialect = dialect_with(Form::Compute, options)?;
    let template = match dialect.syntax {
        Syntax::Wgsl => COMPUTE_WGSL,
        Syntax::Hlsl => COMPUTE_HLSL,
        _ => COMPUTE_GLSL,
    };
    render("compute", template, program, options, &Sphere::default())
}

pub fn fragment(program: &Program, options: &Options, sphere: &Sphere) -> Result<String, EmitError> {
    let dialect = dialect_with(Form::Fragment, options)?;
    let template = match dialect.syntax {
        Syntax::Wgsl => SPHERE_WGSL,
        Syntax::Hlsl => SPHERE_HLSL,
        _ => SPHERE_GLSL,
    };
    render("fragment", template, program, options, sphere)
}

/// The row of the language, if it has this form.
fn dialect_with(form: Form, options: &Options) -> Result<&'static Dialect, EmitError> {
    let dialect = Dialect::of(options.language);
    let no_entry = EmitError::NoEntry { language: options.language, form };
    if dialect.forms.contains(&form) { Ok(dialect) } else { Err(no_entry) }
}

fn render(
    form: &'static str,
    template: &str,
    program: &Program,
    options: &Options,
    sphere: &Sphere,
) -> Result<String, EmitError> {
    let dialect = Dialect::of(options.language);
    let names = Names::new(program, options);
    let main = main_body(program, options, &names);
    let mut offset = 0;
    let inputs: Vec<minijinja::Value> = program
        .inputs()
        .iter()
        .zip(&main.parameters)
        .map(|(input, name)| {
            let row = context! {
                name,
                offset,
                vector => input.ty == Type::Vec3,
                ty => dialect.type_name(input.ty),
                value => value_over_sphere(dialect, sphere, &input.name, input.ty),
                geometry => GEOMETRY.contains(&input.name.as_str()),
            };
            offset += input.components();
            row
        })
        .collect();
    let outputs: Vec<minijinja::Value> = program
        .outputs()
        .iter()
        .zip(&main.results)
        .map(|(output, value)| context! { name => output.name.as_str(), value })
        .collect();
    let columns: Vec<&str> = program.inputs().iter().map(|input| input.name.as_str()).collect();
    let values = context! {
        inputs,
        outputs,
        columns => columns.join(", "),
        statements => main.statements,
        stride => program.input_components(),
        workgroup_size => WORKGROUP_SIZE,
        modern => options.language == Language::Glsl450,
    };
    // A compute shader reads its tables from buffers after those of the inputs and outputs.
    let tables = if form == "compute" { Tables::Buffers { first_binding: 2 } } else { Tables::Constants };
    complete(form, template, values, &functions(program, options, &names, tables), options)
}

/// What an entry point does with the inputs of a program.
pub(crate) fn main_body(program: &Program, options: &Options, names: &Names) -> Body {
    let fields = names.fields();
    let passed = structs_passed(program, &names.structs);
    let printer = Context {
        dialect: Dialect::of(options.language),
        functions: &names.functions,
        tables: &names.tables,
        structs: &names.structs,
        fields: &fields,
        passed: &passed,
        outer: &names.outer,
        source_lines: options.source_lines,
    };
    body(&printer, program.body(), program.functions().len())
}

/// A complete text: header, functions, and an entry point from its template.
pub(crate) fn complete(
    form: &'static str,
    template: &str,
    values: minijinja::Value,
    functions: &str,
    options: &Options,
) -> Result<String, EmitError> {
    let dialect = Dialect::of(options.language);
    let mut environment = Environment::new();
    environment.set_undefined_behavior(minijinja::UndefinedBehavior::Strict);
    let broken = |error: minijinja::Error| EmitError::Template { form, message: format!("{error:#}") };
    let entry = environment.render_str(template, values).map_err(broken)?;
    let mut text = String::new();
    if !dialect.version.is_empty() {
        text.push_str(dialect.version);
        text.push('\n');
    }
    text.push_str(&header(options));
    if !dialect.preamble.is_empty() {
        text.push('\n');
        text.push_str(dialect.preamble);
    }
    text.push_str(functions);
    text.push('\n');
    text.push_str(entry.trim_end());
    text.push('\n');
    Ok(text)
}

/// The expression of an input over the sphere: a constant, or one that follows the pattern.
fn value_over_sphere(dialect: &Dialect, sphere: &Sphere, name: &str, ty: Type) -> String {
    let Some(input) = sphere.inputs.iter().find(|input| input.name == name) else { return String::new() };
    let constant = |numbers: &[f64]| {
        let numbers: Vec<String> = numbers.iter().copied().map(number).collect();
        match ty {
            Type::Vec3 => format!("{}({})", dialect.type_name(ty), numbers.join(", ")),
            _ => numbers.concat(),
        }
    };
    if input.low == input.high {
        constant(&input.low)
    } else {
        format!("{}({}, {}, pattern)", dialect.mix, constant(&input.low), constant(&input.high))
    }
}
