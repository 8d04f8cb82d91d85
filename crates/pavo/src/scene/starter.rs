//! The scene that a new project starts from.

use super::error::SceneError;
use super::validate::check_name;

/// A commented scene, a soap bubble, that stands for any name as `NAME`; [`starter`] puts the name in.
pub const STARTER: &str = include_str!("starter.toml");

/// The text of a new scene called `name`.
///
/// # Errors
/// A `name` that no scene may have.
pub fn starter(name: &str) -> Result<String, SceneError> {
    check_name(name).map_err(|fault| fault.into_error())?;
    Ok(STARTER.replace("NAME", name))
}
