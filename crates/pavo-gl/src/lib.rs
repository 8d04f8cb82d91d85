//! Runs fragment shaders in GLSL 3.30 and GLSL ES 3.00 by the OpenGL of the system, without a window or a display.
//!
//! Vulkan reads neither language. Here Mesa's own compiler does, on its driver for the CPU where there is no card:
//! [`GlDevice`] opens EGL without a surface, draws one pixel a point into a target of 32-bit floats, and reads it back.
//! libEGL is opened when it is needed; a system without it gets a [`GlError::Missing`] that says what to install.

mod context;
mod draw;

pub use context::{Api, GlDevice};

use thiserror::Error;

/// How many points a row of the target holds.
pub const POINTS_PER_ROW: usize = 256;

/// How many numbers a texel of the inputs holds.
pub const NUMBERS_PER_TEXEL: usize = 4;

/// Why a shader cannot be run.
#[derive(Debug, Error)]
pub enum GlError {
    /// EGL, or a driver behind it, is not installed.
    #[error(
        "{what} is missing: {reason}; install the packages `libegl1`, `libgl1-mesa-dri` and `libgles2` (Debian, Ubuntu)"
    )]
    Missing {
        /// What is missing.
        what: &'static str,
        /// What the system says.
        reason: String,
    },
    /// The driver has no targets of 32-bit floats.
    #[error("{device} cannot draw to 32-bit floats (EXT_color_buffer_float); use Mesa's llvmpipe")]
    NoFloatTarget {
        /// The driver.
        device: String,
    },
    /// The driver's compiler refuses a shader.
    #[error("the {stage} shader is refused by {device}:\n{log}")]
    Refused {
        /// Which shader.
        stage: &'static str,
        /// The driver.
        device: String,
        /// What its compiler says.
        log: String,
    },
    /// The points do not all have as many numbers as the shader takes.
    #[error("point {index} has {found} numbers where the shader takes {expected}")]
    Points {
        /// The number of the point, from 0.
        index: usize,
        /// How many numbers it has.
        found: usize,
        /// How many are right.
        expected: usize,
    },
    /// OpenGL fails.
    #[error("{device} fails to {what}: {reason}")]
    Failed {
        /// The driver.
        device: String,
        /// What it was asked to do.
        what: &'static str,
        /// What it says.
        reason: String,
    },
}
