//! Makes the functions of the soap film: in WGSL for the shader, in Rust for the check.

use pavo::{Build, BuildError, Language};

fn main() -> Result<(), BuildError> {
    Build::scene("scenes/bubble.toml").target(Language::Wgsl).target(Language::Rust).emit()?;
    Ok(())
}
