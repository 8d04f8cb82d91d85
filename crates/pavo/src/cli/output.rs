//! Where output goes: standard output and files. Files are written whole or not at all.

use super::failure::Failure;
use std::io::Write;
use std::path::Path;

/// Prints to standard output.
pub fn print(text: &str) -> Result<(), Failure> {
    write_or_print(None, text.as_bytes())
}

/// Says something beside the output, its control characters escaped but for the ends of lines.
#[allow(clippy::print_stderr)]
pub fn say(message: &str) {
    eprintln!("{}", printable(message));
}

/// Warns of something.
pub fn warn(message: &str) {
    say(&format!("warning: {message}"));
}

/// A text that a terminal takes for no command: lines stay lines.
pub fn printable(text: &str) -> String {
    text.split('\n').map(pavo_files::shown_text).collect::<Vec<_>>().join("\n")
}

/// Writes a file whole or not at all, as [`pavo_files::write`] does.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    pavo_files::write(path, bytes).map_err(|error| Failure::file(path, "written", &error))
}

/// Makes a folder with those above it, where it is not there.
pub fn make_folder(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|error| Failure::file(folder, "made", &error))
}

/// Writes to a file, or to standard output where none is named. A reader that has gone away ends the output without
/// an error.
pub fn write_or_print(path: Option<&Path>, bytes: &[u8]) -> Result<(), Failure> {
    match path {
        Some(path) => write(path, bytes),
        None => {
            let mut output = std::io::stdout().lock();
            match output.write_all(bytes).and_then(|()| output.flush()) {
                Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
                    Err(Failure::check(format!("standard output cannot be written: {error}")))
                }
                _ => Ok(()),
            }
        }
    }
}
