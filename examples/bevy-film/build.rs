//! Makes the functions of the film as WGSL that Bevy imports as `pavo::thin_film`.

use pavo::{Build, BuildError, Language};

fn main() -> Result<(), BuildError> {
    Build::scene("scenes/film.toml").target(Language::Wgsl).import_path("pavo::thin_film").emit()?;
    Ok(())
}
