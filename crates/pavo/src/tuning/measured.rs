//! The variants of a scene with their errors, which are measured once whatever costs are asked for.

use super::{CostKind, Judge, Meter, Row, Tuning, TuningError, VariantErrors, load, mark_frontier, scene_key, store};
use crate::fitting::FitCache;
use crate::scene::Scene;
use crate::shading::{Shading, ShadingError};
use crate::variant::Variant;
use rayon::prelude::*;

/// The variants of a scene with their errors.
pub struct Measured<'a> {
    scene: &'a Scene,
    judge: Judge,
    made: Vec<(Shading, VariantErrors)>,
    refused: Vec<(String, String)>,
}

impl<'a> Measured<'a> {
    /// Makes and measures the variants, on all cores. `progress` is told the number of variants, and each one's name as
    /// its turn comes.
    ///
    /// # Errors
    /// A scene whose data cannot be had.
    pub fn new(
        scene: &'a Scene,
        cache: &dyn FitCache,
        progress: &(dyn Fn(usize, &str) + Sync),
    ) -> Result<Self, TuningError> {
        let mut measured = Self { scene, judge: Judge::new(scene)?, made: Vec::new(), refused: Vec::new() };
        let candidates = Variant::candidates_for(scene);
        let measure = |variant: &Variant| {
            progress(candidates.len(), &variant.to_string());
            match Shading::with_cache(scene, variant, cache) {
                Ok(shading) => {
                    let errors = measured.errors(&shading, cache)?;
                    Ok(Ok((shading, errors)))
                }
                Err(ShadingError::Variant { cause, .. }) => Ok(Err((variant.to_string(), cause))),
                Err(error) => Err(TuningError::from(error)),
            }
        };
        let found = candidates.par_iter().map(measure).collect::<Result<Vec<_>, _>>()?;
        for candidate in found {
            match candidate {
                Ok(made) => measured.made.push(made),
                Err(refused) => measured.refused.push(refused),
            }
        }
        Ok(measured)
    }

    fn errors(&self, shading: &Shading, cache: &dyn FitCache) -> Result<VariantErrors, TuningError> {
        let key = format!("errors 2 {} {}", scene_key(self.scene), shading.variant());
        if let Some(kept) = load(cache, &key) {
            return Ok(kept);
        }
        let errors = self.judge.errors(shading)?;
        store(cache, &key, &errors);
        Ok(errors)
    }

    /// How many variants there are to choose from, those that cannot be made included.
    pub fn count(&self) -> usize {
        self.made.len() + self.refused.len()
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        self.scene
    }

    /// What compares the variants with the exact reference.
    pub fn judge(&self) -> &Judge {
        &self.judge
    }

    /// The surface by a variant that can be made.
    pub fn shading(&self, variant: &str) -> Option<&Shading> {
        self.made.iter().map(|(shading, _)| shading).find(|shading| shading.variant().to_string() == variant)
    }

    /// The variants by error and one kind of cost.
    ///
    /// # Errors
    /// If the cost cannot be measured.
    pub fn by(&self, kind: &CostKind, cache: &dyn FitCache) -> Result<Tuning, TuningError> {
        let key = tuning_key(self.scene, kind);
        if let Some(kept) = load(cache, &key).filter(|_| kind.is_repeatable()) {
            return Ok(kept);
        }
        let shadings: Vec<&Shading> = self.made.iter().map(|(shading, _)| shading).collect();
        let costs = Meter::new(kind)?.costs(&shadings)?;
        let row = |((shading, errors), cost): (&(Shading, VariantErrors), f64)| Row {
            variant: shading.variant().to_string(),
            errors: errors.clone(),
            cost,
            on_frontier: false,
        };
        let mut rows: Vec<Row> = self.made.iter().zip(costs).map(row).collect();
        rows.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.errors.max_delta_e.total_cmp(&b.errors.max_delta_e)));
        mark_frontier(&mut rows, false);
        let refused = self.refused.clone();
        let tuning = Tuning { cost: kind.name().to_owned(), has_tables: false, rows, refused };
        // Times differ from run to run: what was measured once is not kept for the next.
        if kind.is_repeatable() {
            store(cache, &key, &tuning);
        }
        Ok(tuning)
    }
}

/// Under what the measurement by a kind of cost is kept.
pub(super) fn tuning_key(scene: &Scene, kind: &CostKind) -> String {
    let candidates: Vec<String> = Variant::candidates_for(scene).iter().map(Variant::to_string).collect();
    format!("tuning 3 {} {} {candidates:?}", scene_key(scene), kind.name())
}
