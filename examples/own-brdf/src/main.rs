//! Prints a BRDF of one's own as WGSL, judged, and says how far a device is from the CPU.

mod brdf;

use brdf::{lambert_phong, program};
use glam::{DVec3, Vec3};
use pavo_check::{CheckError, ComputeShader, Device, judge_text, wgsl_to_spirv};
use pavo_emit::{Form, Language, Options, WORKGROUP_SIZE, emit_compute, emit_library};
use std::error::Error;
use std::process::ExitCode;

/// How far the device may be from the CPU in double precision.
const LARGEST_DIFFERENCE: f64 = 2e-7;

fn main() -> ExitCode {
    match run() {
        Ok(difference) if difference <= LARGEST_DIFFERENCE => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(error) => {
            say_error(&error.to_string());
            ExitCode::from(error.downcast_ref::<CheckError>().map_or(1, CheckError::exit_status))
        }
    }
}

#[allow(clippy::print_stderr)]
fn say_error(message: &str) {
    eprintln!("error: {message}");
}

fn run() -> Result<f64, Box<dyn Error>> {
    // The function is one of numbers ...
    let color = lambert_phong::<f32>(0.8, 0.95, Vec3::new(0.5, 0.2, 0.1));
    // ... and one of the graph, which is printed in each language.
    let options = |language| Options {
        language,
        header: vec!["Lambert and Phong.".to_owned()],
        prefix: "my_".to_owned(),
        source_lines: false,
    };
    for language in Language::ALL {
        let text = emit_library(&program(), &options(language));
        let verdicts = judge_text(language, Form::Library, "own-brdf", &text)?;
        if language == Language::Wgsl {
            println!("{text}");
        }
        let judges: Vec<String> = verdicts.iter().map(|verdict| verdict.judge.described()).collect();
        println!("{:<8} passed by {}", language.name(), judges.join(", "));
    }
    println!("\nOn the CPU: {color}");
    // With an entry point it runs on a device.
    let text = emit_compute(&program(), &options(Language::Wgsl))?;
    let spirv = wgsl_to_spirv("own-brdf.wgsl", &text)?;
    let device = Device::lavapipe()?;
    let shader = ComputeShader { spirv: &spirv, entry: "main", workgroup_size: WORKGROUP_SIZE, tables: &[] };
    let points: Vec<[f32; 5]> =
        (0..=1000).map(|step| step as f32 / 1000.0).map(|t| [t, 2.0 * t - 1.0, t, 1.0 - t, 0.5]).collect();
    let found = device.evaluate(&shader, points.as_flattened(), 5, 3)?;
    let mut largest = 0.0_f64;
    for (point, found) in points.iter().zip(found.chunks_exact(3)) {
        let [n_dot_l, r_dot_v, r, g, b] = point.map(f64::from);
        let expected = lambert_phong::<f64>(n_dot_l, r_dot_v, DVec3::new(r, g, b)).to_array();
        for (found, expected) in found.iter().zip(expected) {
            let difference = (f64::from(*found) - expected).abs();
            largest = if difference.is_nan() { f64::INFINITY } else { largest.max(difference) };
        }
    }
    println!("On {}: {} points, at most {largest:.1e} from the CPU in f64", device.description(), points.len());
    Ok(largest)
}
