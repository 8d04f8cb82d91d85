//! What a short examination finds of the numerical stability of the variant that is shown.

use super::figures::StabilityFinding;
use crate::cli::failure::Failure;
use crate::shading::Shading;
use crate::stability::{Check, Effort, Exceptions, Judged, Placed, examine};
use pavo_check::Device;

/// Ten times the points of a quick sweep: it is one variant alone.
const EFFORT: Effort = Effort { sweep_points: 400_000, all_roads: true, ..Effort::QUICK };

/// The largest figure of each check.
pub fn findings(device: &Device, shading: &Shading) -> Result<Vec<StabilityFinding>, Failure> {
    let placed = [Placed::new(shading.clone())];
    let stability = examine(device, &placed, EFFORT, &|_, _| {})?;
    let exceptions = Exceptions::built_in()?;
    let judgement = exceptions.judge(&stability.findings);
    let largest = |check: Check| {
        let rows = judgement.rows.iter().filter(|row| row.finding.check == check);
        // Of rows alike, the one over the most points says the most.
        let size = |row: &Judged<'_>| (row.finding.value, row.finding.points);
        let order = |a: (f64, usize), b: (f64, usize)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
        let row = rows.max_by(|a, b| order(size(a), size(b)))?;
        Some(StabilityFinding { place: check.described().to_owned(), message: said(row) })
    };
    Ok(Check::ALL.into_iter().filter_map(largest).collect())
}

fn said(row: &Judged<'_>) -> String {
    let finding = row.finding;
    let kept = match (row.passed, row.exception) {
        (true, None) if row.bound == 0.0 => "as it must be".to_owned(),
        (true, None) => format!("within {:.0e}", row.bound),
        (true, Some(reason)) => format!("within {:.0e}, an exception: {reason}", row.bound),
        (false, _) => format!("beyond {:.0e}, which is not kept", row.bound),
    };
    let value = if finding.value == 0.0 { "none".to_owned() } else { format!("{:.1e}", finding.value) };
    let (case, evaluator) = (&finding.case, &finding.evaluator);
    format!("{value} over {} points ({case}, {evaluator}); {kept}", finding.points)
}
