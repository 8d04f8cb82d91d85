//! The command, as the tests run it.

use std::process::ExitCode;

fn main() -> ExitCode {
    pavo::cli::run(std::env::args_os())
}
