//! Measures pavo's variants beside the thin-film functions that other systems ship, in one run.
//!
//! The text of the others is read from their installed packages and is no part of this repository; what is taken of it
//! stands in `templates/peers/peers.toml`. `cargo xtask peers` installs the packages and calls this program.

mod catalogue;
mod classes;
mod date;
mod extract;
mod failure;
mod kernel;
mod measure;
mod musts;
mod plot;
mod report;

use clap::Parser;
use failure::Failure;
use measure::{Plan, Report};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Measure pavo's variants beside the thin-film functions that other systems ship.
///
/// Exit status: 0 fine, 1 a bound is not kept, 2 a text is not as expected, 3 something needed is missing.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    /// The folder that the packages are installed in: npm/node_modules and python
    #[arg(long, value_name = "FOLDER")]
    packages: PathBuf,
    /// The folder to write peers.json, peers.csv and peers.svg to
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// Print JSON in place of tables
    #[arg(long)]
    json: bool,
    /// Points of each kernel in each round of the timing
    #[arg(long, value_name = "COUNT", default_value_t = 500_000)]
    points: usize,
    /// Rounds of the timing
    #[arg(long, value_name = "COUNT", default_value_t = 25)]
    rounds: usize,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(&arguments) {
        Ok(report) => {
            say_aside(&format!("written: peers.json, peers.csv and peers.svg in {}", arguments.output.display()));
            let missed = report.musts.iter().filter(|outcome| !outcome.is_reached).count();
            if missed == 0 {
                return ExitCode::SUCCESS;
            }
            say_aside(&format!("error: {missed} of {} bounds are not kept", report.musts.len()));
            ExitCode::from(1)
        }
        Err(failure) => {
            say_aside(&format!("error: {failure}"));
            failure.exit_code()
        }
    }
}

/// Prints a line on the standard error; a reader that goes away is no failure.
fn say_aside(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

fn run(arguments: &Arguments) -> Result<Report, Failure> {
    let plan = Plan { packages: arguments.packages.clone(), timed_points: arguments.points, rounds: arguments.rounds };
    let report = measure::measure(&plan)?;
    let json = serde_json::to_string_pretty(&report).map_err(|error| Failure::Text(error.to_string()))? + "\n";
    std::fs::create_dir_all(&arguments.output).map_err(|cause| Failure::file(&arguments.output, cause))?;
    write(&arguments.output.join("peers.json"), json.as_bytes())?;
    write(&arguments.output.join("peers.csv"), &report::csv(&report)?)?;
    write(&arguments.output.join("peers.svg"), plot::svg(&report).map_err(Failure::Text)?.as_bytes())?;
    let printed = if arguments.json { json } else { report::text(&report) };
    // A reader that goes away is no failure.
    let _ = std::io::stdout().write_all(printed.as_bytes());
    Ok(report)
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    pavo_files::write(path, bytes).map_err(|cause| Failure::file(path, cause))
}
