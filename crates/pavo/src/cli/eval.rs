//! `pavo eval`: a scene at the points of a table.

use super::arguments::{self, Evaluator};
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use super::sources::Source;
use crate::inputs::ShadingQuantity;
use crate::points_table::PointsTable;
use crate::roads::{self, Road};
use crate::statistics::Difference;
use pavo_check::Device;
use pavo_files::{read_up_to, shown};

/// The largest table of points that is read, in bytes.
const MAXIMUM_POINTS_BYTES: usize = 256 << 20;

/// Evaluates the points, and writes them with their colours.
pub fn run(arguments: &arguments::Eval) -> Result<(), Failure> {
    let source = Source::load(&arguments.scene, arguments.variant.as_deref())?;
    let quantity = arguments.quantity.into();
    let path = &arguments.points;
    let text = read_up_to(path, MAXIMUM_POINTS_BYTES).map_err(|error| Failure::file(path, "read", &error))?;
    let inputs = source.shading.inputs(quantity);
    let table = PointsTable::parse(&shown(path), &text, source.shading.scene(), &inputs)?;
    drop(text);
    if !table.ignored.is_empty() {
        output::warn(&format!("no input of the scene is called {}: not used", table.ignored.join(", ")));
    }
    if table.out_of_range > 0 {
        output::warn(&format!(
            "{} of {} points lie outside of the ranges of the scene; they were evaluated all the same",
            table.out_of_range,
            table.points.len()
        ));
    }
    let progress = Progress::start();
    progress.step(format!("evaluating {} points", table.points.len()));
    let colors = evaluate(&source, quantity, arguments.on, &table.points)?;
    drop(progress);
    let not_finite = colors.iter().flatten().filter(|value| !value.is_finite()).count();
    if not_finite > 0 {
        output::warn(&format!("{not_finite} of the values are not finite"));
    }
    if let Some(expected) = &table.expected {
        let difference = Difference::between(&colors, expected, 1);
        output::warn(&format!(
            "against the columns r, g, b of the points: max {:.3e}, RMS {:.3e} over {} points",
            difference.max, difference.rms, difference.points
        ));
    }
    output::write_or_print(arguments.output.as_deref(), &table.with_colors(&colors))
}

fn evaluate(
    source: &Source,
    quantity: ShadingQuantity,
    on: Evaluator,
    points: &[Vec<f64>],
) -> Result<Vec<[f64; 3]>, Failure> {
    let single =
        || -> Vec<Vec<f32>> { points.iter().map(|point| point.iter().map(|&value| value as f32).collect()).collect() };
    let double = |colors: Vec<[f32; 3]>| colors.into_iter().map(|color| color.map(f64::from)).collect();
    let on_lavapipe = |road: Road| {
        let device = Device::lavapipe()?;
        roads::evaluate(&device, road, &source.shading, quantity, &single()).map(double).map_err(Failure::from)
    };
    match on {
        Evaluator::Reference => Ok(source.shading.reference_each(quantity, points)?),
        Evaluator::CpuF64 => Ok(source.shading.evaluate_each(quantity, points)),
        Evaluator::CpuF32 => Ok(double(source.shading.evaluate_each_f32(quantity, &single()))),
        Evaluator::LavapipeWgsl => on_lavapipe(Road::Wgsl),
        Evaluator::LavapipeGlsl => on_lavapipe(Road::Glsl),
        Evaluator::LavapipeHlsl => on_lavapipe(Road::Hlsl),
        Evaluator::LavapipeSpirv => on_lavapipe(Road::Spirv),
    }
}
