//! The starter scenes, and the text that a new scene starts from.

use std::path::{Path, PathBuf};

use crate::scene::{STARTER, Scene, starter};

fn starter_scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../templates/scenes");
    let entries = std::fs::read_dir(&folder).expect("the folder of the starter scenes is there");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("the folder can be listed").path()).collect();
    paths.sort();
    paths
}

#[test]
fn every_starter_scene_is_accepted_and_named_after_its_file() {
    let mut names = Vec::new();
    for path in starter_scenes() {
        let scene = Scene::load(&path).unwrap_or_else(|error| panic!("{error:?}"));
        assert_eq!(path.file_name().and_then(|name| name.to_str()), Some(format!("{}.toml", scene.name).as_str()));
        let text = std::fs::read_to_string(&path).expect("the scene was just read");
        assert!(text.starts_with("# "), "{} says in its first line what it is", scene.name);
        names.push(scene.name);
    }
    let expected = [
        "anodised-titanium",
        "bare-plastic",
        "beetle-shell",
        "coated-lens",
        "lacquered-gold",
        "oil-on-water",
        "oxide-on-silicon",
        "rutile-on-titanium",
        "soap-bubble",
    ];
    assert_eq!(names, expected);
}

#[test]
fn a_scene_written_as_toml_reads_back_as_itself() {
    for path in starter_scenes() {
        let scene = Scene::load(&path).unwrap_or_else(|error| panic!("{error:?}"));
        let text = toml::to_string(&scene).expect("a scene can be written as TOML");
        let again = Scene::from_toml("again.toml", &text, Path::new("")).unwrap_or_else(|error| panic!("{error:?}"));
        assert_eq!(again, scene);
    }
}

#[test]
fn a_new_scene_is_accepted_under_its_name() {
    let text = starter("my-film").expect("the name is a good one");
    let scene = Scene::from_toml("my-film.toml", &text, Path::new("")).unwrap_or_else(|error| panic!("{error:?}"));
    assert_eq!(scene.name, "my-film");
    assert!(!text.contains("NAME"));
    let error = starter("my film").expect_err("a name has no spaces");
    assert!(error.to_string().contains("' '"), "{error}");
}

/// The starter text with the commented lines that start with one of `wanted` in force, and the lines that start with
/// one of `dropped` left out.
fn starter_with(wanted: &[&str], dropped: &[&str]) -> String {
    let starts = |line: &str, with: &[&str]| with.iter().any(|start| line.starts_with(start));
    let kept = STARTER.lines().filter(|line| !starts(line, dropped));
    let lines = kept.map(|line| line.strip_prefix("# ").filter(|rest| starts(rest, wanted)).unwrap_or(line));
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn every_key_that_the_starter_text_offers_in_a_comment_is_accepted() {
    let cases: &[(&[&str], &[&str])] = &[
        (&["ior = 2.7", "kappa = "], &["ior = 1.0"]),
        (&["metal = "], &["ior = 1.0"]),
        (&["csv = "], &["ior = 1.0"]),
        (&["workflow = \"f0\"", "f0 = ", "edge_tint = "], &["ior = 1.0"]),
        (&["workflow = \"metalness\"", "base_color = ", "metalness = "], &["ior = 1.0"]),
        (&["visibility_k = "], &[]),
        (&["[ambient]", "ior = 1.0"], &[]),
        (&["[colour]", "observer = ", "illuminant = ", "space = "], &[]),
        (&["[lights]", "punctual = "], &[]),
        (&["[budget]", "max_delta_e = "], &[]),
        (&["[rates]", "thickness_nm = \"material\""], &[]),
        (&["variant = ", "prefix = "], &[]),
    ];
    for (wanted, dropped) in cases {
        let text = starter_with(wanted, dropped);
        assert_ne!(text, starter_with(&[], dropped), "{wanted:?} is offered");
        Scene::from_toml("starter.toml", &text, Path::new("")).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    }
    let tried: Vec<&str> = cases.iter().flat_map(|(wanted, _)| *wanted).copied().collect();
    for line in STARTER.lines().filter_map(|line| line.strip_prefix("# ")) {
        let is_key = line.split_once(" = ").is_some_and(|(key, _)| !key.contains(' '));
        assert!(!is_key || tried.iter().any(|start| line.starts_with(start)), "`{line}` is offered but not tried");
    }
}
