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
    let bounds = ReflectanceBounds::of(shading, boxes(shading.variant()));
    let on_device = device.map_or_else(Enclosure::default, |device| {
        let colors = roads::evaluate(device, Road::Wgsl, shading, QUANTITY, &points);
        bounds.enclose(&points, &colors.unwrap_or_else(|error| panic!("{}: {error}", shading.variant())))
    });
    [bounds.enclose(&points, &shading.evaluate_each_f32(QUANTITY, &points)), on_device]
}

/// How many boxes a variant is bounded over: the kernel under a window divides by what only small boxes keep off 0.
fn boxes(variant: &Variant) -> usize {
    match variant {
        Variant::Windowed { .. } | Variant::Cosines { .. } => 64 * BOXES,
        _ => BOXES,
    }
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
            println!("{name}, {variant}: {found:?}");
            for (place, found) in found.iter().enumerate() {
                assert_eq!(found.outside, 0, "{name}, {variant}, road {place}: {found:?}");
                assert_eq!(found.samples, samples(), "{name}, {variant}, road {place}: {found:?}");
                // Where nothing is bounded, nothing was compared.
                assert!(found.unbounded < found.samples, "{name}, {variant}, road {place}: {found:?}");
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

/// Films of which angle, thickness and index vary.
const VARYING: [(&str, &str); 2] = [
    ("dielectric", "[film]\nior = [1.2, 1.6]\nthickness_nm = [50, 1200]\n[base]\nior = 1.7\n"),
    ("conductor", "[film]\nior = [1.6, 2.4]\nthickness_nm = [50, 600]\n[base]\nior = 2.7\nkappa = 3.8\n"),
];

/// What the colour is differentiated by, and the step of differences.
const VARIABLES: [(&str, f64); 3] = [("cos_theta1", 1e-4), ("thickness_nm", 0.05), ("film_ior", 1e-4)];

/// An error of the colour is a sum of waves, one for each order of round trips: its slope is at most so large that it waves
/// at the phase of the second order, as far as orders above that are small.
const ORDERS: f64 = 2.0;

/// The largest change of a round trip's phase at 380 nm, `4 pi d q2 / 380`, with a unit of each variable, radians; `q2` is
/// the root of `n2^2 - 1 + cos1^2`.
fn phase_speeds(thickness_nm: f64, [lowest_ior, highest_ior]: [f64; 2]) -> [f64; 3] {
    let wave_number = 4.0 * std::f64::consts::PI / 380.0;
    let by_cosine = thickness_nm / lowest_ior;
    let by_index = thickness_nm * lowest_ior / (lowest_ior * lowest_ior - 1.0).sqrt();
    [by_cosine, highest_ior, by_index].map(|factor| factor * wave_number)
}

#[test]
fn derivatives_are_those_of_the_exact_reference_within_the_variants_own_error() {
    for (name, layers) in VARYING {
        for variant in ["poles:k=6", "spectral:n=161"] {
            let shading = shading(name, layers, variant);
            let inputs = shading.inputs(QUANTITY);
            let mut inside = inputs.clone();
            inside[0].low = 0.1;
            inside[0].high = 0.999;
            let points = spread(&inside, 400, 13);
            let reference = |points: &[Vec<f64>]| {
                shading.reference_each(QUANTITY, points).unwrap_or_else(|error| panic!("{name}: {error}"))
            };
            let error = |found: &[[f64; 3]], expected: &[[f64; 3]]| {
                let pairs = found.iter().flatten().zip(expected.iter().flatten());
                pairs.map(|(found, expected)| (found - expected).abs()).fold(0.0, f64::max)
            };
            let own = error(&shading.evaluate_each(QUANTITY, &points), &reference(&points));
            let speeds = phase_speeds(inputs[1].high, [inputs[2].low, inputs[2].high]);
            for (place, ((variable, step), speed)) in VARIABLES.into_iter().zip(speeds).enumerate() {
                assert_eq!(inputs[place].name, variable);
                let moved = |step: f64| {
                    let moved = |point: &Vec<f64>| {
                        let mut point = point.clone();
                        point[place] += step;
                        point
                    };
                    reference(&points.iter().map(moved).collect::<Vec<_>>())
                };
                let (before, after) = (moved(-step), moved(step));
                let expected: Vec<[f64; 3]> = (before.iter().zip(&after))
                    .map(|(before, after)| [0, 1, 2].map(|channel| (after[channel] - before[channel]) / (2.0 * step)))
                    .collect();
                let found = error(&derivatives(&shading, &points, place), &expected);
                let largest = error(&expected, &vec![[0.0; 3]; expected.len()]);
                let allowed = own * ORDERS * speed;
                println!(
                    "{name}, {variant}: by {variable} {found:.2e} of up to {largest:.2e}, allowed {allowed:.2e}; \
                     own error {own:.2e}"
                );
                assert!(found <= allowed, "{name}, {variant}: by {variable} {found:e}, allowed {allowed:e}");
                // A derivative that is off by a tenth of the largest would not be within.
                assert!(
                    allowed < 0.1 * largest,
                    "{name}, {variant}: by {variable} {allowed:e} of {largest:e} tells nothing"
                );
            }
        }
    }
}

/// The numbers of which the condition is given, and whether the scene fixes them.
const CONDITIONS: [(&str, &[(&str, bool)]); 2] = [
    ("dielectric", &[("cos_theta1", false), ("thickness_nm", false), ("film_ior", true), ("base_ior", true)]),
    (
        "conductor",
        &[("cos_theta1", false), ("thickness_nm", false), ("film_ior", true), ("base_ior", true), ("base_kappa", true)],
    ),
];

#[test]
fn the_figures_of_a_variant_follow_from_its_error_and_are_the_same_each_time() {
    for ((name, layers), (_, expected)) in FILMS.into_iter().zip(CONDITIONS) {
        for variant in ["poles:k=6", "series:m=3,fit=xyz-gauss"] {
            let shading = shading(name, layers, variant);
            let found = || Numerics::of(&shading).unwrap_or_else(|error| panic!("{name}: {error}"));
            let numerics = found();
            assert_eq!(numerics, found(), "{name}, {variant}");
            let needs = &numerics.needs;
            println!("{name}, {variant}: {needs:?}");
            assert!(needs.met && needs.added.is_within(needs.budget), "{name}, {variant}: {needs:?}");
            assert!(needs.budget.max >= numerics.own_error.max, "{name}, {variant}: {needs:?}");
            // Somewhere between what all devices keep to and an error that spoils everything.
            let sizes: Vec<f64> = [needs.sin, needs.cos].into_iter().flatten().collect();
            assert!(!sizes.is_empty(), "{name}, {variant}: {needs:?}");
            assert!(sizes.iter().all(|size| (5e-6..0.1).contains(size)), "{name}, {variant}: {needs:?}");
            let exact = &numerics.policies[0];
            assert_eq!((exact.policy, exact.not_finite), ("exact", 0));
            assert!(exact.against_f64.max <= 4e-6, "{name}, {variant}: {exact:?}");
            let waves = numerics.policies.last().expect("Vulkan's").against_f64;
            assert!(waves.max > 10.0 * exact.against_f64.max, "{name}, {variant}: {waves:?}");
            let rows: Vec<(&str, bool)> =
                numerics.condition.iter().map(|row| (row.input.as_str(), row.fixed)).collect();
            let known: Vec<_> = rows.iter().copied().filter(|(input, _)| *input != "ambient_ior").collect();
            assert_eq!(known, expected, "{name}, {variant}");
            for row in &numerics.condition {
                assert!(row.absolute.median > 0.0 && row.absolute.median <= row.absolute.max, "{name}: {row:?}");
                assert!(row.relative.max.is_finite() && row.relative.median > 0.0, "{name}: {row:?}");
            }
        }
    }
}
