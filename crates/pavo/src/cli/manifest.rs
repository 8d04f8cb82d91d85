//! The manifest: all that is known of what was built.

use super::precision::PrecisionSection;
use super::sources::Emitted;
use crate::emission::library_quantity;
use crate::inputs::ShadingQuantity;
use crate::numerics::Numerics;
use crate::points::spread;
use crate::roads::Road;
use crate::scene::Scene;
use crate::shading::Shading;
use crate::statistics::Difference;
use pavo_check::{DeviceDescription, Verdict};
use pavo_shade::{Input, LeftOut, Operations, OperationsByRate, Prepared, Program, Split, Stages, stages};
use serde::Serialize;

/// What is written as `manifest.json`.
#[derive(Serialize)]
pub struct Manifest<'a> {
    /// The version of pavo.
    pub pavo: &'static str,
    /// The scene with all defaults filled in.
    pub scene: &'a Scene,
    /// The variant.
    pub variant: String,
    /// What the functions take.
    pub inputs: Vec<InputRow>,
    /// The files with their verdicts.
    pub targets: Vec<TargetRow<'a>>,
    /// What can be computed once a material, and what that saves.
    pub rates: Rates,
    /// Operations of one evaluation of the reflectance.
    pub operations: Operations,
    /// The guards that the functions do without, since the ranges of the inputs make them unnecessary.
    pub left_out: Vec<LeftOut>,
    /// What was measured on the device; nothing where the shaders were not run.
    pub runs: Option<Runs>,
    /// The reflectance of the variant, in f64, against the exact spectral reference over the scene's ranges.
    pub against_reference: Difference,
    /// What the variant needs of drivers, and how it behaves as numbers.
    pub numerics: Numerics,
    /// What is in half precision, and what that adds to the errors.
    pub precision: PrecisionSection,
    /// What should be said of the data.
    pub warnings: Vec<String>,
}

/// A run-time input.
#[derive(Serialize)]
pub struct InputRow {
    name: String,
    components: usize,
    unit: String,
    low: f64,
    high: f64,
    rate: &'static str,
}

impl From<&Input> for InputRow {
    fn from(input: &Input) -> Self {
        Self {
            name: input.name.clone(),
            components: input.components(),
            unit: input.unit.clone(),
            low: input.low,
            high: input.high,
            rate: input.rate.name(),
        }
    }
}

/// The functions in parts, by how often they are run.
#[derive(Serialize)]
pub struct Rates {
    /// Operations of one evaluation of the whole by the rate of what they depend on.
    pub by_rate: OperationsByRate,
    /// Whether the functions were emitted with a part that is run once a material.
    pub emitted: bool,
    /// The values that are prepared once a material.
    pub prepared: Vec<PreparedRow>,
    /// Operations of one evaluation of the whole.
    pub whole: Operations,
    /// Operations of the part that is run once a material.
    pub prepare: Operations,
    /// Operations that each pixel is spared.
    pub saved_per_pixel: Operations,
    /// What can be computed at the vertices of what is left.
    pub vertex: VertexRates,
}

/// The part that is run at each vertex.
#[derive(Serialize)]
pub struct VertexRates {
    /// Whether the functions were emitted so.
    pub emitted: bool,
    /// The values that are interpolated.
    pub interpolated: Vec<PreparedRow>,
    /// Operations of the part that is run at each vertex.
    pub operations: Operations,
    /// Operations that each pixel is spared besides those of the material.
    pub saved_per_pixel: Operations,
    /// How right it is.
    pub note: &'static str,
}

/// What interpolation does to the values of the vertices.
const INTERPOLATED: &str =
    "interpolated values approximate what a pixel would compute; the errors in this manifest are those without it";

/// A value that is passed from one part to the next.
#[derive(Serialize)]
pub struct PreparedRow {
    name: String,
    components: usize,
}

impl From<&Prepared> for PreparedRow {
    fn from(prepared: &Prepared) -> Self {
        Self { name: prepared.name.clone(), components: prepared.components() }
    }
}

impl PreparedRow {
    /// The name of the value.
    pub fn name(&self) -> &str {
        &self.name
    }
}

impl Rates {
    /// The parts of what a library is of.
    pub fn of(shading: &Shading) -> Self {
        let quantity = library_quantity(shading.scene());
        let whole = shading.program(quantity);
        let Stages { material, vertex, .. } = stages(&whole);
        let rows = |split: &Split| split.prepared.iter().map(PreparedRow::from).collect();
        let operations = |split: &Split| split.prepare.as_ref().map_or_else(Operations::default, Program::operations);
        Self {
            by_rate: whole.operations_by_rate(),
            emitted: shading.scene().is_prepared() && material.prepare.is_some(),
            prepared: rows(&material),
            whole: whole.operations(),
            prepare: operations(&material),
            saved_per_pixel: material.saved,
            vertex: VertexRates {
                emitted: shading.scene().emit.vertex && vertex.prepare.is_some(),
                interpolated: rows(&vertex),
                operations: operations(&vertex),
                saved_per_pixel: vertex.saved,
                note: INTERPOLATED,
            },
        }
    }
}

/// An emitted file.
#[derive(Serialize)]
pub struct TargetRow<'a> {
    target: &'static str,
    form: &'static str,
    file: &'a str,
    bytes: usize,
    verdicts: &'a [Verdict],
}

impl<'a> From<&'a Emitted> for TargetRow<'a> {
    fn from(emitted: &'a Emitted) -> Self {
        Self {
            target: emitted.target.name(),
            form: emitted.form.name(),
            file: &emitted.file,
            bytes: emitted.bytes.len(),
            verdicts: &emitted.verdicts,
        }
    }
}

/// What ran on the device.
#[derive(Serialize)]
pub struct Runs {
    /// The device.
    pub device: DeviceDescription,
    /// A row for each quantity and road.
    pub rows: Vec<RunRow>,
}

/// One quantity by one road.
#[derive(Serialize)]
pub struct RunRow {
    /// The quantity.
    pub quantity: &'static str,
    /// The road.
    pub road: &'static str,
    /// The range of the cosine at the half vector.
    pub cos_theta1: [f64; 2],
    /// The inputs of the worst points are in the order of these columns.
    pub columns: Vec<String>,
    /// Against the CPU in f32.
    pub against_f32: Compared,
    /// Against the CPU in f64, at the same f32 inputs.
    pub against_f64: Compared,
}

/// A difference with the inputs of its worst points.
#[derive(Serialize)]
pub struct Compared {
    /// The difference.
    #[serde(flatten)]
    pub difference: Difference,
    /// The inputs of the worst points.
    pub worst_inputs: Vec<Vec<f32>>,
}

impl Compared {
    /// A difference at these points.
    pub fn new(found: &[[f32; 3]], expected: &[[f64; 3]], points: &[Vec<f32>]) -> Self {
        let found: Vec<[f64; 3]> = found.iter().map(|color| color.map(f64::from)).collect();
        let difference = Difference::between(&found, expected, 3);
        let worst_inputs = difference.worst.iter().map(|worst| points[worst.index].clone()).collect();
        Self { difference, worst_inputs }
    }
}

impl RunRow {
    /// The row of what a road found.
    pub fn new(
        quantity: ShadingQuantity,
        road: Road,
        inputs: &[Input],
        points: &[Vec<f32>],
        found: &[[f32; 3]],
        cpu: (&[[f64; 3]], &[[f64; 3]]),
    ) -> Self {
        Self {
            quantity: quantity.name(),
            road: road.name(),
            cos_theta1: inputs
                .iter()
                .find(|input| input.name == "cos_theta1")
                .map_or([0.0, 1.0], |input| [input.low, input.high]),
            columns: inputs.iter().flat_map(crate::points_table::column_names).collect(),
            against_f32: Compared::new(found, cpu.0, points),
            against_f64: Compared::new(found, cpu.1, points),
        }
    }
}

/// The reflectance against the exact reference over the scene's ranges.
pub fn against_reference(shading: &Shading, count: usize) -> Result<Difference, crate::media::MediaError> {
    let quantity = ShadingQuantity::Reflectance;
    let points = spread(&shading.inputs(quantity), count, 1);
    let expected = shading.reference_each(quantity, &points)?;
    Ok(Difference::between(&shading.evaluate_each(quantity, &points), &expected, 3))
}
