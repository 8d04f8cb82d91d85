//! Looks for what the workspace needs.

use std::path::{Path, PathBuf};

use super::requirement::Sign;
use crate::programs::find_program;

/// Whether the sign of a requirement is on this system.
pub fn is_here(sign: Sign) -> bool {
    match sign {
        Sign::Program(names) => names.iter().any(|name| find_program(name).is_some()),
        Sign::VulkanLoader => opens(VULKAN_LOADER),
        Sign::Egl => opens(EGL),
        Sign::Llvmpipe => has_llvmpipe(),
        Sign::LavapipeManifest => driver_manifests().iter().any(|path| is_lavapipe(path)),
    }
}

/// The file that programs open to use Vulkan.
const VULKAN_LOADER: &str = if cfg!(windows) {
    "vulkan-1.dll"
} else if cfg!(target_os = "macos") {
    "libvulkan.dylib"
} else {
    "libvulkan.so.1"
};

/// The file that programs open to use EGL.
const EGL: &str = if cfg!(windows) {
    "libEGL.dll"
} else if cfg!(target_os = "macos") {
    "libEGL.dylib"
} else {
    "libEGL.so.1"
};

fn opens(library: &str) -> bool {
    // SAFETY: opening the system's own loader of drivers runs its initialisers, which is what it is for; nothing in it
    // is called, and it is closed at once.
    unsafe { libloading::Library::new(library) }.is_ok()
}

/// Whether Mesa's drivers of OpenGL are in one of the folders of libraries: each as a file of its own, or since Mesa
/// 24.3 as one.
fn has_llvmpipe() -> bool {
    let triple = format!("/usr/lib/{}-linux-gnu", std::env::consts::ARCH);
    let folders = [&triple, "/usr/lib64", "/usr/lib", "/opt/homebrew/lib", "/usr/local/lib"].map(Path::new);
    let is_gallium = |entry: std::fs::DirEntry| entry.file_name().to_string_lossy().starts_with("libgallium-");
    folders.iter().any(|folder| {
        let is_one = std::fs::read_dir(folder).is_ok_and(|entries| entries.flatten().any(is_gallium));
        is_one || folder.join("dri/swrast_dri.so").exists()
    })
}

/// The manifests of Vulkan drivers where the loader looks for them: "Architecture of the Vulkan Loader Interfaces"
/// (Khronos), "Driver Discovery on Linux". Homebrew's folder is that of macOS.
fn driver_manifests() -> Vec<PathBuf> {
    let list = |variable: &str, default: &str| -> Vec<PathBuf> {
        let value = std::env::var_os(variable).filter(|value| !value.is_empty()).unwrap_or_else(|| default.into());
        std::env::split_paths(&value).filter(|path| !path.as_os_str().is_empty()).collect()
    };
    let mut manifests = list("VK_DRIVER_FILES", "");
    manifests.extend(list("VK_ICD_FILENAMES", ""));

    let mut folders = list("XDG_CONFIG_DIRS", "/etc/xdg");
    folders.push("/etc".into());
    folders.extend(std::env::home_dir().map(|home| home.join(".local/share")));
    folders.extend(list("XDG_DATA_DIRS", "/usr/local/share:/usr/share"));
    folders.extend(list("HOMEBREW_PREFIX", "/opt/homebrew").into_iter().map(|prefix| prefix.join("share")));
    for folder in folders {
        if let Ok(entries) = std::fs::read_dir(folder.join("vulkan/icd.d")) {
            manifests.extend(entries.flatten().map(|entry| entry.path()));
        }
    }
    manifests
}

/// Whether a manifest, by its name, is lavapipe's for the architecture of this process: `lvp_icd.json` or, for
/// instance, `lvp_icd.x86_64.json`. A system with packages of two architectures has a manifest for each.
fn is_lavapipe(manifest: &Path) -> bool {
    let architecture = match std::env::consts::ARCH {
        "x86" => "i686",
        other => other,
    };
    manifest.file_name().and_then(|name| name.to_str()).is_some_and(|name| {
        name == "lvp_icd.json" || name.strip_prefix("lvp_icd.") == Some(&format!("{architecture}.json"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_that_is_nowhere_is_not_here() {
        assert!(!is_here(Sign::Program(&["no-such-program-1", "no-such-program-2"])));
        assert!(!is_here(Sign::Program(&[])));
    }

    #[test]
    #[cfg(target_arch = "x86_64")]
    fn only_manifests_of_lavapipe_for_this_architecture_count() {
        for (path, expected) in [
            ("/usr/share/vulkan/icd.d/lvp_icd.x86_64.json", true),
            ("/usr/share/vulkan/icd.d/lvp_icd.json", true),
            ("/usr/share/vulkan/icd.d/lvp_icd.i686.json", false),
            ("/usr/share/vulkan/icd.d/radeon_icd.x86_64.json", false),
            ("/usr/share/vulkan/icd.d/lvp_icd.x86_64.json.dpkg-new", false),
        ] {
            assert_eq!(is_lavapipe(Path::new(path)), expected, "{path}");
        }
    }
}
