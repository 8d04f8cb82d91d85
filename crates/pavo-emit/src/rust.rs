//! What is written in Rust in another way than in the shading languages: functions are methods, a choice is an `if`,
//! the last expression is what a function returns.

mod expression;
mod layout;
mod tree;

use crate::dialect::Dialect;
use crate::literal;
use crate::text::{Struct, field_doc, split_place};
use crate::uniform::padding;
pub use expression::named_operands;
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
const NAMED: [(&str, f64); 19] = {
    use std::f64::consts::*;
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
        ("LOG2_10", LOG2_10),
        ("LOG2_E", LOG2_E),
        ("LOG10_2", LOG10_2),
        ("LOG10_E", LOG10_E),
    ]
};

/// How many characters make clippy take a number for a constant, at least.
const CLIPPY_DIGITS: usize = 4;

/// A number: by its name where it has one.
pub fn number(value: f64) -> String {
    let sign = if value < 0.0 { "-" } else { "" };
    match NAMED.iter().find(|(_, named)| *named as f32 == (value as f32).abs()) {
        Some((name, _)) => format!("{sign}std::f32::consts::{name}"),
        None => literal::number(value),
    }
}

/// Whether a text has a number that clippy takes for a constant, as an index of 3.14.
fn has_near_constant(text: &str) -> bool {
    let is_near = |digits: &str, named: f64| {
        let rounded = format!("{named:.*}", digits.len().saturating_sub(2));
        named.to_string().starts_with(digits) || rounded == digits
    };
    let words =
        text.split(|character: char| !character.is_ascii_alphanumeric() && character != '.' && character != '_');
    let numbers = words.map(|word| word.trim_end_matches("_f32")).filter(|word| {
        word.len() >= CLIPPY_DIGITS && word.contains('.') && word.starts_with(|first: char| first.is_ascii_digit())
    });
    numbers.into_iter().any(|digits| NAMED.iter().any(|(_, named)| is_near(digits, *named)))
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

/// What stands before a function of so many parameters, or before a table, with this text in it.
pub fn attributes(parameters: usize, text: &str) -> String {
    let mut attributes = String::new();
    if has_near_constant(text) {
        attributes.push_str("#[allow(clippy::approx_constant)]\n");
    }
    if has_clamp(text) {
        attributes.push_str("#[allow(clippy::manual_clamp)]\n");
    }
    if parameters > CLIPPY_PARAMETERS {
        attributes.push_str("#[allow(clippy::too_many_arguments)]\n");
    }
    attributes
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

/// Whether a number is held between two others: what is no number passes through `clamp`, and not through this.
fn has_clamp(text: &str) -> bool {
    let follows = |first: &str, second: &str| {
        let after = text.split(first).skip(1).filter_map(|rest| rest.split_once(')'));
        after.into_iter().any(|(bound, rest)| bound.parse::<f64>().is_ok() && rest.trim_start().starts_with(second))
    };
    follows(".max(", ".min(") || follows(".min(", ".max(")
}

#[cfg(test)]
mod tests {
    use super::{attributes, number};
    use std::f64::consts::{FRAC_1_PI, PI};

    #[test]
    fn constants_have_names_and_what_is_near_them_is_allowed() {
        assert_eq!(number(PI), "std::f32::consts::PI");
        assert_eq!(number(-FRAC_1_PI), "-std::f32::consts::FRAC_1_PI");
        assert_eq!(number(3.25), "3.25");
        for (text, is_near) in [("x * 3.14", true), ("(-2.718_f32).max(x)", true), ("0.5 + x_2 * 3.1", false)] {
            assert_eq!(attributes(1, text).contains("approx_constant"), is_near, "{text}");
        }
    }

    #[test]
    fn what_is_held_between_two_numbers_is_allowed() {
        let rows = [("x.max(0.1).min(5.0)", true), ("x.min(2.0)\n    .max(1e-3)", true), ("x.max(y).min(5.0)", false)];
        for (text, is_held) in rows {
            assert_eq!(attributes(1, text).contains("manual_clamp"), is_held, "{text}");
        }
    }
}
