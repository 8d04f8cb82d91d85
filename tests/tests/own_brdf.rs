//! A user's own BRDF, written in the DSL: that of the example `own-brdf`. It is evaluated on the CPU, emitted in every
//! language, judged, and run on lavapipe.

#[path = "../../examples/own-brdf/src/brdf.rs"]
mod brdf;

use brdf::{lambert_phong, program};
use glam::{DVec3, Vec3};
use pavo_check::{ComputeShader, Device, judge_text, wgsl_to_spirv};
use pavo_emit::{Form, Language, Options, WORKGROUP_SIZE, emit_compute, emit_library};

fn options(language: Language) -> Options {
    let header = vec!["Lambert and Phong.".to_owned()];
    Options { language, header, prefix: "my_".to_owned(), source_lines: false }
}

/// A point of the BRDF, the inputs as they are passed.
fn points() -> Vec<[f32; 5]> {
    let fraction = |index: usize, step: f32| (index as f32 * step).fract();
    let point = |index| {
        let [r, g, b] = [0.317, 0.561, 0.741].map(|step| fraction(index, step));
        [fraction(index, 0.618_034), fraction(index, 0.754_877_7) * 2.0 - 1.0, r, g, b]
    };
    (0..10_000).map(point).collect()
}

#[test]
fn it_reads_as_it_was_written() {
    insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!("own-brdf.wgsl", emit_library(&program(), &options(Language::Wgsl)));
    });
}

#[test]
fn its_inputs_are_known_by_name_range_and_rate() {
    let program = program();
    let rows: Vec<String> = program
        .inputs()
        .iter()
        .map(|input| format!("{} [{}, {}] {}", input.name, input.low, input.high, input.rate.name()))
        .collect();
    assert_eq!(rows, ["n_dot_l [0, 1] pixel", "r_dot_v [-1, 1] pixel", "diffuse_color [0, 1] material"]);
}

#[test]
fn every_language_passes_its_judges() {
    for language in Language::ALL {
        let text = emit_library(&program(), &options(language));
        let verdicts = judge_text(language, Form::Library, "own-brdf", &text);
        assert!(verdicts.is_ok_and(|verdicts| !verdicts.is_empty()), "{}", language.name());
    }
}

#[test]
fn it_runs_on_lavapipe_as_on_the_cpu() {
    let text = emit_compute(&program(), &options(Language::Wgsl)).expect("WGSL has compute shaders");
    let spirv = wgsl_to_spirv("own-brdf.wgsl", &text).expect("naga takes it");
    let device = Device::lavapipe().expect("lavapipe is needed: `cargo xtask setup` installs it");
    let points = points();
    let shader = ComputeShader { spirv: &spirv, entry: "main", workgroup_size: WORKGROUP_SIZE, tables: &[] };
    let found = device.evaluate(&shader, points.as_flattened(), 5, 3).expect("it runs");
    for (point, found) in points.iter().zip(found.chunks_exact(3)) {
        let [n_dot_l, r_dot_v, r, g, b] = *point;
        let single = lambert_phong::<f32>(n_dot_l, r_dot_v, Vec3::new(r, g, b));
        let [n_dot_l, r_dot_v, r, g, b] = point.map(f64::from);
        let double = lambert_phong::<f64>(n_dot_l, r_dot_v, DVec3::new(r, g, b));
        for channel in 0..3 {
            assert!((found[channel] - single[channel]).abs() < 1e-7, "{point:?}: {found:?} and {single}");
            assert!((f64::from(found[channel]) - double[channel]).abs() < 2e-7, "{point:?}: {found:?} and {double}");
        }
    }
}
