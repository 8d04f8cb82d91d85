//! What is written in Rust in another way than in the shading languages: functions are methods, a choice is an `if`,
//! the last expression is what a function returns.

use crate::dialect::{Dialect, Syntax};
use crate::expression::{Binding, Expressions};
use crate::function::Local;
use crate::literal;
use crate::text::{PrintedTable, Struct, field_doc};
use crate::uniform::padding;
use pavo_shade::{BinaryOp, Comparison, Definition, Node, Op, Type, UnaryOp, operands};

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
        let bound = statements.last().and_then(|last| last.strip_prefix(&format!("let {value} = "))?.strip_suffix(';'));
        let last = bound.map(str::to_owned);
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

impl Dialect {
    /// The operands of a node, as often as its text names them.
    pub fn named_operands(&self, definition: &Definition, node: &Node) -> Vec<u32> {
        match node.op {
            Op::Mix(a, b, part) if self.syntax == Syntax::Rust => match scalar_part(definition, part) {
                Some(number) => vec![a, b, number],
                None => vec![a, b, part, part],
            },
            op => operands(op).collect(),
        }
    }
}

/// The number that a vector has in each component, as the part of `Vec3::lerp`.
fn scalar_part(definition: &Definition, part: u32) -> Option<u32> {
    match definition.nodes[part as usize].op {
        Op::Splat(number) => Some(number),
        _ => None,
    }
}

impl Expressions<'_> {
    /// The text of a node where Rust writes it in another way than the others.
    pub(crate) fn in_rust(&self, node: &Node) -> Option<(String, Binding)> {
        let is_vector = node.ty == Type::Vec3;
        let written = match node.op {
            Op::Unary(UnaryOp::Negate | UnaryOp::Not, _) => return None,
            Op::Unary(UnaryOp::InverseSqrt, x) => {
                let root = if is_vector { "map(f32::sqrt)" } else { "sqrt()" };
                (format!("1.0 / {}.{root}", self.receiver(x)), Binding::Product)
            }
            Op::Unary(op, x) => (format!("{}.{}", self.receiver(x), method(op, is_vector)), Binding::Primary),
            Op::Binary(BinaryOp::Min, a, b) => self.method("min", a, &[b]),
            Op::Binary(BinaryOp::Max, a, b) => self.method("max", a, &[b]),
            Op::Binary(BinaryOp::Dot, a, b) => self.method("dot", a, &[b]),
            Op::Compare(Comparison::Less, a, b) if node.ty == Type::Mask3 => self.method("cmplt", a, &[b]),
            Op::Select(condition, a, b) => self.choice(condition, a, b),
            Op::Clamp(x, low, high) if self.is_literal(low) && self.is_literal(high) => {
                self.method("clamp", x, &[low, high])
            }
            // The method of f32 panics where the ends are not in order.
            Op::Clamp(x, low, high) => {
                let text = format!("{}.max({}).min({})", self.receiver(x), self.whole(low), self.whole(high));
                (text, Binding::Primary)
            }
            Op::Mix(a, b, part) => self.mix(a, b, part),
            Op::Vec3(x, y, z) => {
                let [x, y, z] = [x, y, z].map(|index| self.whole(index));
                (format!("Vec3::new({x}, {y}, {z})"), Binding::Primary)
            }
            Op::Splat(x) => (format!("Vec3::splat({})", self.whole(x)), Binding::Primary),
            Op::Fetch(table, row) => {
                // An index beyond the last row would panic.
                let PrintedTable { name, rows } = &self.tables[table as usize];
                let row = self.at_least(row, Binding::Primary);
                (format!("{name}[({row} as usize).min({})]", rows.saturating_sub(1)), Binding::Primary)
            }
            _ => return None,
        };
        Some(written)
    }

    /// What stands before a point; a number there has to say its type.
    fn receiver(&self, index: u32) -> String {
        match (&self.locals[index as usize], self.definition.nodes[index as usize].op) {
            (Local::Written, Op::Literal(bits)) if f64::from_bits(bits) < 0.0 => {
                format!("({}_f32)", self.whole(index))
            }
            (Local::Written, Op::Literal(_)) => format!("{}_f32", self.whole(index)),
            _ => self.at_least(index, Binding::Primary),
        }
    }

    fn method(&self, name: &str, x: u32, others: &[u32]) -> (String, Binding) {
        let others: Vec<String> = others.iter().map(|&other| self.whole(other)).collect();
        (format!("{}.{name}({})", self.receiver(x), others.join(", ")), Binding::Primary)
    }

    fn is_literal(&self, index: u32) -> bool {
        matches!(self.definition.nodes[index as usize].op, Op::Literal(_) | Op::Literal3(_))
    }

    /// Whether a number is written as literals alone.
    fn has_no_type(&self, index: u32) -> bool {
        match (&self.locals[index as usize], self.definition.nodes[index as usize].op) {
            (Local::Written, Op::Literal(_)) => true,
            (Local::Written, Op::Select(_, a, b)) => self.has_no_type(a) && self.has_no_type(b),
            _ => false,
        }
    }

    fn choice(&self, condition: u32, a: u32, b: u32) -> (String, Binding) {
        if self.definition.nodes[condition as usize].ty == Type::Mask3 {
            let [condition, a, b] = [condition, a, b].map(|index| self.whole(index));
            return (format!("Vec3::select({condition}, {a}, {b})"), Binding::Primary);
        }
        // Of two numbers one has to say its type, for methods of what is chosen.
        let a = if self.has_no_type(b) { self.receiver(a) } else { self.whole(a) };
        let (condition, b) = (self.whole(condition), self.whole(b));
        let otherwise = if b.starts_with("if ") { b } else { format!("{{ {b} }}") };
        (format!("if {condition} {{ {a} }} else {otherwise}"), Binding::Choice)
    }

    fn mix(&self, a: u32, b: u32, part: u32) -> (String, Binding) {
        if let Some(number) = scalar_part(self.definition, part) {
            let (b, number) = (self.whole(b), self.whole(number));
            return (format!("{}.lerp({b}, {number})", self.receiver(a)), Binding::Primary);
        }
        let [a, b] = [a, b].map(|index| self.at_least(index, Binding::Product));
        let factor = self.at_least(part, Binding::Product.tighter());
        let rest = format!("(1.0 - {})", self.at_least(part, Binding::Product));
        (format!("{a} * {rest} + {b} * {factor}"), Binding::Sum)
    }
}

/// The call of a method without operands.
fn method(op: UnaryOp, is_vector: bool) -> &'static str {
    match (op, is_vector) {
        (UnaryOp::Sqrt, false) => "sqrt()",
        (UnaryOp::Sqrt, true) => "map(f32::sqrt)",
        (UnaryOp::Sin, false) => "sin()",
        (UnaryOp::Sin, true) => "map(f32::sin)",
        (UnaryOp::Cos, false) => "cos()",
        (UnaryOp::Cos, true) => "map(f32::cos)",
        (UnaryOp::Exp, _) => "exp()",
        (UnaryOp::Abs, _) => "abs()",
        (UnaryOp::Floor, _) => "floor()",
        // The method `fract` of Rust cuts towards zero.
        (UnaryOp::Fract, false) => "rem_euclid(1.0)",
        (UnaryOp::Fract, true) => "fract_gl()",
        (UnaryOp::Normalize, _) => "normalize()",
        (UnaryOp::InverseSqrt | UnaryOp::Negate | UnaryOp::Not, _) => unreachable!("they are no methods"),
    }
}
