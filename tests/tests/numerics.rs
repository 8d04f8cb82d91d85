//! Bounds of the reflectance enclose what the CPU and lavapipe compute, derivatives are those of the exact reference, and
//! what a variant needs of drivers follows from its error.

use pavo::numerics::{Enclosure, Numerics, ReflectanceBounds, derivatives};
use pavo::points::spread;
use pavo::roads::{self, Road};
use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity, Variant};
use pavo_check::Device;
use std::path::Path;

const QUANTITY: ShadingQuantity = ShadingQuantity::Reflectance;
/// How many boxes the ranges are divided into.
const BOXES: usize = 1_024;
/// How many samples are compared with the bounds, unless `PAVO_BOUNDS_SAMPLES` asks for another number.
const SAMPLES: usize = 4_096;

/// A film: its name, what varies, and whether it is the one for polynomials.
const FILMS: [(&str, &str); 3] = [
    ("dielectric", "[film]\nior = 1.33\nthickness_nm = [0, 1200]\n[base]\nior = 1.5\n"),
    ("conductor", "[film]\nior = 2.4\nthickness_nm = [0, 600]\n[base]\nior = 2.7\nkappa = 3.8\n"),
    ("uniform", "[film]\nior = 1.38\nthickness_nm = 100\n[base]\nior = 1.52\n"),
];

fn scene(name: &str, layers: &str) -> Scene {
    let text = format!("name = \"{name}\"\n{layers}");
    Scene::from_toml(name, &text, Path::new(".")).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn shading(name: &str, layers: &str, variant: &str) -> Shading {
    let variant: Variant = variant.parse().unwrap_or_else(|error| panic!("{variant}: {error}"));
    Shading::new(&scene(name, layers), &variant).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn samples() -> usize {
    match std::env::var("PAVO_BOUNDS_SAMPLES") {
        Ok(count) => count.parse().expect("PAVO_BOUNDS_SAMPLES is a number"),
        Err(_) => SAMPLES,
    }
}

/// The inputs of a surface with the cosines that bounds are for.
fn points(shading: &Shading, count: usize, seed: u64) -> Vec<Vec<f32>> {
    let mut inputs = shading.inputs(QUANTITY);
    inputs.iter_mut().filter(|input| input.name == "cos_theta1").for_each(|input| input.low = 0.05);
    let single = |point: Vec<f64>| point.into_iter().map(|number| number as f32).collect();
    spread(&inputs, count, seed).into_iter().map(single).collect()
}

/// Compares the CPU, and a device where there is one, with the bounds.
fn enclosures(shading: &Shading, device: Option<&Device>) -> [Enclosure; 2] {
    let points = points(shading, samples(), 11);
    let bounds = ReflectanceBounds::of(shading, BOXES);
    let on_device = device.map_or_else(Enclosure::default, |device| {
        let colors = roads::evaluate(device, Road::Wgsl, shading, QUANTITY, &points);
        bounds.enclose(&points, &colors.unwrap_or_else(|error| panic!("{}: {error}", shading.variant())))
    });
    [bounds.enclose(&points, &shading.evaluate_each_f32(QUANTITY, &points)), on_device]
}

/// Whether a variant is made for a film by the solver, which takes seconds: its functions are those of other variants,
/// with other constants.
fn is_solved_for(variant: &Variant) -> bool {
    matches!(variant, Variant::Fitted { .. } | Variant::Windowed { groups: Some(_), .. })
        || matches!(variant, Variant::Baked { denominator: 1.., .. })
}

#[test]
fn bounds_enclose_what_the_cpu_and_lavapipe_compute_by_every_built_in_variant() {
    let device = Device::lavapipe().unwrap_or_else(|error| panic!("{error}"));
    let mut total = [Enclosure::default(); 2];
    let mut variants = std::collections::BTreeSet::new();
    for (name, layers) in FILMS {
        let scene = scene(name, layers);
        for variant in Variant::candidates().iter().filter(|variant| !is_solved_for(variant)) {
            // A polynomial is for a uniform film, a table of several thicknesses for no such film.
            let Ok(shading) = Shading::new(&scene, variant) else { continue };
            variants.insert(variant.to_string());
            let found = enclosures(&shading, Some(&device));
            let summary = ReflectanceBounds::of(&shading, BOXES).summary();
            println!("{name}, {variant}: {found:?}, {summary:?}");
            for (place, found) in found.iter().enumerate() {
                assert_eq!(found.outside, 0, "{name}, {variant}, road {place}: {found:?}");
                assert_eq!(found.samples, samples(), "{name}, {variant}, road {place}: {found:?}");
                total[place].samples += found.samples;
                total[place].unbounded += found.unbounded;
            }
        }
    }
    println!("{} variants: {total:?}", variants.len());
    let expected = Variant::candidates().iter().filter(|variant| !is_solved_for(variant)).count();
    assert_eq!(variants.len(), expected, "each variant was made for a film: {variants:?}");
}

#[test]
fn bounds_are_broken_by_what_lies_outside_of_them() {
    let shading = shading("film", FILMS[0].1, "poles:k=6");
    let points = points(&shading, 100, 3);
    let bounds = ReflectanceBounds::of(&shading, BOXES);
    let moved = |distance: f32| {
        let colors: Vec<[f32; 3]> = shading
            .evaluate_each_f32(QUANTITY, &points)
            .into_iter()
            .map(|color| color.map(|it| it + distance))
            .collect();
        bounds.enclose(&points, &colors)
    };
    assert_eq!(moved(0.0), Enclosure { samples: 100, outside: 0, unbounded: moved(0.0).unbounded });
    assert_eq!(moved(f32::NAN).outside + moved(0.0).unbounded, 100);
    assert!(moved(5.0).outside + moved(0.0).unbounded == 100, "{:?}", moved(5.0));
}
