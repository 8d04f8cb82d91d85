//! Complete texts whose cost a compiler counts: inputs from the stage before, one evaluation, a colour.

use crate::dialect::Dialect;
use crate::entry::{complete, main_body};
use crate::text::{Names, Tables, functions};
use crate::{EmitError, Language, Options};
use minijinja::context;
use pavo_shade::{Program, Type};

const COST_WGSL: &str = include_str!("../../../templates/entry/cost.wgsl");
const COST_GLSL: &str = include_str!("../../../templates/entry/cost.glsl");

/// How many numbers a location holds.
const LOCATION_SIZE: usize = 4;

pub fn whole(program: &Program, options: &Options) -> Result<String, EmitError> {
    let entry = Entry::new(program, options)?;
    let main = main_body(program, options, &entry.names);
    let color = match &main.results[..] {
        [value] => value.clone(),
        values => values.iter().map(|value| format!("({value})")).collect::<Vec<_>>().join(" + "),
    };
    let comment = "Evaluates the outputs once, from interpolated inputs and nothing else, and writes their sum.";
    let functions = functions(program, options, &entry.names, Tables::Constants);
    entry.complete(comment, &main.parameters, &main.statements, &color, &functions)
}

pub fn baseline(program: &Program, options: &Options) -> Result<String, EmitError> {
    let entry = Entry::new(program, options)?;
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
    fn new(program: &'a Program, options: &'a Options) -> Result<Self, EmitError> {
        let template = match options.language {
            Language::Wgsl => COST_WGSL,
            Language::Glsl450 => COST_GLSL,
            Language::Glsl330 | Language::Essl300 | Language::Rust => {
                return Err(EmitError::NoCost { language: options.language.name() });
            }
        };
        let mut names = Names::new(program, options);
        let count = program.input_components().div_ceil(LOCATION_SIZE);
        let locations = (0..count).map(|location| names.outer.fresh(&format!("varying_{location}"))).collect();
        let target = names.outer.fresh("fragment_color");
        Ok(Self { program, options, template, names, locations, target })
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
        let values = context! { comment, inputs, statements => statements.to_vec(), color, locations, target };
        complete("cost", self.template, values, functions, self.options)
    }
}
