//! Prints what the emitted code saves where a scene fixes something, as a Markdown table. `cargo xtask savings` calls it.

use pavo_check::static_cost::StaticCompiler;
use pavo_savings::{FAMILY, Failure, cases, table};
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(text) => {
            // A reader that goes away is no failure.
            let _ = std::io::stdout().write_all(text.as_bytes());
            ExitCode::SUCCESS
        }
        Err(failure) => {
            let _ = writeln!(std::io::stderr(), "error: {failure}");
            failure.exit_code()
        }
    }
}

fn run() -> Result<String, Failure> {
    // First of all, as opening one sets an environment variable for the moment.
    let compiler = StaticCompiler::open(FAMILY)?;
    let table = table(&cases()?, &compiler)?;
    Ok(format!("{table}\nCycles by {}.\n", compiler.description()))
}
