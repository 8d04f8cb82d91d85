//! Surfaces in two parts: both compute the bits of the whole, their text passes the judges, and with the first part on
//! the CPU the second one gives on a device what the whole gives.

use pavo::points::spread;
use pavo::roads::{self, Road};
use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity, Variant, library};
use pavo_check::{ComputeShader, Device, judge_text, wgsl_to_spirv};
use pavo_emit::{Form, Language, Options, WORKGROUP_SIZE, emit_compute};
use pavo_shade::{LEAST_SAVED, Rate, Split, interpret, split};
use pavo_tests::{SCENES, run, scene_file};
use serde_json::Value;
use std::path::Path;
use std::time::Instant;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");
const VARIANTS: [&str; 5] = ["windowed:k=6", "poles:k=5", "series:m=3,fit=xyz-gauss", "spectral:n=16", "spectral:n=81"];
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
                let split = split(&whole, Rate::Material);
                let elapsed = start.elapsed();
                let names: Vec<&str> = split.prepared.iter().map(|prepared| prepared.name.as_str()).collect();
                println!(
                    "{name} {variant} {quantity:?}: {} to {} in {elapsed:?}: {names:?}",
                    whole.operations().weight(),
                    split.pixel.operations().weight()
                );
                let saved = whole.operations().weight() - split.pixel.operations().weight();
                let numbers: usize = split.prepared.iter().map(|prepared| prepared.components()).sum();
                assert!(saved >= LEAST_SAVED * numbers, "{name} {variant} {quantity:?}: {saved}");
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

/// A metal under a film, where everything is uniform but the direction.
const UNIFORM: &str = r#"
name = "uniform"
[ambient]
ior = [1.0, 1.3]
[film]
ior = [1.3, 2.2]
thickness_nm = [100, 600]
[base]
ior = [0.3, 3.0]
kappa = [1.0, 4.0]
[surface]
roughness = [0.1, 0.8]
[rates]
thickness_nm = "material"
roughness = "pixel"
"#;

fn uniform(variant: &str) -> Shading {
    let scene = Scene::from_toml("uniform.toml", UNIFORM, Path::new("")).unwrap_or_else(|error| panic!("{error:?}"));
    let variant: Variant = variant.parse().unwrap_or_else(|error| panic!("{variant}: {error}"));
    Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_scene_says_the_rates_of_the_inputs() {
    let rate = |name: &str| {
        let inputs = uniform("series:m=3,fit=xyz-gauss").inputs(ShadingQuantity::Radiance);
        inputs.into_iter().find(|input| input.name == name).map(|input| input.rate)
    };
    assert_eq!(rate("thickness_nm"), Some(Rate::Material));
    assert_eq!(rate("roughness"), Some(Rate::Pixel));
    assert_eq!(rate("film_ior"), Some(Rate::Material));
    assert_eq!(rate("n_dot_l"), Some(Rate::Pixel));
}

#[test]
fn the_functions_in_two_parts_pass_the_judges() {
    let starters = SCENES.iter().map(|name| {
        let mut scene = Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        scene.emit.prepare = true;
        scene.emit.prefix = "film_".to_owned();
        let variant: Variant = scene.emit.variant.parse().unwrap_or_else(|error| panic!("{name}: {error}"));
        Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{name}: {error}"))
    });
    for shading in starters.chain(VARIANTS.map(uniform)) {
        let name = shading.scene().name.clone();
        let is_split = shading.split(ShadingQuantity::Directions).prepare.is_some();
        for language in Language::ALL {
            let text = library(&shading, language);
            judge_text(language, Form::Library, &name, &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(text.contains("prepare_surface("), is_split, "{text}");
            assert_eq!(text.contains("PreparedSurface"), is_split, "{text}");
        }
    }
}

/// [`UNIFORM`] with inputs that change with the vertices.
fn with_vertices(variant: &str) -> Shading {
    let text = UNIFORM.replace("thickness_nm = \"material\"", "film_ior = \"vertex\"");
    let text = text.replace("roughness = \"pixel\"", "roughness = \"vertex\"") + "[emit]\nvertex = true\n";
    let scene = Scene::from_toml("vertices.toml", &text, Path::new("")).unwrap_or_else(|error| panic!("{error:?}"));
    let variant: Variant = variant.parse().unwrap_or_else(|error| panic!("{variant}: {error}"));
    Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_functions_in_three_parts_pass_the_judges_and_compute_the_bits_of_the_whole() {
    for variant in VARIANTS {
        let shading = with_vertices(variant);
        let quantity = ShadingQuantity::Directions;
        let whole = shading.program(quantity);
        let stages = shading.stages(quantity);
        assert!(stages.material.prepare.is_some() && stages.vertex.prepare.is_some(), "{variant}");
        for point in spread(whole.inputs(), POINTS, 1) {
            let expected = interpret::evaluate(&whole, &point);
            let of_rest = stages.material.pixel_point(whole.inputs(), &point, |value| value);
            let of_pixel = stages.vertex.pixel_point(stages.material.pixel.inputs(), &of_rest, |value| value);
            assert_eq!(interpret::evaluate(&stages.vertex.pixel, &of_pixel), expected, "{variant} at {point:?}");
            assert_eq!(interpret::evaluate(&stages.joined, &point), expected, "{variant} at {point:?}");
        }
        for language in Language::ALL {
            let text = library(&shading, language);
            judge_text(language, Form::Library, variant, &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
            for name in ["prepare_surface(", "vertex_surface(", "PreparedSurface", "VertexSurface"] {
                assert!(text.contains(name), "{variant}: no {name} in\n{text}");
            }
        }
    }
}

#[test]
fn the_manifest_counts_operations_by_rate_and_says_what_is_interpolated() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let text = UNIFORM.replace("roughness = \"pixel\"", "roughness = \"vertex\"") + "[emit]\nvertex = true\n";
    std::fs::write(folder.path().join("scene.toml"), text).expect("the scene can be written");
    let arguments = ["build", "scene.toml", "-o", "out", "--no-run", "--json", "--target", "wgsl,rust"];
    let ran = run(PROGRAM, folder.path(), &arguments);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    let manifest: Value = serde_json::from_str(&ran.output).expect("the manifest is JSON");
    let rates = &manifest["rates"];
    for kind in ["arithmetic", "roots", "transcendental", "fetches"] {
        let of = |rate: &str| rates["by_rate"][rate][kind].as_u64();
        let sum = ["material", "vertex", "pixel"].into_iter().filter_map(of).sum::<u64>();
        assert_eq!(Some(sum), rates["whole"][kind].as_u64(), "{kind}: {rates}");
    }
    assert!(rates["emitted"] == true && rates["vertex"]["emitted"] == true, "{rates}");
    let interpolated = rates["vertex"]["interpolated"].as_array().expect("a list");
    assert!(interpolated.iter().any(|value| value["name"] == "alpha_squared"), "{rates}");
    let checks = |target: usize| &manifest["targets"][target]["verdicts"][0]["checks"];
    assert_eq!([checks(0), checks(1)], ["syntax and types", "syntax alone"]);
}

/// Single precision.
fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

/// The second part at these points on a device, the first one on the CPU.
fn in_two(
    device: &Device,
    shading: &Shading,
    split: &Split,
    quantity: ShadingQuantity,
    points: &[Vec<f32>],
) -> Vec<f32> {
    let options = Options { language: Language::Wgsl, header: Vec::new(), prefix: String::new(), source_lines: false };
    let text = emit_compute(&split.pixel, &options).unwrap_or_else(|error| panic!("{error}"));
    let words = wgsl_to_spirv("pixel.wgsl", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let inputs = shading.inputs(quantity);
    let of_pixel = |point: &Vec<f32>| {
        let point: Vec<f64> = point.iter().copied().map(f64::from).collect();
        split.pixel_point(&inputs, &point, single).into_iter().map(|number| number as f32).collect::<Vec<_>>()
    };
    let numbers: Vec<f32> = points.iter().flat_map(of_pixel).collect();
    let shader = ComputeShader { spirv: &words, entry: "main", workgroup_size: WORKGROUP_SIZE, tables: &[] };
    let count = split.pixel.input_components();
    device.evaluate(&shader, &numbers, count, 3).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn with_the_first_part_on_the_cpu_the_second_gives_on_lavapipe_what_the_whole_gives() {
    const LARGEST: f32 = 5e-6;
    let device = Device::lavapipe().unwrap_or_else(|error| panic!("{error}"));
    let beetle = || shading("beetle-shell", "series:m=3,fit=xyz-gauss");
    let cases = [
        (uniform("series:m=3,fit=xyz-gauss"), ShadingQuantity::Reflectance),
        (uniform("windowed:k=6"), ShadingQuantity::Reflectance),
        (uniform("spectral:n=16"), ShadingQuantity::Reflectance),
        (beetle(), ShadingQuantity::Reflectance),
        (beetle(), ShadingQuantity::Radiance),
    ];
    for (shading, quantity) in cases {
        let split = shading.split(quantity);
        assert!(split.prepare.is_some());
        let mut inputs = shading.inputs(quantity);
        inputs.iter_mut().filter(|input| input.name == "cos_theta1").for_each(|input| input.low = 0.05);
        let points: Vec<Vec<f32>> = spread(&inputs, 20_000, 2)
            .into_iter()
            .map(|point| point.into_iter().map(|number| number as f32).collect())
            .collect();
        let found = in_two(&device, &shading, &split, quantity, &points);
        let whole =
            roads::evaluate(&device, Road::Wgsl, &shading, quantity, &points).unwrap_or_else(|error| panic!("{error}"));
        let differences =
            found.iter().zip(whole.iter().flatten()).map(|(found, whole)| (found - whole).abs() / whole.abs().max(1.0));
        let largest = differences.fold(0.0, f32::max);
        println!("{} {} {quantity:?}: {largest:e}", shading.scene().name, shading.variant());
        assert!(largest <= LARGEST, "{} {} {quantity:?}: {largest:e}", shading.scene().name, shading.variant());
    }
}
