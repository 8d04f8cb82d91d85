//! `pavo new`: a scene to start from.

use super::arguments;
use super::failure::Failure;
use super::output;
use crate::scene::starter;
use std::path::PathBuf;

/// Writes a starter scene, unless there is a file of that name.
pub fn run(arguments: &arguments::New) -> Result<(), Failure> {
    let text = starter(&arguments.name)?;
    let path = PathBuf::from(format!("{}.toml", arguments.name));
    if path.exists() {
        return Err(Failure::input(
            format!("{} is there already", pavo_files::shown(&path)),
            "choose another name, or move the file away",
        ));
    }
    output::write(&path, text.as_bytes())?;
    output::print(&format!("{}: edit it, then: pavo build {}\n", path.display(), path.display()))
}
