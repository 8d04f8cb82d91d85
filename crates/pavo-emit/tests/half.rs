//! What is held in half precision, as each language writes it.

use pavo_emit::{Language, Options, emit_library};
use pavo_shade::{Expr, Graph, Input, Rate, Real, Scalar, Vector, shade};

/// Two weighted numbers.
#[shade]
fn blend<S: Scalar>(
    /// The first.
    a: S,
    /// The second.
    b: S,
) -> S::Vec3 {
    let color = (S::Vec3::lit3([0.5, 0.25, 0.1]).half() * a.half()).half();
    let color = (color - (S::Vec3::lit3([0.1, 0.2, 0.3]).half() * (a * b).half()).half()).half();
    color
}

fn text(language: Language) -> String {
    let graph = Graph::new();
    let [a, b] = ["a", "b"].map(|name| graph.input(Input::scalar(name, "", 0.0, 1.0, Rate::Pixel)));
    graph.output("color", blend::<Expr<'_>>(a, b).as_vec3());
    let options = Options { language, header: Vec::new(), prefix: String::new(), source_lines: false };
    emit_library(&graph.program(), &options)
}

/// Language, and the lines of its text without comments and those around the statements.
const EXPECTED: [(Language, &[&str]); 5] = [
    (
        Language::Wgsl,
        &[
            "enable f16;",
            "var color = vec3h(0.5h, 0.25h, 0.099975586h) * f16(a);",
            "color -= vec3h(0.099975586h, 0.19995117h, 0.30004883h) * f16(a * b);",
            "return vec3f(color);",
        ],
    ),
    (
        Language::Glsl450,
        &[
            "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require",
            "f16vec3 color = f16vec3(0.5hf, 0.25hf, 0.099975586hf) * float16_t(a);",
            "color -= f16vec3(0.099975586hf, 0.19995117hf, 0.30004883hf) * float16_t(a * b);",
            "return vec3(color);",
        ],
    ),
    (
        Language::Glsl330,
        &[
            "vec3 color = vec3(0.5, 0.25, 0.099975586) * a;",
            "color -= vec3(0.099975586, 0.19995117, 0.30004883) * (a * b);",
            "return color;",
        ],
    ),
    (
        Language::Essl300,
        &[
            "mediump float rounded_a = a;",
            "mediump vec3 color = vec3(0.5, 0.25, 0.099975586) * rounded_a;",
            "mediump float rounded = a * b;",
            "color -= vec3(0.099975586, 0.19995117, 0.30004883) * rounded;",
            "return color;",
        ],
    ),
    (
        Language::Rust,
        &[
            "let mut color = Vec3::new(0.5, 0.25, 0.099975586) * a;",
            "color -= Vec3::new(0.099975586, 0.19995117, 0.30004883) * (a * b);",
            "color",
        ],
    ),
];

#[test]
fn each_language_writes_half_precision_in_its_own_way() {
    for (language, expected) in EXPECTED {
        let text = text(language);
        for line in expected {
            let is_there = text.lines().any(|written| written.trim() == *line);
            assert!(is_there, "{}: no line {line:?} in\n{text}", language.name());
        }
        let has_half = text.contains("16") || text.contains("mediump");
        let is_without = matches!(language, Language::Glsl330 | Language::Rust);
        assert_eq!(has_half, !is_without, "{}:\n{text}", language.name());
    }
}
