//! Times of kernels, compared with each other. No test knows how fast the machine is.

use std::sync::OnceLock;

use pavo_check::timing::{Candidate, Clock, Spread, Timings, compare};
use pavo_check::{CheckError, ComputeShader, Device, wgsl_to_spirv};

const WORKGROUP_SIZE: u32 = 64;

/// The device that all tests share. Without lavapipe they fail, with what to install.
fn lavapipe() -> &'static Device {
    static DEVICE: OnceLock<Device> = OnceLock::new();
    DEVICE.get_or_init(|| Device::lavapipe().unwrap_or_else(|error| panic!("{error}")))
}

/// A kernel of two inputs and one output, with that many cosines in a row.
fn cosines(count: usize) -> Vec<u32> {
    let rows = "    x = cos(x + y);\n".repeat(count);
    let text = format!(
        "@group(0) @binding(0) var<storage, read> inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;

@compute @workgroup_size({WORKGROUP_SIZE})
fn evaluate(@builtin(global_invocation_id) id: vec3u) {{
    let i = id.x;
    if i >= arrayLength(&outputs) {{
        return;
    }}
    var x = inputs[2u * i];
    let y = inputs[2u * i + 1u];
{rows}    outputs[i] = x;
}}
"
    );
    wgsl_to_spirv("cosines.wgsl", &text).unwrap_or_else(|error| panic!("{error}"))
}

fn candidate<'call>(name: &'call str, spirv: &'call [u32], inputs: &'call [f32]) -> Candidate<'call> {
    let shader = ComputeShader { spirv, entry: "evaluate", workgroup_size: WORKGROUP_SIZE, tables: &[] };
    Candidate { name, shader, inputs, inputs_per_point: 2, outputs_per_point: 1 }
}

fn inputs(points: u16) -> Vec<f32> {
    (0..2 * u32::from(points)).map(|i| i as f32 * 1.0e-3).collect()
}

fn check_spread(what: &str, spread: &Spread) {
    let values = [spread.least, spread.lower_quartile, spread.median, spread.upper_quartile, spread.greatest];
    assert!(values.iter().all(|value| value.is_finite() && *value > 0.0), "{what}: {spread:?}");
    assert!(values.is_sorted(), "{what}: {spread:?}");
}

#[test]
fn fifty_times_the_work_takes_longer() {
    let (little, much) = (cosines(4), cosines(200));
    let inputs = inputs(50_000);
    let candidates = [candidate("little", &little, &inputs), candidate("much", &much, &inputs)];
    let found: Timings = compare(lavapipe(), &candidates, "much", 7).unwrap_or_else(|error| panic!("{error}"));
    println!("{found:#?}");
    assert_eq!((found.points, found.rounds, found.reference.as_str()), (50_000, 7, "much"));
    assert_eq!(found.clock, Clock::Timestamps);
    assert!(found.device.is_lavapipe);
    let names: Vec<&str> = found.timings.iter().map(|timing| timing.name.as_str()).collect();
    assert_eq!(names, ["little", "much"]);
    let [little, much] = &found.timings[..] else { panic!("{found:?}") };
    for (what, spread) in [
        ("little", &little.gross),
        ("much", &much.gross),
        ("reading and writing", &much.copy),
        ("much, net", &much.net),
        ("its ratio", &much.ratio),
    ] {
        check_spread(what, spread);
    }
    assert_eq!((much.ratio.least, much.ratio.greatest), (1.0, 1.0));
    assert!(little.ratio.least.is_finite() && little.ratio.median < 0.3, "{found:#?}");
    assert!(much.gross.median > little.gross.median && much.net.median < much.gross.median, "{found:#?}");
}

#[test]
fn candidates_may_have_other_inputs() {
    let (little, much) = (cosines(20), cosines(200));
    let (own, other) = (inputs(20_000), inputs(20_000));
    let single = "@group(0) @binding(0) var<storage, read> inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;
@compute @workgroup_size(32)
fn evaluate(@builtin(global_invocation_id) id: vec3u) {
    if id.x < arrayLength(&inputs) {
        outputs[3u * id.x] = exp(inputs[id.x]);
    }
}
";
    let single = wgsl_to_spirv("single.wgsl", single).unwrap();
    let third = Candidate {
        name: "single",
        shader: ComputeShader { spirv: &single, entry: "evaluate", workgroup_size: 32, tables: &[] },
        inputs: &own[..20_000],
        inputs_per_point: 1,
        outputs_per_point: 3,
    };
    let candidates = [candidate("little", &little, &own), candidate("much", &much, &other), third];
    let found = compare(lavapipe(), &candidates, "much", 3).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.timings.len(), 3);
    assert!(found.timings.iter().all(|timing| timing.ratio.median.is_finite()), "{found:#?}");
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let spirv = cosines(1);
    let (inputs, fewer, none) = (inputs(100), inputs(99), Vec::new());
    let check = |candidates: &[Candidate<'_>], reference: &str, rounds: usize, expected: &str| {
        let error = compare(lavapipe(), candidates, reference, rounds).expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}\nexpected: {expected}");
        error
    };
    let one = candidate("one", &spirv, &inputs);
    let two = candidate("two", &spirv, &fewer);
    check(&[one], "one", 0, "no rounds");
    check(&[one, two], "three", 1, "no candidate is called `three`: there are one, two");
    check(&[one, two], "one", 1, "`two` has 99 points and `one` has 100");
    check(&[one, one], "one", 1, "candidate 2 is called `one`");
    check(&[candidate("one", &spirv, &none)], "one", 1, "no points");
    check(&[candidate("one", &spirv, &inputs[1..])], "one", 1, "199 inputs are not whole points");
    check(&[Candidate { inputs_per_point: 0, ..one }], "one", 1, "no inputs");
    check(&[Candidate { outputs_per_point: 0, ..one }], "one", 1, "no outputs");
    let other_size = ComputeShader { workgroup_size: 32, ..one.shader };
    check(&[Candidate { shader: other_size, ..one }], "one", 1, "has the workgroup size [64, 1, 1]");
    let error = check(&[Candidate { outputs_per_point: 1_025, ..one }], "one", 1, "1025 asked");
    assert!(matches!(error, CheckError::Limit { .. }), "{error:?}");

    // One invocation in a workgroup, of which lavapipe allows 65535.
    let text = "@group(0) @binding(0) var<storage, read> inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;
@compute @workgroup_size(1) fn evaluate(@builtin(global_invocation_id) id: vec3u) { outputs[id.x] = inputs[id.x]; }";
    let spirv = wgsl_to_spirv("single.wgsl", text).unwrap();
    let many = vec![0.5; 70_000];
    let shader = ComputeShader { spirv: &spirv, entry: "evaluate", workgroup_size: 1, tables: &[] };
    let many = Candidate { name: "many", shader, inputs: &many, inputs_per_point: 1, outputs_per_point: 1 };
    let error = check(&[many], "many", 1, "the number of points of one dispatch: 70000 asked");
    assert!(matches!(error, CheckError::Limit { allowed: 65_535, .. }), "{error:?}");
}
