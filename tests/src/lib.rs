//! What the tests that cross crates share: the starter scenes, and the command as a process.

pub mod random;
pub mod unused;

use pavo::scene::Scene;
use pavo::{Shading, Variant};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The names of the starter scenes in `templates/scenes`.
pub const SCENES: [&str; 9] = [
    "anodised-titanium",
    "bare-plastic",
    "beetle-shell",
    "coated-lens",
    "lacquered-gold",
    "oil-on-water",
    "oxide-on-silicon",
    "rutile-on-titanium",
    "soap-bubble",
];

/// The file of a starter scene.
pub fn scene_file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../templates/scenes").join(format!("{name}.toml"))
}

/// A starter scene with its own variant.
///
/// # Panics
/// If it is not a good scene.
pub fn starter(name: &str) -> Shading {
    let scene = Scene::load(&scene_file(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let variant: Variant = scene.emit.variant.parse().unwrap_or_else(|error| panic!("{name}: {error}"));
    Shading::new(&scene, &variant).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// What a run of the command gave.
#[derive(Debug)]
pub struct Ran {
    /// The exit status.
    pub status: i32,
    /// Standard output.
    pub output: String,
    /// Standard error.
    pub errors: String,
}

/// Runs the command in a folder.
///
/// # Panics
/// If it cannot be started, or is ended by a signal.
pub fn run(program: &str, folder: &Path, arguments: &[&str]) -> Ran {
    // Each folder has a cache of its own: no test sees what an earlier build has kept.
    let mut command = Command::new(program);
    command.current_dir(folder).args(arguments).env("NO_COLOR", "1").env("PAVO_CACHE", folder.join("cache"));
    let result = command.output();
    let Output { status, stdout, stderr } = result.unwrap_or_else(|error| panic!("{program}: {error}"));
    Ran {
        status: status.code().unwrap_or_else(|| panic!("{arguments:?} was ended by a signal")),
        output: String::from_utf8_lossy(&stdout).into_owned(),
        errors: String::from_utf8_lossy(&stderr).into_owned(),
    }
}
