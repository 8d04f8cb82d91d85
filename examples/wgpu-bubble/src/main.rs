//! A soap bubble with wgpu. `build.rs` makes the functions of its film, in WGSL and in Rust.
//!
//! Draws into a picture in floating point, compares each pixel with the CPU, and writes a PNG. With the feature `window`
//! and the argument `--window` it shows the bubble instead.

#[allow(dead_code)]
mod bubble {
    include!(concat!(env!("OUT_DIR"), "/bubble.rs"));
}
mod cpu;
mod gpu;
#[cfg(feature = "window")]
mod window;

use bubble::SurfaceUniforms;
use glam::Vec2;
use gpu::{Gpu, SIZE};
use std::error::Error;
use std::process::ExitCode;

/// How far a pixel may be from the CPU.
const LARGEST_DIFFERENCE: f32 = 1e-5;

const USAGE: &str = "\
Usage: wgpu-bubble [FILE.png]    draws to a picture (bubble.png) and checks it against the CPU
       wgpu-bubble --window      shows the bubble, where it is built with --features window";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let result = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => draw("bubble.png"),
        ["--window"] => show(),
        ["-h" | "--help"] => {
            println!("{USAGE}");
            Ok(ExitCode::SUCCESS)
        }
        [path] if !path.starts_with('-') => draw(path),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    result.unwrap_or_else(|error| {
        eprintln!("error: {error}");
        ExitCode::from(3)
    })
}

/// Of a broad highlight: a sharp one, as of roughness 0.3, amplifies what single precision rounds to some 1e-4.
fn surface() -> SurfaceUniforms {
    SurfaceUniforms::new(0.5, [1.0, 0.97, 0.92], 2.0)
}

fn draw(path: &str) -> Result<ExitCode, Box<dyn Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let gpu = Gpu::new(&instance, None)?;
    let surface = surface();
    let pixels = gpu::picture(&gpu, &surface)?;
    let half = SIZE as f32 / 2.0;
    let mut largest = 0.0_f32;
    for (index, pixel) in (0..).zip(&pixels) {
        let (column, row) = (index % SIZE, index / SIZE);
        let position = Vec2::new(column as f32 + 0.5 - half, half - (row as f32 + 0.5)) / half;
        let expected = cpu::bubble(position, &surface).to_array();
        for (found, expected) in pixel.iter().zip(expected) {
            let difference = (found - expected).abs();
            // What is no number is as far off as can be.
            largest = if difference.is_nan() { f32::INFINITY } else { largest.max(difference) };
        }
    }
    write_png(path, &pixels)?;
    println!("{path}: drawn on {}", gpu.adapter.get_info().name);
    println!("{} pixels, at most {largest:.1e} from the CPU (allowed: {LARGEST_DIFFERENCE:e})", pixels.len());
    Ok(if largest <= LARGEST_DIFFERENCE { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Writes linear pixels as an sRGB picture, beside its place first.
fn write_png(path: &str, pixels: &[[f32; 4]]) -> Result<(), Box<dyn Error>> {
    let encoded = |linear: f32| {
        let linear = linear.clamp(0.0, 1.0);
        let value = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
        (value * 255.0).round() as u8
    };
    let bytes: Vec<u8> = pixels.iter().flat_map(|[r, g, b, _]| [*r, *g, *b].map(encoded)).collect();
    let beside = format!("{path}.partial");
    let mut encoder = png::Encoder::new(std::fs::File::create(&beside)?, SIZE, SIZE);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    writer.finish()?;
    std::fs::rename(beside, path)?;
    Ok(())
}

#[cfg(feature = "window")]
fn show() -> Result<ExitCode, Box<dyn Error>> {
    window::show(surface())?;
    Ok(ExitCode::SUCCESS)
}

#[cfg(not(feature = "window"))]
fn show() -> Result<ExitCode, Box<dyn Error>> {
    Err("built without a window; run `cargo run --features window -- --window`".into())
}
