//! Half precision: what it adds to the errors, and that the device computes what the CPU says.

use pavo::points::spread;
use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity, Variant};
use pavo_optics::Precision;
use pavo_tests::run;
use serde_json::Value;
use std::path::Path;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

/// Index of the film, its base, and the thickest film in nm.
const FILMS: [(f64, &str, f64); 5] = [
    (1.33, "ior = 1.0", 1200.0),
    (1.5, "ior = 1.33", 3000.0),
    (2.5, "ior = 1.2", 3000.0),
    (2.4, "ior = 2.7\nkappa = 3.8", 3000.0),
    (2.0, "ior = 0.06\nkappa = 3.6", 3000.0),
];

/// Variant, and the largest RMS and the largest difference that half precision may add over all films. 0 is for what has
/// no part in half precision.
const ADDED: [(&str, [f64; 2]); 7] = [
    ("windowed:k=6", [3e-4, 2e-3]),
    ("windowed:k=8", [3.5e-4, 3.5e-3]),
    ("poles:k=5", [3e-4, 2e-3]),
    ("series:m=3,fit=xyz-gauss", [2.5e-4, 2e-3]),
    ("cosines:k=6,m=2", [3e-4, 2e-3]),
    ("spectral:n=16", [6e-4, 3.5e-3]),
    ("spectral:n=81", [0.0, 0.0]),
];

fn scene((film, base, thickest): (f64, &str, f64), variant: &str, precision: &str) -> String {
    format!(
        "name = \"film\"\n[film]\nior = {film}\nthickness_nm = [0, {thickest}]\n[base]\n{base}\n[emit]\n\
         variant = \"{variant}\"\nprecision = \"{precision}\"\n"
    )
}

/// Root mean square and largest of what half precision changes, in f64 over 1,000 points.
fn added(film: (f64, &str, f64), variant: &str, parts: Option<Precision>) -> [f64; 2] {
    let scene = Scene::from_toml("film.toml", &scene(film, variant, "half"), Path::new(".")).expect("a valid scene");
    let half = Shading::new(&scene, &variant.parse::<Variant>().expect("a variant")).expect("it can be made");
    let half = parts.map_or(half.clone(), |parts| half.with_precision(parts));
    let quantity = ShadingQuantity::Reflectance;
    let points = spread(&half.inputs(quantity), 1000, 1);
    let full = half.with_precision(Precision::FULL).evaluate_each(quantity, &points);
    let half = half.evaluate_each(quantity, &points);
    let differences: Vec<f64> = half.iter().flatten().zip(full.iter().flatten()).map(|(a, b)| (a - b).abs()).collect();
    let squares: f64 = differences.iter().map(|difference| difference * difference).sum();
    [(squares / differences.len() as f64).sqrt(), differences.into_iter().fold(0.0, f64::max)]
}

#[test]
fn half_precision_adds_no_more_than_its_bounds() {
    for (variant, bounds) in ADDED {
        for film in FILMS {
            let found = added(film, variant, None);
            for (found, bound) in found.into_iter().zip(bounds) {
                assert!(found <= bound && (found > 0.0) == (bound > 0.0), "{variant}, {film:?}: {found:e} > {bound:e}");
            }
        }
    }
}

#[test]
fn nodes_and_long_sums_do_not_stand_half_precision() {
    let sums = Precision { sums: true, nodes: false };
    for (variant, film, parts) in
        [("windowed:k=6", FILMS[2], Precision { sums: true, nodes: true }), ("spectral:n=81", FILMS[4], sums)]
    {
        let [rms, _] = added(film, variant, Some(parts));
        assert!(rms > 1e-3, "{variant}, {film:?}: {rms:e}");
    }
}

#[test]
fn half_precision_runs_on_lavapipe_as_it_is_rounded_on_the_cpu() {
    for (variant, film) in [("windowed:k=6", FILMS[0]), ("poles:k=5", FILMS[3])] {
        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        std::fs::write(folder.path().join("film.toml"), scene(film, variant, "half")).expect("it can be written");
        let targets = "wgsl,glsl450,glsl330,essl300,rust,spirv";
        let ran = run(PROGRAM, folder.path(), &["build", "film.toml", "-o", "out", "--json", "--target", targets]);
        assert_eq!(ran.status, 0, "{variant}: {}", ran.errors);
        let manifest: Value = serde_json::from_str(&ran.output).expect("the manifest is JSON");
        let precision = &manifest["precision"];
        assert_eq!(precision["parts"], serde_json::json!(["weights and sums"]), "{variant}");
        assert_eq!(precision["languages"], serde_json::json!(["wgsl", "glsl450", "essl300"]), "{variant}");
        // HLSL has no half precision here: it is held against the CPU in 32 bits.
        for row in manifest["runs"]["rows"].as_array().expect("runs are a list") {
            // A value next to the middle of two numbers may be rounded to either; few are.
            let difference = &row["against_f32"];
            let [max, rms] = ["max", "rms"].map(|key| difference[key].as_f64().expect("a number"));
            assert!(max <= 4e-3 && rms <= 5e-5, "{variant}: {row:#}");
        }
        for (file, word) in
            [("film.wgsl", "enable f16;"), ("film.450.glsl", "float16_t"), ("film.300es.glsl", "mediump float")]
        {
            let text = std::fs::read_to_string(folder.path().join("out").join(file)).expect("it is written");
            assert!(text.contains(word), "{variant}: no {word} in {file}");
        }
    }
}

#[test]
fn an_unknown_precision_is_refused_with_those_there_are() {
    let error = Scene::from_toml("film.toml", &scene(FILMS[0], "poles:k=5", "f16"), Path::new(".")).unwrap_err();
    let text = format!("{error:?}");
    assert!(text.contains("unknown precision `f16`") && text.contains("half"), "{text}");
}
