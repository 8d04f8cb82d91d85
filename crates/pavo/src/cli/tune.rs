//! `pavo tune`: error against cost of every variant, the frontier, and the pick.

use super::arguments;
use super::cache::DiskCache;
use super::failure::Failure;
use super::output;
use super::progress::Progress;
use crate::scene::Scene;
use crate::tuning::{Budget, CostKind, DEFAULT_MAX_DELTA_E, Pick, Tuning, pick, tune};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Measures the variants of a scene, prints the frontier and picks.
pub fn run(arguments: &arguments::Tune) -> Result<(), Failure> {
    let scene = Scene::load(&arguments.scene)?;
    let kind = match &arguments.device {
        Some(device) => CostKind::Device(device.clone()),
        None => CostKind::from_name(&arguments.cost).map_err(|error| Failure::input(error, "see pavo tune --help"))?,
    };
    let limit = |limit: f64| {
        if limit.is_finite() && limit > 0.0 {
            Ok(limit)
        } else {
            Err(Failure::input(format!("a budget of {limit}"), "a budget is a number above 0"))
        }
    };
    let budget = match (arguments.max_cost, arguments.max_rms, arguments.max_delta_e) {
        (Some(cost), _, _) => Budget::MaxCost(limit(cost)?),
        (None, Some(rms), _) => Budget::MaxRms(limit(rms)?),
        (None, None, Some(delta_e)) => Budget::MaxDeltaE(limit(delta_e)?),
        (None, None, None) => Budget::MaxDeltaE(scene.budget.max_delta_e.unwrap_or(DEFAULT_MAX_DELTA_E)),
    };
    let cache = DiskCache::open();
    let mut tuning = measure(&scene, &kind, &cache)?;
    if arguments.tables {
        tuning = tuning.with_tables();
    }
    let picked = pick(&scene, &tuning, budget, &cache);
    if arguments.json {
        let pick = picked.as_ref().ok();
        output::print(&format!("{:#}\n", serde_json::json!({ "tuning": tuning, "pick": pick })))?;
    } else {
        output::print(&report(&scene, &tuning, kind.unit(), arguments.all))?;
    }
    let picked = picked?;
    if arguments.json { Ok(()) } else { output::print(&said(&picked, budget)) }
}

/// Measures the variants under a progress bar.
pub fn measure(scene: &Scene, kind: &CostKind, cache: &DiskCache) -> Result<Tuning, Failure> {
    let progress = Progress::start();
    let started = AtomicUsize::new(0);
    let tuning = tune(scene, kind, cache, &|count, name| {
        let place = started.fetch_add(1, Ordering::Relaxed) + 1;
        progress.step(format!("{} of {count}: {name}", place.min(count)));
    });
    drop(progress);
    Ok(tuning?)
}

fn report(scene: &Scene, tuning: &Tuning, unit: &str, all: bool) -> String {
    let mut text = format!(
        "{} by cost ({}, {unit}) and error against the exact reference; * marks the frontier, t what reads tables:\n\n  {:<44} {:>9} {:>9} {:>9} {:>8} {:>8} {:>8}\n",
        scene.name, tuning.cost, "variant", "cost", "RMS", "max", "mean dE", "95% dE", "max dE"
    );
    for row in tuning.rows.iter().filter(|row| all || row.on_frontier) {
        let errors = &row.errors;
        text.push_str(&format!(
            "{} {:<44} {:>9.4} {:>9.2e} {:>9.2e} {:>8.3} {:>8.3} {:>8.3}\n",
            match row.on_frontier {
                true => "*",
                false if row.reads_tables() && !tuning.has_tables => "t",
                false => " ",
            },
            row.variant,
            row.cost,
            errors.rms,
            errors.max,
            errors.mean_delta_e,
            errors.p95_delta_e,
            errors.max_delta_e
        ));
    }
    let hidden = || tuning.rows.iter().filter(|row| !row.on_frontier);
    let tables = if tuning.has_tables { 0 } else { hidden().filter(|row| row.reads_tables()).count() };
    if !all {
        text.push_str(&format!(
            "\n{} others are both dearer and further off, {tables} read tables (see --tables), and {} cannot be made for \
             this scene: see --all.\n",
            hidden().count() - tables,
            tuning.refused.len()
        ));
        return text;
    }
    for (variant, cause) in &tuning.refused {
        text.push_str(&format!("- {variant}: {cause}\n"));
    }
    text
}

fn said(pick: &Pick, budget: Budget) -> String {
    let limit = match budget {
        Budget::MaxDeltaE(limit) => format!("a dE2000 of {limit} at most"),
        Budget::MaxRms(limit) => format!("an RMS error of {limit} at most"),
        Budget::MaxCost(limit) => format!("a cost of {limit} at most"),
    };
    format!(
        "\nPick for {limit}: {}\n  on {} points that it was not chosen by: max dE2000 {:.3}, RMS {:.2e}\n",
        pick.variant,
        crate::tuning::VERIFIED_POINTS,
        pick.verified_max_delta_e,
        pick.verified_rms
    )
}
