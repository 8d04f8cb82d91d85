//! Why the measuring ended early, and the exit code that says so: those of the command `pavo`.

use pavo::scene::SceneError;
use pavo::tuning::TuningError;
use pavo::{MediaError, ShadingError, VariantError};
use pavo_check::CheckError;
use pavo_emit::EmitError;
use std::process::ExitCode;
use thiserror::Error;

/// Why the measuring ended early.
#[derive(Debug, Error)]
pub enum Failure {
    /// The table of cases is wrong.
    #[error("templates/savings/savings.toml: {0}")]
    Table(String),
    /// No variant of a scene is as right as it has to be.
    #[error("{what}: no variant of those in `instead` has an RMS error of {rms:.2e} or less")]
    Choice {
        /// What was fixed.
        what: String,
        /// The error that is not to be exceeded.
        rms: f64,
    },
    /// A judge refuses a text, or a driver is missing or fails.
    #[error(transparent)]
    Check(#[from] CheckError),
    /// A text cannot be emitted.
    #[error(transparent)]
    Emit(#[from] EmitError),
    /// A scene of the table is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A variant of the table is wrong.
    #[error(transparent)]
    Variant(#[from] VariantError),
    /// A variant cannot be made for a scene.
    #[error(transparent)]
    Shading(#[from] ShadingError),
    /// The data of a scene cannot be had.
    #[error(transparent)]
    Media(#[from] MediaError),
    /// The points of a scene cannot be evaluated.
    #[error(transparent)]
    Tuning(#[from] TuningError),
}

impl Failure {
    /// The code to end the process with.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Failure::Check(CheckError::Missing { .. }) => 3,
            Failure::Table(_) | Failure::Scene(_) | Failure::Variant(_) => 2,
            _ => 1,
        })
    }
}
