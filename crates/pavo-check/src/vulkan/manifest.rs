//! Finds the library of one of Mesa's drivers by the manifests that Vulkan drivers install.
//!
//! The folders and the form of the manifests are those of the "Architecture of the Vulkan Loader Interfaces"
//! (Khronos, "Driver Discovery on Linux").

use std::path::{Path, PathBuf};

use serde::Deserialize;

/// A driver manifest, and the library that it names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Manifest {
    /// The manifest itself.
    pub path: PathBuf,
    /// The driver: a path, or a name that the dynamic linker resolves.
    pub library: PathBuf,
}

#[derive(Deserialize)]
struct ManifestFile {
    #[serde(rename = "ICD")]
    driver: DriverEntry,
}

#[derive(Deserialize)]
struct DriverEntry {
    library_path: PathBuf,
}

/// What the names of lavapipe's manifests begin with.
pub(crate) const LAVAPIPE_MANIFEST: &str = "lvp_icd";
/// What the names of RADV's manifests begin with.
pub(crate) const RADV_MANIFEST: &str = "radeon_icd";

/// The manifests of a driver on this system, the most specific first. Empty where drivers are not announced by files.
pub(crate) fn manifests(prefix: &str) -> Vec<Manifest> {
    let mut found: Vec<Manifest> = Vec::new();
    for path in candidate_files() {
        let is_of_driver = path.file_name().and_then(|name| name.to_str()).is_some_and(|name| name.starts_with(prefix));
        if is_of_driver && let Some(library) = std::fs::read(&path).ok().and_then(|text| library_of(&path, &text)) {
            let manifest = Manifest { path, library };
            if !found.contains(&manifest) {
                found.push(manifest);
            }
        }
    }
    found
}

/// The library that a manifest names; a relative path with a folder is relative to the manifest.
fn library_of(path: &Path, text: &[u8]) -> Option<PathBuf> {
    let library = serde_json::from_slice::<ManifestFile>(text).ok()?.driver.library_path;
    let has_folder = library.components().count() > 1;
    Some(if library.is_relative() && has_folder { path.parent()?.join(library) } else { library })
}

/// Every driver manifest, named by the environment or lying in one of the standard folders.
fn candidate_files() -> Vec<PathBuf> {
    let mut files = Vec::new();
    for variable in ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"] {
        if let Some(list) = std::env::var_os(variable) {
            files.extend(std::env::split_paths(&list));
        }
    }
    for folder in folders() {
        let mut in_folder: Vec<PathBuf> = std::fs::read_dir(folder.join("vulkan/icd.d"))
            .map(|entries| entries.flatten().map(|entry| entry.path()).collect())
            .unwrap_or_default();
        // A folder lists its files in no fixed order. The native architecture goes before others.
        in_folder.sort_by_key(|path| (!path.to_string_lossy().contains(std::env::consts::ARCH), path.clone()));
        files.extend(in_folder);
    }
    files
}

fn folders() -> Vec<PathBuf> {
    let list = |variable: &str, default: &str| -> Vec<PathBuf> {
        let value = std::env::var_os(variable).filter(|value| !value.is_empty()).unwrap_or_else(|| default.into());
        std::env::split_paths(&value).collect()
    };
    let home = std::env::var_os("HOME").map(PathBuf::from).unwrap_or_default();
    let in_home = |folder: &str| home.join(folder).to_string_lossy().into_owned();
    let mut folders = list("XDG_CONFIG_HOME", &in_home(".config"));
    folders.extend(list("XDG_CONFIG_DIRS", "/etc/xdg"));
    folders.push(PathBuf::from("/etc"));
    folders.extend(list("XDG_DATA_HOME", &in_home(".local/share")));
    folders.extend(list("XDG_DATA_DIRS", "/usr/local/share:/usr/share"));
    folders
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_manifest_names_its_library() {
        for (library, expected) in [
            ("/usr/lib/libvulkan_lvp.so", Some("/usr/lib/libvulkan_lvp.so")),
            ("libvulkan_lvp.so", Some("libvulkan_lvp.so")),
            ("../lib/libvulkan_lvp.so", Some("/opt/icd.d/../lib/libvulkan_lvp.so")),
        ] {
            let text = format!(r#"{{"ICD": {{"library_path": "{library}"}}, "file_format_version": "1.0.0"}}"#);
            let found = library_of(Path::new("/opt/icd.d/lvp_icd.json"), text.as_bytes());
            assert_eq!(found, expected.map(PathBuf::from));
        }
        assert_eq!(library_of(Path::new("/opt/lvp_icd.json"), b"{}"), None);
    }
}
