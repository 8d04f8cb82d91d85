//! The roads by which emitted code runs on a device.

use crate::inputs::ShadingQuantity;
use crate::points::columns;
use crate::{Shading, compute};
use pavo_check::wgsl_to_spirv;
use pavo_check::{CheckError, ComputeShader, Device, Stage, glsl_to_spirv, hlsl_to_spirv, judge_spirv, judge_text};
use pavo_emit::{Dialect, EmitError, Form, Language, WORKGROUP_SIZE};
use pavo_shade::{Input, Table};
use thiserror::Error;

/// A way from the emitted code to the device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Road {
    /// The emitted WGSL, made SPIR-V by naga.
    Wgsl,
    /// The emitted GLSL 4.50, made SPIR-V by glslang.
    Glsl,
    /// The emitted HLSL, made SPIR-V by glslang.
    Hlsl,
    /// The emitted SPIR-V as it is.
    Spirv,
}

impl Road {
    /// All roads.
    pub const ALL: [Road; 4] = [Road::Wgsl, Road::Glsl, Road::Hlsl, Road::Spirv];

    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Road::Wgsl => "wgsl by naga",
            Road::Glsl => "glsl450 by glslang",
            Road::Hlsl => "hlsl by glslang",
            Road::Spirv => "spirv as emitted",
        }
    }

    /// The language that is emitted.
    pub fn language(self) -> Language {
        match self {
            Road::Wgsl | Road::Spirv => Language::Wgsl,
            Road::Glsl => Language::Glsl450,
            Road::Hlsl => Language::Hlsl,
        }
    }

    /// The SPIR-V that this road brings to the device.
    ///
    /// # Errors
    /// If the text cannot be emitted, or a judge refuses it.
    pub fn spirv(self, shading: &Shading, quantity: ShadingQuantity) -> Result<Vec<u32>, RoadError> {
        let language = self.language();
        let name = format!("{}.{}", shading.scene().name, Dialect::of(language).extension);
        let text = compute(shading, quantity, language)?;
        judge_text(language, Form::Compute, &name, &text)?;
        let words = match self {
            // The emitted SPIR-V is naga's of the emitted WGSL.
            Road::Wgsl | Road::Spirv => wgsl_to_spirv(&name, &text)?,
            Road::Glsl => glsl_to_spirv(&name, &text, Stage::Compute)?,
            Road::Hlsl => hlsl_to_spirv(&name, &text, Stage::Compute)?,
        };
        judge_spirv(&name, &words)?;
        Ok(words)
    }
}

/// Why a quantity cannot be evaluated by a road.
#[derive(Debug, Error)]
pub enum RoadError {
    /// The text cannot be emitted.
    #[error(transparent)]
    Emit(#[from] EmitError),
    /// A judge refuses it, or the device fails.
    #[error(transparent)]
    Check(#[from] CheckError),
}

/// A quantity that is ready to run by a road.
pub struct Prepared {
    words: Vec<u32>,
    /// How many numbers a point has.
    width: usize,
    /// Where each number that the program takes stands in a point.
    columns: Vec<usize>,
    tables: Vec<Vec<f32>>,
}

impl Prepared {
    /// Emits a quantity and has it judged.
    ///
    /// # Errors
    /// If the text cannot be emitted, or a judge refuses it.
    pub fn new(road: Road, shading: &Shading, quantity: ShadingQuantity) -> Result<Self, RoadError> {
        let words = road.spirv(shading, quantity)?;
        let program = shading.program(quantity);
        let inputs = shading.inputs(quantity);
        Ok(Self {
            words,
            width: inputs.iter().map(Input::components).sum(),
            columns: columns(&inputs, program.inputs()),
            tables: program.tables().iter().map(table_numbers).collect(),
        })
    }

    /// The SPIR-V that runs.
    pub fn words(&self) -> &[u32] {
        &self.words
    }

    /// Evaluates points, which have a number for each component of each input, one after the other.
    ///
    /// # Errors
    /// If the device fails.
    pub fn evaluate(&self, device: &Device, points: &[f32]) -> Result<Vec<[f32; 3]>, RoadError> {
        let shader =
            ComputeShader { spirv: &self.words, entry: "main", workgroup_size: WORKGROUP_SIZE, tables: &self.tables };
        let takes_all = self.columns.iter().copied().eq(0..self.width);
        let taken: Vec<f32> = if takes_all {
            Vec::new()
        } else {
            let point = |point: &[f32]| self.columns.iter().map(|&column| point[column]).collect::<Vec<f32>>();
            points.chunks_exact(self.width.max(1)).flat_map(point).collect()
        };
        let outputs = device.evaluate(&shader, if takes_all { points } else { &taken }, self.columns.len(), 3)?;
        let mut colors: Vec<[f32; 3]> = outputs.chunks_exact(3).map(|color| [color[0], color[1], color[2]]).collect();
        if self.columns.is_empty() {
            // A program without inputs gives the same colour at each point.
            let color = colors.first().copied().unwrap_or([f32::NAN; 3]);
            colors = vec![color; points.len() / self.width.max(1)];
        }
        Ok(colors)
    }
}

/// Evaluates a quantity at many points by a road.
///
/// # Errors
/// If the text cannot be emitted, a judge refuses it, or the device fails.
pub fn evaluate(
    device: &Device,
    road: Road,
    shading: &Shading,
    quantity: ShadingQuantity,
    points: &[Vec<f32>],
) -> Result<Vec<[f32; 3]>, RoadError> {
    Prepared::new(road, shading, quantity)?.evaluate(device, &points.concat())
}

/// Of each point the numbers that the program of a quantity takes, in its order: what it does not depend on is left out.
///
/// A point has a number for each component of [`Shading::inputs`].
pub fn numbers_taken(shading: &Shading, quantity: ShadingQuantity, points: &[Vec<f32>]) -> Vec<Vec<f32>> {
    let columns = columns(&shading.inputs(quantity), shading.program(quantity).inputs());
    points.iter().map(|point| columns.iter().map(|&column| point[column]).collect()).collect()
}

/// A table as a buffer of [`Road::spirv`] holds it: a fourth number after each three.
pub fn table_numbers(table: &Table) -> Vec<f32> {
    table.rows.iter().flat_map(|[x, y, z]| [*x as f32, *y as f32, *z as f32, 0.0]).collect()
}
