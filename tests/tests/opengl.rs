//! GLSL 3.30 and GLSL ES 3.00, which no Vulkan driver reads, are compiled and run by Mesa's OpenGL.

use pavo::points::spread;
use pavo::roads::numbers_taken;
use pavo::statistics::Difference;
use pavo::{Shading, ShadingQuantity, Variant, points_fragment, scene::Scene};
use pavo_check::judge_text;
use pavo_emit::{Form, Language};
use pavo_gl::{Api, GlDevice, GlError};
use pavo_tests::{SCENES, scene_file, starter};

/// The largest difference of the reflectance from the CPU in f32 and in f64, and that of what stands around it, which
/// is relative where it is above 1.
const REFLECTANCE: f64 = 1e-5;
const WHOLE: f64 = 1e-4;

const LANGUAGES: [(Language, Api); 2] = [(Language::Glsl330, Api::OpenGl33), (Language::Essl300, Api::OpenGlEs30)];

fn device(api: Api) -> GlDevice {
    let device = GlDevice::open(api).unwrap_or_else(|error| panic!("{error}"));
    assert!(device.description().contains("llvmpipe"), "it would run on {}", device.description());
    device
}

/// Runs a quantity by a driver and compares it with the CPU: what is wrong.
fn failures(
    device: &GlDevice,
    language: Language,
    shading: &Shading,
    quantity: ShadingQuantity,
    allowed: f64,
) -> Vec<String> {
    let label = format!("{} of {} by {}", quantity.name(), shading.scene().name, shading.variant());
    let text = points_fragment(shading, quantity, language).unwrap_or_else(|error| panic!("{label}: {error}"));
    judge_text(language, Form::Fragment, &label, &text).unwrap_or_else(|error| panic!("{label}: {error}"));
    let mut inputs = shading.inputs(quantity);
    for input in inputs.iter_mut().filter(|input| input.name == "cos_theta1") {
        (input.low, input.high) = (0.05, 1.0);
    }
    let points: Vec<Vec<f32>> = spread(&inputs, 20_000, 2)
        .into_iter()
        .map(|point| point.into_iter().map(|value| value as f32).collect())
        .collect();
    let components = shading.program(quantity).input_components();
    let found = device.evaluate(&text, &numbers_taken(shading, quantity, &points), components);
    let found: Vec<[f64; 3]> =
        found.unwrap_or_else(|error| panic!("{label}: {error}")).iter().map(|color| color.map(f64::from)).collect();
    let single = shading.evaluate_each_f32(quantity, &points).into_iter().map(|color| color.map(f64::from)).collect();
    let double: Vec<Vec<f64>> = points.iter().map(|point| point.iter().copied().map(f64::from).collect()).collect();
    let mut failures = Vec::new();
    for (against, expected) in [("f32", single), ("f64", shading.evaluate_each(quantity, &double))] {
        let difference = Difference::between(&found, &expected, 1);
        println!(
            "{} {label} against {against}: max {:.1e}, RMS {:.1e}",
            language.name(),
            difference.max_relative,
            difference.rms
        );
        if difference.max_relative > allowed || difference.not_finite > 0 {
            failures.push(format!("{} {label} against {against}: {difference:?}", language.name()));
        }
    }
    failures
}

#[test]
fn every_starter_scene_runs_in_opengl_as_on_the_cpu() {
    let mut wrong = Vec::new();
    for (language, api) in LANGUAGES {
        let device = device(api);
        for name in SCENES {
            let shading = starter(name);
            wrong.extend(failures(&device, language, &shading, ShadingQuantity::Reflectance, REFLECTANCE));
            let whole = if shading.scene().lights.punctual { ShadingQuantity::Radiance } else { ShadingQuantity::Brdf };
            wrong.extend(failures(&device, language, &shading, whole, WHOLE));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn tables_and_closed_forms_run_in_opengl_as_on_the_cpu() {
    let scene = Scene::load(&scene_file("soap-bubble")).unwrap_or_else(|error| panic!("{error}"));
    let mut wrong = Vec::new();
    for (language, api) in LANGUAGES {
        let device = device(api);
        for variant in ["poles:k=5", "windowed:k=6", "series:m=3,fit=exact", "spectral:n=16"] {
            let variant: Variant = variant.parse().expect("a variant");
            let shading = Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{variant}: {error}"));
            wrong.extend(failures(&device, language, &shading, ShadingQuantity::Reflectance, REFLECTANCE));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_wrong_shader_is_refused_with_the_log_of_the_driver() {
    let device = device(Api::OpenGlEs30);
    let text = "#version 300 es\nprecision highp float;\nout vec4 color;\nvoid main() { color = vec4(undeclared); }\n";
    match device.evaluate(text, &[vec![1.0]], 1) {
        Err(GlError::Refused { stage: "fragment", log, .. }) => assert!(log.contains("undeclared"), "{log}"),
        other => panic!("{other:?}"),
    }
    let text = text.replace("undeclared", "1.0");
    assert!(matches!(device.evaluate(&text, &[vec![1.0, 2.0]], 1), Err(GlError::Points { index: 0, .. })));
}
