//! Why a build script cannot emit.

use crate::scene::SceneError;
use crate::shading::ShadingError;
use crate::variant::VariantError;
use std::fmt;
use std::path::Path;

/// Why a scene could not be emitted: where it is, what is wrong, and what would be right.
///
/// `Debug`, which cargo shows of a build script whose `main` returns it, is that text, and no dump of fields.
pub struct BuildError {
    text: String,
}

impl BuildError {
    /// The same error of a scene in a file.
    pub(super) fn in_file(self, path: &Path) -> Self {
        Self { text: format!("{}: {}", pavo_files::shown(path), self.text) }
    }

    pub(super) fn new(message: impl fmt::Display, help: impl fmt::Display) -> Self {
        Self { text: format!("{message}\n  help: {help}") }
    }
}

impl fmt::Display for BuildError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

impl fmt::Debug for BuildError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

impl std::error::Error for BuildError {}

impl From<SceneError> for BuildError {
    fn from(error: SceneError) -> Self {
        Self { text: format!("{error:?}") }
    }
}

impl From<ShadingError> for BuildError {
    fn from(error: ShadingError) -> Self {
        match error.help_text() {
            Some(help) => Self::new(&error, help),
            None => Self { text: error.to_string() },
        }
    }
}

impl From<VariantError> for BuildError {
    fn from(error: VariantError) -> Self {
        Self::new(&error, error.help())
    }
}
