//! Installs the packages of other systems, and measures pavo's variants beside the shaders in them.

use std::path::Path;
use std::process::ExitStatus;

use crate::command_line::{CommandLine, end_text};
use crate::console::complain;
use crate::failure::{Failure, Status};
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
    let program = workspace.target.join("release").join(format!("pavo-peers{}", std::env::consts::EXE_SUFFIX));
    let compile = workspace.cargo(&["build", "--release", "--quiet", "--package", "pavo-peers"]);
    complain(&format!("$ {compile}"));
    ended(&compile, compile.run_aside(workspace)?, |_| Status::CheckFailed)?;
    let measure = CommandLine::new(&program)
        .shown_as(workspace.relative(&program).to_string_lossy())
        .arguments([Path::new("--packages"), shown, Path::new("--output"), shown])
        .arguments(json.then_some("--json"))
        // One thread gives steadier times.
        .environment("LP_NUM_THREADS", "1");
    complain(&format!("$ {measure}"));
    ended(&measure, measure.run(workspace)?, Status::of_product)
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

/// Nothing where the command has succeeded.
fn ended(command: &CommandLine, status: ExitStatus, status_of: fn(Option<i32>) -> Status) -> Result<(), Failure> {
    if status.success() {
        return Ok(());
    }
    Err(Failure { status: status_of(status.code()), message: format!("{} from: {command}", end_text(status)) })
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
