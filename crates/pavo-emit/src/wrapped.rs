//! The functions of a program behind a signature of somebody else's.

use crate::dialect::{Dialect, Syntax};
use crate::entry::main_body;
use crate::expression::vector;
use crate::literal::number;
use crate::text::{Names, Tables, functions, header};
use crate::{EmitError, Options};
use minijinja::{Environment, context};
use pavo_shade::{Input, Program, Type};

/// What stands around the functions.
///
/// The template has `header`, `functions`, `inputs` (each with `name`, `declared`, its name with its type, and `value`),
/// `statements` and `result`, the expression of the program's first output.
#[derive(Clone, Copy, Debug)]
pub struct Wrapper<'a> {
    /// The name of the template, for messages.
    pub name: &'a str,
    /// The text of the template.
    pub template: &'a str,
    /// The expression that each input of the program is given, in the order of the inputs. It is held within the range
    /// of the input.
    pub given: &'a [String],
}

pub fn wrapped(program: &Program, options: &Options, wrapper: &Wrapper<'_>) -> Result<String, EmitError> {
    let dialect = Dialect::of(options.language);
    let names = Names::new(program, options);
    let main = main_body(program, options, &names);
    let inputs: Vec<minijinja::Value> = program
        .inputs()
        .iter()
        .zip(&main.parameters)
        .zip(wrapper.given)
        .map(|((input, name), given)| {
            let declared = match dialect.syntax {
                Syntax::Wgsl | Syntax::Rust => format!("let {name}"),
                _ => format!("{} {name}", dialect.type_name(input.ty)),
            };
            context! { name, declared, value => held(dialect, input, given) }
        })
        .collect();
    let values = context! {
        header => header(options).trim_end(),
        functions => functions(program, options, &names, Tables::Constants).trim(),
        inputs,
        statements => main.statements,
        result => main.results.first(),
    };
    let mut environment = Environment::new();
    environment.set_undefined_behavior(minijinja::UndefinedBehavior::Strict);
    environment
        .render_str(wrapper.template, values)
        .map(|text| text.trim_end().to_owned() + "\n")
        .map_err(|error| EmitError::Wrapper { name: wrapper.name.to_owned(), message: format!("{error:#}") })
}

/// An expression held within the range of its input: guards are left out for what lies outside.
fn held(dialect: &Dialect, input: &Input, given: &str) -> String {
    let bound = |value: f64| match input.ty {
        Type::Vec3 => vector(dialect, [value; 3]),
        _ => number(value),
    };
    format!("clamp({given}, {}, {})", bound(input.low), bound(input.high))
}
