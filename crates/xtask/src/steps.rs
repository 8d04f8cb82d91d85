//! Runs commands one after the other, and tells how long each took.

use std::time::{Duration, Instant};

use crate::command_line::{CommandLine, end_text};
use crate::console::{duration_text, say};
use crate::failure::{Failure, Status};
use crate::workspace::Workspace;

/// The steps that have run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Steps {
    finished: Vec<FinishedStep>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct FinishedStep {
    name: &'static str,
    duration: Duration,
    passed: bool,
}

impl Steps {
    /// Shows a command, runs it, and tells how long it took.
    ///
    /// # Errors
    ///
    /// The command cannot be started, or it fails; `status_of` gives the kind of failure for its exit code.
    pub fn run(
        &mut self,
        workspace: &Workspace,
        name: &'static str,
        command: &CommandLine,
        status_of: fn(Option<i32>) -> Status,
    ) -> Result<(), Failure> {
        say(&format!("\n$ {command}"));
        let start = Instant::now();
        let status = command.run(workspace)?;
        let duration = start.elapsed();
        let passed = status.success();
        self.finished.push(FinishedStep { name, duration, passed });
        say(&format!("{name}: {}, {}", outcome(passed), duration_text(duration)));
        if passed {
            return Ok(());
        }
        let message = format!("the step `{name}` failed ({}): {command}", end_text(status));
        Err(Failure { status: status_of(status.code()), message })
    }

    /// A line for each step with its outcome and its time, and a last line with the time of them all.
    pub fn table(&self) -> String {
        let total = self.finished.iter().map(|step| step.duration).sum();
        let mut lines: Vec<String> =
            self.finished.iter().map(|step| line(step.name, outcome(step.passed), step.duration)).collect();
        lines.push(line("all", outcome(self.finished.iter().all(|step| step.passed)), total));
        lines.join("\n")
    }
}

fn outcome(passed: bool) -> &'static str {
    if passed { "passed" } else { "FAILED" }
}

fn line(name: &str, outcome: &str, duration: Duration) -> String {
    format!("{name:<28} {outcome} {:>12}", duration_text(duration))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_adds_the_times_and_shows_what_failed() {
        let step = |name, seconds, passed| FinishedStep { name, duration: Duration::from_secs(seconds), passed };
        let passing = [step("formatting", 1, true), step("lints", 75, true)];
        let failing = [step("formatting", 1, true), step("lints", 2, false)];
        for (finished, expected) in [
            (
                passing,
                [
                    "formatting                   passed        1.0 s",
                    "lints                        passed   1 min 15 s",
                    "all                          passed   1 min 16 s",
                ],
            ),
            (
                failing,
                [
                    "formatting                   passed        1.0 s",
                    "lints                        FAILED        2.0 s",
                    "all                          FAILED        3.0 s",
                ],
            ),
        ] {
            assert_eq!(Steps { finished: finished.to_vec() }.table().lines().collect::<Vec<_>>(), expected);
        }
    }
}
