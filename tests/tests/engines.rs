//! What `pavo export` writes: for each engine and each of these scenes it passes its judges.

use pavo_tests::{Ran, run, scene_file};
use serde_json::Value;
use std::path::{Path, PathBuf};

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

/// A film on a base of the engine's colour, by a variant: each kind of text that a method makes.
fn scene(variant: &str, precision: &str) -> String {
    format!(
        "name = \"film\"\n[film]\nior = [1.2, 2.0]\nthickness_nm = [0, 1000]\n[base]\nworkflow = \"metalness\"\n\
         [surface]\nmetalness = 1\nbase_color = \"input\"\n[emit]\nvariant = \"{variant}\"\nprecision = \"{precision}\"\n"
    )
}

fn written(folder: &Path, variant: &str, precision: &str) -> PathBuf {
    let file = folder.join("film.toml");
    std::fs::write(&file, scene(variant, precision)).expect("the scene can be written");
    file
}

fn engines(folder: &Path) -> Vec<Value> {
    let listed = run(PROGRAM, folder, &["export", "--list", "--json"]);
    let engines: Vec<Value> = serde_json::from_str(&listed.output).expect("the list is JSON");
    assert!(engines.len() > 10, "{engines:?}");
    engines
}

fn exports(folder: &Path, scene: &Path, name: &str) -> Ran {
    let scene = scene.to_str().expect("a path is text");
    run(PROGRAM, folder, &["export", scene, "--engine", name, "-o", name])
}

fn exported(folder: &Path, scene: &Path, engine: &Value) {
    let name = engine["name"].as_str().expect("an engine has a name");
    let ran = exports(folder, scene, name);
    assert_eq!(ran.status, 0, "{name}: {}", ran.errors);
    for file in engine["files"].as_array().expect("an engine has files") {
        let file = file["file"].as_str().expect("a file has a name");
        let text = std::fs::read_to_string(folder.join(name).join(file)).expect("the file is there");
        assert!(text.contains("Error: max ") && text.contains("Cost: "), "{name}: {file}: {text}");
    }
}

#[test]
fn each_engine_takes_each_kind_of_text_with_its_error_and_cost() {
    for variant in ["poles:k=5", "windowed:k=6", "spectral:n=16"] {
        let folder = tempfile::tempdir().expect("a folder can be made");
        let file = written(folder.path(), variant, "full");
        for engine in engines(folder.path()) {
            exported(folder.path(), &file, &engine);
        }
    }
}

#[test]
fn half_precision_is_refused_where_a_text_in_wgsl_stands_below_the_engines_own() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    let file = written(folder.path(), "windowed:k=6", "half");
    for engine in engines(folder.path()) {
        let files = engine["files"].as_array().expect("an engine has files");
        if files.iter().any(|file| file["language"] == "wgsl") {
            let ran = exports(folder.path(), &file, engine["name"].as_str().expect("an engine has a name"));
            assert_eq!(ran.status, 2, "{engine}: {}", ran.errors);
            assert!(ran.errors.contains("enable f16;"), "{}", ran.errors);
        } else {
            exported(folder.path(), &file, &engine);
        }
    }
}

#[test]
fn an_engine_without_a_fixed_base_takes_a_conductor() {
    let folder = tempfile::tempdir().expect("a folder can be made");
    for engine in engines(folder.path()) {
        // Those of the web know the base by a colour alone.
        if engine["loses"] == "" {
            exported(folder.path(), &scene_file("anodised-titanium"), &engine);
        }
    }
}
