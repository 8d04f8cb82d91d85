//! `pavo report` writes pages that stand by themselves, and figures that agree with `pavo tune`.

use pavo_tests::{Ran, run};
use serde_json::Value;
use std::path::Path;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

/// A film whose index is given at run time: nothing has to be fitted to it.
const COATING: &str =
    "# A coating.\nname = 'coating'\n[film]\nior = [1.3, 1.5]\nthickness_nm = 100\n[base]\nior = 1.52\n";

fn read(folder: &Path, file: &str) -> String {
    std::fs::read_to_string(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

fn report(folder: &Path, arguments: &[&str]) -> Ran {
    run(PROGRAM, folder, &[&["report"], arguments].concat())
}

/// A page loads nothing from elsewhere, runs no script, and shows nothing that was left undone.
fn assert_stands_alone(page: &str, name: &str) {
    assert!(page.starts_with("<!DOCTYPE html>") && page.trim_end().ends_with("</html>"), "{name} is whole");
    for loaded in ["<script", "<link", "@import", "url(", "src=\"http", "src=\"//", "href=\"http", "href=\"//"] {
        assert!(!page.contains(loaded), "{name} has {loaded}");
    }
    for source in page.split("src=\"").skip(1) {
        assert!(source.starts_with("data:image/png;base64,"), "{name} loads {}", &source[..40.min(source.len())]);
    }
}

fn assert_svg(text: &str, name: &str) {
    assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"), "{name} is a whole SVG");
    let count = |part: &str| text.matches(part).count();
    let (open, close, alone) = (count("<") - count("</"), count("</"), count("/>"));
    assert_eq!(open, close + alone, "each element of {name} is closed");
    assert!(text.contains("largest dE2000") && text.contains("RMS error"), "{name} names its axes");
}

#[test]
fn the_page_of_a_scene_holds_its_sections_and_agrees_with_tune() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let folder = folder.path();
    let scene = "coating.toml";
    std::fs::write(folder.join(scene), COATING).expect("written");
    let ran = report(folder, &[scene, "--max-delta-e", "0.5", "--json"]);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    let page = read(folder, "report/index.html");
    assert_stands_alone(&page, "the page");
    for section in ["scene", "picked", "sphere", "frontier", "variants", "worst", "stability", "code", "reproduce"] {
        assert!(page.contains(&format!("<section id=\"{section}\">")), "the page has no section {section}");
    }
    assert!(page.contains("numbers that are NaN or infinite: none over 4"), "the page says what is stable");
    assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count());
    for file in ["frontier.svg", "frontier-lavapipe.svg"] {
        assert_svg(&read(folder, &format!("report/{file}")), file);
    }

    let text = read(folder, "report/report.json");
    assert_eq!(ran.output, text, "--json prints the file");
    let figures: Value = serde_json::from_str(&text).expect("the figures are JSON");
    let tuned = run(PROGRAM, folder, &["tune", scene, "--max-delta-e", "0.5", "--json"]);
    let tuned: Value = serde_json::from_str(&tuned.output).expect("pavo tune prints JSON");
    assert_eq!(figures["picked"], tuned["pick"]);
    let rows = tuned["tuning"]["rows"].as_array().expect("rows");
    assert_eq!(figures["variants"].as_array().map(Vec::len), Some(rows.len()));
    let agreement = figures["sphere"]["shader_against_cpu"].as_f64().expect("the shader was run");
    assert!(agreement <= 1.0, "the sphere by the shader is {agreement} levels from that by the CPU");
    assert!(figures["timed"]["device"]["is_lavapipe"].as_bool().expect("times were taken"));

    let variant = figures["picked"]["variant"].as_str().expect("a variant");
    let points = ["--points", "report/worst-points.csv", "--on", "reference", "--variant", variant];
    let again = run(PROGRAM, folder, &[&["eval", scene], &points[..]].concat());
    assert_eq!(again.status, 0, "{}", again.errors);
    let difference = again.errors.split("max ").nth(1).and_then(|rest| rest.split(',').next());
    let difference: f64 = difference.and_then(|number| number.parse().ok()).expect("the difference is said");
    assert!(difference < 1e-12, "{}", again.errors);
}

#[test]
fn several_scenes_make_a_gallery_and_one_without_a_pick_fails() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let folder = folder.path();
    std::fs::write(folder.join("bare.toml"), "name = 'bare'\n[base]\nior = 1.5\n").expect("written");
    let hostile = "# <b>&\nname = 'metal'\n[base]\nmetal = 'Au'\n";
    std::fs::write(folder.join("metal.toml"), hostile).expect("written");
    // One index is computed exactly; a sum over wavelengths never is.
    let ran = report(folder, &["bare.toml", "metal.toml", "--max-delta-e", "1e-9", "--no-run", "-o", "out"]);
    assert_eq!(ran.status, 1, "{}{}", ran.output, ran.errors);
    assert!(ran.errors.contains("keeps to the budget"), "{}", ran.errors);
    let gallery = read(folder, "out/index.html");
    assert_stands_alone(&gallery, "the gallery");
    for name in ["bare", "metal"] {
        assert!(gallery.contains(&format!("href=\"{name}/index.html\"")), "the gallery links {name}");
        let page = read(folder, &format!("out/{name}/index.html"));
        assert_stands_alone(&page, name);
        assert!(page.contains("evaluated on the CPU") && page.contains("--no-run"), "{name} says what was not done");
        let figures: Value = serde_json::from_str(&read(folder, &format!("out/{name}/report.json"))).expect("JSON");
        assert_eq!(figures["picked"].is_null(), name == "metal");
        assert!(figures["timed"].is_null());
        assert!(figures["stability"].is_null() && !page.contains("id=\"stability\""), "{name} was not run");
    }
    let page = read(folder, "out/metal/index.html");
    assert!(page.contains("No variant keeps to the budget"));
    assert!(page.contains("&lt;b&gt;&amp;") && !page.contains("<b>&"), "what comes from the scene is escaped");
}

#[test]
fn bad_input_leaves_nothing_behind() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let folder = folder.path();
    std::fs::write(folder.join("coating.toml"), COATING).expect("written");
    std::fs::write(folder.join("same.toml"), COATING).expect("written");
    std::fs::write(folder.join("file"), "").expect("written");
    let cases: [(&[&str], &str); 6] = [
        (&[], "SCENE"),
        (&["absent.toml"], "there is no scene file"),
        (&["coating.toml", "absent.toml"], "there is no scene file"),
        (&["coating.toml", "same.toml"], "both called coating"),
        (&["coating.toml", "--max-delta-e", "0"], "a budget of 0"),
        (&["coating.toml", "--no-run", "-o", "file"], "cannot be made"),
    ];
    for (arguments, expected) in cases {
        let ran = report(folder, arguments);
        assert_eq!(ran.status, 2, "{arguments:?}: {}", ran.errors);
        assert!(ran.errors.contains(expected), "{arguments:?}: {}", ran.errors);
        assert!(!folder.join("report").exists(), "{arguments:?} left something behind");
    }
}
