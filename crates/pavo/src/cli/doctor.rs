//! `pavo doctor`: which judges and drivers are here.

use super::arguments;
use super::failure::Failure;
use super::output;
use pavo_check::CheckError;
use pavo_check::doctor::{Finding, survey};
use serde_json::json;

/// Prints what was found, and fails if something needed is missing.
pub fn run(arguments: &arguments::Doctor) -> Result<(), Failure> {
    let findings = survey();
    if arguments.json {
        output::print(&format!("{:#}\n", json!(findings)))?;
    } else {
        output::print(&findings.iter().map(line).collect::<String>())?;
    }
    let missing: Vec<&Finding> = findings.iter().filter(|finding| !finding.found).collect();
    match missing.first() {
        None => Ok(()),
        Some(first) => Err(CheckError::Missing {
            what: missing.iter().map(|finding| finding.name.as_str()).collect::<Vec<_>>().join(", "),
            install: first.install.clone().unwrap_or_default(),
            found: None,
        }
        .into()),
    }
}

fn line(finding: &Finding) -> String {
    let version = finding.version.as_deref().unwrap_or("");
    let place = finding.location.as_deref().or(finding.install.as_deref()).unwrap_or("");
    let mark = if finding.found { "found  " } else { "MISSING" };
    format!("{mark} {:<14} {version}  {place}\n", finding.name)
}
