//! A command to run, as data, so that it can be shown before it runs and compared in tests.

use std::ffi::{OsStr, OsString};
use std::fmt;
use std::io::ErrorKind;
use std::process::{Command, ExitStatus};

use crate::failure::Failure;
use crate::workspace::Workspace;

/// A program with its arguments and the environment variables that are set for it.
///
/// It is displayed as a line that can be typed in a shell, in the root of the workspace.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CommandLine {
    program: OsString,
    shown_program: String,
    arguments: Vec<OsString>,
    environment: Vec<(&'static str, &'static str)>,
}

impl CommandLine {
    /// A program, looked up in `PATH` where it is a bare name, without arguments.
    pub fn new(program: impl AsRef<OsStr>) -> CommandLine {
        let program = program.as_ref().to_owned();
        let shown_program = program.to_string_lossy().into_owned();
        CommandLine { program, shown_program, arguments: Vec::new(), environment: Vec::new() }
    }

    /// The same command, its program displayed by another name.
    pub fn shown_as(mut self, program: impl Into<String>) -> CommandLine {
        self.shown_program = program.into();
        self
    }

    /// The same command with more arguments at its end.
    pub fn arguments<T: AsRef<OsStr>>(mut self, arguments: impl IntoIterator<Item = T>) -> CommandLine {
        self.arguments.extend(arguments.into_iter().map(|argument| argument.as_ref().to_owned()));
        self
    }

    /// The same command with an environment variable set.
    pub fn environment(mut self, name: &'static str, value: &'static str) -> CommandLine {
        self.environment.push((name, value));
        self
    }

    /// Runs the command in the root of the workspace, its input and output being those of this process.
    ///
    /// # Errors
    ///
    /// The program cannot be started. A program that starts and fails is no error here.
    pub fn run(&self, workspace: &Workspace) -> Result<ExitStatus, Failure> {
        self.command(workspace).status().map_err(|error| self.not_started(&error))
    }

    /// Runs the command as [`CommandLine::run`] does, what it prints going to the standard error.
    ///
    /// # Errors
    ///
    /// The program cannot be started.
    pub fn run_aside(&self, workspace: &Workspace) -> Result<ExitStatus, Failure> {
        self.command(workspace).stdout(std::io::stderr()).status().map_err(|error| self.not_started(&error))
    }

    /// Whether the command can be started and succeeds, its input being empty and its output dropped.
    pub fn succeeds_silently(&self, workspace: &Workspace) -> bool {
        let null = std::process::Stdio::null;
        let status = self.command(workspace).stdin(null()).stdout(null()).stderr(null()).status();
        status.is_ok_and(|status| status.success())
    }

    fn command(&self, workspace: &Workspace) -> Command {
        let mut command = Command::new(&self.program);
        command.args(&self.arguments).current_dir(&workspace.root);
        // Everything is built in the folder in which this tool looks for it, whatever cargo's configuration says.
        command.env("CARGO_TARGET_DIR", &workspace.target);
        command.envs(self.environment.iter().copied());
        command
    }

    fn not_started(&self, error: &std::io::Error) -> Failure {
        let program = &self.shown_program;
        Failure::missing(match error.kind() {
            ErrorKind::NotFound => format!("cannot start `{program}`: there is no such program"),
            _ => format!("cannot start `{program}`: {error}"),
        })
    }
}

impl fmt::Display for CommandLine {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, value) in &self.environment {
            write!(formatter, "{name}={} ", quoted(value))?;
        }
        write!(formatter, "{}", quoted(&self.shown_program))?;
        for argument in &self.arguments {
            write!(formatter, " {}", quoted(&argument.to_string_lossy()))?;
        }
        Ok(())
    }
}

/// How a process ended: `exit code 101`, `signal: 9 (SIGKILL)`.
pub fn end_text(status: ExitStatus) -> String {
    status.code().map_or_else(|| status.to_string(), |code| format!("exit code {code}"))
}

/// A word as a POSIX shell reads it back: in single quotes where it holds anything but harmless characters.
fn quoted(word: &str) -> String {
    let harmless = |character: char| character.is_ascii_alphanumeric() || "-_./:=+@,".contains(character);
    if !word.is_empty() && word.chars().all(harmless) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_shown_as_a_shell_reads_it() {
        for (command, expected) in [
            (CommandLine::new("apt-get").arguments(["update"]), "apt-get update"),
            (
                CommandLine::new("/opt/toolchain/bin/cargo").shown_as("cargo").arguments(["fmt", "--all"]),
                "cargo fmt --all",
            ),
            (
                CommandLine::new("cargo").arguments(["doc"]).environment("RUSTDOCFLAGS", "-D warnings"),
                "RUSTDOCFLAGS='-D warnings' cargo doc",
            ),
            (CommandLine::new("pavo").arguments(["build", "my scene.toml"]), "pavo build 'my scene.toml'"),
            (CommandLine::new("pavo").arguments(["it's $HOME", ""]), r"pavo 'it'\''s $HOME' ''"),
            (
                CommandLine::new("env").arguments(["DEBIAN_FRONTEND=noninteractive", "DPkg::Lock::Timeout=120"]),
                "env DEBIAN_FRONTEND=noninteractive DPkg::Lock::Timeout=120",
            ),
        ] {
            assert_eq!(command.to_string(), expected);
        }
    }
}
