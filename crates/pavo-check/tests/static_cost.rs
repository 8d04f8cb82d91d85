//! The cost of fragment shaders on graphics cards that are not here.

use std::sync::OnceLock;

use pavo_check::CheckError;
use pavo_check::static_cost::{FAMILIES, StaticCompiler, StaticCost, net};

/// The compiler of a family, one for all tests. Without RADV they fail, with what to install.
fn compiler(family: &str) -> &'static StaticCompiler {
    static COMPILERS: OnceLock<Vec<StaticCompiler>> = OnceLock::new();
    let open = |name: &'static str| StaticCompiler::open(name).unwrap_or_else(|error| panic!("{name}: {error}"));
    let all = COMPILERS.get_or_init(|| FAMILIES.iter().map(|family| open(family.name)).collect());
    all.iter().find(|compiler| compiler.family().name == family).unwrap()
}

/// A shader that adds up that many exponentials and as many cosines of its input.
fn waves(count: usize) -> String {
    let terms: Vec<String> = (0..count).map(|i| format!("exp(-0.{}1 * x) * cos({}.5 * x + y)", i + 1, i + 1)).collect();
    let sum = if terms.is_empty() { "x + y".to_owned() } else { terms.join(" + ") };
    format!(
        "@fragment fn shade(@location(0) x: f32, @location(1) y: f32) -> @location(0) vec4f {{ return vec4f({sum}); }}"
    )
}

fn cost(family: &str, text: &str) -> StaticCost {
    compiler(family).wgsl("cost.wgsl", text, "shade").unwrap_or_else(|error| panic!("{family}: {error}\n{text}"))
}

#[test]
fn the_figures_are_plausible_and_name_the_driver() {
    let cost = cost("navi21", &waves(8));
    println!("{cost:#?}");
    assert_eq!((cost.family, cost.driver.as_str()), ("navi21", "radv"));
    assert!(cost.driver_version.starts_with("Mesa "), "{cost:?}");
    for (what, value, low, high) in [
        ("instructions", cost.instructions, 30, 130),
        ("inverse throughput", cost.inverse_throughput, 40, 250),
        ("latency", cost.latency, 40, 2_000),
        ("VGPRs", cost.vgprs, 4, 64),
        ("SGPRs", cost.sgprs, 1, 128),
        ("code size", cost.code_size, 100, 2_000),
        ("spilled VGPRs", cost.spilled_vgprs, 0, 0),
        ("spilled SGPRs", cost.spilled_sgprs, 0, 0),
    ] {
        assert!((low..=high).contains(&value), "{what}: {value} is not in [{low}, {high}]");
    }
}

#[test]
fn more_work_costs_more_on_each_family() {
    for family in FAMILIES {
        let costs: Vec<StaticCost> = [0, 1, 2, 4, 8].map(|count| cost(family.name, &waves(count))).into();
        for pair in costs.windows(2) {
            let net = net(&pair[1], &pair[0]).unwrap();
            assert!(net.instructions > 0 && net.inverse_throughput > 0 && net.code_size > 0, "{pair:#?}");
        }
    }
}

#[test]
fn families_differ() {
    let costs = FAMILIES.iter().map(|family| cost(family.name, &waves(8)));
    let mut figures: Vec<_> = costs.map(|cost| (cost.inverse_throughput, cost.latency, cost.code_size)).collect();
    println!("{figures:?}");
    figures.sort_unstable();
    figures.dedup();
    assert_eq!(figures.len(), FAMILIES.len(), "{figures:?}");
}

#[test]
fn figures_are_the_same_in_each_run() {
    let text = waves(5);
    let first = cost("vega10", &text);
    let others: Vec<StaticCost> = std::thread::scope(|scope| {
        let again = |_| scope.spawn(|| StaticCompiler::open("vega10").unwrap().wgsl("a.wgsl", &text, "shade").unwrap());
        let threads: Vec<_> = (0..4).map(again).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert!(others.iter().all(|other| *other == first), "{first:?} {others:?}");
}

#[test]
fn both_languages_cost_the_same() {
    let glsl = "#version 450
layout(location = 0) in float x;
layout(location = 1) in vec3 v;
layout(location = 2) flat in ivec2 n;
layout(location = 0) out vec4 color;
void main() { color = vec4(v * exp(x), float(n.x * n.y)); }
";
    let wgsl = "@fragment
fn shade(@location(0) x: f32, @location(1) v: vec3f, @location(2) @interpolate(flat) n: vec2i) -> @location(0) vec4f {
    return vec4f(v * exp(x), f32(n.x * n.y));
}
";
    let by_glslang = compiler("navi21").glsl("cost.frag", glsl).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(by_glslang, cost("navi21", wgsl));
}

#[test]
fn each_input_is_kept() {
    let sum = |count: usize| {
        let parameters: Vec<String> = (0..count).map(|i| format!("@location({i}) v{i}: vec4f")).collect();
        let terms: Vec<String> = (0..count).map(|i| format!("v{i}")).collect();
        let (parameters, sum) = (parameters.join(", "), terms.join(" + "));
        cost("navi21", &format!("@fragment fn shade({parameters}) -> @location(0) vec4f {{ return {sum}; }}"))
    };
    let (one, two, three) = (sum(1), sum(2), sum(3));
    // Four components that are each interpolated in two steps and added in one.
    let (second, third) = (net(&two, &one).unwrap(), net(&three, &two).unwrap());
    assert!(second.instructions >= 12 && third.instructions >= 12, "{second:?} {third:?}");
}

#[test]
fn what_cannot_be_costed_is_refused() {
    let error = StaticCompiler::open("navi99").err().expect("a family that is none");
    assert!(matches!(error, CheckError::Input(_)), "{error:?}");
    let message = error.to_string();
    assert!(message.contains("`navi99`"), "{message}");
    assert!(FAMILIES.iter().all(|family| message.contains(family.name)), "{message}");

    let refused = |text: &str, entry: &str, expected: &str| {
        let error = compiler("navi21").wgsl("cost.wgsl", text, entry).expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}\nexpected: {expected}");
    };
    refused(&waves(1), "main", "has no fragment entry point `main`: it has `shade` (fragment)");
    refused("@fragment fn shade() -> oops {}", "shade", "refused by naga");
    let uniform = "@group(1) @binding(2) var<uniform> x: vec4f;
@fragment fn shade() -> @location(0) vec4f { return x; }";
    refused(uniform, "shade", "declares a resource at set 1, binding 2: provided: none are");
    assert!(matches!(compiler("navi21").spirv(&[], "shade"), Err(CheckError::Input(_))));

    let (navi21, vega10) = (cost("navi21", &waves(1)), cost("vega10", &waves(1)));
    let message = net(&navi21, &vega10).expect_err("two families").to_string();
    assert!(message.contains("navi21") && message.contains("vega10"), "{message}");
}
