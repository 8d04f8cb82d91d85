//! `pavo plot` writes pictures that can be read.

use pavo_tests::{run, scene_file};
use std::path::Path;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

fn plot(folder: &Path, arguments: &[&str]) {
    let ran = run(PROGRAM, folder, &[&["plot"], arguments].concat());
    assert_eq!(ran.status, 0, "{arguments:?}: {}", ran.errors);
}

fn assert_svg(folder: &Path, file: &str, labels: &[&str]) {
    let text = std::fs::read_to_string(folder.join(file)).expect("the picture is written");
    assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"), "{file} is a whole SVG");
    for label in labels {
        assert!(text.contains(label), "{file} has no {label:?}");
    }
}

fn assert_png(folder: &Path, file: &str) {
    let content = std::fs::File::open(folder.join(file)).expect("the picture is written");
    let mut reader = png::Decoder::new(std::io::BufReader::new(content)).read_info().expect("it is a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
    reader.next_frame(&mut pixels).expect("it is whole");
    let colours: std::collections::HashSet<&[u8]> = pixels.chunks_exact(3).collect();
    assert!(colours.len() > 20, "{file} has {} colours", colours.len());
}

#[test]
fn the_sensitivities_are_drawn_in_both_formats() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    plot(folder.path(), &["sensitivities"]);
    let labels = ["wavelength λ (nm)", "wave number 1/λ", "optical path difference D (µm)", "Gaussian fit"];
    assert_svg(folder.path(), "sensitivities.svg", &labels);
    plot(folder.path(), &["sensitivities", "--illuminant", "D65", "--space", "linear-srgb", "-o", "rgb.PNG"]);
    assert_png(folder.path(), "rgb.PNG");
}

#[test]
fn the_reflectance_is_drawn_in_both_formats() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = |name: &str| scene_file(name).display().to_string();
    plot(folder.path(), &["reflectance", &scene("soap-bubble")]);
    assert_png(folder.path(), "reflectance.png");
    plot(folder.path(), &["reflectance", &scene("bare-plastic"), "-o", "strip.svg"]);
    assert_svg(folder.path(), "strip.svg", &["cos θ₁", "no film", "CIEDE2000"]);
}

#[test]
fn another_extension_is_bad_input() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = scene_file("soap-bubble").display().to_string();
    for arguments in [&["sensitivities", "-o", "plot.jpg"][..], &["reflectance", &scene, "-o", "plot"]] {
        let ran = run(PROGRAM, folder.path(), &[&["plot"], arguments].concat());
        assert_eq!(ran.status, 2, "{arguments:?}: {}", ran.errors);
        assert!(ran.errors.contains(".svg or .png"), "{}", ran.errors);
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("the folder is there").count(), 0, "nothing is written");
}
