//! Why the measuring ended early, and the exit code that says so: those of the command `pavo`.

use pavo::roads::RoadError;
use pavo::scene::SceneError;
use pavo::{MediaError, ShadingError, VariantError};
use pavo_check::CheckError;
use pavo_emit::EmitError;
use std::path::Path;
use std::process::ExitCode;
use thiserror::Error;

/// Why the measuring ended early.
#[derive(Debug, Error)]
pub enum Failure {
    /// The text of a package is not what the table of peers expects.
    #[error("{0}")]
    Text(String),
    /// Something that is needed is missing.
    #[error("{0}")]
    Missing(String),
    /// A file that cannot be read or written.
    #[error("{path}: {cause}")]
    File {
        /// The file.
        path: String,
        /// Why.
        cause: std::io::Error,
    },
    /// A judge refuses a text, or a driver fails.
    #[error(transparent)]
    Check(#[from] CheckError),
    /// A text cannot be emitted.
    #[error(transparent)]
    Emit(#[from] EmitError),
    /// A scene of a class is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A variant is wrong.
    #[error(transparent)]
    Variant(#[from] VariantError),
    /// A variant cannot be made for a class.
    #[error(transparent)]
    Shading(#[from] ShadingError),
    /// The data of a scene cannot be had.
    #[error(transparent)]
    Media(#[from] MediaError),
    /// A quantity cannot be evaluated.
    #[error(transparent)]
    Road(#[from] RoadError),
}

impl Failure {
    /// A file that cannot be read or written.
    pub fn file(path: &Path, cause: std::io::Error) -> Failure {
        Failure::File { path: pavo_files::shown(path), cause }
    }

    /// The code to end the process with.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Failure::Missing(_)
            | Failure::Check(CheckError::Missing { .. })
            | Failure::Road(RoadError::Check(CheckError::Missing { .. })) => 3,
            Failure::Text(_) | Failure::File { .. } => 2,
            _ => 1,
        })
    }
}
