//! `pavo stability`: where variants break, over a catalogue of hard cases and a sweep of many points.

mod files;
mod picture;
mod table;

use super::arguments;
use super::cache::DiskCache;
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use super::work;
use crate::scene::Scene;
use crate::stability::{
    Catalogue, Check, Effort, Exceptions, Judgement, Placed, Stability, StabilityError, built_in, by_variant, examine,
};
use crate::variant::Variant;
use pavo_check::Device;
use serde_json::json;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The fewest points of a sweep: each case has its turn.
const LEAST_POINTS: usize = 1000;

/// Examines the variants, prints what was found, and fails where a bound is not kept.
pub fn run(arguments: &arguments::Stability) -> Result<(), Failure> {
    let mut effort = if arguments.quick { Effort::QUICK } else { Effort::FULL };
    if let Some(points) = arguments.points {
        let asked = format!("`--points {points}`");
        work::SWEEP_POINTS.check(&asked, points)?;
        let points = points as usize;
        if points < LEAST_POINTS {
            let message = format!("a sweep of {points} points");
            return Err(Failure::input(message, format!("take {LEAST_POINTS} points or more")));
        }
        effort.compared_points = effort.compared_points.min(points);
        effort.sweep_points = points;
    }
    let exceptions = Exceptions::built_in()?;
    let cache = DiskCache::open();
    let progress = Progress::start();
    progress.step("preparing the surfaces");
    let scene_file = arguments.scene.clone();
    let placed = match &scene_file {
        Some(file) => of_scene(&Scene::load(file)?, arguments.variant.as_deref(), &cache)?,
        None => of_all(arguments.variant.as_deref(), &cache)?,
    };
    let device = Device::lavapipe()?;
    let started = AtomicUsize::new(0);
    let stability = examine(&device, &placed, effort, &|count, name| {
        let place = started.fetch_add(1, Ordering::Relaxed) + 1;
        progress.step(format!("{place} of {count}: {name}"));
    })?;
    drop(progress);
    let mut judgement = exceptions.judge(&stability.findings);
    // Of one scene, or of one variant, not all is seen that an exception may be for; nor is it by a short sweep.
    let sees_all = arguments.all && arguments.variant.is_none();
    let is_full = effort.sweep_points >= Effort::FULL.sweep_points && effort.all_roads;
    judgement.stale.retain(|stale| sees_all && (is_full || !stale.exception.needs_full()));
    if let Some(folder) = &arguments.output {
        files::write(folder, &placed, &stability, &judgement, scene_file.as_deref())?;
    }
    let replayed: PathBuf = match (&arguments.output, &scene_file) {
        (_, Some(file)) => file.clone(),
        (Some(folder), None) => folder.clone(),
        (None, None) => PathBuf::new(),
    };
    if arguments.json {
        output::print(&format!("{:#}\n", report(&device, &stability, &judgement)))?;
    } else {
        let place = table::Replay { place: &replayed, is_scene: scene_file.is_some(), placed: &placed };
        output::print(&table::text(device.description(), effort, &stability, &judgement, place)?)?;
    }
    let failures = judgement.failures().count();
    match (failures, judgement.stale.len()) {
        (0, 0) => Ok(()),
        (0, stale) => Err(Failure::check(format!("{stale} exceptions are no longer needed"))),
        (failures, _) => Err(Failure::check(format!("{failures} bounds are not kept"))),
    }
}

/// All figures, for programs.
fn report(device: &Device, stability: &Stability, judgement: &Judgement<'_>) -> serde_json::Value {
    let points: serde_json::Map<String, serde_json::Value> =
        stability.device_points.iter().map(|(variant, points)| (variant.clone(), json!(points))).collect();
    json!({
        "pavo": env!("CARGO_PKG_VERSION"),
        "device": device.description(),
        "points_on_device": points,
        "findings": judgement.rows,
        "stale_exceptions": judgement.stale,
        "cases": Catalogue::built_in().map(|catalogue| {
            let case = |case: &crate::stability::Case| json!({ "name": case.name, "why": case.why });
            catalogue.cases.iter().map(case).collect::<Vec<_>>()
        }).unwrap_or_default(),
        "checks": Check::ALL.map(Check::name),
    })
}

fn of_scene(scene: &Scene, variant: Option<&str>, cache: &DiskCache) -> Result<Vec<Placed>, Failure> {
    let named = match variant {
        Some(text) => Some(text.parse::<Variant>()?),
        None if scene.emit.variant == super::sources::AUTO => None,
        None => Some(scene.emit.variant.parse()?),
    };
    let variants = match named {
        Some(variant) => vec![variant],
        None => Variant::candidates_for(scene),
    };
    let placed = by_variant(scene, &variants, cache)?;
    if let (true, [variant]) = (placed.is_empty(), variants.as_slice()) {
        crate::shading::Shading::with_cache(scene, variant, cache)?;
    }
    Ok(placed)
}

fn of_all(variant: Option<&str>, cache: &DiskCache) -> Result<Vec<Placed>, Failure> {
    let only = variant.map(str::parse::<Variant>).transpose()?;
    let placed = built_in(only.as_ref(), cache)?;
    match only {
        Some(variant) if placed.is_empty() => {
            let message = format!("{variant} is none of the built-in variants");
            Err(Failure::input(message, "see pavo variants; for others name a scene in place of --all"))
        }
        _ => Ok(placed),
    }
}

impl From<StabilityError> for Failure {
    fn from(error: StabilityError) -> Self {
        match error {
            StabilityError::Shading(error) => error.into(),
            StabilityError::Media(error) => error.into(),
            StabilityError::Road(error) => error.into(),
            StabilityError::Data(message) => Self::check(message),
        }
    }
}
