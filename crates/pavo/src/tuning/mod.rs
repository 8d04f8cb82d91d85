//! The choice of a variant: every candidate with its error and its cost, without those that another one beats in both,
//! and of the rest the cheapest that keeps to a budget.

mod cost;
mod error;
mod f0_loss;
mod measured;

pub use cost::{CostKind, Meter, time};
pub use error::{Judge, VariantErrors, WorstPoint};
pub use f0_loss::F0Loss;
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
    /// The largest root of the mean square error; of what keeps to it the cheapest is picked.
    MaxRms(f64),
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
    /// Whether no other variant is both cheaper and closer by its largest dE2000; never for what reads tables, unless
    /// [`Tuning::with_tables`].
    pub on_frontier: bool,
}

/// All that was measured of a scene's variants.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tuning {
    /// What the costs count.
    pub cost: String,
    /// Whether what reads tables of constants may be on the frontier.
    pub has_tables: bool,
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
    let frontier = tuning.frontier(budget);
    let keeps = |row: &&&Row| match budget {
        Budget::MaxDeltaE(limit) => row.errors.max_delta_e <= limit,
        Budget::MaxRms(limit) => row.errors.rms <= limit,
        Budget::MaxCost(limit) => row.cost <= limit,
    };
    let mut eligible: Vec<&Row> = frontier.iter().filter(keeps).copied().collect();
    // The frontier runs from the cheapest to the closest.
    if matches!(budget, Budget::MaxCost(_)) {
        eligible.reverse();
    }
    for row in eligible {
        let Ok(variant) = row.variant.parse::<Variant>() else { continue };
        let shading = Shading::with_cache(scene, &variant, cache)?;
        let pick = verify(&shading)?;
        let is_kept = match budget {
            Budget::MaxDeltaE(limit) => pick.verified_max_delta_e <= limit,
            Budget::MaxRms(limit) => pick.verified_rms <= limit,
            Budget::MaxCost(_) => true,
        };
        if is_kept {
            return Ok(pick);
        }
    }
    let closest = match budget {
        Budget::MaxDeltaE(limit) => frontier.last().map(|row| {
            format!("{} has a dE2000 of {:.3}, and {limit} is allowed", row.variant, row.errors.max_delta_e)
        }),
        Budget::MaxRms(limit) => frontier
            .last()
            .map(|row| format!("{} has an RMS error of {:.2e}, and {limit} is allowed", row.variant, row.errors.rms)),
        Budget::MaxCost(limit) => frontier
            .first()
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

impl Tuning {
    /// The same with tables of constants among what may be picked. What counts costs sees no cache that they do not fit,
    /// and some compilers copy them into registers: elsewhere they are listed, but not picked.
    pub fn with_tables(mut self) -> Self {
        self.has_tables = true;
        mark_frontier(&mut self.rows, true);
        self
    }

    /// The variants that no other one beats in both cost and what the budget limits, the cheapest first.
    fn frontier(&self, budget: Budget) -> Vec<&Row> {
        let rows = self.rows.iter().filter(|row| self.has_tables || !row.reads_tables());
        match budget {
            Budget::MaxRms(_) => closer_than_all_cheaper(rows, |row| row.errors.rms),
            Budget::MaxDeltaE(_) | Budget::MaxCost(_) => self.rows.iter().filter(|row| row.on_frontier).collect(),
        }
    }
}

impl Row {
    /// Whether the emitted code reads a table of many constants.
    pub fn reads_tables(&self) -> bool {
        self.variant.parse::<Variant>().is_ok_and(|variant| variant.reads_tables())
    }
}

/// Marks the rows, which are sorted by cost, that are closer than all cheaper ones.
fn mark_frontier(rows: &mut [Row], has_tables: bool) {
    let candidates = rows.iter().filter(|row| has_tables || !row.reads_tables());
    let names: Vec<String> = closer_than_all_cheaper(candidates, |row| row.errors.max_delta_e)
        .iter()
        .map(|row| row.variant.clone())
        .collect();
    rows.iter_mut().for_each(|row| row.on_frontier = names.contains(&row.variant));
}

/// Of rows sorted by cost those whose error is below that of all before them.
fn closer_than_all_cheaper<'a>(rows: impl Iterator<Item = &'a Row>, error: impl Fn(&Row) -> f64) -> Vec<&'a Row> {
    let mut least = f64::INFINITY;
    rows.filter(|row| {
        let is_closer = error(row) < least;
        least = least.min(error(row));
        is_closer
    })
    .collect()
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
        let row = |variant: &str, cost: f64, max_delta_e: f64| Row {
            variant: variant.to_owned(),
            errors: VariantErrors { max_delta_e, ..VariantErrors::default() },
            cost,
            on_frontier: false,
        };
        let mut rows = [
            row("a", 1.0, 9.0),
            row("b", 2.0, 9.5),
            row("table:8x8", 2.5, 1.5),
            row("c", 3.0, 2.0),
            row("d", 3.0, 2.0),
            row("e", 4.0, 1.0),
        ];
        let on_frontier = |rows: &[Row; 6]| rows.each_ref().map(|row| row.on_frontier);
        mark_frontier(&mut rows, false);
        assert_eq!(on_frontier(&rows), [true, false, false, true, false, true]);
        mark_frontier(&mut rows, true);
        assert_eq!(on_frontier(&rows), [true, false, true, false, false, true]);
    }
}
