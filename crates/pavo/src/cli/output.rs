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
/// it at most one `.pavo-*.unfinished` that a later write to the folder removes after an hour.
///
/// A device or a pipe, such as `/dev/stdout`, is written to and stays what it is; a link stays, and what it names is
/// replaced.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let cannot = |error: std::io::Error| Failure::file(path, "written", &error);
    match std::fs::metadata(path) {
        Ok(found) if found.is_dir() => {
            Err(Failure::input(format!("{}: cannot be written: it is a folder", path.display()), "name a file in it"))
        }
        Ok(found) if !found.is_file() => {
            let opened = std::fs::OpenOptions::new().write(true).open(path);
            opened.and_then(|mut file| file.write_all(bytes)).map_err(cannot)
        }
        Ok(_) => {
            let file = path.canonicalize().map_err(cannot)?;
            replace(&file, bytes).map_err(cannot)
        }
        Err(_) => replace(path, bytes).map_err(cannot),
    }
}

/// Writes an unfinished file beside an ordinary one, and gives it its name when all of it is on the disk.
fn replace(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    remove_abandoned(folder);
    let unfinished = tempfile::Builder::new().prefix(PREFIX).suffix(SUFFIX).tempfile_in(folder);
    unfinished.and_then(|mut file| {
        file.write_all(bytes)?;
        make_readable(file.as_file())?;
        // The content is on the disk before the name is: what loses power has the old file or the new one.
        file.as_file().sync_all()?;
        file.persist(path).map_err(|error| error.error)?;
        Ok(())
    })
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
