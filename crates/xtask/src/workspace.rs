//! Where the workspace is, where it is built, and with which cargo.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::command_line::CommandLine;
use crate::failure::Failure;

/// The folders and the cargo that every step uses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Workspace {
    /// The folder of the workspace's manifest, absolute.
    pub root: PathBuf,
    /// The folder that cargo builds in, absolute.
    pub target: PathBuf,
    /// The cargo that runs this tool.
    pub cargo: OsString,
}

impl Workspace {
    /// The workspace that this tool was compiled in. Cargo compiles it anew where the workspace has moved.
    ///
    /// `CARGO_TARGET_DIR` names the folder to build in, as it does for cargo.
    ///
    /// # Errors
    ///
    /// The current folder cannot be read, and `CARGO_TARGET_DIR` is relative to it.
    pub fn of_this_tool() -> Result<Workspace, Failure> {
        let manifest_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        // This package is two folders below the root: crates/xtask.
        let root = manifest_folder.ancestors().nth(2).unwrap_or(manifest_folder).to_owned();
        let target = match std::env::var_os("CARGO_TARGET_DIR").filter(|folder| !folder.is_empty()) {
            // Resolved where it is there already, as it is when cargo has compiled this tool into it.
            Some(folder) => {
                std::fs::canonicalize(&folder).or_else(|_| std::path::absolute(&folder)).map_err(|error| {
                    let folder = folder.to_string_lossy();
                    Failure::bad_input(format!(
                        "CARGO_TARGET_DIR is `{folder}`, which cannot be made absolute: {error}"
                    ))
                })?
            }
            None => root.join("target"),
        };
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        Ok(Workspace { root, target, cargo })
    }

    /// A call of cargo.
    pub fn cargo(&self, arguments: &[&str]) -> CommandLine {
        CommandLine::new(&self.cargo).shown_as("cargo").arguments(arguments)
    }

    /// A path as it is shown, and as a command that runs in the root takes it: relative to the root where it lies below.
    pub fn relative<'a>(&self, path: &'a Path) -> &'a Path {
        path.strip_prefix(&self.root).unwrap_or(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_holds_the_manifest_of_the_workspace() {
        let workspace = Workspace::of_this_tool().expect("the workspace is found");
        let manifest = std::fs::read_to_string(workspace.root.join("Cargo.toml")).expect("the manifest can be read");
        assert!(manifest.contains("[workspace]"));
        assert!(workspace.target.is_absolute());
    }

    #[test]
    fn paths_are_relative_to_the_root_where_they_lie_below() {
        let workspace = Workspace { root: "/home/me/pavo".into(), target: "/build".into(), cargo: "cargo".into() };
        for (path, expected) in
            [("/home/me/pavo/target/demo", "target/demo"), ("/build/demo", "/build/demo"), ("/home/me", "/home/me")]
        {
            assert_eq!(workspace.relative(Path::new(path)), Path::new(expected));
        }
    }
}
