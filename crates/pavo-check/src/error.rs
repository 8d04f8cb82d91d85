//! The errors of this crate.

use std::fmt;
use std::path::PathBuf;

use crate::install::Requirement;
use crate::judge::{Diagnostic, Verdict};

/// Why a check gave no pass.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckError {
    /// At least one judge refuses the input.
    #[error("{}", RefusalText(.verdicts))]
    Refused {
        /// The verdicts of every judge that was asked, those that pass included.
        verdicts: Vec<Verdict>,
    },

    /// A tool or a driver of the system is not here.
    #[error("{what} is missing: {install}{}", .found.as_ref().map(|found| format!(" ({found})")).unwrap_or_default())]
    Missing {
        /// What is missing.
        what: String,
        /// What to install to get it.
        install: String,
        /// What was found in its place, such as the other Vulkan devices.
        found: Option<String>,
    },

    /// A file cannot be read.
    #[error("{}: cannot be read: {reason}", pavo_files::shown(.path))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: String,
    },

    /// No judge reads this kind of file.
    #[error("{}: no judge reads this kind of file: expected one of {expected}", pavo_files::shown(.path))]
    UnknownKind {
        /// The file.
        path: PathBuf,
        /// The extensions that are read.
        expected: String,
    },

    /// An argument does not fit the shader or the call.
    #[error("{0}")]
    Input(String),

    /// An argument is beyond what the device can do.
    #[error("{what}: {asked} asked, the device allows {allowed}")]
    Limit {
        /// The limit, with its unit.
        what: String,
        /// What the call asks for.
        asked: u64,
        /// The most that the device allows.
        allowed: u64,
    },

    /// A Vulkan call failed.
    #[error("Vulkan: cannot {action}: {reason}")]
    Vulkan {
        /// What was being done, as an infinitive.
        action: &'static str,
        /// What the driver said.
        reason: String,
    },

    /// A tool could be started but did not do its work.
    #[error("{tool}: {reason}")]
    Tool {
        /// The tool.
        tool: String,
        /// What went wrong.
        reason: String,
    },
}

impl CheckError {
    /// The status with which a command should exit: 3 when something has to be installed first, otherwise 1.
    pub fn exit_status(&self) -> u8 {
        match self {
            CheckError::Missing { .. } => 3,
            _ => 1,
        }
    }

    /// The diagnostics of every judge that refused; empty unless this is a refusal.
    pub fn diagnostics(&self) -> impl Iterator<Item = &Diagnostic> {
        let verdicts = match self {
            CheckError::Refused { verdicts } => verdicts.as_slice(),
            _ => &[],
        };
        verdicts.iter().filter(|verdict| !verdict.passed).flat_map(|verdict| &verdict.diagnostics)
    }

    /// The error for a requirement that is not on this system.
    pub(crate) fn missing(requirement: Requirement) -> CheckError {
        CheckError::Missing { what: requirement.name.to_owned(), install: requirement.install.to_owned(), found: None }
    }
}

/// Prints a refusal: one line for each diagnostic of the judges that refused.
struct RefusalText<'a>(&'a [Verdict]);

impl fmt::Display for RefusalText<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let judges: Vec<&str> =
            self.0.iter().filter(|verdict| !verdict.passed).map(|verdict| verdict.judge.name()).collect();
        write!(formatter, "refused by {}", judges.join(" and "))?;
        for diagnostic in self.0.iter().filter(|verdict| !verdict.passed).flat_map(|verdict| &verdict.diagnostics) {
            write!(formatter, "\n{diagnostic}")?;
        }
        Ok(())
    }
}
