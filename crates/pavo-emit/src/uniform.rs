//! What is uniform over a material, as a struct of a uniform buffer: in the shading languages, and in Rust with the same
//! layout.
//!
//! WGSL and std140 agree on it for numbers and vectors of three: a vector begins at a multiple of 16 bytes. std140 has
//! the whole end at such, WGSL only where there is a vector; here it always does.

use crate::Options;
use crate::comment::{Paragraph, doc_comment};
use crate::dialect::{Dialect, Syntax};
use crate::rust;
use crate::text::{Names, Struct, struct_name, structure};
use pavo_shade::{Input, Program, Rate, Type};
use std::fmt::Write as _;

/// How many numbers are as long as a vector is aligned.
const ALIGNMENT: usize = 4;

/// How many bytes a number has.
const NUMBER: usize = 4;

/// The name of the struct, after the prefix.
const UNIFORMS: &str = "SurfaceUniforms";

/// How many numbers stand unused before each field, and after the last one.
pub fn padding(made: &Struct) -> Vec<usize> {
    let mut place: usize = 0;
    let mut padding = Vec::new();
    for (_, ty, _) in &made.fields {
        let begin = begin(*ty, place);
        padding.push(begin - place);
        place = begin + numbers(*ty);
    }
    padding.push(place.next_multiple_of(ALIGNMENT) - place);
    padding
}

/// Where a field begins if so many numbers are before it.
fn begin(ty: Type, place: usize) -> usize {
    if ty == Type::Vec3 { place.next_multiple_of(ALIGNMENT) } else { place }
}

fn numbers(ty: Type) -> usize {
    if ty == Type::Vec3 { 3 } else { 1 }
}

/// The struct of a program's inputs that are uniform over a material, in the order of the inputs; nothing where there
/// are none. In Rust it has a constructor, and the bytes of the buffer. There is none in HLSL, whose constant buffers pack
/// otherwise, and in OSL, which has no buffers.
pub fn uniforms(program: &Program, options: &Options) -> Option<String> {
    let dialect = Dialect::of(options.language);
    let mut names = Names::new(program, options);
    let uniform: Vec<&Input> = program.inputs().iter().filter(|input| input.rate == Rate::Material).collect();
    if uniform.is_empty() || matches!(dialect.syntax, Syntax::Hlsl | Syntax::Osl) {
        return None;
    }
    let fields = uniform.iter().map(|input| (input.name.clone(), input.ty, described(input))).collect();
    let name = names.outer.fresh(&struct_name(&options.prefix, UNIFORMS));
    let made = Struct { name, fields, is_prepared: false };
    if dialect.syntax == Syntax::Rust {
        return Some(in_rust(&made));
    }
    let doc = ["What is uniform over a material, in the order of a uniform buffer (std140 where there is a choice)."
        .to_owned()];
    Some(doc_comment(dialect, &Paragraph::of_doc(dialect, &doc)) + &structure(dialect, &made))
}

/// The range of an input, as the comment on its field.
fn described(input: &Input) -> String {
    let unit = if input.unit.is_empty() { String::new() } else { format!(" {}", input.unit) };
    format!("Within [{}, {}]{unit}.", input.low, input.high)
}

fn rust_type(ty: Type) -> &'static str {
    if ty == Type::Vec3 { "[f32; 3]" } else { "f32" }
}

fn in_rust(made: &Struct) -> String {
    let padding = padding(made);
    let mut fields = String::new();
    let mut values = String::new();
    for (index, unused) in padding.iter().enumerate() {
        if *unused > 0 {
            let _ = writeln!(fields, "    _padding_{index}: [f32; {unused}],");
            let _ = writeln!(values, "            _padding_{index}: [0.0; {unused}],");
        }
        if let Some((name, ty, doc)) = made.fields.get(index) {
            let _ = writeln!(fields, "    /// {doc}\n    pub {name}: {},", rust_type(*ty));
            let _ = writeln!(values, "            {name},");
        }
    }
    let parameters: Vec<String> =
        made.fields.iter().map(|(name, ty, _)| format!("{name}: {}", rust_type(*ty))).collect();
    format!(
        "/// What is uniform over a material. It lies in memory as the struct of this name does in a uniform buffer of\n\
         /// WGSL, or of GLSL by std140.\n\
         #[repr(C)]\n#[derive(Clone, Copy, Debug, PartialEq)]\npub struct {name} {{\n{fields}}}\n\n\
         impl {name} {{\n    /// The uniforms of these values.\n{attributes}    \
         pub fn new({parameters}) -> Self {{\n        Self {{\n{values}        }}\n    }}\n\n{bytes}}}\n",
        name = made.name,
        attributes = crate::text::indent(&rust::attributes(parameters.len(), "")),
        parameters = parameters.join(", "),
        bytes = to_bytes(made, |name, component| format!(
            "self.{name}{}",
            component.map_or(String::new(), |at| format!("[{at}]"))
        )),
    )
}

/// The bytes of what a program prepares for a material, as a method of its struct in Rust; nothing where it prepares
/// nothing.
pub fn prepared_bytes(program: &Program, options: &Options) -> Option<String> {
    let names = Names::new(program, options);
    let made = names.structs.iter().flatten().find(|made| made.is_prepared)?;
    let field = |name: &str, component: Option<usize>| match component {
        Some(at) => format!("self.{name}.{}", ["x", "y", "z"][at]),
        None => format!("self.{name}"),
    };
    Some(format!("impl {} {{\n{}}}\n", made.name, to_bytes(made, field)))
}

/// A method that gives the bytes of the buffer. `field` is the expression of a field, or of a component of it.
fn to_bytes(made: &Struct, field: impl Fn(&str, Option<usize>) -> String) -> String {
    let mut place = 0;
    let mut copies = String::new();
    for (name, ty, _) in &made.fields {
        place = begin(*ty, place);
        for component in 0..numbers(*ty) {
            let value = field(name, (*ty == Type::Vec3).then_some(component));
            let (first, last) = (place * NUMBER, (place + 1) * NUMBER);
            let _ = writeln!(copies, "        bytes[{first}..{last}].copy_from_slice(&{value}.to_le_bytes());");
            place += 1;
        }
    }
    let length = place.next_multiple_of(ALIGNMENT) * NUMBER;
    format!(
        "    /// The bytes of the uniform buffer, little-endian.\n    pub fn to_bytes(&self) -> [u8; {length}] {{\n        \
         let mut bytes = [0; {length}];\n{copies}        bytes\n    }}\n"
    )
}

#[cfg(test)]
mod tests {
    use super::padding;
    use crate::text::Struct;
    use pavo_shade::Type::{Scalar, Vec3};

    #[test]
    fn vectors_begin_at_multiples_of_16_bytes_and_so_does_what_follows_the_whole() {
        for (types, expected) in [
            (&[Scalar, Scalar][..], &[0, 0, 2][..]),
            (&[Vec3, Scalar, Scalar, Vec3], &[0, 0, 0, 3, 1]),
            (&[Vec3, Vec3], &[0, 1, 1]),
            (&[Scalar, Scalar, Scalar, Scalar], &[0, 0, 0, 0, 0]),
        ] {
            let fields = types.iter().map(|&ty| ("x".to_owned(), ty, String::new())).collect();
            let made = Struct { name: "Prepared".to_owned(), fields, is_prepared: true };
            assert_eq!(padding(&made), expected);
        }
    }
}
