//! Fits and measurements that are kept on disk between runs, by the content of what was asked for.

use super::output;
use crate::fitting::FitCache;
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::path::PathBuf;

/// The largest text that is kept, in bytes; the largest that is made has some hundred kilobytes.
const MAXIMUM_BYTES: usize = 64 << 20;

/// A folder that keeps texts: that of `PAVO_CACHE`, or `pavo` among the user's caches. Without either, nothing is kept.
pub struct DiskCache {
    folder: Option<PathBuf>,
}

impl DiskCache {
    /// The user's cache.
    pub fn open() -> Self {
        let chosen = std::env::var_os("PAVO_CACHE").filter(|folder| !folder.is_empty()).map(PathBuf::from);
        Self { folder: chosen.or_else(|| Some(dirs::cache_dir()?.join("pavo"))) }
    }

    /// The file of a key: named by the key's digest, this version of pavo included.
    fn file(&self, key: &str) -> Option<PathBuf> {
        let digest =
            Sha256::new().chain_update(env!("CARGO_PKG_VERSION")).chain_update([0]).chain_update(key).finalize();
        let name = digest.iter().fold(String::new(), |mut name, byte| {
            let _ = write!(name, "{byte:02x}");
            name
        });
        Some(self.folder.as_ref()?.join(name).with_extension("json"))
    }
}

impl FitCache for DiskCache {
    fn load(&self, key: &str) -> Option<String> {
        pavo_files::read_text_up_to(&self.file(key)?, MAXIMUM_BYTES).ok()
    }

    fn store(&self, key: &str, text: &str) {
        if let Some(file) = self.file(key)
            && let Some(folder) = file.parent()
            && std::fs::create_dir_all(folder).is_ok()
        {
            // What cannot be kept is made again.
            let _ = output::write(&file, text.as_bytes());
        }
    }
}
