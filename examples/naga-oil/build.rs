//! Makes the functions of the film as WGSL that is imported as `pavo::thin_film`.

use pavo::{Build, BuildError, Language};

fn main() -> Result<(), BuildError> {
    Build::scene("../bevy-film/scenes/film.toml").target(Language::Wgsl).import_path("pavo::thin_film").emit()?;
    Ok(())
}
