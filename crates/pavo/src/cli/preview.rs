//! `pavo preview`: a lit sphere, rendered on lavapipe by the emitted fragment shader.

use super::arguments;
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use super::sources::Source;
use crate::inputs::ShadingQuantity;
use crate::target::Target;
use pavo_check::{Device, RenderShaders, judge_spirv, wgsl_to_spirv};
use pavo_emit::{Form, full_screen_triangle};
use pavo_spectra::ColourSpace;
use pavo_spectra::colour_space::srgb_encode;

/// Samples a side that make up a pixel.
const OVERSAMPLING: u32 = 2;

/// Renders the sphere and writes the picture.
pub fn run(arguments: &arguments::Preview) -> Result<(), Failure> {
    let source = Source::load(&arguments.scene, arguments.variant.as_deref())?;
    if !source.shading.sphere_program().tables().is_empty() {
        return Err(Failure::input(
            format!(
                "{} reads tables, and lavapipe takes minutes to compile those of a fragment shader",
                source.shading.variant()
            ),
            "take another variant for the picture, such as --variant windowed:k=6",
        ));
    }
    let progress = Progress::start();
    progress.step("emitting the fragment shader");
    let fragment = source.emit(Target::Spirv, Form::Fragment, ShadingQuantity::Radiance)?;
    let words = fragment.bytes.chunks_exact(4);
    let fragment_words: Vec<u32> = words.map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect();
    let vertex_words = wgsl_to_spirv("triangle.wgsl", full_screen_triangle())?;
    judge_spirv("triangle.spv", &vertex_words)?;
    progress.step("rendering on lavapipe");
    let device = Device::lavapipe()?;
    let shaders = RenderShaders {
        vertex: &vertex_words,
        vertex_entry: "main",
        fragment: &fragment_words,
        fragment_entry: "main",
    };
    let side = arguments.size * OVERSAMPLING;
    let samples = device.render(&shaders, side, side)?;
    let space = ColourSpace::from_name(&source.shading.scene().colour.space)
        .map_err(|error| Failure::input(error, "see colour.space of the scene"))?;
    let picture = encode(&pixels(&samples, arguments.size, space), arguments.size)
        .map_err(|error| Failure::check(format!("the picture cannot be encoded: {error}")))?;
    output::write(&arguments.output, &picture)?;
    drop(progress);
    output::print(&format!("{}\n", arguments.output.display()))
}

/// Averages the samples of each pixel and maps the colour to sRGB.
fn pixels(samples: &[[f32; 4]], size: u32, space: ColourSpace) -> Vec<u8> {
    let to_srgb = matrix_to_srgb(space);
    let exposure = exposure(samples);
    let (size, oversampling) = (size as usize, OVERSAMPLING as usize);
    let mut bytes = Vec::with_capacity(size * size * 3);
    for row in 0..size {
        for column in 0..size {
            let mut sum = [0.0_f64; 3];
            for sample in 0..oversampling * oversampling {
                let y = row * oversampling + sample / oversampling;
                let x = column * oversampling + sample % oversampling;
                let color = samples[y * size * oversampling + x];
                let linear =
                    to_srgb.map(|row| (0..3).map(|channel| row[channel] * f64::from(color[channel]) * exposure).sum());
                for (sum, value) in sum.iter_mut().zip(tone_mapped(linear)) {
                    *sum += value;
                }
            }
            let count = (oversampling * oversampling) as f64;
            bytes.extend(sum.map(|value| (srgb_encode(value / count) * 255.0).round() as u8));
        }
    }
    bytes
}

/// What brings the brighter parts of the picture to one level, whether a surface mirrors 4 % or all of the light: a
/// factor that puts the ninetieth percentile of the sphere at 0.8.
fn exposure(samples: &[[f32; 4]]) -> f64 {
    let brightness = samples.iter().map(|color| color[..3].iter().copied().fold(0.0, f32::max));
    let mut lit: Vec<f32> = brightness.filter(|value| value.is_finite() && *value > 0.0).collect();
    lit.sort_by(f32::total_cmp);
    lit.get(lit.len() * 9 / 10).map_or(1.0, |level| 0.8 / f64::from(*level))
}

/// Highlights are compressed by the brightest channel, so that hues stay.
///
/// Source: Reinhard et al. 2002, equation 4, with white at 4.
fn tone_mapped(linear: [f64; 3]) -> [f64; 3] {
    const WHITE: f64 = 4.0;
    let brightest = linear.iter().copied().fold(0.0, f64::max);
    let scale = (1.0 + brightest / (WHITE * WHITE)) / (1.0 + brightest) * 1.3;
    linear.map(|value| value * scale)
}

fn matrix_to_srgb(space: ColourSpace) -> [[f64; 3]; 3] {
    let (from, to) = (space.rgb_to_xyz(), ColourSpace::LinearSrgb.xyz_to_rgb());
    std::array::from_fn(|row| std::array::from_fn(|column| (0..3).map(|k| to[row][k] * from[k][column]).sum()))
}

fn encode(bytes: &[u8], size: u32) -> Result<Vec<u8>, png::EncodingError> {
    let mut picture = Vec::new();
    let mut encoder = png::Encoder::new(&mut picture, size, size);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(bytes)?;
    writer.finish()?;
    Ok(picture)
}
