//! Reading up to a size.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::time::Duration;

/// How long a pipe or a device may give nothing before reading it is given up.
pub const MAXIMUM_SILENCE: Duration = Duration::from_secs(10);

/// The content of a file, which need not know its size, such as a pipe.
///
/// # Errors
/// The file cannot be read; it has more than `maximum` bytes, of which no more than these are read; or it is a pipe or a
/// device that gives nothing for [`MAXIMUM_SILENCE`].
pub fn read_up_to(path: &Path, maximum: usize) -> Result<Vec<u8>> {
    let found = std::fs::metadata(path)?;
    if found.is_dir() {
        return Err(Error::new(ErrorKind::IsADirectory, "it is a folder"));
    }
    if found.is_file() && found.len() > maximum as u64 {
        return Err(too_large(Some(found.len()), maximum));
    }
    let bytes = if found.is_file() { read_file(path, maximum)? } else { read_stream(path, maximum)? };
    if bytes.len() > maximum { Err(too_large(None, maximum)) } else { Ok(bytes) }
}

/// The text in a file; a byte order mark is left to who reads it.
///
/// # Errors
/// As [`read_up_to`]; and a file that is not UTF-8.
pub fn read_text_up_to(path: &Path, maximum: usize) -> Result<String> {
    String::from_utf8(read_up_to(path, maximum)?).map_err(|error| {
        let at = error.utf8_error().valid_up_to() + 1;
        Error::new(ErrorKind::InvalidData, format!("it is not UTF-8: byte {at} starts no character"))
    })
}

/// One byte more than is allowed, so that a file that grows, or has no end, is seen to be too large.
fn read_file(path: &Path, maximum: usize) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(maximum as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The same of a pipe or a device, by a thread of its own: opening or reading one may wait for ever.
fn read_stream(path: &Path, maximum: usize) -> Result<Vec<u8>> {
    let (sender, receiver) = sync_channel::<Result<Vec<u8>>>(4);
    let path = path.to_owned();
    std::thread::spawn(move || {
        let read = || -> Result<()> {
            let mut file = File::open(&path)?;
            let mut buffer = vec![0; 1 << 16];
            loop {
                let count = file.read(&mut buffer)?;
                // Who has heard enough, or waited long enough, has gone away.
                if count == 0 || sender.send(Ok(buffer[..count].to_vec())).is_err() {
                    return Ok(());
                }
            }
        };
        if let Err(error) = read() {
            let _ = sender.send(Err(error));
        }
    });
    let mut bytes = Vec::new();
    while bytes.len() <= maximum {
        match receiver.recv_timeout(MAXIMUM_SILENCE) {
            Ok(piece) => bytes.extend(piece?),
            Err(RecvTimeoutError::Disconnected) => break,
            Err(RecvTimeoutError::Timeout) => {
                let message =
                    format!("it is no ordinary file, and nothing came from it for {} s", MAXIMUM_SILENCE.as_secs());
                return Err(Error::new(ErrorKind::TimedOut, message));
            }
        }
    }
    Ok(bytes)
}

fn too_large(size: Option<u64>, maximum: usize) -> Error {
    let size = size.map_or_else(|| format!("it has more than {maximum} bytes"), |size| format!("it has {size} bytes"));
    Error::new(ErrorKind::FileTooLarge, format!("{size}; the most that are read are {maximum}"))
}

#[cfg(test)]
mod tests {
    use super::read_up_to;
    use std::io::ErrorKind;
    use std::path::Path;

    #[test]
    fn a_file_is_read_up_to_its_size_and_refused_above_it() {
        let folder = tempfile::tempdir().expect("a temporary folder can be made");
        let path = folder.path().join("file");
        std::fs::write(&path, vec![7; 3 << 20]).expect("it can be written");
        assert_eq!(read_up_to(&path, 3 << 20).expect("it is not too large").len(), 3 << 20);
        let error = read_up_to(&path, 2 << 20).expect_err("it is too large");
        assert_eq!(error.kind(), ErrorKind::FileTooLarge);
        assert_eq!(error.to_string(), "it has 3145728 bytes; the most that are read are 2097152");
        let error = read_up_to(folder.path(), 1 << 20).expect_err("it is a folder");
        assert_eq!(error.to_string(), "it is a folder");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_without_an_end_is_refused() {
        let error = read_up_to(Path::new("/dev/zero"), 1 << 20).expect_err("it has no end");
        assert_eq!(error.to_string(), "it has more than 1048576 bytes; the most that are read are 1048576");
        assert_eq!(read_up_to(Path::new("/dev/null"), 1 << 20).expect("it is empty"), []);
    }
}
