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
/// The template has `header`, `functions`, `inputs`, the names of what the program takes, `body`, the lines that take it
/// and compute, and `result`, the expression of the program's first output.
#[derive(Clone, Copy, Debug)]
pub struct Wrapper<'a> {
    /// The name of the template, for messages.
    pub name: &'a str,
    /// The text of the template.
    pub template: &'a str,
    /// The expression that each input of the program is given, in the order of the inputs. It is held within the range
    /// of the input.
    pub given: &'a [String],
    /// The parameters of the signature: no variable takes such a name.
    pub parameters: &'a [&'a str],
}

pub fn wrapped(program: &Program, options: &Options, wrapper: &Wrapper<'_>) -> Result<String, EmitError> {
    let dialect = Dialect::of(options.language);
    let mut names = Names::new(program, options);
    let functions = functions(program, options, &names, Tables::Constants);
    for parameter in wrapper.parameters {
        names.outer.fresh(parameter);
    }
    let main = main_body(program, options, &names);
    let inputs: Vec<String> = program.inputs().iter().map(|input| input.name.clone()).collect();
    let taken = program.inputs().iter().zip(&main.parameters).zip(wrapper.given).map(|((input, name), given)| {
        let declared = match dialect.syntax {
            Syntax::Wgsl | Syntax::Rust => format!("let {name}"),
            _ => format!("{} {name}", dialect.type_name(input.ty)),
        };
        format!("{declared} = {};", held(dialect, input, given))
    });
    let body: Vec<String> =
        taken.chain(main.statements.iter().cloned()).map(|statement| format!("    {statement}")).collect();
    let values = context! {
        header => header(options).trim_end(),
        functions => functions.trim(),
        inputs,
        body => body.join("\n"),
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
