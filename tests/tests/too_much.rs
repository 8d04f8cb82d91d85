//! What would take too long or too much is refused before the work begins, with an estimate of it and what is allowed.

use pavo_tests::run;
use std::time::{Duration, Instant};

const PROGRAM: &str = env!("CARGO_BIN_EXE_pavo-under-test");

const SCENE: &str = "name = \"film\"\n[film]\nior = 1.33\nthickness_nm = [0, 1200]\n[base]\nior = 1.5\n";
const GREEDY: &str = "[emit]\nvariant = \"spectral:n=100000\"\n";

/// A refusal takes a fraction of a second; the work that is refused takes minutes or more. Between them is what a busy
/// machine may need.
const TIME: Duration = Duration::from_secs(20);

/// Runs the command beside `scene.toml`, `greedy.toml` and `points.csv`, and expects a refusal that has these fragments.
fn refused(points: &str, arguments: &[&str], fragments: &[&str]) {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let files = [("scene.toml", SCENE), ("greedy.toml", &format!("{SCENE}{GREEDY}")), ("points.csv", points)];
    for (file, text) in files {
        std::fs::write(folder.path().join(file), text).expect("it can be written");
    }
    let started = Instant::now();
    let ran = run(PROGRAM, folder.path(), arguments);
    let taken = started.elapsed();
    assert_eq!(ran.status, 2, "{arguments:?}\n{}\n{}", ran.output, ran.errors);
    for fragment in fragments {
        assert!(ran.errors.contains(fragment), "{arguments:?}: no {fragment:?} in\n{}", ran.errors);
    }
    assert!(taken < TIME, "{arguments:?} took {taken:?}");
    let count = std::fs::read_dir(folder.path()).expect("the folder can be read").count();
    assert_eq!(count, files.len(), "{arguments:?} left something behind");
}

#[test]
fn a_variant_beyond_its_range_is_refused_with_what_it_would_take() {
    let cases: [(&str, &[&str]); 10] = [
        ("spectral:n=100000", &["`n=100000`", "e6 operations an evaluation", "12 MB of WGSL", "hours", "2 to 512"]),
        ("spectral:n=99999999999999999999999", &["operations an evaluation", "years of processor time", "2 to 512"]),
        ("series:m=100000", &["`m=100000`", "e6 operations an evaluation", "of WGSL", "hours", "1 to 32"]),
        ("poles:k=100000", &["`k=100000`", "e6 operations an evaluation", "of WGSL", "3 to 8"]),
        ("windowed:k=100000", &["operations an evaluation", "of WGSL", "4 to 10"]),
        ("cosines:k=100000,m=2", &["operations an evaluation", "of WGSL", "4 to 10"]),
        ("nodes:n=100000", &["operations an evaluation", "of WGSL", "4 to 16"]),
        ("baked:degree=100000", &["operations an evaluation", "of WGSL", "2 to 16"]),
        ("fitted:k=100000", &["operations an evaluation", "of WGSL", "1 to 12"]),
        ("table:4096x4096", &["`4096x4096`", "MB of WGSL", "years of processor time to build", "at most 4096 entries"]),
    ];
    for (variant, fragments) in cases {
        refused("", &["emit", "scene.toml", "--target", "wgsl", "--variant", variant], fragments);
    }
}

#[test]
fn every_command_refuses_such_a_variant() {
    let cases: [&[&str]; 9] = [
        &["build", "greedy.toml", "-o", "out"],
        &["check", "greedy.toml"],
        &["emit", "greedy.toml", "--target", "wgsl", "-o", "out.wgsl"],
        &["eval", "greedy.toml", "--points", "points.csv", "--on", "cpu-f64", "-o", "out.csv"],
        &["export", "greedy.toml", "--engine", "three", "-o", "out"],
        &["plot", "reflectance", "greedy.toml", "-o", "out.png"],
        &["preview", "greedy.toml", "-o", "out.png"],
        &["stability", "greedy.toml", "-o", "out"],
        &["stability", "--all", "--variant", "spectral:n=100000", "-o", "out"],
    ];
    for arguments in cases {
        refused("cos_theta1,thickness_nm\n1,0\n", arguments, &["`n=100000`", "operations an evaluation", "2 to 512"]);
    }
}

#[test]
fn too_many_of_anything_are_refused_with_what_they_would_take() {
    let scenes = [["report"].as_slice(), &["scene.toml"; 33]].concat();
    let cases: [(&[&str], &[&str]); 9] = [
        (
            &["stability", "scene.toml", "--points", "1e12"],
            &["1.0e12 points of a sweep", "80 TB of memory", "3 days of processor time", "the most are 1.0e8"],
        ),
        (&["stability", "--all", "--points", "1000000000000"], &["1.0e12 points of a sweep", "the most are 1.0e8"]),
        (&["stability", "--all", "--points", "1e300"], &["1.0e300 points of a sweep", "years of processor time"]),
        (
            &["preview", "scene.toml", "--size", "100000"],
            &["100000 pixels a side", "1900 GB of memory", "117 minutes of processor time", "the most are 4096"],
        ),
        (
            &["fit", "scene", "scene.toml", "-k", "100000"],
            &["100000 waves of a fit", "years of processor time", "the most are 12"],
        ),
        (
            &["fit", "sensitivities", "--family", "gauss", "--count", "1000000"],
            &["1.0e6 terms of a fit", "years of processor time", "the most are 16"],
        ),
        (&["fit", "sensitivities", "--family", "gauss", "--count", "16"], &["16 were asked for", "1 to 5"]),
        (
            &["fit", "sensitivities", "--family", "poles", "--count", "5", "--max-opd-um", "1e12"],
            &["is 1000000000000 um", "from 0.5 to 40 um"],
        ),
        (&scenes, &["33 scenes of a report", "25 minutes of processor time", "the most are 32"]),
    ];
    for (arguments, fragments) in cases {
        refused("", arguments, fragments);
    }
}

#[test]
fn more_points_than_are_read_are_refused_with_their_number() {
    let points = format!("cos_theta1,thickness_nm\n{}", "1,100\n".repeat(2_000_000));
    let arguments = ["eval", "scene.toml", "--points", "points.csv", "--on", "cpu-f64", "-o", "out.csv"];
    let fragments =
        ["about 2.00e6 points", "6.0e8 bytes of memory", "the most that are read are 1000000", "divide the table"];
    refused(&points, &arguments, &fragments);
}
