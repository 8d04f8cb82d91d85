//! `pavo export`: what an engine cannot take is refused with what would be right, and the same scene gives the same bytes.

use pavo_tests::{run, scene_file};
use std::path::Path;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

/// A scene with this base and variant under a film that varies.
fn scene(base: &str) -> String {
    format!(
        "name = \"film\"\n[film]\nior = [1.2, 2]\nthickness_nm = [0, 900]\n[base]\n{base}\n[emit]\nvariant = \"windowed:k=4\"\n"
    )
}

const F0: &str = "workflow = \"f0\"\nf0 = \"input\"";

/// The engines that only have an F0, with the files of their code.
const BY_F0: [(&str, &[&str]); 4] = [
    ("three", &["iridescence_fragment.glsl"]),
    ("three-wgsl", &["thin_film.wgsl"]),
    ("babylon", &["thin_film.glsl", "thin_film.wgsl"]),
    ("playcanvas", &["iridescenceDiffraction.glsl", "iridescenceDiffraction.wgsl"]),
];

/// Exports `scene.toml` with this text, beside a file called `taken`.
fn export(text: &str, arguments: &[&str]) -> (tempfile::TempDir, pavo_tests::Ran) {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    std::fs::write(folder.path().join("scene.toml"), text).expect("the scene can be written");
    std::fs::write(folder.path().join("taken"), "kept").expect("the file can be written");
    let ran = run(PROGRAM, folder.path(), &[&["export", "scene.toml"], arguments].concat());
    (folder, ran)
}

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn what_an_engine_cannot_take_is_refused_with_what_would_be_right() {
    let tinted = format!("{F0}\nedge_tint = \"input\"");
    let index = "ior = [1.1, 3]";
    let conductor = "ior = [0.1, 3]\nkappa = 2";
    let cases: [(&str, &[&str], &str, &str); 9] = [
        (F0, &["--engine", "thre", "-o", "out"], "unknown engine `thre`", "three, three-wgsl, babylon"),
        (F0, &["--engine", "", "-o", "out"], "unknown engine ``", "pavo export --list"),
        (index, &["--engine", "three", "-o", "out"], "has no base_ior", "`f0 = \"input\"` in [base]"),
        (conductor, &["--engine", "babylon", "-o", "out"], "Babylon.js has no base_ior", "fix it in the scene"),
        (&tinted, &["--engine", "three-wgsl", "-o", "out"], "has no edge_tint", "fix it in the scene"),
        (&tinted, &["--engine", "playcanvas", "-o", "out"], "PlayCanvas has no edge_tint", "base_color or f0"),
        (&tinted, &["--engine", "unity", "-o", "out"], "has no edge_tint", "base_kappa"),
        (F0, &["--engine", "three", "--variant", "baked:degree=6", "-o", "out"], "baked", "windowed:k=6"),
        (F0, &["--engine", "three", "-o", "taken"], "taken", "made"),
    ];
    for (base, arguments, expected, help) in cases {
        let (folder, ran) = export(&scene(base), arguments);
        assert_eq!(ran.status, 2, "{arguments:?}\n{}\n{}", ran.output, ran.errors);
        assert!(ran.output.is_empty(), "{arguments:?} printed {}", ran.output);
        for fragment in [expected, help] {
            assert!(ran.errors.contains(fragment), "{arguments:?}: no {fragment:?} in\n{}", ran.errors);
        }
        assert!(!folder.path().join("out").exists(), "{arguments:?} left something behind");
        assert_eq!(read(folder.path(), "taken"), "kept");
    }
}

#[test]
fn an_engine_that_only_has_an_f0_gives_it_to_the_base() {
    let tinted = format!("{F0}\nedge_tint = [0.9, 0.6, 0.5]");
    for (engine, files) in BY_F0 {
        for (base, function, note) in [
            (F0, "ior_from_reflectance", "the base is a dielectric in each channel"),
            (&tinted, "index_from_f0", "that of the scene, [0.900, 0.600, 0.500], is a constant of the code"),
        ] {
            let (folder, ran) = export(&scene(base), &["--engine", engine, "-o", "out"]);
            assert_eq!(ran.status, 0, "{engine}: {}", ran.errors);
            let out = folder.path().join("out");
            for file in files {
                let text = read(&out, file);
                assert!(text.contains(&format!("pavo_{function}(")), "{engine}: no {function} in {file}");
            }
            let readme = read(&out, "README.md");
            for fragment in [note, "its extinction and its dispersion are lost"] {
                assert!(readme.contains(fragment), "{engine}: no {fragment:?} in\n{readme}");
            }
        }
    }
}

#[test]
fn an_export_of_a_metal_says_what_its_f0_would_lose() {
    let mut said = String::new();
    for (metal, film) in [("Au", 1.5), ("Cu", 1.5), ("Al", 1.5), ("Ti", 2.2)] {
        let text =
            format!("name = \"film\"\n[film]\nior = {film}\nthickness_nm = [0, 900]\n[base]\nmetal = \"{metal}\"\n");
        let (folder, ran) = export(&text, &["--engine", "three", "--variant", "nodes:n=6", "-o", "out"]);
        assert_eq!(ran.status, 0, "{metal}: {}", ran.errors);
        let readme = read(&folder.path().join("out"), "README.md");
        let line = readme.lines().find(|line| line.contains("Known by its F0")).expect("the README says it");
        assert!(ran.output.contains(line), "{metal}: the command does not say {line:?}");
        said.push_str(&format!("{metal} under {film}: {line}\n"));
    }
    insta::assert_snapshot!(said);
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    for engine in ["three", "three-wgsl", "babylon", "playcanvas", "unity", "unreal", "materialx", "blender"] {
        let contents = || {
            let (folder, ran) = export(&scene(F0), &["--engine", engine, "-o", "out"]);
            assert_eq!(ran.status, 0, "{engine}: {}", ran.errors);
            let entries = std::fs::read_dir(folder.path().join("out")).expect("the folder can be read");
            let mut files: Vec<(String, Vec<u8>)> = entries
                .map(|entry| {
                    let path = entry.expect("it can be read").path();
                    let name = path.file_name().expect("it has a name").to_string_lossy().into_owned();
                    (name, std::fs::read(&path).expect("the file can be read"))
                })
                .collect();
            files.sort();
            files
        };
        let first = contents();
        assert!(first.len() >= 4, "{engine}: {:?}", first.iter().map(|(name, _)| name).collect::<Vec<_>>());
        assert!(first == contents(), "{engine}: the second export differs");
    }
}

#[test]
fn each_test_vector_has_the_three_colours_and_a_tolerance() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let file = scene_file("lacquered-gold").display().to_string();
    let ran = run(PROGRAM, folder.path(), &["export", &file, "--engine", "three", "-o", "out"]);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    let text = read(&folder.path().join("out"), "test-vectors.csv");
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let header = lines.next().expect("it has a header");
    assert!(header.ends_with(",r,g,b,tolerance"), "{header}");
    let rows: Vec<&str> = lines.collect();
    assert_eq!(rows.len(), 64);
    for row in rows {
        let fields: Vec<f64> = row.split(',').map(|field| field.parse().expect("a number")).collect();
        assert_eq!(fields.len(), header.split(',').count(), "{row}");
        assert_eq!(fields.last(), Some(&2e-5), "{row}");
    }
    // The command takes its own table and says nothing of the columns that are no inputs.
    let points = ["eval", &file, "--points", "out/test-vectors.csv", "--on", "cpu-f64"];
    let ran = run(PROGRAM, folder.path(), &points);
    assert!(ran.status == 0 && !ran.errors.contains("not used"), "{}", ran.errors);
}
