//! What each check may find: bounds for all, and the exceptions from them, each with its reason.

use super::StabilityError;
use super::finding::{Check, Finding};
use super::surfaces::matches;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

const TEXT: &str = include_str!("../../../../templates/stability/exceptions.toml");

/// The table of bounds and exceptions.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exceptions {
    /// The bound of each check.
    bounds: BTreeMap<Check, f64>,
    /// The exceptions.
    #[serde(default, rename = "exception")]
    rows: Vec<Exception>,
}

/// An exception: of what, from which check, how far, and why.
#[derive(Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Exception {
    /// Patterns of variants, `*` for any text.
    pub variants: Vec<String>,
    /// Patterns of surfaces.
    #[serde(default = "any")]
    pub surfaces: Vec<String>,
    /// Patterns of cases.
    #[serde(default = "any")]
    pub cases: Vec<String>,
    /// The check.
    pub check: Check,
    /// What it may find.
    pub bound: f64,
    /// Why.
    pub reason: String,
    /// Whether only the full effort finds what needs it.
    #[serde(default)]
    only_full: bool,
}

fn any() -> Vec<String> {
    vec!["*".to_owned()]
}

impl Exception {
    /// Whether it may be needed where only the full effort looks: in the sweep, or as the table says.
    pub fn needs_full(&self) -> bool {
        let is_of_sweep = self.check == Check::SingleP99 || self.cases.iter().all(|case| case == super::SWEEP);
        self.only_full || is_of_sweep
    }

    fn covers(&self, finding: &Finding) -> bool {
        let one = |patterns: &[String], text: &str| patterns.iter().any(|pattern| matches(pattern, text));
        self.check == finding.check
            && one(&self.variants, &finding.variant)
            && one(&self.surfaces, &finding.surface)
            && one(&self.cases, &finding.case)
    }
}

/// A finding with its bound.
#[derive(Debug, Serialize)]
pub struct Judged<'a> {
    /// The finding.
    #[serde(flatten)]
    pub finding: &'a Finding,
    /// What it may be.
    pub bound: f64,
    /// Why it may be more than the bound of all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exception: Option<&'a str>,
    /// Whether it keeps to the bound.
    pub passed: bool,
}

/// An exception that nothing needs.
#[derive(Debug, Serialize)]
pub struct Stale<'a> {
    /// The exception.
    pub exception: &'a Exception,
    /// The largest figure that it covers.
    pub largest: f64,
    /// The bound of all.
    pub bound: f64,
}

/// All findings with their bounds.
#[derive(Debug)]
pub struct Judgement<'a> {
    /// The findings.
    pub rows: Vec<Judged<'a>>,
    /// Exceptions that are not needed.
    pub stale: Vec<Stale<'a>>,
}

impl Exceptions {
    /// The table that is compiled in.
    ///
    /// # Errors
    /// If it is not as it should be, which the tests rule out.
    pub fn built_in() -> Result<Self, StabilityError> {
        Self::read(TEXT)
    }

    fn read(text: &str) -> Result<Self, StabilityError> {
        let table: Self =
            toml::from_str(text).map_err(|error| StabilityError::Data(format!("exceptions.toml: {error}")))?;
        match Check::ALL.into_iter().find(|check| !table.bounds.contains_key(check)) {
            Some(check) => Err(StabilityError::Data(format!("exceptions.toml: {check} has no bound"))),
            None => Ok(table),
        }
    }

    /// Holds the findings against the bounds; the first exception that covers a finding is its own.
    pub fn judge<'a>(&'a self, findings: &'a [Finding]) -> Judgement<'a> {
        let bound = |check: Check| self.bounds.get(&check).copied().unwrap_or(0.0);
        let mut largest = vec![None; self.rows.len()];
        let rows = findings.iter().map(|finding| {
            let place = self.rows.iter().position(|row| row.covers(finding));
            if let Some(place) = place {
                largest[place] = Some(finding.value.max(largest[place].unwrap_or(0.0)));
            }
            let exception = place.map(|place| &self.rows[place]);
            let bound = exception.map_or(bound(finding.check), |exception| exception.bound);
            let exception = exception.map(|exception| exception.reason.as_str());
            Judged { finding, bound, exception, passed: finding.value <= bound }
        });
        let rows = rows.collect();
        let stale = self.rows.iter().zip(largest).filter_map(|(exception, largest)| {
            let (largest, bound) = (largest.unwrap_or(0.0), bound(exception.check));
            (largest <= bound).then_some(Stale { exception, largest, bound })
        });
        Judgement { rows, stale: stale.collect() }
    }
}

impl Judgement<'_> {
    /// The findings that do not keep to their bounds.
    pub fn failures(&self) -> impl Iterator<Item = &Judged<'_>> {
        self.rows.iter().filter(|row| !row.passed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "[bounds]\nfinite = 0\nrange = 1e-6\nsingle = 1\nsingle-p99 = 1\nreference = 1\nneutral = 1\n\
        continuity = 1\nenergy = 1\nreciprocity = 1\nwavelength = 1\ncontained = 0\n\
        [[exception]]\nvariants = ['poles:*']\ncheck = 'range'\nbound = 1e-3\nreason = 'poles overshoot'\n";

    fn finding(variant: &str, value: f64) -> Finding {
        Finding {
            surface: "dielectric".to_owned(),
            variant: variant.to_owned(),
            case: "thin".to_owned(),
            check: Check::Range,
            evaluator: "cpu f64".to_owned(),
            quantity: "reflectance",
            points: 1,
            value,
            worst: Vec::new(),
        }
    }

    #[test]
    fn an_exception_must_be_kept_and_must_be_needed() {
        let table = Exceptions::read(TABLE).expect("a table");
        for (variant, value, passed, stale) in [
            ("poles:k=5", 9e-4, true, 0),
            ("poles:k=5", 2e-3, false, 0),
            ("poles:k=5", 1e-7, true, 1),
            ("windowed:k=6", 9e-4, false, 1),
            ("windowed:k=6", f64::INFINITY, false, 1),
        ] {
            let findings = [finding(variant, value)];
            let judgement = table.judge(&findings);
            assert_eq!((judgement.rows[0].passed, judgement.stale.len()), (passed, stale), "{variant} {value}");
        }
    }

    #[test]
    fn the_compiled_in_table_is_read() {
        Exceptions::built_in().expect("it is as it should be");
    }
}
