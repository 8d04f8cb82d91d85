//! `pavo preview`: a lit sphere, rendered on lavapipe by the emitted fragment shader.

use super::arguments;
use super::failure::Failure;
use super::output;
use super::picture::png;
use super::progress::Progress;
use super::sources::Source;
use super::sphere::{Display, bytes, is_renderable, render};
use super::work;
use pavo_check::Device;

/// Samples a side that make up a pixel.
const OVERSAMPLING: u32 = 2;
/// The smallest picture, pixels a side.
const SMALLEST_SIZE: f64 = 16.0;

/// Renders the sphere and writes the picture.
pub fn run(arguments: &arguments::Preview) -> Result<(), Failure> {
    let size = size(arguments.size)?;
    let source = Source::load(&arguments.scene, arguments.variant.as_deref())?;
    if !is_renderable(&source.shading) {
        return Err(Failure::input(
            format!(
                "{} reads tables, and lavapipe takes minutes to compile those of a fragment shader",
                source.shading.variant()
            ),
            "take another variant for the picture, such as --variant windowed:k=6",
        ));
    }
    let progress = Progress::start();
    progress.step("rendering on lavapipe");
    let samples = render(&source, &Device::lavapipe()?, size * OVERSAMPLING)?;
    let space = source.shading.sensitivities().space();
    let pixels = Display::of(&samples, space).pixels(&samples, size, OVERSAMPLING);
    let picture = png(&bytes(&pixels), (size, size))
        .map_err(|error| Failure::check(format!("the picture cannot be encoded: {error}")))?;
    output::write(&arguments.output, &picture)?;
    drop(progress);
    output::print(&format!("{}\n", arguments.output.display()))
}

/// The size of a picture that can be seen and can be held.
fn size(asked: f64) -> Result<u32, Failure> {
    work::PIXELS.check(&format!("`--size {asked}`"), asked)?;
    if asked < SMALLEST_SIZE {
        return Err(Failure::input(format!("a picture of {asked} pixels a side"), "take 16 to 4096 pixels"));
    }
    Ok(asked as u32)
}
