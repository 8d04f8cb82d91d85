//! The table of peers: what to take of which installed package, and how it is called.

use crate::classes::{Class, PeerInput};
use crate::extract::{declaration, without};
use crate::failure::Failure;
use serde::Deserialize;
use std::path::{Path, PathBuf};

const TABLE: &str = include_str!("../../../templates/peers/peers.toml");

/// A system whose own text is measured.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Peer {
    /// Its name in reports.
    pub name: String,
    /// Where its package comes from.
    pub registry: Registry,
    /// The name of its package.
    pub package: String,
    /// What stands before its text: what its own shader generator would define.
    #[serde(default)]
    pub prelude: String,
    /// The early return to leave out where the cost is counted.
    pub early_exit: Option<String>,
    /// What is taken of which file, in the order in which it is put together.
    pub text: Vec<Source>,
    /// How it is called.
    pub call: Vec<Call>,
}

/// A registry of packages.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Registry {
    /// npm: a package is the folder `npm/node_modules/<package>`.
    Npm,
    /// PyPI: a package is the folder `python/<package>`.
    Pypi,
}

/// Declarations of one file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// The file in the package.
    pub file: String,
    /// The words that the declarations start with.
    pub declarations: Vec<String>,
}

/// A call of a system's function.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Call {
    /// What sets it apart from the way in which the system itself makes the call.
    pub note: Option<String>,
    /// The classes of surfaces that it is for.
    pub classes: Vec<Class>,
    /// Its inputs.
    pub inputs: Vec<PeerInput>,
    /// The call in GLSL.
    pub expression: String,
}

/// The text of a peer.
#[derive(Debug)]
pub struct PeerText {
    /// As it is shipped.
    pub shipped: String,
    /// Without the early return, where it has one.
    pub without_exit: Option<String>,
}

/// The peers of the table.
///
/// # Errors
/// If the table is broken.
pub fn peers() -> Result<Vec<Peer>, Failure> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Table {
        peer: Vec<Peer>,
    }
    let table: Table =
        toml::from_str(TABLE).map_err(|error| Failure::Text(format!("templates/peers/peers.toml: {error}")))?;
    Ok(table.peer)
}

impl Peer {
    /// The version of the installed package.
    ///
    /// # Errors
    /// If the package is not there.
    pub fn version(&self, packages: &Path) -> Result<String, Failure> {
        let found = match self.registry {
            Registry::Npm => npm_version(&self.folder(packages)),
            Registry::Pypi => pypi_version(&packages.join("python"), &self.package),
        };
        found.ok_or_else(|| {
            let (package, folder) = (&self.package, packages.display());
            Failure::Missing(format!(
                "the package {package} is not installed in {folder}: `cargo xtask peers` installs it"
            ))
        })
    }

    /// The text that its calls need.
    ///
    /// # Errors
    /// If a file cannot be read, or does not hold what is taken of it.
    pub fn read(&self, packages: &Path) -> Result<PeerText, Failure> {
        let mut parts = Vec::new();
        if !self.prelude.is_empty() {
            parts.push(self.prelude.clone());
        }
        for source in &self.text {
            let path = self.folder(packages).join(&source.file);
            let text = std::fs::read_to_string(&path).map_err(|cause| Failure::file(&path, cause))?;
            for marker in &source.declarations {
                let found = declaration(&text, marker);
                parts.push(found.map_err(|error| Failure::Text(format!("{}: {error}", path.display())))?.to_owned());
            }
        }
        let shipped = parts.join("\n\n");
        let without_exit = self.early_exit.as_ref().map(|marker| without(&shipped, marker)).transpose();
        let without_exit = without_exit.map_err(|error| Failure::Text(format!("{}: {error}", self.name)))?;
        Ok(PeerText { shipped, without_exit })
    }

    fn folder(&self, packages: &Path) -> PathBuf {
        let folder = match self.registry {
            Registry::Npm => "npm/node_modules",
            Registry::Pypi => "python",
        };
        packages.join(folder).join(&self.package)
    }
}

fn npm_version(package: &Path) -> Option<String> {
    let text = std::fs::read_to_string(package.join("package.json")).ok()?;
    let manifest: serde_json::Value = serde_json::from_str(&text).ok()?;
    manifest.get("version")?.as_str().map(str::to_owned)
}

/// The version of a Python package, from the name of the folder `<package>-<version>.dist-info` beside it.
fn pypi_version(folder: &Path, package: &str) -> Option<String> {
    let entries = std::fs::read_dir(folder).ok()?;
    entries.flatten().find_map(|entry| {
        let name = entry.file_name().into_string().ok()?;
        let (found, version) = name.strip_suffix(".dist-info")?.split_once('-')?;
        found.eq_ignore_ascii_case(package).then(|| version.to_owned())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_peers_is_whole() {
        let peers = peers().unwrap_or_else(|error| panic!("{error}"));
        for peer in &peers {
            for class in Class::ALL {
                let calls = peer.call.iter().filter(|call| call.classes.contains(&class) && call.note.is_none());
                assert_eq!(calls.count(), 1, "{} calls for the {} once", peer.name, class.name());
            }
            for call in &peer.call {
                let named = |input: &PeerInput| call.expression.contains(&input.name());
                assert!(call.inputs.iter().all(named), "{}: {}", peer.name, call.expression);
            }
        }
    }

    #[test]
    fn a_package_that_is_not_installed_is_missing() {
        let peers = peers().unwrap_or_else(|error| panic!("{error}"));
        for peer in peers {
            let failure = peer.version(Path::new("no/such/folder")).expect_err("it is not there");
            assert!(matches!(&failure, Failure::Missing(message) if message.contains(&peer.package)), "{failure}");
        }
    }
}
