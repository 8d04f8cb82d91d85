//! Numbers that are none, or larger than any that makes sense: refused, or computed with to a finite colour.

use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity};
use pavo_tests::run;
use std::path::Path;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

/// A scene with a mark in the place of each number that it can have.
const FIELDS: [(&str, &str); 13] = [
    ("ambient.ior", "[ambient]\nior = @\n[film]\nior = 1.33\nthickness_nm = 300\n[base]\nior = 1.5\n"),
    ("film.ior", "[film]\nior = @\nthickness_nm = [0, 1200]\n[base]\nior = 1.5\n"),
    ("film.ior of a range", "[film]\nior = [1.2, @]\nthickness_nm = [0, 1200]\n[base]\nior = 1.5\n"),
    ("film.thickness_nm", "[film]\nior = 1.33\nthickness_nm = @\n[base]\nior = 1.5\n"),
    ("film.thickness_nm of a range", "[film]\nior = 1.33\nthickness_nm = [0, @]\n[base]\nior = 1.5\n"),
    ("base.ior", "[film]\nior = 1.33\nthickness_nm = 300\n[base]\nior = @\n"),
    ("base.kappa", "[film]\nior = 1.33\nthickness_nm = 300\n[base]\nior = 1.5\nkappa = @\n"),
    ("base.ior without a film", "[base]\nior = @\n"),
    ("surface.roughness", "[base]\nior = 1.5\n[surface]\nroughness = @\n"),
    ("surface.visibility_k", "[base]\nior = 1.5\n[surface]\nvisibility_k = @\n"),
    ("surface.metalness", "[base]\nworkflow = 'metalness'\n[surface]\nmetalness = @\nbase_color = 'input'\n"),
    ("surface.base_color", "[base]\nworkflow = 'metalness'\n[surface]\nmetalness = 1\nbase_color = [@, 0.5, 0.5]\n"),
    ("budget.max_delta_e", "[base]\nior = 1.5\n[budget]\nmax_delta_e = @\n"),
];

/// What is no number for anything, and what is one for some.
const NO_NUMBERS: [&str; 9] =
    ["nan", "+nan", "-nan", "inf", "-inf", "1e999", "-1e999", "99999999999999999999999999", "0x7fffffffffffffffffff"];
const EXTREME_NUMBERS: [&str; 14] = [
    "0",
    "-0.0",
    "1e308",
    "-1e308",
    "1e-308",
    "5e-324",
    "-5e-324",
    "9223372036854775807",
    "-9223372036854775808",
    "1e39",
    "-1e39",
    "1e-46",
    "1e6",
    "100",
];

fn scene(text: &str) -> Result<Scene, pavo::scene::SceneError> {
    Scene::from_toml("scene.toml", &format!("name = 'x'\n{text}"), Path::new(""))
}

#[test]
fn what_is_no_number_is_refused_in_every_field_of_a_scene() {
    for (field, text) in FIELDS {
        for number in NO_NUMBERS {
            let error = scene(&text.replace('@', number)).err();
            let error = error.unwrap_or_else(|| panic!("{field} = {number} was taken"));
            assert!(!error.to_string().is_empty() && !error.help_text().is_empty(), "{field} = {number}");
            assert!(error.location().is_some(), "{field} = {number}: {error}");
        }
    }
}

#[test]
fn extreme_numbers_are_refused_or_give_finite_colours() {
    let mut taken = 0;
    for (field, text) in FIELDS {
        for number in EXTREME_NUMBERS {
            let Ok(scene) = scene(&text.replace('@', number)) else { continue };
            taken += 1;
            for variant in ["series:m=1", "spectral:n=16", "fresnel:form=exact"] {
                let variant = variant.parse().expect("it is a variant");
                let Ok(shading) = Shading::new(&scene, &variant) else { continue };
                for quantity in [ShadingQuantity::Reflectance, ShadingQuantity::Brdf] {
                    let inputs = shading.inputs(quantity);
                    let point = inputs
                        .iter()
                        .flat_map(|input| std::iter::repeat_n((input.low + input.high) / 2.0, input.components()));
                    let point: Vec<f64> = point.collect();
                    let single: Vec<f32> = point.iter().map(|value| *value as f32).collect();
                    let in_f64 = shading.evaluate(quantity, &point);
                    let in_f32 = shading.evaluate_each_f32(quantity, &[single]);
                    let is_finite = in_f64.iter().all(|value| value.is_finite())
                        && in_f32.iter().flatten().all(|value| value.is_finite());
                    assert!(is_finite, "{field} = {number}, {variant}: {in_f64:?} {in_f32:?}");
                }
            }
        }
    }
    assert!(taken > 20, "only {taken} scenes were taken");
}

#[test]
fn what_is_no_number_is_refused_by_every_flag() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let text = "name = 'x'\n[film]\nior = 1.33\nthickness_nm = 300\n[base]\nior = 1.5\n";
    std::fs::write(folder.path().join("scene.toml"), text).expect("it can be written");
    let flags: [(&[&str], &str); 10] = [
        (&["tune", "scene.toml"], "--max-delta-e"),
        (&["tune", "scene.toml"], "--max-rms"),
        (&["tune", "scene.toml"], "--max-cost"),
        (&["report", "scene.toml"], "--max-delta-e"),
        (&["fit", "scene", "scene.toml"], "--max-rms"),
        (&["fit", "scene", "scene.toml"], "--max-error"),
        (&["fit", "scene", "scene.toml"], "--count"),
        (&["fit", "sensitivities", "--family", "gauss", "--count", "2"], "--max-opd-um"),
        (&["preview", "scene.toml"], "--size"),
        (&["stability", "scene.toml"], "--points"),
    ];
    for (command, flag) in flags {
        for number in ["nan", "inf", "-inf", "1e999", "-1", "-1e308", "0", "x"] {
            let argument = format!("{flag}={number}");
            let ran = run(PROGRAM, folder.path(), &[command, &[&argument]].concat());
            assert_eq!(ran.status, 2, "{command:?} {argument}\n{}\n{}", ran.output, ran.errors);
            assert!(!ran.errors.is_empty() && !ran.errors.contains("panicked"), "{argument}: {}", ran.errors);
        }
    }
}
