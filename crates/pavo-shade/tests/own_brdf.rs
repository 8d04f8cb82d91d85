//! A worked example: a BRDF of one's own, Lambert's diffuse reflection under Phong's highlight, from the formula to
//! numbers and to a graph with its inputs.

use pavo_shade::{Expr, Graph, Input, Program, Rate, Real, Scalar, Type, Vector, interpret, shade};

/// The material.
#[shade]
struct Plastic<S: Scalar> {
    /// Diffuse colour, linear, [0, 1].
    diffuse: S::Vec3,
    /// Share of light in the highlight, [0, 1].
    highlight: S,
}

/// Phong's highlight, normalised to reflect what falls on it at normal incidence.
///
/// Source: Phong 1975; the factor is Lafortune and Willems 1994, equation 7.
#[shade]
fn phong<R: Real>(
    /// Exponent, a whole number.
    #[constant]
    exponent: u32,
    /// Cosine of the angle between mirror direction and view, [-1, 1].
    cos_alpha: R,
) -> R {
    cos_alpha.max(0.0).powi(exponent) * R::lit((f64::from(exponent) + 2.0) / (2.0 * core::f64::consts::PI))
}

/// Radiance of a plastic under a light of radiance pi, the diffuse part being what the highlight leaves.
///
/// Source: the reflection equation for one direction.
#[shade]
fn lambert_phong<S: Scalar>(
    /// Surface normal, length 1.
    normal: S::Vec3,
    /// Direction to the light, length 1.
    light_direction: S::Vec3,
    /// Direction to the view, length 1.
    view_direction: S::Vec3,
    /// The material.
    plastic: Plastic<S>,
) -> S::Vec3 {
    let Plastic { diffuse, highlight } = plastic;
    let n_dot_l = normal.dot(light_direction).clamp(0.0, 1.0);
    let mirrored = normal * (2.0 * normal.dot(light_direction)) - light_direction;
    let lobe = phong(16, mirrored.dot(view_direction));
    let matte = diffuse * ((1.0 - highlight) * core::f64::consts::FRAC_1_PI);
    (matte + S::Vec3::splat(highlight * lobe)) * (core::f64::consts::PI * n_dot_l)
}

/// The same formula in the plainest Rust, for one channel.
fn by_hand(normal: [f64; 3], light: [f64; 3], view: [f64; 3], diffuse: f64, highlight: f64) -> f64 {
    use std::f64::consts::PI;
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let n_dot_l = dot(normal, light);
    let mirrored: [f64; 3] = core::array::from_fn(|axis| 2.0 * n_dot_l * normal[axis] - light[axis]);
    let lobe = 18.0 / (2.0 * PI) * dot(mirrored, view).max(0.0).powf(16.0);
    (diffuse * (1.0 - highlight) / PI + highlight * lobe) * PI * n_dot_l.clamp(0.0, 1.0)
}

/// Normal, light, view, colour, highlight.
type Point = ([f64; 3], [f64; 3], [f64; 3], [f64; 3], f64);

const POINTS: [Point; 4] = [
    ([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.5, 0.25, 1.0], 0.04),
    ([0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.6, 0.0, 0.8], [0.1, 0.2, 0.3], 0.5),
    ([0.0, 0.6, 0.8], [0.0, 0.0, 1.0], [0.0, 0.8, 0.6], [0.9, 0.0, 0.4], 1.0),
    ([0.0, 0.0, 1.0], [0.0, 0.6, -0.8], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0], 0.3),
];

#[test]
fn it_runs_on_f64() {
    for (normal, light, view, diffuse, highlight) in POINTS {
        let plastic = Plastic { diffuse: diffuse.into(), highlight };
        let found = lambert_phong::<f64>(normal.into(), light.into(), view.into(), plastic).to_array();
        for (found, diffuse) in found.into_iter().zip(diffuse) {
            let expected = by_hand(normal, light, view, diffuse, highlight);
            assert!((found - expected).abs() <= 1e-14, "{found} instead of {expected}");
        }
    }
}

#[test]
fn it_runs_on_f32() {
    let vector = |vector: [f64; 3]| glam::DVec3::from(vector).as_vec3();
    for (normal, light, view, diffuse, highlight) in POINTS {
        let plastic = Plastic { diffuse: vector(diffuse), highlight: highlight as f32 };
        let found = lambert_phong::<f32>(vector(normal), vector(light), vector(view), plastic).to_array();
        for (found, diffuse) in found.into_iter().zip(diffuse) {
            let expected = by_hand(normal, light, view, diffuse, highlight);
            let allowed = 4e-6 * expected.abs().max(1.0);
            assert!((f64::from(found) - expected).abs() <= allowed, "{found} instead of {expected}");
        }
    }
}

/// A direction at each pixel.
fn direction(name: &str) -> Input {
    Input { name: name.to_owned(), ty: Type::Vec3, unit: String::new(), low: -1.0, high: 1.0, rate: Rate::Pixel }
}

/// The BRDF as a program.
fn program() -> Program {
    let graph = Graph::new();
    let [normal, light, view] =
        ["normal", "light_direction", "view_direction"].map(|name| graph.input(direction(name)));
    let diffuse = graph.input(Input::colour("diffuse", Rate::Material));
    let highlight = graph.input(Input::scalar("highlight", "1", 0.0, 1.0, Rate::Vertex));
    let plastic = Plastic { diffuse, highlight };
    graph.output("radiance", lambert_phong::<Expr<'_>>(normal, light, view, plastic));
    graph.program()
}

#[test]
fn as_a_graph_it_computes_the_same() {
    let program = program();
    for (normal, light, view, diffuse, highlight) in POINTS {
        let point = [&normal[..], &light, &view, &diffuse, &[highlight]].concat();
        let plastic = Plastic { diffuse: diffuse.into(), highlight };
        let native = lambert_phong::<f64>(normal.into(), light.into(), view.into(), plastic);
        assert_eq!(interpret::evaluate(&program, &point), [native.to_array()]);
    }
}

#[test]
fn its_inputs_have_names_units_ranges_and_rates() {
    let program = program();
    let expected = [
        direction("normal"),
        direction("light_direction"),
        direction("view_direction"),
        Input {
            name: "diffuse".to_owned(),
            ty: Type::Vec3,
            unit: String::new(),
            low: 0.0,
            high: 1.0,
            rate: Rate::Material,
        },
        Input {
            name: "highlight".to_owned(),
            ty: Type::Scalar,
            unit: "1".to_owned(),
            low: 0.0,
            high: 1.0,
            rate: Rate::Vertex,
        },
    ];
    assert_eq!(program.inputs(), expected);
    assert_eq!(program.input_components(), 13);
    assert_eq!(
        program.inputs().iter().map(|input| input.rate.name()).collect::<Vec<_>>()[2..],
        ["pixel", "material", "vertex"]
    );
}

#[test]
fn its_functions_keep_their_names_documentation_and_parameters() {
    let program = program();
    let names: Vec<&str> = program.functions().iter().map(|function| function.name.as_str()).collect();
    assert_eq!(names, ["phong", "lambert_phong"]);
    let [phong, lambert_phong] = program.functions() else { panic!("two functions") };
    assert_eq!(phong.doc[0], "Phong's highlight, normalised to reflect what falls on it at normal incidence.");
    assert_eq!(phong.parameters[0].doc, "Cosine of the angle between mirror direction and view, [-1, 1].");
    let parameters: Vec<&str> = lambert_phong.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    assert_eq!(parameters, ["normal", "light_direction", "view_direction", "plastic_diffuse", "plastic_highlight"]);
    assert_eq!(program.outputs()[0].name, "radiance");
    assert_eq!(program.outputs()[0].ty, Type::Vec3);
}
