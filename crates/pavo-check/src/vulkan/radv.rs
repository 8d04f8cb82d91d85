//! Finds RADV's library, and the name that its release has for a family of graphics cards.
//!
//! RADV ends the process when it is asked for a family that it does not know, and releases differ in names. So the
//! names are looked for in the library before the driver is asked.

use std::path::{Path, PathBuf};

use libloading::Library;

use super::environment;
use super::manifest::{RADV_MANIFEST, manifests};
use crate::CheckError;
use crate::install::RADV;

/// The libraries of RADV on this system, by the manifests that announce them.
pub(super) fn libraries() -> Result<Vec<PathBuf>, CheckError> {
    let found: Vec<PathBuf> = manifests(RADV_MANIFEST).iter().filter_map(|found| file(&found.library)).collect();
    if found.is_empty() { Err(CheckError::missing(RADV)) } else { Ok(found) }
}

/// The first of these names that the library has for a family.
pub(super) fn known_name(library: &Path, names: &[&'static str]) -> Option<&'static str> {
    let bytes = std::fs::read(library).ok()?;
    // The names are strings of C, and the linker may have made one the end of another.
    let has = |name: &str| bytes.split(|&byte| byte == 0).any(|string| string.ends_with(name.as_bytes()));
    names.iter().copied().find(|name| has(name))
}

/// The file of a library: a manifest may leave it to the dynamic linker to find it.
fn file(library: &Path) -> Option<PathBuf> {
    if library.is_absolute() {
        return library.is_file().then(|| library.to_owned());
    }
    let _unchanged = environment::unchanged();
    // SAFETY: the library is a Vulkan driver, named by its manifest; loading it runs its initialisers.
    let _loaded = unsafe { Library::new(library) }.ok()?;
    let mapped = std::fs::read_to_string("/proc/self/maps").ok()?;
    let files = mapped.lines().filter_map(|line| line.find('/').map(|start| Path::new(&line[start..])));
    files.into_iter().find(|file| file.file_name() == library.file_name()).map(Path::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_is_found_by_the_linker_too() {
        for library in libraries().unwrap_or_else(|error| panic!("{error}")) {
            assert!(library.is_absolute(), "{library:?}");
            let name = library.file_name().map(Path::new).unwrap();
            assert!(file(name).is_some_and(|file| file.file_name() == library.file_name()), "{library:?}");
        }
        assert_eq!(file(Path::new("libno-such-driver.so")), None);
        assert_eq!(file(Path::new("/there/is/no/driver.so")), None);
    }

    #[test]
    fn only_names_that_the_library_has_are_known() {
        for library in libraries().unwrap_or_else(|error| panic!("{error}")) {
            assert_eq!(known_name(&library, &["NO_SUCH_FAMILY", "VEGA10", "NAVI21"]), Some("VEGA10"));
            assert_eq!(known_name(&library, &["NO_SUCH_FAMILY"]), None);
        }
    }
}
