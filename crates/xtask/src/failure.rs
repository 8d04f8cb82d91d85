//! Why a task ended early, and the exit code that says so.

use std::process::ExitCode;

/// The kinds of failure, each with its exit code: those of the command `pavo`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// A check of the workspace, or a step of the demo, failed.
    CheckFailed = 1,
    /// The command line, or a file that it names, is wrong.
    BadInput = 2,
    /// Something that the task needs is missing from the system.
    Missing = 3,
}

/// A task that ended early.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// The kind of failure.
    pub status: Status,
    /// What is wrong, and what would be right.
    pub message: String,
}

impl Failure {
    /// A failure of `Status::BadInput`.
    pub fn bad_input(message: String) -> Failure {
        Failure { status: Status::BadInput, message }
    }

    /// A failure of `Status::Missing`.
    pub fn missing(message: String) -> Failure {
        Failure { status: Status::Missing, message }
    }

    /// The code to end the process with.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(self.status as u8)
    }
}

impl Status {
    /// The status for the exit code of the command `pavo`, which has the same codes; any other code, and an end by a
    /// signal, is a failed check.
    pub fn of_product(code: Option<i32>) -> Status {
        match code {
            Some(2) => Status::BadInput,
            Some(3) => Status::Missing,
            _ => Status::CheckFailed,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exit_codes_of_the_product_are_passed_on() {
        for (code, expected) in [(Some(1), 1), (Some(2), 2), (Some(3), 3), (Some(101), 1), (None, 1)] {
            assert_eq!(Status::of_product(code) as u8, expected, "{code:?}");
        }
    }
}
