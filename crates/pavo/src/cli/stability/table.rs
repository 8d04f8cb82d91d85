//! What was found, as text: a row for each variant, and the points that do not keep to their bounds.

use super::Failure;
use crate::cli::command_line::quoted;
use crate::inputs::ShadingQuantity;
use crate::points_table::column_names;
use crate::stability::{Check, Effort, Finding, Judged, Judgement, Placed, Stability};
use pavo_check::DeviceDescription;
use std::path::Path;

/// How many failures are printed with their points.
const SHOWN: usize = 12;

/// How the worst points are evaluated again.
#[derive(Clone, Copy)]
pub struct Replay<'a> {
    /// The scene, or the folder with the scenes; empty where none was written.
    pub place: &'a Path,
    /// Whether it is the scene.
    pub is_scene: bool,
    /// The variants on their surfaces.
    pub placed: &'a [Placed],
}

/// The report.
pub fn text(
    device: &DeviceDescription,
    effort: Effort,
    stability: &Stability,
    judgement: &Judgement<'_>,
    replay: Replay<'_>,
) -> Result<String, Failure> {
    let fewest = stability.device_points.iter().map(|(_, points)| *points).min().unwrap_or(0);
    let mut text = format!(
        "The catalogue, and a sweep of {} points a variant, on the CPU and on {}; each variant ran at {fewest} points or \
         more there.\nThe largest figure of each check: ~ where an exception allows it, ! where nothing does.\n\n{:<38}",
        effort.sweep_points, device.name, "variant"
    );
    for check in Check::ALL {
        text.push_str(&format!(" {check:>11}"));
    }
    text.push('\n');
    for (variant, _) in &stability.device_points {
        text.push_str(&format!("{variant:<38}"));
        for check in Check::ALL {
            text.push_str(&format!(" {:>11}", cell(judgement, variant, check)));
        }
        text.push('\n');
    }
    let failures: Vec<&Judged<'_>> = judgement.failures().collect();
    if !failures.is_empty() {
        text.push_str(&format!("\n{} bounds are not kept:\n", failures.len()));
    }
    for failure in failures.iter().take(SHOWN) {
        text.push_str(&said(failure, replay));
    }
    if failures.len() > SHOWN {
        text.push_str(&format!("\nand {} more: see --json or -o DIR\n", failures.len() - SHOWN));
    }
    for stale in &judgement.stale {
        let row = stale.exception;
        text.push_str(&format!(
            "\nno longer needed: the exception of {} on {} in {} from {}, since {:.2e} is within {:.2e} ({})\n",
            row.variants.join(" "),
            row.surfaces.join(" "),
            row.cases.join(" "),
            row.check,
            stale.largest,
            stale.bound,
            row.reason
        ));
    }
    Ok(text)
}

/// The largest figure of a check of a variant, with its mark.
fn cell(judgement: &Judgement<'_>, variant: &str, check: Check) -> String {
    let rows: Vec<&Judged<'_>> =
        judgement.rows.iter().filter(|row| row.finding.variant == variant && row.finding.check == check).collect();
    let Some(largest) = rows.iter().max_by(|a, b| a.finding.value.total_cmp(&b.finding.value)) else {
        return "-".to_owned();
    };
    let mark = match (rows.iter().all(|row| row.passed), largest.exception) {
        (false, _) => "!",
        (true, Some(_)) => "~",
        (true, None) => " ",
    };
    if largest.finding.value == 0.0 { format!("0{mark}") } else { format!("{:.2e}{mark}", largest.finding.value) }
}

/// A failure with the command and the point that show it again.
fn said(failure: &Judged<'_>, replay: Replay<'_>) -> String {
    let Finding { surface, variant, case, check, evaluator, value, points, .. } = failure.finding;
    let mut text = format!(
        "\n{variant} on {surface}, {case}: {check} {value:.3e}, allowed {:.1e}, by {evaluator} over {points} points\n",
        failure.bound
    );
    if failure.finding.worst.is_empty() {
        return text;
    }
    let scene = match (replay.is_scene, replay.place.as_os_str().is_empty()) {
        (true, _) => quoted(replay.place),
        (false, true) => format!("{surface}.toml"),
        (false, false) => quoted(&replay.place.join(format!("{surface}.toml"))),
    };
    text.push_str(&format!(
        "  pavo eval {scene} --points points.csv --variant {variant} --quantity {} --on {}\n  points.csv: {}\n              {}\n",
        failure.finding.quantity,
        flag(evaluator),
        columns(replay.placed, failure.finding),
        numbers(&failure.finding.worst)
    ));
    if !replay.is_scene && replay.place.as_os_str().is_empty() {
        text.push_str(&format!("  ({surface}.toml is written by -o DIR)\n"));
    }
    text
}

/// What `pavo eval --on` calls an evaluator.
fn flag(evaluator: &str) -> &'static str {
    match evaluator {
        "cpu f64" => "cpu-f64",
        "cpu f32" => "cpu-f32",
        name if name.starts_with("glsl") => "lavapipe-glsl",
        _ => "lavapipe-wgsl",
    }
}

/// The header of the points of a finding.
pub fn columns(placed: &[Placed], finding: &Finding) -> String {
    let shading = placed.iter().map(|placed| &placed.shading).find(|shading| shading.scene().name == finding.surface);
    let quantity = match finding.quantity {
        "brdf" => ShadingQuantity::Brdf,
        "directions" => ShadingQuantity::Directions,
        _ => ShadingQuantity::Reflectance,
    };
    let inputs = shading.map_or(Vec::new(), |shading| shading.inputs(quantity));
    inputs.iter().flat_map(column_names).collect::<Vec<_>>().join(",")
}

/// A point as a row.
pub fn numbers(point: &[f32]) -> String {
    point.iter().map(|number| format!("{number:e}")).collect::<Vec<_>>().join(",")
}
