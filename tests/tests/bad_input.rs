//! What is wrong is said once and clearly, with status 2, and nothing is written.

use pavo_tests::{run, scene_file};
use std::path::Path;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

const SCENE: &str = "name = \"film\"\n[film]\nior = 1.33\nthickness_nm = [0, 1200]\n[base]\nior = 1.5\n";

/// Runs the command beside `scene.toml` with this text and `points.csv` with that, and expects a refusal.
fn refused(scene: &str, points: &str, arguments: &[&str], expected: &str, help: &str) {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    std::fs::write(folder.path().join("scene.toml"), scene).expect("the scene can be written");
    std::fs::write(folder.path().join("points.csv"), points).expect("the points can be written");
    let ran = run(PROGRAM, folder.path(), arguments);
    assert_eq!(ran.status, 2, "{arguments:?}\n{}\n{}", ran.output, ran.errors);
    assert!(ran.output.is_empty(), "{arguments:?} printed {}", ran.output);
    for fragment in [expected, help] {
        assert!(ran.errors.contains(fragment), "{arguments:?}: no {fragment:?} in\n{}", ran.errors);
    }
    assert_eq!(files(folder.path()), ["points.csv", "scene.toml"], "{arguments:?} left something behind");
}

fn files(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("it can be read").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_bad_scene_is_refused_by_every_command() {
    let with = |from: &str, to: &str| SCENE.replace(from, to);
    let cases = [
        (with("ior = 1.33", "ior = 0"), "film.ior", "0.01"),
        (with("[0, 1200]", "[1200, 0]"), "1200", "[0, 1200]"),
        (with("thickness_nm", "thicknes_nm"), "thicknes_nm", "thickness_nm"),
        (with("ior = 1.5", "ior = 1.5\nkappa = -1"), "kappa", "100"),
        (with("ior = 1.5", "metal = \"Xx\""), "Xx", "Ag"),
        (with("ior = 1.33", "ior = nan"), "nan", "film.ior"),
        (with("[base]", "[base"), "scene.toml", "]"),
    ];
    for (scene, expected, help) in cases {
        for arguments in [
            &["build", "scene.toml", "-o", "out"][..],
            &["emit", "scene.toml", "--target", "wgsl", "-o", "out.wgsl"],
            &["check", "scene.toml"],
            &["preview", "scene.toml", "-o", "out.png"],
            &["eval", "scene.toml", "--points", "points.csv", "--on", "cpu-f64", "-o", "out.csv"],
            &["variants", "scene.toml"],
            &["report", "scene.toml", "-o", "out"],
        ] {
            refused(&scene, "cos_theta1,thickness_nm\n1,0\n", arguments, expected, help);
        }
    }
}

#[test]
fn bad_arguments_are_refused() {
    let cases: [(&[&str], &str, &str); 12] = [
        (&["build", "absent.toml"], "there is no scene file `absent.toml`", "pavo new"),
        (&["build", "scene.toml", "--variant", "sereis:m=3", "-o", "out"], "unknown method `sereis`", "series, poles"),
        (&["build", "scene.toml", "--variant", "series:m=99", "-o", "out"], "`m=99`", "from 1 to 32"),
        (&["build", "scene.toml", "--target", "wgsl,hlsl7", "-o", "out"], "unknown target `hlsl7`", "essl300"),
        (&["emit", "scene.toml", "--target", "metal"], "unknown target `metal`", "glsl450"),
        (&["emit", "scene.toml", "--target", "spirv", "--form", "library"], "entry point", "--form compute"),
        (&["emit", "scene.toml", "--target", "rust", "--form", "compute"], "no compute shaders", "--form library"),
        (&["emit", "scene.toml", "--target", "rust", "--form", "fragment"], "no fragment shaders", "--target wgsl"),
        (&["emit", "scene.toml", "--target", "essl300", "--form", "compute"], "no compute shaders", "--form fragment"),
        (&["emit", "scene.toml", "--target", "wgsl", "--form", "mesh"], "mesh", "fragment"),
        (&["eval", "scene.toml", "--points", "absent.csv", "--on", "cpu-f64"], "absent.csv", "cannot be read"),
        (&["check", "absent.wgsl"], "absent.wgsl", "cannot be read"),
    ];
    for (arguments, expected, help) in cases {
        refused(SCENE, "cos_theta1,thickness_nm\n1,0\n", arguments, expected, help);
    }
}

#[test]
fn a_bad_table_of_points_is_refused() {
    let cases = [
        ("", "cos_theta1", "the points need a header"),
        ("cos_theta1,thickness_nm\n", "no points", "cos_theta1,thickness_nm"),
        ("cos_theta1\n1\n", "the column `thickness_nm` is missing", "cos_theta1,thickness_nm"),
        ("cos_theta1,thickness_nm\n1,NaN\n", "points.csv:2: `NaN`", "a number such as"),
        ("cos_theta1,thickness_nm\n1,0\n0.5,inf\n", "points.csv:3: `inf`", "a number such as"),
        ("cos_theta1,thickness_nm\n1,\n", "points.csv:2: ``", "a number such as"),
        ("cos_theta1,thickness_nm\n1,0,7\n", "points.csv", "cos_theta1,thickness_nm"),
        ("cos_theta1,thickness_nm,cos_theta1\n1,0,1\n", "`cos_theta1` stands twice", "cos_theta1,thickness_nm"),
        ("cos_theta1,thickness_nm,film_ior\n1,0,1.4\n", "`film_ior` is fixed at 1.33", "make it a range"),
    ];
    for (points, expected, help) in cases {
        let arguments = ["eval", "scene.toml", "--points", "points.csv", "--on", "cpu-f64", "-o", "out.csv"];
        refused(SCENE, points, &arguments, expected, help);
    }
}

#[test]
fn points_outside_of_the_ranges_are_evaluated_and_counted() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    std::fs::write(folder.path().join("points.csv"), "cos_theta1,thickness_nm\n1,0\n1,5000\n0.5,-1\n")
        .expect("written");
    let scene = scene_file("soap-bubble").display().to_string();
    let ran = run(PROGRAM, folder.path(), &["eval", &scene, "--points", "points.csv", "--on", "cpu-f32"]);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    assert!(ran.errors.contains("2 of 3 points lie outside"), "{}", ran.errors);
    assert_eq!(ran.output.lines().count(), 4, "{}", ran.output);
    assert!(ran.output.starts_with("cos_theta1,thickness_nm,r,g,b\n1,0,"), "{}", ran.output);
}
