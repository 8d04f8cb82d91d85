//! Surfaces in two parts: both compute the bits of the whole, and what each pixel is spared.

use pavo::points::spread;
use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity, Variant};
use pavo_shade::{interpret, split};
use pavo_tests::{SCENES, scene_file};
use std::time::Instant;

const VARIANTS: [&str; 5] =
    ["windowed:k=6", "poles:k=5", "series:m=3,fit=xyz-gauss", "spectral:n=16", "spectral:n=81"];
const QUANTITIES: [ShadingQuantity; 3] =
    [ShadingQuantity::Reflectance, ShadingQuantity::Radiance, ShadingQuantity::Directions];
const POINTS: usize = 50;

fn shading(name: &str, variant: &str) -> Shading {
    let scene = Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let variant: Variant = variant.parse().unwrap_or_else(|error| panic!("{variant}: {error}"));
    Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn both_parts_of_the_starter_scenes_compute_the_bits_of_the_whole() {
    for name in SCENES {
        for variant in VARIANTS {
            let shading = shading(name, variant);
            for quantity in QUANTITIES {
                let whole = shading.program(quantity);
                let start = Instant::now();
                let split = split(&whole);
                let elapsed = start.elapsed();
                let names: Vec<&str> = split.prepared.iter().map(|prepared| prepared.name.as_str()).collect();
                println!(
                    "{name} {variant} {quantity:?}: {} to {} in {elapsed:?}: {names:?}",
                    whole.operations().weight(),
                    split.pixel.operations().weight()
                );
                for point in spread(whole.inputs(), POINTS, 1) {
                    let expected = interpret::evaluate(&whole, &point);
                    let in_two = split.pixel_point(whole.inputs(), &point, |value| value);
                    assert_eq!(interpret::evaluate(&split.pixel, &in_two), expected, "{name} {variant} at {point:?}");
                    assert_eq!(interpret::evaluate(&split.joined, &point), expected, "{name} {variant} at {point:?}");
                }
            }
        }
    }
}
