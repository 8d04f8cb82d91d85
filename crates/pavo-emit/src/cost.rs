//! Complete texts that evaluate a program once and write a colour: with inputs from the stage before, for a compiler to
//! count what that costs, and with inputs from a texture, for OpenGL to run.

use crate::dialect::Dialect;
use crate::entry::{complete, main_body};
use crate::text::{Names, Tables, functions};
use crate::{EmitError, Language, Options};
use minijinja::context;
use pavo_shade::{Program, Type};

const COST_WGSL: &str = include_str!("../../../templates/entry/cost.wgsl");
const COST_GLSL: &str = include_str!("../../../templates/entry/cost.glsl");
const POINTS_GLSL: &str = include_str!("../../../templates/entry/points.glsl");

/// How many numbers a location or a texel holds.
const LOCATION_SIZE: usize = 4;

pub fn whole(program: &Program, options: &Options) -> Result<String, EmitError> {
    Entry::new(program, options, cost_template(options)?).whole()
}

/// The template of the language's cost entry.
fn cost_template(options: &Options) -> Result<&'static str, EmitError> {
    match options.language {
        Language::Wgsl => Ok(COST_WGSL),
        Language::Glsl450 => Ok(COST_GLSL),
        Language::Glsl330 | Language::Essl300 | Language::Hlsl | Language::Osl | Language::Rust => {
            Err(EmitError::NoCost { language: options.language.name() })
        }
    }
}

pub fn points(program: &Program, options: &Options) -> Result<String, EmitError> {
    match options.language {
        Language::Glsl330 | Language::Essl300 => Entry::new(program, options, POINTS_GLSL).whole(),
        _ => Err(EmitError::NoPoints { language: options.language.name() }),
    }
}

pub fn baseline(program: &Program, options: &Options) -> Result<String, EmitError> {
    let entry = Entry::new(program, options, cost_template(options)?);
    let numbers: Vec<String> = (0..program.input_components()).map(|number| entry.number(number)).collect();
    let sum = if numbers.is_empty() { "0.0".to_owned() } else { numbers.join(" + ") };
    let color = format!("{}({sum})", Dialect::of(options.language).type_name(Type::Vec3));
    entry.complete("Only adds the inputs up.", &[], &[], &color, "")
}

/// An entry point with its inputs.
struct Entry<'a> {
    program: &'a Program,
    options: &'a Options,
    template: &'static str,
    names: Names,
    /// The names of the locations, each a vector of four numbers.
    locations: Vec<String>,
    /// The name of the colour that is written, in GLSL.
    target: String,
}

impl<'a> Entry<'a> {
    fn new(program: &'a Program, options: &'a Options, template: &'static str) -> Self {
        let mut names = Names::new(program, options);
        let count = program.input_components().div_ceil(LOCATION_SIZE);
        let locations = (0..count).map(|location| names.outer.fresh(&format!("varying_{location}"))).collect();
        let target = names.outer.fresh("fragment_color");
        Self { program, options, template, names, locations, target }
    }

    /// The text that evaluates all outputs and writes their sum.
    fn whole(&self) -> Result<String, EmitError> {
        let main = main_body(self.program, self.options, &self.names);
        let color = match &main.results[..] {
            [value] => value.clone(),
            values => values.iter().map(|value| format!("({value})")).collect::<Vec<_>>().join(" + "),
        };
        let comment = "Evaluates the outputs once, from interpolated inputs and nothing else, and writes their sum.";
        let functions = functions(self.program, self.options, &self.names, Tables::Constants);
        self.complete(comment, &main.parameters, &main.statements, &color, &functions)
    }

    /// One number of all inputs in a row.
    fn number(&self, number: usize) -> String {
        let component = ["x", "y", "z", "w"][number % LOCATION_SIZE];
        format!("{}.{component}", self.locations[number / LOCATION_SIZE])
    }

    /// The text; `parameters` are the names of the inputs, or nothing where they are not used.
    fn complete(
        &self,
        comment: &str,
        parameters: &[String],
        statements: &[String],
        color: &str,
        functions: &str,
    ) -> Result<String, EmitError> {
        let dialect = Dialect::of(self.options.language);
        let mut offset = 0;
        let inputs: Vec<minijinja::Value> = self
            .program
            .inputs()
            .iter()
            .zip(parameters)
            .map(|(input, name)| {
                let numbers: Vec<String> =
                    (offset..offset + input.components()).map(|number| self.number(number)).collect();
                offset += input.components();
                let ty = dialect.type_name(input.ty);
                let value = match input.ty {
                    Type::Vec3 => format!("{ty}({})", numbers.join(", ")),
                    _ => numbers.concat(),
                };
                context! { name, ty, value }
            })
            .collect();
        let (locations, target) = (&self.locations, &self.target);
        let columns: Vec<&str> = self.program.inputs().iter().map(|input| input.name.as_str()).collect();
        let columns = columns.join(", ");
        let texels = locations.len();
        let statements = statements.to_vec();
        let values = context! { comment, inputs, statements, color, locations, target, columns, texels };
        complete("cost", self.template, values, functions, self.options)
    }
}
