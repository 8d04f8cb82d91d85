//! Installs the packages of other systems, and measures pavo's variants beside the shaders in them.

use std::path::Path;

use crate::command_line::CommandLine;
use crate::console::complain;
use crate::failure::{Failure, Status};
use crate::measuring::{self, ended};
use crate::programs::find_program;
use crate::workspace::Workspace;

/// Installs the packages into `target/peers` where asked to, and measures; what is measured is on the standard output,
/// all else on the standard error.
///
/// # Errors
///
/// npm or Python is missing, a package cannot be installed, or the measuring fails: its exit codes are those of the
/// command `pavo`.
pub fn run(workspace: &Workspace, install: bool, json: bool) -> Result<(), Failure> {
    let folder = workspace.target.join("peers");
    let shown = workspace.relative(&folder);
    if install {
        for package in installs(shown)? {
            complain(&format!("$ {package}"));
            ended(&package, package.run_aside(workspace)?, |_| Status::Missing)?;
        }
    }
    measuring::run(workspace, "pavo-peers", |measure| {
        let measure = measure.arguments([Path::new("--packages"), shown, Path::new("--output"), shown]);
        // One thread gives steadier times.
        measure.arguments(json.then_some("--json")).environment("LP_NUM_THREADS", "1")
    })
}

/// The commands that install the packages into a folder.
fn installs(folder: &Path) -> Result<[CommandLine; 2], Failure> {
    let missing = |program: &str, package: &str, debian: &str| {
        Failure::missing(format!(
            "{program} is needed to install the package {package}, and is not here; on Debian and Ubuntu, \
             `apt-get install {debian}` brings it. Nothing was measured"
        ))
    };
    if find_program("npm").is_none() {
        return Err(missing("npm", "three", "npm"));
    }
    let python = ["python3", "python"].into_iter().find(|name| find_program(name).is_some());
    let python = python.ok_or_else(|| missing("python3", "MaterialX", "python3-pip"))?;
    let npm = CommandLine::new("npm")
        .arguments(["install", "--no-audit", "--no-fund", "--loglevel=error", "--prefix"])
        .arguments([folder.join("npm")])
        .arguments(["three@latest"]);
    // Not an environment of its own: that would need one more package of Debian's.
    let pip = CommandLine::new(python)
        .arguments(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps", "--upgrade"])
        .arguments(["--target"])
        .arguments([folder.join("python")])
        .arguments(["MaterialX"]);
    Ok([npm, pip])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_packages_go_below_the_folder() {
        // Where a program is missing the message says which.
        match installs(Path::new("target/peers")) {
            Ok([npm, pip]) => {
                assert!(npm.to_string().ends_with("--prefix target/peers/npm three@latest"), "{npm}");
                assert!(pip.to_string().ends_with("--target target/peers/python MaterialX"), "{pip}");
            }
            Err(failure) => assert!(failure.message.contains("is not here"), "{}", failure.message),
        }
    }
}
