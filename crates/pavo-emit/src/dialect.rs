//! The table of what differs between the languages.

use crate::{Form, Language};
use pavo_shade::{Type, UnaryOp};

/// How declarations are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Syntax {
    /// `let x = ..`, `fn f(x: f32) -> f32`, `struct S { x: f32, }`.
    Wgsl,
    /// `float x = ..`, `float f(float x)`, `struct S { float x; };`.
    C,
    /// As in C, but structs and tables are filled by braces, a vector is made of three numbers or by a cast, and what is
    /// chosen by component is written out for each.
    Hlsl,
    /// As in HLSL, but truth values are whole numbers, three of them a vector of 0 and 1, and a table is a function:
    /// nothing else may stand outside of one.
    Osl,
    /// `let x = ..`, `pub fn f(x: f32) -> f32`, `pub struct S { pub x: f32, }`, functions called as methods.
    Rust,
}

impl Syntax {
    /// Whether declarations begin with their type.
    pub fn is_like_c(self) -> bool {
        matches!(self, Syntax::C | Syntax::Hlsl | Syntax::Osl)
    }

    /// Whether a struct is filled by braces where it is declared.
    pub fn fills_by_braces(self) -> bool {
        matches!(self, Syntax::Hlsl | Syntax::Osl)
    }
}

/// What a language has of half precision.
#[derive(Debug, PartialEq, Eq)]
pub struct HalfPrecision {
    /// Names of the types: number, vector.
    pub types: [&'static str; 2],
    /// What a literal ends with.
    pub suffix: &'static str,
    /// The line that a text needs before it uses these types; may be empty.
    pub directive: &'static str,
    /// Whether these are types of their own, to which and from which numbers are converted. If not, the operands alone
    /// say how precise an operation is, so that what is rounded needs a variable.
    pub converts: bool,
}

/// A row of the table.
#[derive(Debug)]
pub struct Dialect {
    /// Its name on the command line and in scenes.
    pub name: &'static str,
    /// The ending of a file's name.
    pub extension: &'static str,
    /// How declarations are written.
    pub syntax: Syntax,
    /// The first line of a complete text.
    pub version: &'static str,
    /// What a library needs at its top.
    pub preamble: &'static str,
    /// Names of the types: number, vector, truth value, vector of truth values.
    pub types: [&'static str; 4],
    /// The name of `1 / sqrt(x)`.
    pub inverse_sqrt: &'static str,
    /// The name of what lies between two values.
    pub mix: &'static str,
    /// The type of an index into a table.
    pub index_type: &'static str,
    /// The forms that are printed.
    pub forms: &'static [Form],
    /// Half precision, where the language has it.
    pub half: Option<HalfPrecision>,
    /// What a comment begins with that documents what stands after it.
    pub doc_comment: &'static str,
    /// Its reserved words beyond those that no language here takes for a name, lines with `#` being comments.
    pub reserved: &'static str,
}

const ESSL_PREAMBLE: &str = "\
// Interference needs all 32 bits: at mediump the phase is lost.
precision highp float;
";

static DIALECTS: [(Language, Dialect); 7] = [
    (
        Language::Wgsl,
        Dialect {
            name: "wgsl",
            extension: "wgsl",
            syntax: Syntax::Wgsl,
            version: "",
            preamble: "",
            types: ["f32", "vec3f", "bool", "vec3<bool>"],
            inverse_sqrt: "inverseSqrt",
            mix: "mix",
            index_type: "u32",
            forms: &[Form::Library, Form::Compute, Form::Fragment],
            half: Some(HalfPrecision {
                types: ["f16", "vec3h"],
                suffix: "h",
                directive: "enable f16;\n",
                converts: true,
            }),
            doc_comment: "//",
            reserved: "",
        },
    ),
    (
        Language::Glsl450,
        Dialect {
            name: "glsl450",
            extension: "450.glsl",
            syntax: Syntax::C,
            version: "#version 450",
            preamble: "",
            types: ["float", "vec3", "bool", "bvec3"],
            inverse_sqrt: "inversesqrt",
            mix: "mix",
            index_type: "int",
            forms: &[Form::Library, Form::Compute, Form::Fragment],
            half: Some(HalfPrecision {
                types: ["float16_t", "f16vec3"],
                suffix: "hf",
                directive: "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n",
                converts: true,
            }),
            doc_comment: "//",
            reserved: "",
        },
    ),
    (
        Language::Glsl330,
        Dialect {
            name: "glsl330",
            extension: "330.glsl",
            syntax: Syntax::C,
            version: "#version 330 core",
            preamble: "",
            types: ["float", "vec3", "bool", "bvec3"],
            inverse_sqrt: "inversesqrt",
            mix: "mix",
            index_type: "int",
            forms: &[Form::Library, Form::Fragment],
            half: None,
            doc_comment: "//",
            reserved: "",
        },
    ),
    (
        Language::Essl300,
        Dialect {
            name: "essl300",
            extension: "300es.glsl",
            syntax: Syntax::C,
            version: "#version 300 es",
            preamble: ESSL_PREAMBLE,
            types: ["float", "vec3", "bool", "bvec3"],
            inverse_sqrt: "inversesqrt",
            mix: "mix",
            index_type: "int",
            forms: &[Form::Library, Form::Fragment],
            half: Some(HalfPrecision {
                types: ["mediump float", "mediump vec3"],
                suffix: "",
                directive: "",
                converts: false,
            }),
            doc_comment: "//",
            reserved: "",
        },
    ),
    (
        Language::Hlsl,
        Dialect {
            name: "hlsl",
            extension: "hlsl",
            syntax: Syntax::Hlsl,
            version: "",
            preamble: "",
            types: ["float", "float3", "bool", "bool3"],
            inverse_sqrt: "rsqrt",
            mix: "lerp",
            index_type: "int",
            forms: &[Form::Library, Form::Compute, Form::Fragment],
            half: None,
            doc_comment: "//",
            reserved: include_str!("../data/reserved-hlsl.txt"),
        },
    ),
    (
        Language::Osl,
        Dialect {
            name: "osl",
            extension: "osl",
            syntax: Syntax::Osl,
            version: "",
            preamble: "",
            types: ["float", "vector", "int", "vector"],
            inverse_sqrt: "inversesqrt",
            mix: "mix",
            index_type: "int",
            forms: &[Form::Library],
            half: None,
            doc_comment: "//",
            // Its judge reads it as HLSL.
            reserved: concat!(include_str!("../data/reserved-osl.txt"), include_str!("../data/reserved-hlsl.txt")),
        },
    ),
    (
        Language::Rust,
        Dialect {
            name: "rust",
            extension: "rs",
            syntax: Syntax::Rust,
            version: "",
            preamble: "use glam::Vec3;\n",
            types: ["f32", "Vec3", "bool", "glam::BVec3"],
            // It has none: the printer writes `1.0 / x.sqrt()`.
            inverse_sqrt: "",
            mix: "lerp",
            index_type: "usize",
            forms: &[Form::Library],
            half: None,
            doc_comment: "///",
            reserved: "",
        },
    ),
];

impl Dialect {
    /// The row of a language.
    pub fn of(language: Language) -> &'static Dialect {
        let row = DIALECTS.iter().find(|(name, _)| *name == language);
        &row.expect("each language has its row").1
    }

    /// The name of a type.
    pub fn type_name(&self, ty: Type) -> &'static str {
        match ty {
            Type::Scalar => self.types[0],
            Type::Vec3 => self.types[1],
            Type::Mask => self.types[2],
            Type::Mask3 => self.types[3],
            Type::Results => unreachable!("the results of a call have the name of their struct"),
        }
    }

    /// The name of a type of what is held in half precision or not.
    pub fn type_name_held(&self, ty: Type, in_half: bool) -> &'static str {
        match (&self.half, ty) {
            (Some(half), Type::Scalar) if in_half => half.types[0],
            (Some(half), Type::Vec3) if in_half => half.types[1],
            _ => self.type_name(ty),
        }
    }

    /// The name of a built-in function.
    pub fn function_name(&self, op: UnaryOp) -> &'static str {
        match op {
            UnaryOp::Sqrt => "sqrt",
            UnaryOp::InverseSqrt => self.inverse_sqrt,
            UnaryOp::Sin => "sin",
            UnaryOp::Cos => "cos",
            UnaryOp::Exp => "exp",
            UnaryOp::Abs => "abs",
            UnaryOp::Floor => "floor",
            UnaryOp::Fract if self.syntax == Syntax::Hlsl => "frac",
            UnaryOp::Fract => "fract",
            UnaryOp::Normalize => "normalize",
            UnaryOp::Negate | UnaryOp::Not | UnaryOp::Half => unreachable!("an operator is no function"),
        }
    }

    /// A local variable: its declaration with a value.
    pub fn declare(&self, ty: &str, name: &str, value: &str, mutable: bool) -> String {
        match (self.syntax, mutable) {
            (Syntax::Wgsl | Syntax::Rust, false) => format!("let {name} = {value};"),
            (Syntax::Wgsl, true) => format!("var {name} = {value};"),
            (Syntax::Rust, true) => format!("let mut {name} = {value};"),
            (Syntax::C | Syntax::Hlsl | Syntax::Osl, _) => format!("{ty} {name} = {value};"),
        }
    }

    /// A table as a constant: the lines before and after its rows.
    pub fn table(&self, name: &str, rows: usize) -> [String; 2] {
        let ty = self.type_name(Type::Vec3);
        match self.syntax {
            Syntax::Wgsl => [format!("const {name} = array<{ty}, {rows}>("), ");".to_owned()],
            Syntax::C => [format!("const {ty} {name}[{rows}] = {ty}[{rows}]("), ");".to_owned()],
            Syntax::Hlsl => [format!("static const {ty} {name}[{rows}] = {{"), "};".to_owned()],
            Syntax::Osl => [
                format!("{ty} {name}(int row) {{\n    {ty} rows[{rows}] = {{"),
                "    };\n    return rows[row];\n}".to_owned(),
            ],
            Syntax::Rust => [format!("static {name}: [{ty}; {rows}] = ["), "];".to_owned()],
        }
    }

    /// The name of a table as a constant.
    pub fn table_name(&self, name: &str) -> String {
        if self.syntax == Syntax::Rust { name.to_uppercase() } else { name.to_owned() }
    }

    /// A table as a storage buffer: vectors at steps of four numbers.
    pub fn table_buffer(&self, name: &str, binding: usize) -> String {
        let ty = self.type_name(Type::Vec3);
        match self.syntax {
            Syntax::Wgsl => format!("@group(0) @binding({binding}) var<storage, read> {name}: array<{ty}>;\n"),
            Syntax::C => {
                let block = format!("layout(std430, set = 0, binding = {binding}) readonly buffer {name}_buffer");
                format!("{block} {{\n    {ty} {name}[];\n}};\n")
            }
            // For Vulkan its rows lie at steps of four numbers as well.
            Syntax::Hlsl => format!("StructuredBuffer<{ty}> {name} : register(t{binding});\n"),
            Syntax::Osl | Syntax::Rust => unreachable!("a library has its tables as constants"),
        }
    }

    /// A parameter, or a field of a struct without what ends it.
    pub fn typed(&self, ty: &str, name: &str) -> String {
        match self.syntax {
            Syntax::Wgsl | Syntax::Rust => format!("{name}: {ty}"),
            Syntax::C | Syntax::Hlsl | Syntax::Osl => format!("{ty} {name}"),
        }
    }
}
