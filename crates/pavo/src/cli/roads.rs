//! The three roads by which emitted code runs on lavapipe.

use super::failure::Failure;
use super::sources::Source;
use crate::inputs::ShadingQuantity;
use crate::target::Target;
use pavo_check::{ComputeShader, Device, Stage, glsl_to_spirv, judge_spirv, wgsl_to_spirv};
use pavo_emit::{Form, Language, WORKGROUP_SIZE};
use pavo_shade::{Input, Table};

/// A way from the emitted code to the device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Road {
    /// The emitted WGSL, made SPIR-V by naga.
    Wgsl,
    /// The emitted GLSL 4.50, made SPIR-V by glslang.
    Glsl,
    /// The emitted SPIR-V as it is.
    Spirv,
}

impl Road {
    /// All roads.
    pub const ALL: [Road; 3] = [Road::Wgsl, Road::Glsl, Road::Spirv];

    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Road::Wgsl => "wgsl by naga",
            Road::Glsl => "glsl450 by glslang",
            Road::Spirv => "spirv as emitted",
        }
    }

    /// The SPIR-V that this road brings to the device.
    fn spirv(self, source: &Source, quantity: ShadingQuantity) -> Result<Vec<u32>, Failure> {
        let target = match self {
            Road::Wgsl => Target::Text(Language::Wgsl),
            Road::Glsl => Target::Text(Language::Glsl450),
            Road::Spirv => Target::Spirv,
        };
        let emitted = source.emit(target, Form::Compute, quantity)?;
        let text = String::from_utf8_lossy(&emitted.bytes);
        let words = match self {
            Road::Wgsl => wgsl_to_spirv(&emitted.file, &text)?,
            Road::Glsl => glsl_to_spirv(&emitted.file, &text, Stage::Compute)?,
            Road::Spirv => {
                let words = emitted.bytes.chunks_exact(4);
                words.map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect()
            }
        };
        judge_spirv(&emitted.file, &words)?;
        Ok(words)
    }
}

/// Evaluates a quantity at many points by a road.
pub fn evaluate(
    device: &Device,
    road: Road,
    source: &Source,
    quantity: ShadingQuantity,
    points: &[Vec<f32>],
) -> Result<Vec<[f32; 3]>, Failure> {
    let words = road.spirv(source, quantity)?;
    let program = source.shading.program(quantity);
    let columns = columns(&source.shading.inputs(quantity), program.inputs());
    let inputs: Vec<f32> = points.iter().flat_map(|point| columns.iter().map(|&column| point[column])).collect();
    let tables: Vec<Vec<f32>> = program.tables().iter().map(table_numbers).collect();
    let shader = ComputeShader { spirv: &words, entry: "main", workgroup_size: WORKGROUP_SIZE, tables: &tables };
    let outputs = device.evaluate(&shader, &inputs, columns.len(), 3)?;
    let mut colors: Vec<[f32; 3]> = outputs.chunks_exact(3).map(|color| [color[0], color[1], color[2]]).collect();
    if columns.is_empty() {
        // A program without inputs gives the same colour at each point.
        colors = vec![colors.first().copied().unwrap_or([f32::NAN; 3]); points.len()];
    }
    Ok(colors)
}

/// A table as a buffer holds it: a fourth number after each three.
fn table_numbers(table: &Table) -> Vec<f32> {
    table.rows.iter().flat_map(|[x, y, z]| [*x as f32, *y as f32, *z as f32, 0.0]).collect()
}

/// Where each number that the program takes stands in a point.
fn columns(declared: &[Input], taken: &[Input]) -> Vec<usize> {
    let mut columns = Vec::new();
    let mut offset = 0;
    for input in declared {
        if taken.iter().any(|other| other.name == input.name) {
            columns.extend(offset..offset + input.components());
        }
        offset += input.components();
    }
    columns
}
