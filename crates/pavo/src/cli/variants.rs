//! `pavo variants`: what there is to choose from.

use super::arguments;
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use crate::inputs::ShadingQuantity;
use crate::points::spread;
use crate::scene::Scene;
use crate::shading::{Shading, ShadingError};
use crate::statistics::Difference;
use crate::variant::Variant;
use pavo_shade::Operations;
use serde::Serialize;

const POINTS: usize = 2000;

#[derive(Serialize)]
struct Row {
    variant: String,
    points: usize,
    max: f64,
    rms: f64,
    operations: Operations,
}

/// Lists the variants of a scene with their error against the exact reference and their operation counts.
pub fn run(arguments: &arguments::Variants) -> Result<(), Failure> {
    let scene = Scene::load(&arguments.scene)?;
    let progress = Progress::start();
    let mut reference = None;
    let mut rows = Vec::new();
    let mut refused = Vec::new();
    for variant in Variant::candidates() {
        progress.step(variant.to_string());
        let shading = match Shading::new(&scene, &variant) {
            Err(ShadingError::Variant { cause, .. }) => {
                refused.push(format!("{variant}: {cause}"));
                continue;
            }
            other => other?,
        };
        let quantity = ShadingQuantity::Reflectance;
        let points = spread(&shading.inputs(quantity), POINTS, 1);
        if reference.is_none() {
            reference = Some(shading.reference_each(quantity, &points)?);
        }
        let expected = reference.as_deref().unwrap_or_default();
        let difference = Difference::between(&shading.evaluate_each(quantity, &points), expected, 1);
        rows.push(Row {
            variant: variant.to_string(),
            points: POINTS,
            max: difference.max,
            rms: difference.rms,
            operations: shading.program(quantity).operations(),
        });
    }
    drop(progress);
    for line in &refused {
        output::warn(line);
    }
    if arguments.json {
        return output::print(&format!("{:#}\n", serde_json::json!(rows)));
    }
    let mut text = format!(
        "Reflectance of {} against the exact spectral reference, {POINTS} points over its ranges, in {}:\n\n\
         {:<26} {:>9} {:>9} {:>11} {:>8} {:>8}\n",
        scene.name, scene.colour.space, "variant", "max", "RMS", "arithmetic", "sqrt, /", "sin, exp"
    );
    for row in &rows {
        let Operations { arithmetic, roots, transcendental } = row.operations;
        text.push_str(&format!(
            "{:<26} {:>9.2e} {:>9.2e} {arithmetic:>11} {roots:>8} {transcendental:>8}\n",
            row.variant, row.max, row.rms
        ));
    }
    output::print(&text)
}
