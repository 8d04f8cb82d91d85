//! What drivers may do to a variant's reflectance.

use super::{Added, Sample, on_all_cores, reflectances};
use crate::statistics::Difference;
use pavo_shade::emulated::{Contracting, Emulated, Exact, Flushing, Loose, Policy, SwiftShader, Vulkan};
use pavo_shade::{Real, evaluate};
use serde::Serialize;

/// A reflectance as a driver may compute it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PolicyRow {
    /// What the driver departs in from the arithmetic of the CPU.
    pub policy: &'static str,
    /// Against the variant in f64, at the same numbers of f32.
    pub against_f64: Added,
    /// Against the exact spectral reference.
    pub against_reference: Added,
    /// How many values were no finite numbers.
    pub not_finite: usize,
}

type Row = fn(&'static str, &Sample) -> PolicyRow;

/// The policies of `pavo_shade::emulated`.
const POLICIES: [(&str, Row); 6] = [
    ("exact", row::<Exact>),
    ("contraction", row::<Contracting>),
    ("flushed denormals", row::<Flushing>),
    ("sines of SwiftShader, off by up to 2e-4", row::<SwiftShader>),
    ("least precision of Vulkan, sines off by up to 4e-7", row::<Loose>),
    ("least precision of Vulkan, sines off by up to 2^-11", row::<Vulkan>),
];

/// The points of a sample as each driver may compute them.
pub fn policies(sample: &Sample) -> Vec<PolicyRow> {
    POLICIES.iter().map(|(policy, row)| row(policy, sample)).collect()
}

fn row<P: Policy>(policy: &'static str, sample: &Sample) -> PolicyRow {
    let evaluate = |points: &[Vec<f64>]| {
        let lit = |point: &Vec<f64>| point.iter().map(|&number| Emulated::<P>::lit(number)).collect();
        let points: Vec<Vec<Emulated<P>>> = points.iter().map(lit).collect();
        reflectances(evaluate(&sample.program, &points))
    };
    let found: Vec<[f64; 3]> =
        on_all_cores(&sample.points, |points| evaluate(points).into_iter().map(|color| color.map(f64::from)).collect());
    PolicyRow {
        policy,
        against_f64: Added::between(&found, &sample.values),
        against_reference: Added::between(&found, &sample.reference),
        not_finite: Difference::between(&found, &sample.values, 1).not_finite,
    }
}
