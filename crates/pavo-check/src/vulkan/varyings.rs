//! Reads what a fragment shader takes from the stage before it, and writes a vertex shader that gives it.
//!
//! The numbers are those of the SPIR-V specification (Khronos, version 1.3), as in `module_interface`.

use super::module_interface::{
    FRAGMENT, OP_DECORATE, OP_ENTRY_POINT, OP_VARIABLE, instructions, literal_string, literal_string_words,
};
use crate::CheckError;

const OP_TYPE_INT: u32 = 21;
const OP_TYPE_FLOAT: u32 = 22;
const OP_TYPE_VECTOR: u32 = 23;
const OP_TYPE_POINTER: u32 = 32;
const STORAGE_CLASS_INPUT: u32 = 1;
const DECORATION_BUILT_IN: u32 = 11;
const DECORATION_LOCATION: u32 = 30;
const DECORATION_COMPONENT: u32 = 31;

/// The type of a varying's components, 32 bits wide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scalar {
    Float,
    Signed,
    Unsigned,
}

/// One input of a fragment shader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Varying {
    location: u32,
    scalar: Scalar,
    /// From 1 to 4.
    components: u32,
}

impl Varying {
    /// The type in WGSL.
    fn type_name(self) -> String {
        let scalar = match self.scalar {
            Scalar::Float => "f32",
            Scalar::Signed => "i32",
            Scalar::Unsigned => "u32",
        };
        if self.components == 1 { scalar.to_owned() } else { format!("vec{}<{scalar}>", self.components) }
    }
}

/// The inputs of a fragment entry point that the vertex stage has to give, by ascending location.
pub(super) fn varyings(words: &[u32], entry: &str, most_locations: u32) -> Result<Vec<Varying>, CheckError> {
    let module = Declarations::read(words, entry)?;
    let mut varyings = Vec::new();
    for &(id, pointer_type) in &module.inputs {
        if module.decoration(id, DECORATION_BUILT_IN).is_some() {
            continue;
        }
        let unreadable = |what: &str| Err(CheckError::Input(format!("the fragment entry point `{entry}` {what}")));
        let Some(location) = module.decoration(id, DECORATION_LOCATION) else {
            return unreadable("has an input without a location: blocks of inputs are not read");
        };
        if module.decoration(id, DECORATION_COMPONENT).is_some_and(|component| component > 0) {
            return unreadable("shares a location between inputs, by `component`: use one vector");
        }
        let Some((scalar, components)) = module.pointee(pointer_type).and_then(|ty| module.numbers(ty)) else {
            return unreadable(&format!(
                "has an input at location {location} that is no scalar or vector of 32-bit numbers"
            ));
        };
        if location >= most_locations {
            let what = format!("the number of input locations of `{entry}`");
            return Err(CheckError::Limit { what, asked: u64::from(location) + 1, allowed: u64::from(most_locations) });
        }
        varyings.push(Varying { location, scalar, components });
    }
    varyings.sort_unstable_by_key(|varying| varying.location);
    if let Some(pair) = varyings.windows(2).find(|pair| pair[0].location == pair[1].location) {
        return Err(CheckError::Input(format!(
            "the fragment entry point `{entry}` has two inputs at location {}",
            pair[0].location
        )));
    }
    Ok(varyings)
}

/// A vertex shader in WGSL, with the entry point `main`: one triangle over the whole target with these varyings.
///
/// Each component is a different number at each vertex and different from the other components, so that a compiler
/// that links the stages can neither drop nor merge an input of the fragment shader.
pub(super) fn vertex_text(varyings: &[Varying]) -> String {
    let mut text = "struct Corner {\n    @builtin(position) clip: vec4<f32>,\n".to_owned();
    for varying in varyings {
        let flat = if varying.scalar == Scalar::Float { "" } else { "@interpolate(flat) " };
        let Varying { location, .. } = varying;
        text.push_str(&format!("    @location({location}) {flat}at_{location}_: {},\n", varying.type_name()));
    }
    text.push_str(
        "}

@vertex
fn main(@builtin(vertex_index) index: u32) -> Corner {
    var corner: Corner;
    corner.clip = vec4<f32>(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
",
    );
    let mut number = 1;
    for varying in varyings {
        let mut components = Vec::new();
        for _ in 0..varying.components {
            number += 1;
            components.push(match varying.scalar {
                Scalar::Float => format!("f32(index) * {number}.5"),
                Scalar::Signed => format!("i32(index) * {number}i"),
                Scalar::Unsigned => format!("index * {number}u"),
            });
        }
        let (ty, location) = (varying.type_name(), varying.location);
        text.push_str(&format!("    corner.at_{location}_ = {ty}({});\n", components.join(", ")));
    }
    text.push_str("    return corner;\n}\n");
    text
}

/// What of a module tells the inputs of an entry point.
#[derive(Default)]
struct Declarations {
    /// Variables of the entry point's interface: id and pointer type.
    inputs: Vec<(u32, u32)>,
    /// Id, decoration and its first number.
    decorations: Vec<(u32, u32, u32)>,
    /// Pointer type and the type that it points to.
    pointers: Vec<(u32, u32)>,
    scalars: Vec<(u32, Scalar)>,
    /// Vector type, type of its components and their number.
    vectors: Vec<(u32, u32, u32)>,
}

impl Declarations {
    fn read(words: &[u32], wanted: &str) -> Result<Declarations, CheckError> {
        let mut module = Declarations::default();
        let mut interface: &[u32] = &[];
        for (opcode, operands) in instructions(words)? {
            match (opcode, operands) {
                (OP_ENTRY_POINT, &[FRAGMENT, _, ref name @ ..]) if literal_string(name) == wanted => {
                    interface = name.get(literal_string_words(name)..).unwrap_or_default();
                }
                (OP_DECORATE, &[id, decoration, number, ..]) => module.decorations.push((id, decoration, number)),
                (OP_TYPE_INT, &[id, 32, signed]) => {
                    module.scalars.push((id, if signed == 0 { Scalar::Unsigned } else { Scalar::Signed }));
                }
                (OP_TYPE_FLOAT, &[id, 32]) => module.scalars.push((id, Scalar::Float)),
                (OP_TYPE_VECTOR, &[id, component, count]) => module.vectors.push((id, component, count)),
                (OP_TYPE_POINTER, &[id, STORAGE_CLASS_INPUT, pointee]) => module.pointers.push((id, pointee)),
                (OP_VARIABLE, &[ty, id, STORAGE_CLASS_INPUT, ..]) if interface.contains(&id) => {
                    module.inputs.push((id, ty));
                }
                _ => {}
            }
        }
        Ok(module)
    }

    fn decoration(&self, id: u32, decoration: u32) -> Option<u32> {
        self.decorations.iter().find(|found| (found.0, found.1) == (id, decoration)).map(|found| found.2)
    }

    fn pointee(&self, pointer: u32) -> Option<u32> {
        self.pointers.iter().find(|found| found.0 == pointer).map(|found| found.1)
    }

    /// A scalar or a vector: the type of its components and their number.
    fn numbers(&self, ty: u32) -> Option<(Scalar, u32)> {
        let (scalar, components) = match self.vectors.iter().find(|found| found.0 == ty) {
            Some(&(_, component, count)) => (component, count),
            None => (ty, 1),
        };
        let scalar = self.scalars.iter().find(|found| found.0 == scalar)?.1;
        (1..=4).contains(&components).then_some((scalar, components))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judge::{judge_wgsl, wgsl_to_spirv};
    use crate::{CheckError, Stage};

    fn read(inputs: &str) -> Result<Vec<Varying>, CheckError> {
        let text = format!("@fragment fn shade({inputs}) -> @location(0) vec4<f32> {{ return vec4<f32>(0.0); }}");
        varyings(&wgsl_to_spirv("inputs.wgsl", &text).unwrap(), "shade", 32)
    }

    #[test]
    fn inputs_are_read_and_given_by_a_valid_vertex_shader() {
        let inputs = "@location(2) a: vec3<f32>, @builtin(position) p: vec4<f32>, @location(0) b: f32, \
                      @location(5) @interpolate(flat) c: vec2<u32>, @location(1) @interpolate(flat) d: i32";
        let found = read(inputs).unwrap();
        let varying = |location, scalar, components| Varying { location, scalar, components };
        let expected = [
            varying(0, Scalar::Float, 1),
            varying(1, Scalar::Signed, 1),
            varying(2, Scalar::Float, 3),
            varying(5, Scalar::Unsigned, 2),
        ];
        assert_eq!(found, expected);
        for varyings in [&[][..], &found] {
            judge_wgsl(Some(Stage::Vertex), "vertex.wgsl", &vertex_text(varyings))
                .unwrap_or_else(|error| panic!("{error}"));
        }
    }

    #[test]
    fn more_locations_than_the_device_has_are_refused() {
        let error = read("@location(32) a: f32").unwrap_err();
        assert!(matches!(error, CheckError::Limit { asked: 33, allowed: 32, .. }), "{error:?}");
    }
}
