//! Scenes as files.

use std::fs;
use std::path::Path;

use crate::scene::{Base, MAXIMUM_FILE_BYTES, Scene, SceneError};

const SCENE: &str = "name = 'nickel'\n[base]\ncsv = 'nickel.csv'\n";

fn refusal(path: &Path) -> SceneError {
    Scene::load(path).expect_err("the file is not a scene")
}

#[test]
fn a_table_beside_the_scene_file_is_found() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("nickel.toml");
    fs::write(&path, SCENE).expect("the scene can be written");

    let error = refusal(&path);
    assert!(error.to_string().contains("nickel.csv"), "{error}");
    assert_eq!(error.span().map(|span| &SCENE[span]), Some("'nickel.csv'"));

    fs::write(folder.path().join("nickel.csv"), "wavelength_nm,n,k\n").expect("the table can be written");
    let scene = Scene::load(&path).unwrap_or_else(|error| panic!("{error:?}"));
    assert_eq!(scene.base, Base::Table { path: folder.path().join("nickel.csv") });
}

#[test]
fn a_file_that_cannot_be_read_is_named_with_what_to_do() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let large = folder.path().join("large.toml");
    fs::write(&large, "#".repeat(MAXIMUM_FILE_BYTES + 1)).expect("the file can be written");
    let cases = [
        (folder.path().join("absent.toml"), "there is no scene file", "pavo new NAME"),
        (folder.path().to_owned(), "is a folder", "name a file"),
        (large, "it has 1048577 bytes; the most that are read are 1048576", "CSV"),
    ];
    for (path, message, help) in cases {
        let error = refusal(&path);
        assert!(error.to_string().contains(message), "{error}");
        assert!(error.to_string().contains(&path.display().to_string()), "{error}");
        assert!(error.help_text().contains(help), "{error:?}");
    }
}

#[test]
fn a_file_of_the_largest_size_is_read() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("x.toml");
    let scene = "name = 'x'\nbase.ior = 1.5\n#";
    let text = format!("{scene}{}", "#".repeat(MAXIMUM_FILE_BYTES - scene.len()));
    fs::write(&path, text).expect("the file can be written");
    assert_eq!(Scene::load(&path).unwrap_or_else(|error| panic!("{error:?}")).name, "x");
}

#[test]
fn a_file_that_is_not_utf8_is_refused_at_its_first_bad_byte() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("latin1.toml");
    fs::write(&path, b"name = 'x'\n# caf\xe9\n").expect("the file can be written");
    let error = refusal(&path);
    assert!(error.to_string().contains("not UTF-8"), "{error}");
    assert_eq!(error.location().map(|(_, line, column)| (line, column)), Some((2, 6)));
    assert!(error.help_text().contains("save the file as UTF-8"), "{error:?}");
}
