//! What emitted shaders cost: on graphics cards, as their compiler counts it, and in time on lavapipe.

use pavo::scene::Scene;
use pavo::{Shading, ShadingQuantity, Variant, compute, cost, cost_baseline};
use pavo_check::static_cost::{NetCost, StaticCompiler, net};
use pavo_check::timing::{Candidate, compare};
use pavo_check::{ComputeShader, Device, Stage, judge_glsl, judge_wgsl, wgsl_to_spirv};
use pavo_emit::{EmitError, Language, WORKGROUP_SIZE};
use pavo_tests::{SCENES, scene_file, starter};

const REFLECTANCE: ShadingQuantity = ShadingQuantity::Reflectance;

fn open(family: &str) -> StaticCompiler {
    StaticCompiler::open(family).unwrap_or_else(|error| panic!("{family}: {error}"))
}

/// A starter scene with a variant of one's own.
fn scene_with(name: &str, variant: &str) -> Shading {
    let scene = Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let variant: Variant = variant.parse().unwrap_or_else(|error| panic!("{variant}: {error}"));
    Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The net cost of a quantity in one of the two languages.
fn net_cost(compiler: &StaticCompiler, shading: &Shading, quantity: ShadingQuantity, language: Language) -> NetCost {
    let whole = cost(shading, quantity, language).expect("the language has such an entry");
    let baseline = cost_baseline(shading, quantity, language).expect("the language has such an entry");
    let [whole, baseline] = [whole, baseline].map(|text| {
        let found = match language {
            Language::Wgsl => compiler.wgsl("cost.wgsl", &text, "main"),
            _ => compiler.glsl("cost.frag", &text),
        };
        found.unwrap_or_else(|error| panic!("{error}\n{text}"))
    });
    net(&whole, &baseline).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_texts_pass_every_judge() {
    for name in SCENES {
        let shading = starter(name);
        for quantity in [REFLECTANCE, ShadingQuantity::Brdf, ShadingQuantity::Directions] {
            let emit = |language: Language| {
                let (whole, baseline) =
                    (cost(&shading, quantity, language), cost_baseline(&shading, quantity, language));
                [whole, baseline].map(|text| text.unwrap_or_else(|error| panic!("{name}: {error}")))
            };
            for text in emit(Language::Wgsl) {
                judge_wgsl(Some(Stage::Fragment), "cost.wgsl", &text)
                    .unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
            }
            for text in emit(Language::Glsl450) {
                judge_glsl(Stage::Fragment, "cost.frag", &text)
                    .unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
            }
        }
    }
}

#[test]
fn other_languages_are_refused() {
    for language in [Language::Glsl330, Language::Essl300, Language::Hlsl, Language::Osl] {
        let shading = starter("soap-bubble");
        for emitted in [cost(&shading, REFLECTANCE, language), cost_baseline(&shading, REFLECTANCE, language)] {
            let error = emitted.expect_err(language.name());
            assert!(matches!(error, EmitError::NoCost { .. }), "{error}");
            assert!(error.to_string().contains(language.name()), "{error}");
        }
    }
}

#[test]
fn every_starter_scene_costs_something_on_each_family() {
    for family in ["navi21", "vega10", "gfx1100"] {
        let compiler = open(family);
        for name in SCENES {
            let shading = starter(name);
            let of = |quantity| net_cost(&compiler, &shading, quantity, Language::Wgsl);
            let (reflectance, radiance) = (of(REFLECTANCE), of(ShadingQuantity::Radiance));
            println!(
                "{family} {name} {}: reflectance {} instructions / {}, radiance {} / {}",
                shading.variant(),
                reflectance.instructions,
                reflectance.inverse_throughput,
                radiance.instructions,
                radiance.inverse_throughput
            );
            assert!(reflectance.instructions > 0 && reflectance.inverse_throughput > 0, "{name}: {reflectance:?}");
            assert!(radiance.instructions > reflectance.instructions, "{name}: {radiance:?} {reflectance:?}");
        }
    }
}

#[test]
fn a_finer_variant_costs_more() {
    let compiler = open("navi21");
    for language in [Language::Wgsl, Language::Glsl450] {
        for variants in [["poles:k=4", "poles:k=5", "poles:k=8"], ["nodes:n=6", "nodes:n=8", "nodes:n=16"]] {
            let costs = variants.map(|variant| {
                let net = net_cost(&compiler, &scene_with("oil-on-water", variant), REFLECTANCE, language);
                println!("{} {variant}: {net:?}", language.name());
                net
            });
            assert!(costs.is_sorted_by(|a, b| a.instructions < b.instructions), "{costs:?}");
            assert!(costs.is_sorted_by(|a, b| a.inverse_throughput < b.inverse_throughput), "{costs:?}");
        }
    }
}

#[test]
fn a_spectral_sum_takes_longer_than_a_fit_on_lavapipe() {
    let device = Device::lavapipe().unwrap_or_else(|error| panic!("{error}"));
    let kernels = ["windowed:k=4", "spectral:n=81"].map(|variant| {
        let shading = scene_with("oil-on-water", variant);
        let text = compute(&shading, REFLECTANCE, Language::Wgsl).expect("WGSL has compute shaders");
        let spirv = wgsl_to_spirv("kernel.wgsl", &text).unwrap_or_else(|error| panic!("{variant}: {error}"));
        (variant, spirv, shading.program(REFLECTANCE).input_components())
    });
    let inputs: Vec<f32> = (0..20_000 * kernels[0].2).map(|i| (i as f32 * 0.618_034).fract()).collect();
    let candidates: Vec<Candidate<'_>> = kernels
        .iter()
        .map(|(name, spirv, inputs_per_point)| Candidate {
            name,
            shader: ComputeShader { spirv, entry: "main", workgroup_size: WORKGROUP_SIZE, tables: &[] },
            inputs: &inputs,
            inputs_per_point: *inputs_per_point,
            outputs_per_point: 3,
        })
        .collect();
    let found = compare(&device, &candidates, "spectral:n=81", 5).unwrap_or_else(|error| panic!("{error}"));
    println!("{found:#?}");
    assert!(found.timings[0].gross.median < found.timings[1].gross.median, "{found:#?}");
}
