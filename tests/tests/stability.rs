//! Every built-in variant over the catalogue of hard cases and a short sweep, by all roads; and the command.

use pavo::stability::{Check, Effort, Exceptions, built_in, examine};
use pavo::{NoCache, Variant};
use pavo_check::Device;
use pavo_tests::{Ran, run, scene_file};
use serde_json::Value;
use std::path::Path;

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

#[test]
fn every_built_in_variant_keeps_to_its_bounds_and_every_exception_is_needed() {
    let device = Device::lavapipe().expect("lavapipe is needed: cargo xtask setup");
    let placed = built_in(None, &NoCache).expect("the surfaces can be made");
    let stability = examine(&device, &placed, Effort::QUICK, &|_, _| {}).expect("they can be examined");
    let exceptions = Exceptions::built_in().expect("the table is as it should be");
    let judgement = exceptions.judge(&stability.findings);
    let failures: Vec<String> = judgement.failures().map(|row| format!("{row:?}")).collect();
    assert!(failures.is_empty(), "{} bounds are not kept:\n{}", failures.len(), failures.join("\n"));
    // A short sweep does not find all that a long one does.
    let stale: Vec<String> =
        judgement.stale.iter().filter(|row| !row.exception.needs_full()).map(|row| format!("{row:?}")).collect();
    assert!(stale.is_empty(), "no longer needed:\n{}", stale.join("\n"));
    for variant in Variant::candidates() {
        let name = variant.to_string();
        assert!(stability.device_points.iter().any(|(other, _)| *other == name), "{variant} was not examined");
    }
    for check in Check::ALL {
        assert!(stability.findings.iter().any(|finding| finding.check == check), "{check} was never made");
    }
}

fn stability(folder: &Path, arguments: &[&str]) -> Ran {
    run(PROGRAM, folder, &[&["stability"], arguments].concat())
}

#[test]
fn the_worst_points_of_a_scene_can_be_evaluated_again() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = scene_file("soap-bubble").display().to_string();
    let arguments = [&scene, "--quick", "--points", "5000", "--variant", "poles:k=6", "-o", "out", "--json"];
    let ran = stability(folder.path(), &arguments);
    assert_eq!(ran.status, 0, "{}", ran.errors);
    let report: Value = serde_json::from_str(&ran.output).expect("the report is JSON");
    let findings = report["findings"].as_array().expect("findings are a list");
    assert!(findings.iter().any(|finding| finding["case"] == "sweep" && finding["points"] == 5000), "{report:#}");
    for file in ["stability.json", "map-poles-k-6.png"] {
        assert!(folder.path().join("out").join(file).exists(), "{file} is not written");
    }
    for quantity in ["reflectance", "directions"] {
        let points = format!("out/worst-soap-bubble-{quantity}.csv");
        let arguments = ["eval", &scene, "--points", &points, "--quantity", quantity, "--on", "lavapipe-wgsl"];
        let ran = run(PROGRAM, folder.path(), &[&arguments[..], &["--variant", "poles:k=6"]].concat());
        assert_eq!(ran.status, 0, "{quantity}: {}", ran.errors);
        assert!(ran.output.lines().count() > 1, "{quantity}: {}", ran.output);
    }
}

#[test]
fn what_cannot_be_examined_is_bad_input() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let scene = scene_file("soap-bubble").display().to_string();
    for (arguments, cause) in [
        (&[][..], "required"),
        (&["--all", &scene], "cannot be used with"),
        (&["--all", "--points", "5"], "a sweep of 5 points"),
        (&["--all", "--variant", "poles:k=7"], "none of the built-in variants"),
        (&[scene.as_str(), "--variant", "baked:degree=4"], "cannot be made"),
        (&["missing.toml"], "missing.toml"),
    ] {
        let ran = stability(folder.path(), arguments);
        assert_eq!(ran.status, 2, "{arguments:?}: {}", ran.errors);
        assert!(ran.errors.contains(cause), "{arguments:?}: {}", ran.errors);
    }
}
