//! Emitted Rust compiles without a warning, and computes on the CPU what the functions that it was made of compute.

#[path = "rust/project.rs"]
mod project;
#[path = "rust/signature.rs"]
mod signature;

use pavo::points::spread;
use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity, Variant, library};
use pavo_emit::Language;
use pavo_shade::{Input, PREPARED_SURFACE, Program, Type, interpret};
use pavo_tests::{SCENES, scene_file, starter};
use project::{Evaluation, Project, difference};
use signature::{Module, layout};
use std::path::Path;

/// To the graph in single precision: the same operations, but for the last bit of sines and exponentials. Over the
/// larger of 1 and the value.
const LARGEST_TO_GRAPH: f64 = 2e-6;
/// To the source in single precision, which rounds the constants that the graph folds in double precision.
const LARGEST_TO_SOURCE: f64 = 1e-5;
const POINTS: usize = 2_000;

/// Variants beside the scenes' own.
const VARIANTS: [(&str, &str); 10] = [
    ("soap-bubble", "windowed:k=6"),
    ("anodised-titanium", "poles:k=5"),
    ("beetle-shell", "windowed:k=6"),
    ("beetle-shell", "poles:k=5"),
    ("beetle-shell", "cosines:k=6,m=1"),
    ("lacquered-gold", "spectral:n=16"),
    ("rutile-on-titanium", "windowed:k=6,groups=2"),
    ("coated-lens", "series:m=3,fit=exact"),
    ("soap-bubble", "table:32x64"),
    ("coated-lens", "baked:degree=8,denominator=0"),
];

fn shading(name: &str, variant: &str, is_prepared: bool) -> Shading {
    let mut scene = Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    scene.emit.prepare = is_prepared;
    let variant: Variant = variant.parse().unwrap_or_else(|error| panic!("{variant}: {error}"));
    Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{name} {variant}: {error}"))
}

/// Points over the inputs; directions have length 1.
fn points(inputs: &[Input]) -> Vec<Vec<f32>> {
    let mut inputs = inputs.to_vec();
    inputs.iter_mut().filter(|input| input.name == "cos_theta1").for_each(|input| input.low = 0.05);
    let mut points = spread(&inputs, POINTS, 4);
    for point in &mut points {
        let mut first = 0;
        for input in &inputs {
            if input.ty == Type::Vec3 && input.low < 0.0 {
                let direction = &mut point[first..first + 3];
                let length = direction.iter().map(|number| number * number).sum::<f64>().sqrt();
                direction.iter_mut().for_each(|number| *number /= length);
            }
            first += input.components();
        }
    }
    points.into_iter().map(|point| point.into_iter().map(|number| number as f32).collect()).collect()
}

const QUANTITIES: [(ShadingQuantity, &str); 3] = [
    (ShadingQuantity::Reflectance, "surface_reflectance"),
    (ShadingQuantity::Brdf, "surface_brdf"),
    (ShadingQuantity::Directions, "shade_surface"),
];

/// A surface in one part and in two.
struct Case {
    whole: Shading,
    prepared: Shading,
}

fn cases() -> Vec<Case> {
    let own = SCENES.iter().map(|name| (*name, starter(name).variant().to_string()));
    let others = VARIANTS.iter().map(|(name, variant)| (*name, (*variant).to_owned()));
    own.chain(others)
        .map(|(name, variant)| Case { whole: shading(name, &variant, false), prepared: shading(name, &variant, true) })
        .chain([of_three_parts()])
        .collect()
}

/// A surface with inputs of each rate, that may be denser or thinner than what is in front of it.
const THREE_PARTS: &str = r#"
name = "three-parts"
[ambient]
ior = [1.0, 1.6]
[film]
ior = [1.1, 2.2]
thickness_nm = [0, 900]
[base]
ior = [1.0, 2.5]
[surface]
diffuse = true
base_color = "input"
[rates]
film_ior = "vertex"
roughness = "vertex"
base_color = "pixel"
"#;

fn of_three_parts() -> Case {
    let of = |text: &str| {
        let scene =
            Scene::from_toml("three-parts.toml", text, Path::new("")).unwrap_or_else(|error| panic!("{error:?}"));
        let variant: Variant = "windowed:k=6".parse().unwrap_or_else(|error| panic!("{error}"));
        Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{error}"))
    };
    let without_rates = THREE_PARTS.split("[rates]").next().unwrap_or_default();
    Case { whole: of(without_rates), prepared: of(&format!("{THREE_PARTS}[emit]\nvertex = true\n")) }
}

/// What the graph computes at points, each operation rounded to single precision.
fn of_graph(program: &Program, inputs: &[Input], points: &[Vec<f32>]) -> Vec<[f32; 3]> {
    let is_taken: Vec<bool> = inputs
        .iter()
        .flat_map(|input| {
            let is_taken = program.inputs().iter().any(|other| other.name == input.name);
            std::iter::repeat_n(is_taken, input.components())
        })
        .collect();
    let at = |point: &Vec<f32>| {
        let taken = point.iter().zip(&is_taken).filter(|(_, taken)| **taken);
        let point: Vec<f64> = taken.map(|(number, _)| f64::from(*number)).collect();
        let outputs = interpret::evaluate_rounded(program, &point, |value| f64::from(value as f32));
        outputs[0].map(|number| number as f32)
    };
    points.iter().map(at).collect()
}

#[test]
fn emitted_rust_compiles_without_a_warning_and_computes_the_same() {
    let cases = cases();
    let mut modules = Vec::new();
    let mut evaluations = Vec::new();
    for (number, case) in cases.iter().enumerate() {
        for (kind, shading) in [("whole", &case.whole), ("prepared", &case.prepared)] {
            let name = format!("{kind}_{number:02}");
            let text = library(shading, Language::Rust);
            let module = Module::new(&name, &text);
            for (quantity, function) in QUANTITIES {
                let inputs = shading.inputs(quantity);
                let expression = module.call(function, &inputs);
                evaluations.push(Evaluation { expression, points: points(&inputs) });
            }
            modules.push((name, text));
        }
    }
    let project = Project::new("generated-surfaces", &modules);
    let results = project.run(&evaluations);
    let mut found = results.chunks_exact(QUANTITIES.len());
    for case in &cases {
        let (whole, prepared) = (found.next().unwrap_or_default(), found.next().unwrap_or_default());
        let title = format!("{} {}", case.whole.scene().name, case.whole.variant());
        for (((quantity, function), whole), prepared) in QUANTITIES.into_iter().zip(whole).zip(prepared) {
            assert_eq!(prepared, whole, "{title}: {function} in two parts has the bits of the whole");
            let inputs = case.whole.inputs(quantity);
            let points = points(&inputs);
            let native = case.whole.evaluate_each_f32(quantity, &points);
            let to_native = difference(whole, &native);
            assert!(to_native <= LARGEST_TO_SOURCE, "{title}: {function}: {to_native:e}");
            // The interpreter rounds a scalar product once, glam each of its sums.
            if quantity == ShadingQuantity::Directions {
                println!("{title}: {function}: {to_native:.1e} to the source");
                continue;
            }
            let graph = of_graph(&case.whole.program(quantity), &inputs, &points);
            let same = whole.iter().zip(&graph).filter(|(found, expected)| found == expected).count();
            let to_graph = difference(whole, &graph);
            println!(
                "{title}: {function}: {to_native:.1e} to the source, {to_graph:.1e} to the graph, the same bits at \
                 {same} of {POINTS}"
            );
            assert!(to_graph <= LARGEST_TO_GRAPH, "{title}: {function}: {to_graph:e}");
        }
    }
    project.lint();
    project.format();
}

#[test]
fn what_is_prepared_lies_in_memory_as_in_a_uniform_buffer() {
    for shading in [
        shading("beetle-shell", "windowed:k=6", true),
        shading("beetle-shell", "poles:k=5", true),
        of_three_parts().prepared,
    ] {
        let wgsl = library(&shading, Language::Wgsl);
        let module = naga::front::wgsl::parse_str(&wgsl).unwrap_or_else(|error| panic!("{error}"));
        let found = module.types.iter().find_map(|(_, ty)| match &ty.inner {
            naga::TypeInner::Struct { members, span } if ty.name.as_deref() == Some(PREPARED_SURFACE) => {
                let field = |member: &naga::StructMember| (member.name.clone().unwrap_or_default(), member.offset);
                Some((members.iter().map(field).collect::<Vec<_>>(), *span))
            }
            _ => None,
        });
        // std140 has the whole end at a multiple of 16 bytes, WGSL where it has a vector.
        let found = found.map(|(fields, span)| (fields, span.next_multiple_of(16)));
        assert_eq!(Some(layout(&library(&shading, Language::Rust), PREPARED_SURFACE)), found);
    }
}
