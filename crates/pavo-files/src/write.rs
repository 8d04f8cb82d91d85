//! Writing whole or not at all.

use std::fs::{File, OpenOptions};
use std::io::{Error, ErrorKind, Result, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// What the names of unfinished files begin and end with.
const PREFIX: &str = ".pavo-";
const SUFFIX: &str = ".unfinished";
/// An unfinished file of this age is nobody's: a write takes seconds.
const ABANDONED: Duration = Duration::from_secs(3600);
/// How many names are tried for an unfinished file. One is taken only where two programs see the same number and time.
const NAMES: u32 = 100;

/// Writes a file beside its place and then moves it there: who is killed leaves the old file or the new one, and beside
/// it at most one `.pavo-*.unfinished` that a later write to the folder removes after an hour.
///
/// A device or a pipe, such as `/dev/stdout`, is written to and stays what it is; a link stays, and what it names is
/// replaced.
///
/// # Errors
/// What the system says; a folder in the place of the file.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    match std::fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(Error::new(ErrorKind::IsADirectory, "it is a folder")),
        Ok(found) if !found.is_file() => OpenOptions::new().write(true).open(path)?.write_all(bytes),
        Ok(_) => replace(&path.canonicalize()?, bytes),
        Err(error) if path.is_symlink() => {
            let target = folder_of(path).join(std::fs::read_link(path)?);
            if error.kind() == ErrorKind::NotFound && !target.is_symlink() {
                replace(&target, bytes)
            } else {
                Err(error)
            }
        }
        Err(_) => replace(path, bytes),
    }
}

/// Writes an unfinished file beside an ordinary one, and gives it its name when all of it is on the disk.
fn replace(path: &Path, bytes: &[u8]) -> Result<()> {
    let folder = folder_of(path);
    remove_abandoned(folder);
    let (unfinished, mut file) = create(folder)?;
    let written = file.write_all(bytes).and_then(|()| {
        // The content is on the disk before the name is: what loses power has the old file or the new one.
        file.sync_all()?;
        std::fs::rename(&unfinished, path)
    });
    if written.is_err() {
        let _ = std::fs::remove_file(&unfinished);
    }
    written
}

/// The folder of a file.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// A new unfinished file in a folder.
fn create(folder: &Path) -> Result<(PathBuf, File)> {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let mut taken = None;
    for _ in 0..NAMES {
        let time = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_nanos());
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("{PREFIX}{}-{count}-{time:x}{SUFFIX}", std::process::id());
        let path = folder.join(name);
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((path, file)),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => taken = Some(error),
            Err(error) => return Err(error),
        }
    }
    Err(taken.unwrap_or_else(|| ErrorKind::AlreadyExists.into()))
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

#[cfg(test)]
mod tests {
    use super::write;

    #[test]
    fn many_writes_at_once_leave_one_whole_file_and_nothing_beside_it() {
        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        let path = folder.path().join("file");
        std::thread::scope(|scope| {
            for writer in 0..8_u8 {
                let path = &path;
                scope.spawn(move || write(path, &vec![writer; 100_000]).expect("it can be written"));
            }
        });
        let found = std::fs::read(&path).expect("it is there");
        assert!(found.len() == 100_000 && found.iter().all(|byte| *byte == found[0]), "{} bytes", found.len());
        assert_eq!(std::fs::read_dir(folder.path()).expect("it can be read").count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_wherever_it_leads() {
        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        for (target, is_written) in [("loop", false), ("absent/file", false), ("absent", true), ("there", true)] {
            std::fs::write(folder.path().join("there"), "old").expect("it can be written");
            let link = folder.path().join("loop");
            std::os::unix::fs::symlink(target, &link).expect("it can be made");
            assert_eq!(write(&link, b"text").is_ok(), is_written, "{target}");
            assert!(link.is_symlink(), "{target}");
            assert_eq!(std::fs::read(&link).is_ok_and(|found| found == b"text"), is_written, "{target}");
            std::fs::remove_file(link).expect("it can be removed");
        }
    }
}
