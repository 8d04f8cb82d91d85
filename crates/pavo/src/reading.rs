//! Reading of users' files, up to a size.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// The largest table of optical constants or of an illuminant that is read, in bytes: 16 MiB, a thousand times the usual.
pub const MAXIMUM_TABLE_BYTES: usize = 16 << 20;

/// The content of a file, which need not know its size, such as a pipe.
///
/// # Errors
/// The file cannot be read, or has more than `maximum` bytes: no more than these are read.
pub fn read_up_to(path: &Path, maximum: usize) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    // One byte more than is allowed, so that a file without an end is refused like a large one.
    File::open(path)?.take(maximum as u64 + 1).read_to_end(&mut bytes)?;
    if bytes.len() > maximum {
        let message = format!("it is larger than {} MiB, the most that is read", maximum >> 20);
        return Err(Error::new(ErrorKind::FileTooLarge, message));
    }
    Ok(bytes)
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
