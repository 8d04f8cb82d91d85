//! All that is said of one scene: measured, drawn and emitted.

use super::commands::commands;
use super::description::Description;
use super::figures::{CodeFigures, Cost, Figures, NotMeasured, Refused, Time, Timed, VariantFigures};
use super::pictures::{Pictures, pictures};
use super::plots::{PlotFile, plots};
use super::stability;
use super::worst;
use crate::cli::cache::DiskCache;
use crate::cli::failure::Failure;
use crate::cli::manifest::{InputRow, Rates};
use crate::cli::output;
use crate::cli::progress::Progress;
use crate::cli::sources::Source;
use crate::cli::sphere::is_renderable;
use crate::emission::library_quantity;
use crate::inputs::ShadingQuantity;
use crate::points_table::column_names;
use crate::scene::Scene;
use crate::shading::Shading;
use crate::target::Target;
use crate::tuning::{
    Budget, CostKind, DEFAULT_MAX_DELTA_E, Measured, Pick, Tuning, TuningError, VERIFIED_POINTS, pick, time, verify,
};
use pavo_check::doctor::{Finding, survey as survey_tools};
use pavo_check::timing::Timings;
use pavo_check::{CheckError, Device};
use pavo_emit::{Form, Language};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The variant that engines ship in simpler forms, and with which times are compared.
const BASELINE: &str = "series:m=3,fit=xyz-gauss";
/// How many of the worst points are listed.
const WORST_POINTS: usize = 8;

/// A scene to report on, with its file.
pub struct Request {
    /// The file.
    pub path: PathBuf,
    /// The file's text.
    pub text: String,
    /// The scene.
    pub scene: Scene,
    /// The largest dE2000 that the arguments allow.
    pub max_delta_e: Option<f64>,
}

/// The report of a scene.
pub struct Survey<'a> {
    /// The figures.
    pub figures: Figures<'a>,
    /// The scene in words.
    pub description: Description,
    /// The pictures of the sphere.
    pub pictures: Pictures,
    /// The plots by the names of their files.
    pub plots: Vec<PlotFile>,
    /// The worst points as a table.
    pub worst_points: String,
}

/// Measures a scene; on a device times are taken and the sphere is rendered.
pub fn survey<'a>(
    request: &'a Request,
    device: Option<&Device>,
    cache: &DiskCache,
    progress: &Progress,
) -> Result<Survey<'a>, Failure> {
    let Request { path, text, scene, max_delta_e } = request;
    let limit = max_delta_e.or(scene.budget.max_delta_e).unwrap_or(DEFAULT_MAX_DELTA_E);
    let started = AtomicUsize::new(0);
    let measured = Measured::new(scene, cache, &|count, variant| {
        let place = started.fetch_add(1, Ordering::Relaxed) + 1;
        progress.step(format!("{}: {place} of {count}: {variant}", scene.name));
    })?;
    progress.step(format!("{}: costs by ops and navi21", scene.name));
    let by_operations = measured.by(&CostKind::Operations, cache)?;
    let mut not_measured = Vec::new();
    let by_compiler = match measured.by(&CostKind::Family("navi21"), cache) {
        Ok(tuning) => Some(tuning),
        Err(TuningError::Check(error @ CheckError::Missing { .. })) => {
            not_measured.push(NotMeasured { cost: "navi21", reason: error.to_string() });
            None
        }
        Err(error) => return Err(error.into()),
    };
    progress.step(format!("{}: picking a variant", scene.name));
    let (picked, not_picked) = match pick(scene, &by_operations, Budget::MaxDeltaE(limit), cache) {
        Ok(picked) => (Some(picked), None),
        Err(error @ TuningError::Budget { .. }) => (None, Some(error.to_string())),
        Err(error) => return Err(error.into()),
    };
    let shown = match &picked {
        Some(picked) => picked.clone(),
        None => closest(&measured, &by_operations)?,
    };
    let shading = measured.shading(&shown.variant).ok_or_else(|| no_variant(scene))?;
    let timings = match device {
        Some(_) => {
            progress.step(format!("{}: times on lavapipe", scene.name));
            // On a device of its own: once one has rendered, lavapipe writes both timestamps of a dispatch at its end.
            Some(timed(&measured, &by_operations, &Device::lavapipe()?)?)
        }
        None => {
            not_measured.push(NotMeasured { cost: "lavapipe", reason: "as asked by --no-run".to_owned() });
            None
        }
    };
    let variants = variants(&by_operations, by_compiler.as_ref(), timings.as_ref(), &shown);
    let source = Source { path: path.clone(), text: text.clone(), shading: shading.clone() };
    let pictures = pictures(&source, device, progress)?;
    progress.step(format!("{}: the worst points", scene.name));
    let worst_points = measured.judge().worst_points(shading, WORST_POINTS)?;
    progress.step(format!("{}: numerical stability", scene.name));
    let stability = device.map_or(Ok(Vec::new()), |device| stability::findings(device, shading))?;
    progress.step(format!("{}: the emitted code", scene.name));
    let quantity = library_quantity(scene);
    for warning in shading.warnings() {
        output::warn(&warning);
    }
    let worst_table = worst::csv(measured.judge().inputs(), &worst_points);
    let plots = plots(scene, limit, picked.is_some(), &variants, timings.as_ref())?;
    let commands = commands(path, &shown.variant, *max_delta_e, device.is_some(), is_renderable(shading));
    let refused = |(variant, reason): &(String, String)| Refused { variant: variant.clone(), reason: reason.clone() };
    let figures = Figures {
        pavo: env!("CARGO_PKG_VERSION"),
        scene_file: path.display().to_string(),
        scene,
        inputs: measured.judge().inputs().iter().map(InputRow::from).collect(),
        max_delta_e: limit,
        picked,
        not_picked,
        shown,
        verified_points: VERIFIED_POINTS,
        variants,
        refused: by_operations.refused.iter().map(refused).collect(),
        not_measured,
        timed: timings.map(|timings| Timed {
            device: timings.device,
            baseline: timings.reference,
            points: timings.points,
            rounds: timings.rounds,
        }),
        sphere: pictures.figures.clone(),
        worst_columns: measured.judge().inputs().iter().flat_map(column_names).collect(),
        worst_points,
        stability,
        operations: shading.program(ShadingQuantity::Reflectance).operations(),
        code: code(&source)?,
        left_out: shading.left_out(quantity),
        rates: Rates::of(shading),
        warnings: shading.warnings(),
        tools: survey_tools().into_iter().map(|finding| Finding { location: None, ..finding }).collect(),
        commands,
    };
    let description = Description::new(scene, text.clone());
    Ok(Survey { figures, description, pictures, plots, worst_points: worst_table })
}

/// The variant with the smallest largest dE2000, with its errors over other points.
fn closest(measured: &Measured<'_>, tuning: &Tuning) -> Result<Pick, Failure> {
    let closest = tuning.rows.iter().rfind(|row| row.on_frontier);
    let shading = closest.and_then(|row| measured.shading(&row.variant));
    shading.map_or_else(|| Err(no_variant(measured.scene())), |shading| Ok(verify(shading)?))
}

fn no_variant(scene: &Scene) -> Failure {
    Failure::check(format!("no variant can be made for the scene {}", scene.name))
}

/// The times of all variants, compared with the baseline, or else with the one that has the most operations.
fn timed(measured: &Measured<'_>, tuning: &Tuning, device: &Device) -> Result<Timings, Failure> {
    let shadings: Vec<&Shading> = tuning.rows.iter().filter_map(|row| measured.shading(&row.variant)).collect();
    let has_baseline = tuning.rows.iter().any(|row| row.variant == BASELINE);
    let dearest = tuning.rows.last().map_or(BASELINE, |row| row.variant.as_str());
    let compared = time(device, &shadings, if has_baseline { BASELINE } else { dearest });
    match compared {
        // The baseline may be as fast as reading and writing alone.
        Err(TuningError::Check(CheckError::Input(_))) if has_baseline => Ok(time(device, &shadings, dearest)?),
        other => Ok(other?),
    }
}

fn variants(
    by_operations: &Tuning,
    by_compiler: Option<&Tuning>,
    timings: Option<&Timings>,
    shown: &Pick,
) -> Vec<VariantFigures> {
    let time = |variant: &str| timings?.timings.iter().find(|timing| timing.name == variant);
    let row = |row: &crate::tuning::Row| VariantFigures {
        variant: row.variant.clone(),
        is_shown: row.variant == shown.variant,
        errors: row.errors.clone(),
        ops: Cost { cost: row.cost, on_frontier: row.on_frontier },
        navi21: by_compiler
            .and_then(|tuning| tuning.rows.iter().find(|other| other.variant == row.variant))
            .map(|row| Cost { cost: row.cost, on_frontier: row.on_frontier }),
        lavapipe: time(&row.variant).map(|timing| Time {
            ns: timing.net,
            ratio: timing.ratio,
            on_frontier: timings.is_some_and(|timings| {
                timings.timings.iter().all(|other| {
                    let errors = by_operations.rows.iter().find(|row| row.variant == other.name).map(|row| &row.errors);
                    other.net.median >= timing.net.median
                        || errors.is_none_or(|errors| errors.max_delta_e > row.errors.max_delta_e)
                })
            }),
        }),
    };
    by_operations.rows.iter().map(row).collect()
}

/// The library of the variant in WGSL and GLSL 4.50.
fn code(source: &Source) -> Result<Vec<CodeFigures>, Failure> {
    [Language::Wgsl, Language::Glsl450]
        .into_iter()
        .map(|language| {
            let target = Target::Text(language);
            let emitted = source.emit(target, Form::Library, ShadingQuantity::Reflectance)?;
            let text = String::from_utf8_lossy(&emitted.bytes).into_owned();
            Ok(CodeFigures { target: target.name(), text, verdicts: emitted.verdicts })
        })
        .collect()
}
