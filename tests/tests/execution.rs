//! Every starter scene is built, judged and run on lavapipe by the four roads, against the CPU.

use pavo_tests::{SCENES, run, scene_file};
use serde_json::Value;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

/// The largest difference of the reflectance from the CPU in f32, and in f64, away from grazing angles.
const ORDINARY: [f64; 2] = [5e-6, 2e-5];

/// The same for cosines from 0.001 to 0.05, where the film's finesse amplifies rounding.
const GRAZING: [(&str, [f64; 2]); 10] = [
    ("anodised-titanium", [1e-6, 2e-6]),
    ("bare-plastic", [1e-6, 1e-6]),
    ("beetle-shell", [1e-6, 1e-6]),
    ("coated-lens", [1e-6, 1e-6]),
    ("lacquered-gold", [2e-5, 2e-5]),
    ("oil-on-water", [1e-6, 1e-6]),
    ("oxide-on-silicon", [1e-6, 1e-6]),
    ("soap-bubble", [5e-6, 5e-6]),
    ("rutile-on-titanium", [1e-6, 2e-6]),
    ("soap-bubble spectral:n=81", [5e-5, 5e-5]),
];

fn build(name: &str, variant: Option<&str>) -> Value {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = scene_file(name).display().to_string();
    let mut arguments = vec![
        "build",
        &scene,
        "-o",
        "out",
        "--json",
        "--target",
        "wgsl,glsl450,glsl330,essl300,hlsl,osl,rust,spirv,spirv-asm",
    ];
    arguments.extend(variant.into_iter().flat_map(|variant| ["--variant", variant]));
    let ran = run(PROGRAM, folder.path(), &arguments);
    assert_eq!(ran.status, 0, "{name}: {}", ran.errors);
    let manifest: Value = serde_json::from_str(&ran.output).expect("the manifest is JSON");
    let written = std::fs::read_to_string(folder.path().join("out/manifest.json")).expect("the manifest is written");
    assert_eq!(serde_json::from_str::<Value>(&written).ok().as_ref(), Some(&manifest), "{name}");
    for target in manifest["targets"].as_array().expect("targets are a list") {
        let file = target["file"].as_str().expect("a target has a file");
        let size = std::fs::metadata(folder.path().join("out").join(file)).expect("it is written").len();
        assert_eq!(Some(size), target["bytes"].as_u64(), "{file}");
        let verdicts = target["verdicts"].as_array().expect("verdicts are a list");
        assert!(!verdicts.is_empty() && verdicts.iter().all(|verdict| verdict["passed"] == true), "{file}: {target}");
    }
    manifest
}

fn check_runs(label: &str, manifest: &Value, ordinary: [f64; 2]) {
    let bounds = GRAZING.iter().find(|(name, _)| *name == label);
    let (_, grazing) = bounds.unwrap_or_else(|| panic!("{label} has no bounds at grazing angles"));
    let rows = manifest["runs"]["rows"].as_array().expect("runs are a list");
    let device = manifest["runs"]["device"]["name"].as_str().unwrap_or_default();
    assert!(device.contains("llvmpipe"), "it ran on {device}");
    assert_eq!(rows.len(), 12, "four roads over three sets of points");
    for row in rows {
        let is_grazing = row["cos_theta1"][1].as_f64().expect("a range") < 0.5;
        let bounds = match row["quantity"].as_str() {
            Some("reflectance") if is_grazing => *grazing,
            Some("reflectance") => ordinary,
            _ => [5e-5, 1e-4],
        };
        for (against, bound) in ["against_f32", "against_f64"].into_iter().zip(bounds) {
            let difference = &row[against];
            let max = difference["max_relative"].as_f64().unwrap_or(f64::INFINITY);
            assert_eq!(difference["points"], 100_000);
            assert!(
                max <= bound,
                "{label}: {} {} {against}: {max:e} > {bound:e}\n{difference:#}",
                row["quantity"],
                row["road"]
            );
        }
    }
}

#[test]
fn every_starter_scene_runs_on_lavapipe_as_on_the_cpu() {
    for name in SCENES {
        check_runs(name, &build(name, None), ORDINARY);
    }
}

#[test]
fn the_closed_form_runs_on_lavapipe_as_on_the_cpu() {
    let manifest = build("soap-bubble", Some("spectral:n=81"));
    check_runs("soap-bubble spectral:n=81", &manifest, ORDINARY);
}

#[test]
fn points_of_a_table_give_the_same_colours_on_every_road() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = scene_file("soap-bubble").display().to_string();
    let points = "cos_theta1,thickness_nm\n1,0\n0.9,300\n0.5,450.5\n0.25,1100\n";
    std::fs::write(folder.path().join("points.csv"), points).expect("the points can be written");
    let evaluate = |on: &str| -> Vec<Vec<f64>> {
        let arguments = ["eval", &scene, "--points", "points.csv", "--on", on, "--variant", "spectral:n=81"];
        let ran = run(PROGRAM, folder.path(), &arguments);
        assert_eq!(ran.status, 0, "{on}: {}", ran.errors);
        let rows = ran.output.lines().skip(1);
        rows.map(|row| row.split(',').map(|field| field.parse().expect("a number")).collect()).collect()
    };
    let reference = evaluate("reference");
    for (on, tolerance) in [
        ("cpu-f64", 2e-3),
        ("cpu-f32", 2e-3),
        ("lavapipe-wgsl", 2e-3),
        ("lavapipe-glsl", 2e-3),
        ("lavapipe-hlsl", 2e-3),
        ("lavapipe-spirv", 2e-3),
    ] {
        let found = evaluate(on);
        assert_eq!(found.len(), 4, "{on}");
        for (found, reference) in found.iter().flatten().zip(reference.iter().flatten()) {
            assert!((found - reference).abs() <= tolerance, "{on}: {found} instead of {reference}");
        }
    }
}
