//! The command `pavo`: its arguments, and a file for each of its words.
//!
//! Exit status: 0 fine, 1 a check failed, 2 bad input, 3 something needed is missing.

mod arguments;
mod build;
mod cache;
mod check;
mod command_line;
mod doctor;
mod emit;
mod eval;
mod export;
mod failure;
mod fit;
mod manifest;
mod new;
mod output;
mod picture;
mod plot;
mod precision;
mod preview;
mod progress;
mod report;
mod sources;
mod spectrum;
mod sphere;
mod stability;
mod tune;
mod variants;
mod work;

use arguments::{Arguments, Command};
use clap::Parser;
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the command with its arguments, the first of which is its own name, and says with what status to exit.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    // Messages of judges keep their lines: `file:line:column` must stay in one piece. Setting this fails only if there
    // is a handler already, which then serves.
    let _ = miette::set_hook(Box::new(|_| Box::new(miette::MietteHandlerOpts::new().wrap_lines(false).build())));
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(error) => {
            let text = error.render().to_string();
            if text.chars().any(|character| character.is_control() && character != '\n') {
                output::say(&text);
            } else {
                // Help and version are no errors; if they cannot be written there is nobody to tell.
                let _ = error.print();
            }
            return ExitCode::from(if error.use_stderr() { failure::BAD_INPUT } else { 0 });
        }
    };
    let result = match arguments.command {
        Command::Build(arguments) => build::run(&arguments),
        Command::Emit(arguments) => emit::run(&arguments),
        Command::Export(arguments) => export::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Eval(arguments) => eval::run(&arguments),
        Command::Preview(arguments) => preview::run(&arguments),
        Command::Plot(arguments) => plot::run(&arguments.plot),
        Command::Fit(arguments) => fit::run(&arguments.fit),
        Command::Tune(arguments) => tune::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Stability(arguments) => stability::run(&arguments),
        Command::Variants(arguments) => variants::run(&arguments),
        Command::Doctor(arguments) => doctor::run(&arguments),
        Command::New(arguments) => new::run(&arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
