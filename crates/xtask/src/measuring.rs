//! Programs of the workspace that measure: built in release, their results on the standard output, all else on the
//! standard error.

use std::process::ExitStatus;

use crate::command_line::{CommandLine, end_text};
use crate::console::complain;
use crate::failure::{Failure, Status};
use crate::workspace::Workspace;

/// Builds the program of a package, and runs it with what is added to its command line.
///
/// # Errors
///
/// It cannot be compiled, or the measuring fails: its exit codes are those of the command `pavo`.
pub fn run(workspace: &Workspace, package: &str, with: impl FnOnce(CommandLine) -> CommandLine) -> Result<(), Failure> {
    let program = workspace.target.join("release").join(format!("{package}{}", std::env::consts::EXE_SUFFIX));
    let compile = workspace.cargo(&["build", "--release", "--quiet", "--package"]).arguments([package]);
    complain(&format!("$ {compile}"));
    ended(&compile, compile.run_aside(workspace)?, |_| Status::CheckFailed)?;
    let measure = with(CommandLine::new(&program).shown_as(workspace.relative(&program).to_string_lossy()));
    complain(&format!("$ {measure}"));
    ended(&measure, measure.run(workspace)?, Status::of_product)
}

/// Nothing where the command has succeeded.
///
/// # Errors
///
/// It has failed; `status_of` gives the kind of failure for its exit code.
pub fn ended(command: &CommandLine, status: ExitStatus, status_of: fn(Option<i32>) -> Status) -> Result<(), Failure> {
    if status.success() {
        return Ok(());
    }
    Err(Failure { status: status_of(status.code()), message: format!("{} from: {command}", end_text(status)) })
}
