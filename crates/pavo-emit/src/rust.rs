//! What is written in Rust in another way than in the shading languages: functions are methods, a choice is an `if`,
//! the last expression is what a function returns.

mod expression;
mod layout;
mod tree;

use crate::dialect::Dialect;
use crate::literal;
use crate::text::{Struct, field_doc, split_place};
use crate::uniform::padding;
pub use layout::statement;

/// How many parameters clippy takes without a word.
const CLIPPY_PARAMETERS: usize = 7;

/// How wide the fields of a struct may be on one line, as rustfmt has it.
const STRUCT_WIDTH: usize = 18;

/// What the struct of the prepared values is.
const PREPARED_DOC: &str = "\
/// What was prepared for the material. It lies in memory as the struct of this name does in a uniform
/// buffer of WGSL, or of GLSL by std140.
#[repr(C)]
";

/// Constants of `std::f32::consts`: clippy refuses their digits.
const NAMED: [(&str, f32); 17] = {
    use std::f32::consts::*;
    [
        ("PI", PI),
        ("TAU", TAU),
        ("E", E),
        ("FRAC_1_PI", FRAC_1_PI),
        ("FRAC_2_PI", FRAC_2_PI),
        ("FRAC_2_SQRT_PI", FRAC_2_SQRT_PI),
        ("FRAC_PI_2", FRAC_PI_2),
        ("FRAC_PI_3", FRAC_PI_3),
        ("FRAC_PI_4", FRAC_PI_4),
        ("FRAC_PI_6", FRAC_PI_6),
        ("FRAC_PI_8", FRAC_PI_8),
        ("SQRT_2", SQRT_2),
        ("FRAC_1_SQRT_2", FRAC_1_SQRT_2),
        ("LN_2", LN_2),
        ("LN_10", LN_10),
        ("LOG2_E", LOG2_E),
        ("LOG10_E", LOG10_E),
    ]
};

/// A number: by its name where it has one.
pub fn number(value: f64) -> String {
    let sign = if value < 0.0 { "-" } else { "" };
    match NAMED.iter().find(|(_, named)| *named == (value as f32).abs()) {
        Some((name, _)) => format!("{sign}std::f32::consts::{name}"),
        None => literal::number(value),
    }
}

/// A constant vector of this type.
pub fn vector(ty: &str, components: [&str; 3]) -> String {
    match components {
        ["0.0", "0.0", "0.0"] => format!("{ty}::ZERO"),
        ["1.0", "1.0", "1.0"] => format!("{ty}::ONE"),
        [x, y, z] if x == y && y == z => format!("{ty}::splat({x})"),
        [x, y, z] => format!("{ty}::new({x}, {y}, {z})"),
    }
}

/// What stands before a function of so many parameters.
pub fn attributes(parameters: usize) -> String {
    let many = if parameters > CLIPPY_PARAMETERS { "#[allow(clippy::too_many_arguments)]\n" } else { "" };
    many.to_owned()
}

/// A struct. What was prepared lies in memory as it does in a uniform buffer.
pub fn structure(dialect: &Dialect, made: &Struct) -> String {
    let mut text = String::new();
    if made.is_prepared {
        text.push_str(PREPARED_DOC);
    }
    text.push_str("#[derive(Clone, Copy, Debug)]\n");
    text.push_str(&format!("pub struct {} {{\n", made.name));
    let padding = padding_fields(made);
    for (index, (name, ty, doc)) in made.fields.iter().enumerate() {
        text.push_str(&padding_declared(&padding, index));
        text.push_str(&field_doc(dialect, doc));
        text.push_str(&format!("    pub {name}: {},\n", dialect.type_name(*ty)));
    }
    text + &padding_declared(&padding, made.fields.len()) + "}\n"
}

/// What stands unused before the fields, and after the last one: where, under which name, and how many numbers.
fn padding_fields(made: &Struct) -> Vec<(usize, String, usize)> {
    if !made.is_prepared {
        return Vec::new();
    }
    let unused = padding(made).into_iter().enumerate().filter(|(_, numbers)| *numbers > 0);
    unused.zip(1..).map(|((place, numbers), number)| (place, format!("_padding_{number}"), numbers)).collect()
}

fn padding_declared(padding: &[(usize, String, usize)], place: usize) -> String {
    let here = padding.iter().find(|(other, ..)| *other == place);
    here.map_or_else(String::new, |(_, name, numbers)| format!("    pub {name}: [f32; {numbers}],\n"))
}

/// The statements of a function with what it returns: the last expression.
pub fn finished(mut statements: Vec<String>, made: Option<&Struct>, mut results: Vec<String>) -> Vec<String> {
    let Some(made) = made else {
        let value = results.swap_remove(0);
        // A name that is bound to be returned at once is none.
        let bound = |last: &String| {
            let (code, place) = split_place(last);
            let bound = code.strip_prefix(&format!("let {value} = "))?.strip_suffix(';')?;
            Some(format!("{bound}{place}"))
        };
        let last = statements.last().and_then(bound);
        if last.is_some() {
            statements.pop();
        }
        statements.push(last.unwrap_or(value));
        return statements;
    };
    let mut fields: Vec<String> = made
        .fields
        .iter()
        .zip(&results)
        .map(|((name, ..), value)| if name == value { name.clone() } else { format!("{name}: {value}") })
        .collect();
    for (place, name, numbers) in padding_fields(made).into_iter().rev() {
        fields.insert(place, format!("{name}: [0.0; {numbers}]"));
    }
    let short = fields.join(", ");
    if short.len() <= STRUCT_WIDTH {
        statements.push(format!("{} {{ {short} }}", made.name));
        return statements;
    }
    statements.push(format!("{} {{", made.name));
    statements.extend(fields.into_iter().map(|field| format!("    {field},")));
    statements.push("}".to_owned());
    statements
}
