//! What lavapipe computes is what the texts say.

use std::sync::OnceLock;

use pavo_check::{CheckError, ComputeShader, Device, RenderShaders, Stage, glsl_to_spirv, judge_spirv, wgsl_to_spirv};

/// The device that all tests share. Without lavapipe they fail, with what to install.
fn lavapipe() -> &'static Device {
    static DEVICE: OnceLock<Device> = OnceLock::new();
    DEVICE.get_or_init(|| Device::lavapipe().unwrap_or_else(|error| panic!("{error}")))
}

/// A kernel of `inputs` and `outputs` for each point, where `body` reads `inputs[i * inputs]` and writes its outputs.
fn wgsl_kernel(workgroup_size: u32, inputs_per_point: usize, body: &str) -> Vec<u32> {
    let text = format!(
        "@group(0) @binding(0) var<storage, read> inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;

@compute @workgroup_size({workgroup_size})
fn evaluate(@builtin(global_invocation_id) id: vec3<u32>) {{
    let i = id.x;
    if i >= arrayLength(&inputs) / {inputs_per_point}u {{
        return;
    }}
    {body}
}}
"
    );
    valid(wgsl_to_spirv("kernel.wgsl", &text).unwrap())
}

fn glsl_kernel(workgroup_size: u32, inputs_per_point: usize, body: &str) -> Vec<u32> {
    let text = format!(
        "#version 450
layout(local_size_x = {workgroup_size}) in;
layout(std430, set = 0, binding = 0) readonly buffer Inputs {{ float inputs[]; }};
layout(std430, set = 0, binding = 1) buffer Outputs {{ float outputs[]; }};

void main() {{
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(inputs.length()) / {inputs_per_point}u) {{
        return;
    }}
    {body}
}}
"
    );
    valid(glsl_to_spirv("kernel.comp", &text, Stage::Compute).unwrap())
}

fn valid(words: Vec<u32>) -> Vec<u32> {
    judge_spirv("test", &words).unwrap_or_else(|error| panic!("{error}"));
    words
}

/// The two roads of a kernel to SPIR-V, with the names of their entry points.
fn both_roads(workgroup_size: u32, inputs_per_point: usize, body: &str) -> [(Vec<u32>, &'static str); 2] {
    [
        (wgsl_kernel(workgroup_size, inputs_per_point, body), "evaluate"),
        (glsl_kernel(workgroup_size, inputs_per_point, body), "main"),
    ]
}

#[test]
fn the_device_is_lavapipe() {
    let description = lavapipe().description();
    assert!(description.is_lavapipe, "{description:?}");
    assert!(description.name.contains("llvmpipe"), "{description:?}");
    assert!(description.driver_info.starts_with("Mesa "), "{description:?}");
    assert!(description.api_version.starts_with("1."), "{description:?}");
}

#[test]
fn a_device_is_found_by_a_part_of_its_name() {
    let device = Device::named("LLVMPIPE").unwrap_or_else(|error| panic!("{error}"));
    assert!(device.description().is_lavapipe);
    let devices = Device::list().unwrap();
    assert!(devices.contains(device.description()), "{devices:?}");
    let error = Device::named("no such device").err().expect("a device of that name");
    assert_eq!(error.exit_status(), 3);
    assert!(error.to_string().contains("the devices found are: llvmpipe"), "{error}");
}

#[test]
fn a_million_cosines_agree_with_the_cpu() {
    let points = 1_000_000_u32;
    let inputs: Vec<f32> = (0..points).map(|i| i as f32 * 1.0e-2).collect();
    for (spirv, entry) in both_roads(64, 1, "outputs[i] = cos(inputs[i]);") {
        let shader = ComputeShader { spirv: &spirv, entry, workgroup_size: 64, tables: &[] };
        let outputs = lavapipe().evaluate(&shader, &inputs, 1, 1).unwrap();
        assert_eq!(outputs.len(), inputs.len());
        let differences = inputs.iter().zip(&outputs).map(|(x, y)| (f64::from(*x).cos() - f64::from(*y)).abs());
        let largest = differences.fold(0.0, f64::max);
        println!("{entry}: largest difference {largest:.2e}");
        assert!(largest < 1.0e-7, "{entry}: {largest:e}");
    }
}

#[test]
fn points_of_several_values_keep_their_order() {
    let body = "outputs[i * 2u] = inputs[i * 3u] + inputs[i * 3u + 1u]; outputs[i * 2u + 1u] = inputs[i * 3u + 2u];";
    // No multiple of the workgroup size, so that the last workgroup reaches beyond the last point.
    let inputs: Vec<f32> = (0..3 * 101_u16).map(f32::from).collect();
    let expected: Vec<f32> = inputs.chunks(3).flat_map(|point| [point[0] + point[1], point[2]]).collect();
    for (spirv, entry) in both_roads(16, 3, body) {
        let shader = ComputeShader { spirv: &spirv, entry, workgroup_size: 16, tables: &[] };
        assert_eq!(lavapipe().evaluate(&shader, &inputs, 3, 2).unwrap(), expected, "{entry}");
    }
}

#[test]
fn more_workgroups_than_one_dispatch_holds_are_run_in_pieces() {
    // lavapipe allows 65535 workgroups; with one invocation each, this takes four dispatches.
    let count = 200_003_u32;
    let inputs: Vec<f32> = (0..count).map(|i| i as f32).collect();
    let spirv = wgsl_kernel(1, 1, "outputs[i] = inputs[i] + 0.5;");
    let shader = ComputeShader { spirv: &spirv, entry: "evaluate", workgroup_size: 1, tables: &[] };
    let outputs = lavapipe().evaluate(&shader, &inputs, 1, 1).unwrap();
    assert_eq!(outputs.len(), inputs.len());
    let wrong = inputs.iter().zip(&outputs).position(|(x, y)| x + 0.5 != *y);
    assert_eq!(wrong, None);
}

#[test]
fn no_inputs_mean_one_point() {
    let spirv = wgsl_kernel(1, 1, "outputs[0] = 1.5; outputs[1] = f32(arrayLength(&inputs));");
    let shader = ComputeShader { spirv: &spirv, entry: "evaluate", workgroup_size: 1, tables: &[] };
    assert_eq!(lavapipe().evaluate(&shader, &[], 0, 2).unwrap(), [1.5, 1.0]);
    assert!(lavapipe().evaluate(&shader, &[], 1, 2).unwrap().is_empty());
}

#[test]
fn outputs_that_are_not_written_are_nan() {
    let spirv = wgsl_kernel(1, 1, "if i == 1u { outputs[i] = inputs[i]; }");
    let shader = ComputeShader { spirv: &spirv, entry: "evaluate", workgroup_size: 1, tables: &[] };
    let outputs = lavapipe().evaluate(&shader, &[5.0, 6.0, 7.0], 1, 1).unwrap();
    assert!(outputs[0].is_nan() && outputs[1] == 6.0 && outputs[2].is_nan(), "{outputs:?}");
}

#[test]
fn a_shader_that_does_not_fit_the_call_is_refused() {
    let device = lavapipe();
    let spirv = wgsl_kernel(8, 1, "outputs[i] = inputs[i];");
    let two_buffers = "@group(0) @binding(2) var<storage, read_write> more: array<f32>;
@compute @workgroup_size(8) fn evaluate() { more[0] = 1.0; }";
    let more = wgsl_to_spirv("more.wgsl", two_buffers).unwrap();
    let check =
        |spirv: &[u32], entry: &str, workgroup_size, inputs: &[f32], per_point: (usize, usize), expected: &str| {
            let shader = ComputeShader { spirv, entry, workgroup_size, tables: &[] };
            let error = device.evaluate(&shader, inputs, per_point.0, per_point.1).expect_err(expected);
            assert!(matches!(error, CheckError::Input(_)), "{error:?}");
            assert!(error.to_string().contains(expected), "{error}\nexpected: {expected}");
        };
    check(&spirv, "main", 8, &[1.0], (1, 1), "has no compute entry point `main`: it has `evaluate` (compute)");
    check(&spirv, "evaluate", 64, &[1.0], (1, 1), "has the workgroup size [8, 1, 1], expected [64, 1, 1]");
    check(&spirv, "evaluate", 0, &[1.0], (1, 1), "has the workgroup size");
    check(&spirv, "evaluate", 8, &[1.0; 5], (2, 1), "5 inputs are not whole points of 2 inputs each");
    check(&spirv, "evaluate", 8, &[1.0; 5], (0, 1), "5 inputs where a point has none");
    check(&spirv, "evaluate", 8, &[1.0], (1, 0), "at least one output");
    check(&spirv, "evaluate", 8, &[1.0; 2], (1, usize::MAX), "more than memory can hold");
    check(&more, "evaluate", 8, &[1.0], (1, 1), "declares a resource at set 0, binding 2");
    check(&spirv[..6], "evaluate", 8, &[1.0], (1, 1), "an instruction is longer than the module");
    check(&[], "evaluate", 8, &[1.0], (1, 1), "does not begin with the header");
}

#[test]
fn a_point_beyond_the_limits_of_the_device_is_refused() {
    let spirv = wgsl_kernel(8, 1, "outputs[i] = inputs[i];");
    let shader = ComputeShader { spirv: &spirv, entry: "evaluate", workgroup_size: 8, tables: &[] };
    let error = lavapipe().evaluate(&shader, &[1.0], 1, 1 << 40).expect_err("a terabyte of outputs");
    assert!(matches!(error, CheckError::Limit { .. }), "{error:?}");
    let large = wgsl_kernel(4_096, 1, "outputs[i] = inputs[i];");
    let shader = ComputeShader { spirv: &large, entry: "evaluate", workgroup_size: 4_096, tables: &[] };
    let error = lavapipe().evaluate(&shader, &[1.0], 1, 1).expect_err("a workgroup of 4096");
    assert!(matches!(error, CheckError::Limit { allowed: 1024, .. }), "{error:?}");
}

#[test]
fn a_device_is_shared_between_threads() {
    let spirv = wgsl_kernel(64, 1, "outputs[i] = inputs[i] * 2.0;");
    std::thread::scope(|scope| {
        for thread in 0..4_u8 {
            let spirv = &spirv;
            scope.spawn(move || {
                let shader = ComputeShader { spirv, entry: "evaluate", workgroup_size: 64, tables: &[] };
                let inputs = vec![f32::from(thread); 1_000];
                let outputs = lavapipe().evaluate(&shader, &inputs, 1, 1).unwrap();
                assert!(outputs.iter().all(|output| *output == 2.0 * f32::from(thread)));
            });
        }
    });
}

const WGSL_GRADIENT: &str = "\
struct Place {
    @builtin(position) position: vec4<f32>,
    @location(0) uv: vec2<f32>,
}

@vertex
fn place(@builtin(vertex_index) index: u32) -> Place {
    let corner = vec2<f32>(f32(index & 1u), f32(index >> 1u)) * 2.0;
    return Place(vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0), corner);
}

@fragment
fn shade(in: Place) -> @location(0) vec4<f32> {
    return vec4<f32>(in.position.xy, in.uv);
}
";

const GLSL_VERTEX: &str = "\
#version 450
layout(location = 0) out vec2 uv;
void main() {
    uv = vec2(float(gl_VertexIndex & 1), float(gl_VertexIndex >> 1)) * 2.0;
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
";

const GLSL_FRAGMENT: &str = "\
#version 450
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
void main() {
    color = vec4(gl_FragCoord.xy, uv);
}
";

/// The corners of a picture, from the top left row by row.
fn corners(pixels: &[[f32; 4]], width: usize, height: usize) -> [[f32; 4]; 4] {
    assert_eq!(pixels.len(), width * height);
    [pixels[0], pixels[width - 1], pixels[(height - 1) * width], pixels[height * width - 1]]
}

#[test]
fn a_gradient_begins_at_the_top_left() {
    let (width, height) = (8_u16, 4_u16);
    // Red and green are the fragment coordinates, in both languages from the top left. Blue and alpha are the position
    // in clip space from 0 to 1, with y upward in WGSL and downward in GLSL for Vulkan.
    let (right, bottom) = (f32::from(width) - 0.5, f32::from(height) - 0.5);
    let (near_x, near_y) = (0.5 / f32::from(width), 0.5 / f32::from(height));
    let expected = |top: f32, below: f32| {
        [
            [0.5, 0.5, near_x, top],
            [right, 0.5, 1.0 - near_x, top],
            [0.5, bottom, near_x, below],
            [right, bottom, 1.0 - near_x, below],
        ]
    };
    let module = valid(wgsl_to_spirv("gradient.wgsl", WGSL_GRADIENT).unwrap());
    let wgsl = RenderShaders { vertex: &module, vertex_entry: "place", fragment: &module, fragment_entry: "shade" };
    let vertex = valid(glsl_to_spirv("gradient.vert", GLSL_VERTEX, Stage::Vertex).unwrap());
    let fragment = valid(glsl_to_spirv("gradient.frag", GLSL_FRAGMENT, Stage::Fragment).unwrap());
    let glsl = RenderShaders { vertex: &vertex, vertex_entry: "main", fragment: &fragment, fragment_entry: "main" };
    for (shaders, expected) in [(wgsl, expected(1.0 - near_y, near_y)), (glsl, expected(near_y, 1.0 - near_y))] {
        let pixels = lavapipe().render(&shaders, u32::from(width), u32::from(height)).unwrap();
        let found = corners(&pixels, usize::from(width), usize::from(height));
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 1.0e-6, "{found} where {expected} is expected in {found:?}");
        }
    }
}

#[test]
fn pixels_that_are_not_drawn_are_zero_and_values_are_not_clamped() {
    let text = WGSL_GRADIENT.replace(
        "return vec4<f32>(in.position.xy, in.uv);",
        "if in.position.x < 1.0 { discard; } return vec4<f32>(-3.5, 1e20, 1e-20, 7.0);",
    );
    let module = valid(wgsl_to_spirv("discard.wgsl", &text).unwrap());
    let shaders = RenderShaders { vertex: &module, vertex_entry: "place", fragment: &module, fragment_entry: "shade" };
    assert_eq!(lavapipe().render(&shaders, 2, 1).unwrap(), [[0.0; 4], [-3.5, 1e20, 1e-20, 7.0]]);
}

#[test]
fn a_picture_that_cannot_be_drawn_is_refused() {
    let module = wgsl_to_spirv("gradient.wgsl", WGSL_GRADIENT).unwrap();
    let check = |vertex_entry: &str, fragment_entry: &str, width, height, expected: &str| {
        let shaders = RenderShaders { vertex: &module, vertex_entry, fragment: &module, fragment_entry };
        let error = lavapipe().render(&shaders, width, height).expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}\nexpected: {expected}");
    };
    check("main", "shade", 4, 4, "no vertex entry point `main`: it has `place` (vertex), `shade` (fragment)");
    check("place", "place", 4, 4, "no fragment entry point `place`");
    check("place", "shade", 0, 4, "a picture of 0 by 4 pixels is empty");
    check("place", "shade", 4, u32::MAX, "the height of a picture in pixels: 4294967295 asked, the device allows ");
}
