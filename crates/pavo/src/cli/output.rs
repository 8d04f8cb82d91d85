//! Where output goes: standard output and files. Files are written whole or not at all.

use super::failure::Failure;
use std::io::Write;
use std::path::Path;
use std::time::Duration;

/// What the names of unfinished files begin and end with.
const PREFIX: &str = ".pavo-";
const SUFFIX: &str = ".unfinished";
/// An unfinished file of this age is nobody's: a write takes seconds.
const ABANDONED: Duration = Duration::from_secs(3600);

/// Prints to standard output.
pub fn print(text: &str) -> Result<(), Failure> {
    write_or_print(None, text.as_bytes())
}

/// Says something beside the output.
#[allow(clippy::print_stderr)]
pub fn warn(message: &str) {
    eprintln!("warning: {message}");
}

/// Writes a file beside its place and then moves it there: who is killed leaves the old file or the new one, and beside
/// it at most one `.pavo-*.unfinished` that a later write to the folder removes.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    remove_abandoned(folder);
    let unfinished = tempfile::Builder::new().prefix(PREFIX).suffix(SUFFIX).tempfile_in(folder);
    let written = unfinished.and_then(|mut file| {
        file.write_all(bytes)?;
        make_readable(file.as_file())?;
        // The content is on the disk before the name is: what loses power has the old file or the new one.
        file.as_file().sync_all()?;
        file.persist(path).map_err(|error| error.error)?;
        Ok(())
    });
    written.map_err(|error| Failure::file(path, "written", &error))
}

/// Removes the unfinished files of runs that were killed. What cannot be removed does no harm.
fn remove_abandoned(folder: &Path) {
    let unfinished = |name: &str| name.starts_with(PREFIX) && name.ends_with(SUFFIX);
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let old = || entry.metadata().ok()?.modified().ok()?.elapsed().ok().filter(|age| *age > ABANDONED);
        if entry.file_name().to_str().is_some_and(unfinished) && old().is_some() {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// Gives a temporary file the permissions of an ordinary one.
#[cfg(unix)]
fn make_readable(file: &std::fs::File) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn make_readable(_: &std::fs::File) -> std::io::Result<()> {
    Ok(())
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
