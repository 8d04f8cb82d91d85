//! The choice of a variant: every candidate with its error and its cost, without those that another one beats in both,
//! and of the rest the cheapest that keeps to a budget.

mod cost;
mod error;
mod measured;

pub use cost::{CostKind, Meter, time};
pub use error::{Judge, VariantErrors, WorstPoint};
pub use measured::Measured;

use crate::fitting::FitCache;
use crate::media::MediaError;
use crate::scene::Scene;
use crate::shading::{Shading, ShadingError};
use crate::variant::Variant;
use miette::Diagnostic;
use pavo_check::CheckError;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The largest dE2000 that a variant may show where nothing says another: just noticeable side by side.
pub const DEFAULT_MAX_DELTA_E: f64 = 1.0;

/// How many points the pick is verified on, none of which it was chosen by.
pub const VERIFIED_POINTS: usize = 20_000;

/// What a pick must keep to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Budget {
    /// The largest dE2000; of what keeps to it the cheapest is picked.
    MaxDeltaE(f64),
    /// The largest cost; of what keeps to it the one with the smallest largest dE2000 is picked.
    MaxCost(f64),
}

/// A variant with its error and its cost.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The variant.
    pub variant: String,
    /// Its errors against the exact reference over the scene's ranges.
    pub errors: VariantErrors,
    /// Its cost, in the unit of the [`CostKind`].
    pub cost: f64,
    /// Whether no other variant is both cheaper and closer.
    pub on_frontier: bool,
}

/// All that was measured of a scene's variants.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tuning {
    /// What the costs count.
    pub cost: String,
    /// The variants that can be made, the cheapest first.
    pub rows: Vec<Row>,
    /// The variants that cannot be made, with the reason.
    pub refused: Vec<(String, String)>,
}

/// The variant that was picked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pick {
    /// The variant.
    pub variant: String,
    /// Its largest dE2000 over [`VERIFIED_POINTS`] points that it was not chosen by.
    pub verified_max_delta_e: f64,
    /// Its root of the mean square error over the same points.
    pub verified_rms: f64,
}

/// Why there is nothing to pick.
#[derive(Debug, Error, Diagnostic)]
pub enum TuningError {
    /// The scene's data.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Shading(#[from] ShadingError),
    /// The scene's media.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Media(#[from] MediaError),
    /// The cost of a variant cannot be measured.
    #[error(transparent)]
    Check(#[from] CheckError),
    /// The text of a variant cannot be emitted.
    #[error(transparent)]
    Emit(#[from] pavo_emit::EmitError),
    /// No variant keeps to the budget.
    #[error("no variant of {scene} keeps to the budget: {closest}")]
    #[diagnostic(code(pavo::tune), help("allow more, or narrow the ranges of the scene"))]
    Budget {
        /// The scene.
        scene: String,
        /// What comes closest.
        closest: String,
    },
}

impl From<crate::roads::RoadError> for TuningError {
    fn from(error: crate::roads::RoadError) -> Self {
        match error {
            crate::roads::RoadError::Emit(error) => error.into(),
            crate::roads::RoadError::Check(error) => error.into(),
        }
    }
}

/// Measures the variants of a scene by one kind of cost. `progress` is told the number of variants, and each one's name
/// as its turn comes.
///
/// # Errors
/// A scene whose data cannot be had, or a cost that cannot be measured. A variant that cannot be made for the scene is no
/// error: it is listed.
pub fn tune(
    scene: &Scene,
    kind: &CostKind,
    cache: &dyn FitCache,
    progress: &(dyn Fn(usize, &str) + Sync),
) -> Result<Tuning, TuningError> {
    match load(cache, &measured::tuning_key(scene, kind)) {
        Some(kept) => Ok(kept),
        None => {
            let measured = Measured::new(scene, cache, progress)?;
            progress(measured.count(), &format!("costs by {}", kind.name()));
            measured.by(kind, cache)
        }
    }
}

/// The variant that keeps to a budget, verified on points that it was not chosen by.
///
/// # Errors
/// If none keeps to it, or the points cannot be evaluated.
pub fn pick(scene: &Scene, tuning: &Tuning, budget: Budget, cache: &dyn FitCache) -> Result<Pick, TuningError> {
    let key = format!("pick 1 {} {budget:?} {tuning:?}", scene_key(scene));
    if let Some(kept) = load(cache, &key) {
        return Ok(kept);
    }
    let picked = verified_pick(scene, tuning, budget, cache)?;
    store(cache, &key, &picked);
    Ok(picked)
}

fn verified_pick(scene: &Scene, tuning: &Tuning, budget: Budget, cache: &dyn FitCache) -> Result<Pick, TuningError> {
    let frontier = tuning.rows.iter().filter(|row| row.on_frontier);
    let keeps = |row: &&Row| match budget {
        Budget::MaxDeltaE(limit) => row.errors.max_delta_e <= limit,
        Budget::MaxCost(limit) => row.cost <= limit,
    };
    let mut eligible: Vec<&Row> = frontier.clone().filter(keeps).collect();
    // The frontier runs from the cheapest to the closest.
    if matches!(budget, Budget::MaxCost(_)) {
        eligible.reverse();
    }
    for row in eligible {
        let Ok(variant) = row.variant.parse::<Variant>() else { continue };
        let shading = Shading::with_cache(scene, &variant, cache)?;
        let pick = verify(&shading)?;
        if let Budget::MaxDeltaE(limit) = budget
            && pick.verified_max_delta_e > limit
        {
            continue;
        }
        return Ok(pick);
    }
    let closest = match budget {
        Budget::MaxDeltaE(limit) => frontier.clone().next_back().map(|row| {
            format!("{} has a dE2000 of {:.3}, and {limit} is allowed", row.variant, row.errors.max_delta_e)
        }),
        Budget::MaxCost(limit) => frontier
            .clone()
            .next()
            .map(|row| format!("{} costs {:.4} by {}, and {limit} is allowed", row.variant, row.cost, tuning.cost)),
    };
    Err(TuningError::Budget {
        scene: scene.name.clone(),
        closest: closest.unwrap_or_else(|| "none can be made".into()),
    })
}

/// A variant, whether it keeps to a budget or not, with its errors over [`VERIFIED_POINTS`] points.
///
/// # Errors
/// If the points cannot be evaluated.
pub fn verify(shading: &Shading) -> Result<Pick, TuningError> {
    let (verified_max_delta_e, verified_rms) = error::verified(shading, VERIFIED_POINTS)?;
    Ok(Pick { variant: shading.variant().to_string(), verified_max_delta_e, verified_rms })
}

/// Marks the rows, which are sorted by cost, that are closer than all cheaper ones.
fn mark_frontier(rows: &mut [Row]) {
    let mut least = f64::INFINITY;
    for row in rows {
        row.on_frontier = row.errors.max_delta_e < least;
        least = least.min(row.errors.max_delta_e);
    }
}

/// What was stored under a key, if it can still be read.
fn load<T: serde::de::DeserializeOwned>(cache: &dyn FitCache, key: &str) -> Option<T> {
    cache.load(key).and_then(|text| serde_json::from_str(&text).ok())
}

fn store(cache: &dyn FitCache, key: &str, value: &impl Serialize) {
    if let Ok(text) = serde_json::to_string(value) {
        cache.store(key, &text);
    }
}

/// A scene as text, the contents of the files that it names included.
fn scene_key(scene: &Scene) -> String {
    let mut key = serde_json::to_string(scene).unwrap_or_default();
    for file in scene.files() {
        key.push('\n');
        key.push_str(&std::fs::read_to_string(file).unwrap_or_default());
    }
    key
}

#[cfg(test)]
mod tests {
    use super::{Row, VariantErrors, mark_frontier};

    #[test]
    fn the_frontier_is_what_no_other_beats_in_both() {
        let row = |cost: f64, max_delta_e: f64| Row {
            variant: String::new(),
            errors: VariantErrors { max_delta_e, ..VariantErrors::default() },
            cost,
            on_frontier: false,
        };
        let mut rows = [row(1.0, 9.0), row(2.0, 9.5), row(3.0, 2.0), row(3.0, 2.0), row(4.0, 1.0)];
        mark_frontier(&mut rows);
        assert_eq!(rows.map(|row| row.on_frontier), [true, false, true, false, true]);
    }
}
