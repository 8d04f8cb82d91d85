//! Makes the built-in fits of spectral sensitivities again: `pavo-fits DIRECTORY` writes the files that
//! `crates/pavo-spectra/data/fits` holds.

use std::io::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use pavo_fit::sensitivity::built_in_file;
use pavo_spectra::fits::BUILT_IN_SPECTRA;

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1);
    let (Some(directory), None) = (arguments.next(), arguments.next()) else {
        say("usage: pavo-fits DIRECTORY (an existing one, such as crates/pavo-spectra/data/fits)");
        return ExitCode::from(2);
    };
    let directory = PathBuf::from(directory);
    for spectrum in &BUILT_IN_SPECTRA {
        let path = directory.join(spectrum.file);
        let text = match built_in_file(spectrum, &|line| say(&line)) {
            Ok(text) => text,
            Err(error) => {
                say(&format!("{}: {error}", spectrum.file));
                return ExitCode::FAILURE;
            }
        };
        if let Err(error) = pavo_files::write(&path, text.as_bytes()) {
            say(&format!("cannot write {}: {error}", path.display()));
            return ExitCode::FAILURE;
        }
        say(&format!("wrote {}", path.display()));
    }
    ExitCode::SUCCESS
}

/// Progress goes to standard error; that it cannot be shown is no reason to stop.
fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}
