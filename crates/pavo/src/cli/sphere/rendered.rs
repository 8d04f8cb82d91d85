//! The sphere by the emitted fragment shader on lavapipe.

use crate::cli::failure::Failure;
use crate::cli::sources::Source;
use crate::inputs::ShadingQuantity;
use crate::shading::Shading;
use crate::target::Target;
use pavo_check::{Device, RenderShaders, judge_spirv, wgsl_to_spirv};
use pavo_emit::{Form, full_screen_triangle};

/// Whether lavapipe renders the sphere in good time: it takes minutes to compile the tables of a fragment shader.
pub fn is_renderable(shading: &Shading) -> bool {
    shading.sphere_program().tables().is_empty()
}

/// The radiance of the samples of a square picture, row by row from the top.
pub fn render(source: &Source, device: &Device, side: u32) -> Result<Vec<[f64; 3]>, Failure> {
    let fragment = source.emit(Target::Spirv, Form::Fragment, ShadingQuantity::Radiance)?;
    let words = fragment.bytes.chunks_exact(4);
    let fragment_words: Vec<u32> = words.map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect();
    let vertex_words = wgsl_to_spirv("triangle.wgsl", full_screen_triangle())?;
    judge_spirv("triangle.spv", &vertex_words)?;
    let shaders = RenderShaders {
        vertex: &vertex_words,
        vertex_entry: "main",
        fragment: &fragment_words,
        fragment_entry: "main",
    };
    let samples = device.render(&shaders, side, side)?;
    Ok(samples.into_iter().map(|[red, green, blue, _]| [red, green, blue].map(f64::from)).collect())
}
