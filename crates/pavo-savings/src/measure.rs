//! What the two scenes of a case cost.

use crate::cases::{Case, Errors, Quantity};
use crate::failure::Failure;
use pavo::scene::Scene;
use pavo::tuning::Judge;
use pavo::{Shading, ShadingError, ShadingQuantity, Variant, cost, cost_baseline, library_quantity};
use pavo_check::static_cost::{StaticCompiler, net};
use pavo_emit::Language;

/// The family of graphics cards whose cycles are counted.
pub const FAMILY: &str = "navi21";

/// The surfaces of a case.
#[derive(Debug)]
pub struct Pair<'a> {
    /// The case.
    pub case: &'a Case,
    /// The surface that leaves something to run time.
    pub from: Shading,
    /// The surface that fixes it.
    pub to: Shading,
    /// The root of the mean square error of both, where their variants differ.
    pub rms: Option<[f64; 2]>,
}

/// A number of the surface that leaves something to run time, and that of the surface that fixes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saving {
    /// The first.
    pub from: f64,
    /// The second.
    pub to: f64,
}

impl Saving {
    /// The second as a part of the first.
    pub fn ratio(self) -> f64 {
        self.to / self.from
    }
}

impl<'a> Pair<'a> {
    /// The surfaces of a case; of the variants that the second may have, the one with the fewest operations whose error
    /// is within the limit of the case.
    ///
    /// # Errors
    /// If a surface cannot be made or evaluated, or no variant is right enough.
    pub fn new(case: &'a Case) -> Result<Self, Failure> {
        let from = shading(&case.from, &case.variant)?;
        if case.instead.is_empty() {
            return Ok(Self { case, from, to: shading(&case.to, &case.variant)?, rms: None });
        }
        let judge = Judge::new(&case.to)?;
        let rms_from = match case.errors {
            Errors::To => judge.errors(&shading(&case.to, &case.variant)?)?.rms,
            Errors::Each => Judge::new(&case.from)?.errors(&from)?.rms,
        };
        let mut candidates = Vec::new();
        for variant in &case.instead {
            match shading(&case.to, variant) {
                Ok(made) => candidates.push(made),
                // A fit that does not come close enough is no candidate.
                Err(Failure::Shading(ShadingError::Variant { .. })) => {}
                Err(other) => return Err(other),
            }
        }
        candidates.sort_by_key(|candidate| operations(case, candidate));
        let limit = case.max_rms.unwrap_or(rms_from);
        for to in candidates {
            let rms = judge.errors(&to)?.rms;
            if rms <= limit {
                return Ok(Self { case, from, to, rms: Some([rms_from, rms]) });
            }
        }
        Err(Failure::Choice { what: case.what.clone(), rms: limit })
    }

    /// The operations of both; quotients, roots, sines and the like count four.
    pub fn operations(&self) -> Saving {
        let [from, to] = [&self.from, &self.to].map(|shading| operations(self.case, shading) as f64);
        Saving { from, to }
    }

    /// The cycles of inverse throughput of both on a graphics card, net of an empty shader with the same inputs.
    ///
    /// # Errors
    /// If a shader cannot be emitted or compiled.
    pub fn cycles(&self, compiler: &StaticCompiler) -> Result<Saving, Failure> {
        let cycles = |shading: &Shading| -> Result<f64, Failure> {
            let quantity = quantity(self.case, shading);
            let compiled = |text: &str| compiler.wgsl("cost.wgsl", text, "main");
            let whole = compiled(&cost(shading, quantity, Language::Wgsl)?)?;
            let baseline = compiled(&cost_baseline(shading, quantity, Language::Wgsl)?)?;
            Ok(net(&whole, &baseline)?.inverse_throughput as f64)
        };
        Ok(Saving { from: cycles(&self.from)?, to: cycles(&self.to)? })
    }
}

fn shading(scene: &Scene, variant: &str) -> Result<Shading, Failure> {
    Ok(Shading::new(scene, &variant.parse::<Variant>()?)?)
}

/// What is counted of a surface.
fn quantity(case: &Case, shading: &Shading) -> ShadingQuantity {
    match case.quantity {
        Quantity::Reflectance => ShadingQuantity::Reflectance,
        Quantity::Surface => library_quantity(shading.scene()),
    }
}

fn operations(case: &Case, shading: &Shading) -> usize {
    shading.program(quantity(case, shading)).operations().weight()
}
