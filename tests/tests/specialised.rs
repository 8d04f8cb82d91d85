//! The programs of the starter scenes without the guards that their ranges make unnecessary: the same bits at each point
//! within the ranges, which guards those are, and how long the proof takes.

use pavo::points::spread;
use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity, Variant};
use pavo_shade::{Input, Program, interpret, specialise};
use pavo_tests::{SCENES, scene_file};
use std::time::{Duration, Instant};

const VARIANTS: [&str; 6] =
    ["windowed:k=6", "poles:k=5", "poles:k=8", "series:m=3,fit=xyz-gauss", "spectral:n=16", "spectral:n=81"];
const QUANTITIES: [ShadingQuantity; 3] =
    [ShadingQuantity::Reflectance, ShadingQuantity::Radiance, ShadingQuantity::Directions];
const POINTS: usize = 100;
/// It takes at most 20 ms in a release build on an idle machine.
const MOST_TIME: Duration = Duration::from_millis(300);

fn shading(name: &str, variant: &str) -> Shading {
    let scene = Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let variant: Variant = variant.parse().unwrap_or_else(|error| panic!("{variant}: {error}"));
    Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The outputs of a program at a point that has a number for each component of these inputs.
fn evaluate(program: &Program, inputs: &[Input], point: &[f64]) -> Vec<[f64; 3]> {
    let mut rest = point;
    let mut taken = Vec::new();
    for input in inputs {
        let (numbers, after) = rest.split_at(input.components());
        if program.inputs().iter().any(|other| other.name == input.name) {
            taken.extend_from_slice(numbers);
        }
        rest = after;
    }
    interpret::evaluate(program, &taken)
}

#[test]
fn without_their_unnecessary_guards_the_starter_scenes_compute_the_same_bits() {
    for name in SCENES {
        for variant in VARIANTS {
            let shading = shading(name, variant);
            for quantity in QUANTITIES {
                let general = shading.general_program(quantity);
                let start = Instant::now();
                let specialised = specialise(&general);
                let elapsed = start.elapsed();
                let [before, after] = [&general, &specialised.program].map(|program| program.operations().arithmetic);
                let count = specialised.left_out.len();
                println!(
                    "{name} {variant} {quantity:?}: {count} left out, {before} to {after} operations, {elapsed:?}"
                );
                assert!(elapsed < MOST_TIME, "{name} {variant} {quantity:?} took {elapsed:?}");
                for point in spread(general.inputs(), POINTS, 1) {
                    let expected = interpret::evaluate(&general, &point);
                    let found = evaluate(&specialised.program, general.inputs(), &point);
                    assert_eq!(found, expected, "{name} {variant} {quantity:?} at {point:?}");
                }
            }
        }
    }
}

/// A function and a guard in it.
type Row = (&'static str, &'static str);

#[test]
fn the_guards_that_a_scene_needs_not_are_listed() {
    let film = "surface_reflectance";
    let cases: [(&str, &str, &[Row]); 3] = [
        // The denominators of a film between two equal media vanish at grazing angles: their guards stay.
        ("soap-bubble", "spectral:n=16", &[(film, "max(0.7689 + q3_squared, 1e-12)")]),
        (
            "oil-on-water",
            "spectral:n=16",
            &[("airy_reflectance", "max(denominator, 1e-30)"), (film, "max(1.25 + cos_theta1 * cos_theta1, 1e-12)")],
        ),
        (
            "anodised-titanium",
            "spectral:n=16",
            &[
                ("normal_component_absorbing", "abs(real)"),
                ("normal_component_absorbing", "max((modulus + ..) * 0.5, 1e-30)"),
                ("normal_component_absorbing", "real < 0"),
                (film, "max(4.76 + cos_theta1 * cos_theta1, 1e-12)"),
            ],
        ),
    ];
    for (name, variant, expected) in cases {
        let left_out = shading(name, variant).left_out(ShadingQuantity::Reflectance);
        let found: Vec<(&str, &str)> = left_out.iter().map(|row| (row.function.as_str(), row.what.as_str())).collect();
        assert_eq!(found, expected, "{name} {variant}");
        for row in &left_out {
            assert!(row.location.contains("pavo-optics/src/"), "{row:?}");
            assert!(row.low <= row.high && !row.reason.is_empty(), "{row:?}");
        }
    }
}
