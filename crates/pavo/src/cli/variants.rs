//! `pavo variants`: what there is to choose from.

use super::arguments;
use super::cache::DiskCache;
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
use pavo_spectra::ColourSpace;
use pavo_spectra::delta_e::delta_e_of_linear;
use serde::Serialize;

const POINTS: usize = 2000;

#[derive(Serialize)]
struct Row {
    variant: String,
    points: usize,
    max: f64,
    rms: f64,
    /// CIEDE2000 against the reference under the scene's white: mean and 95th percentile.
    delta_e_mean: f64,
    delta_e_p95: f64,
    operations: Operations,
}

/// Lists the variants of a scene with their error against the exact reference and their operation counts.
pub fn run(arguments: &arguments::Variants) -> Result<(), Failure> {
    let scene = Scene::load(&arguments.scene)?;
    let progress = Progress::start();
    let space = ColourSpace::from_name(&scene.colour.space)
        .map_err(|error| Failure::input(error, "see colour.space of the scene"))?;
    let cache = DiskCache::open();
    let mut reference = None;
    let mut rows = Vec::new();
    let mut refused = Vec::new();
    for variant in Variant::candidates_for(&scene) {
        progress.step(variant.to_string());
        let shading = match Shading::with_cache(&scene, &variant, &cache) {
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
        let found = shading.evaluate_each(quantity, &points);
        let difference = Difference::between(&found, expected, 1);
        let (delta_e_mean, delta_e_p95) = colour_differences(&found, expected, space);
        rows.push(Row {
            variant: variant.to_string(),
            points: POINTS,
            max: difference.max,
            rms: difference.rms,
            delta_e_mean,
            delta_e_p95,
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
         {:<44} {:>9} {:>9} {:>9} {:>9} {:>11} {:>8} {:>8} {:>7}\n",
        scene.name,
        scene.colour.space,
        "variant",
        "max",
        "RMS",
        "mean dE",
        "95% dE",
        "arithmetic",
        "sqrt, /",
        "sin, exp",
        "fetches"
    );
    for row in &rows {
        let Operations { arithmetic, roots, transcendental, fetches } = row.operations;
        text.push_str(&format!(
            "{:<44} {:>9.2e} {:>9.2e} {:>9.3} {:>9.3} {arithmetic:>11} {roots:>8} {transcendental:>8} {fetches:>7}\n",
            row.variant, row.max, row.rms, row.delta_e_mean, row.delta_e_p95
        ));
    }
    output::print(&text)
}

/// Mean and 95th percentile of CIEDE2000 between colours of a space.
fn colour_differences(found: &[[f64; 3]], expected: &[[f64; 3]], space: ColourSpace) -> (f64, f64) {
    let pairs = found.iter().zip(expected);
    let mut differences: Vec<f64> =
        pairs.map(|(found, expected)| delta_e_of_linear(*found, *expected, space)).collect();
    differences.sort_by(f64::total_cmp);
    let mean = differences.iter().sum::<f64>() / differences.len().max(1) as f64;
    let p95 = differences.get(differences.len() * 95 / 100).copied().unwrap_or(0.0);
    (mean, p95)
}
