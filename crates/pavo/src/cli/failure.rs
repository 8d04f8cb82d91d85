//! How a command fails: with a message, and with a status that says of what kind.

use super::output::printable;
use super::work;
use crate::media::MediaError;
use crate::points_table::PointsError;
use crate::roads::RoadError;
use crate::scene::SceneError;
use crate::shading::ShadingError;
use crate::tuning::TuningError;
use crate::variant::VariantError;
use miette::{Report, miette};
use pavo_check::CheckError;
use pavo_emit::EmitError;
use pavo_files::shown;
use std::io::ErrorKind;
use std::path::Path;
use std::process::ExitCode;

/// A check failed.
pub const CHECK_FAILED: u8 = 1;
/// The input is not what it should be.
pub const BAD_INPUT: u8 = 2;

/// Why a command did not do what was asked.
pub struct Failure {
    status: u8,
    report: Report,
}

impl Failure {
    /// Bad input: what is wrong, and what would be right.
    pub fn input(message: impl std::fmt::Display, help: impl std::fmt::Display) -> Self {
        Self { status: BAD_INPUT, report: miette!(help = help.to_string(), "{}", printable(&message.to_string())) }
    }

    /// A check that failed.
    pub fn check(message: impl std::fmt::Display) -> Self {
        Self { status: CHECK_FAILED, report: miette!("{}", printable(&message.to_string())) }
    }

    /// A file that cannot be read or written.
    pub fn file(path: &Path, action: &str, error: &std::io::Error) -> Self {
        let help = match error.kind() {
            ErrorKind::IsADirectory => "name a file in it",
            ErrorKind::NotADirectory | ErrorKind::AlreadyExists => {
                "a part of the path is a file; name one below a folder"
            }
            ErrorKind::NotFound => "name a file in a folder that is there",
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
                "name a file in a folder that this user may read and write"
            }
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded => "make room on the disk, or name a file on another one",
            ErrorKind::FileTooLarge if action == "written" => {
                "raise the limit on the size of files (`ulimit -f`), or name a file on another disk"
            }
            ErrorKind::FileTooLarge => "divide the file, or leave out of it what is not read",
            ErrorKind::InvalidFilename => "give it a shorter name",
            ErrorKind::TimedOut => "name an ordinary file, or a pipe that somebody writes to",
            _ => "name a file that can be, in a folder that is there",
        };
        Self::input(format!("{}: cannot be {action}: {error}", shown(path)), help)
    }

    /// Prints the message, and gives the status to exit with.
    pub fn report(self) -> ExitCode {
        output_error(&self.report);
        ExitCode::from(self.status)
    }
}

#[allow(clippy::print_stderr)]
fn output_error(report: &Report) {
    eprintln!("{report:?}");
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self { status: BAD_INPUT, report: Report::new(error) }
    }
}

impl From<ShadingError> for Failure {
    fn from(error: ShadingError) -> Self {
        Self { status: BAD_INPUT, report: Report::new(error) }
    }
}

impl From<MediaError> for Failure {
    fn from(error: MediaError) -> Self {
        Self { status: BAD_INPUT, report: Report::new(error) }
    }
}

impl From<PointsError> for Failure {
    fn from(error: PointsError) -> Self {
        Self { status: BAD_INPUT, report: Report::new(error) }
    }
}

impl From<VariantError> for Failure {
    fn from(error: VariantError) -> Self {
        match error.excess().and_then(work::of_variant) {
            Some(taken) => Self::input(format!("{error}: {taken}"), error.help()),
            None => Self::input(&error, error.help()),
        }
    }
}

impl From<EmitError> for Failure {
    fn from(error: EmitError) -> Self {
        Self { status: BAD_INPUT, report: miette!("{error}") }
    }
}

impl From<RoadError> for Failure {
    fn from(error: RoadError) -> Self {
        match error {
            RoadError::Emit(error) => error.into(),
            RoadError::Check(error) => error.into(),
        }
    }
}

impl From<TuningError> for Failure {
    fn from(error: TuningError) -> Self {
        match error {
            TuningError::Shading(error) => error.into(),
            TuningError::Media(error) => error.into(),
            TuningError::Check(error) => error.into(),
            TuningError::Emit(error) => error.into(),
            TuningError::Budget { .. } => Self { status: CHECK_FAILED, report: Report::new(error) },
        }
    }
}

impl From<CheckError> for Failure {
    fn from(error: CheckError) -> Self {
        let status = match error {
            CheckError::Unreadable { .. } | CheckError::UnknownKind { .. } => BAD_INPUT,
            _ => error.exit_status(),
        };
        Self { status, report: miette!("{}", printable(&error.to_string())) }
    }
}
