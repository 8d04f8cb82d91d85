//! What the workspace needs from the system, as data.

use super::package_manager::Packages;

/// Something that the judges or the runs of `pavo-check` need.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Requirement {
    /// What it is called where people look for it.
    pub name: &'static str,
    /// What shows that it is here.
    pub sign: Sign,
    /// The packages that hold it.
    pub packages: Packages,
    /// Where it comes from, for systems whose packages are not known here.
    pub source: &'static str,
}

/// What shows that a requirement is here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// One of these programs is in `PATH`.
    Program(&'static [&'static str]),
    /// The Vulkan loader can be opened as a shared library.
    VulkanLoader,
    /// libEGL can be opened as a shared library.
    Egl,
    /// Mesa's driver of OpenGL for the CPU is where libEGL looks for drivers.
    Llvmpipe,
    /// Lavapipe's manifest is where the Vulkan loader looks for drivers.
    LavapipeManifest,
}

/// Everything that is needed, in the order in which it is told.
pub const REQUIREMENTS: [Requirement; 8] = [
    Requirement {
        name: "glslangValidator",
        // Later releases call it glslang, and keep the old name as a link where the packager lets them.
        sign: Sign::Program(&["glslangValidator", "glslang"]),
        packages: Packages { apt: "glslang-tools", dnf: "glslang", pacman: "glslang", brew: "glslang" },
        source: "https://github.com/KhronosGroup/glslang",
    },
    spirv_tool("spirv-val", &["spirv-val"]),
    spirv_tool("spirv-dis", &["spirv-dis"]),
    spirv_tool("spirv-as", &["spirv-as"]),
    Requirement {
        name: "the Vulkan loader",
        sign: Sign::VulkanLoader,
        packages: Packages {
            apt: "libvulkan1",
            dnf: "vulkan-loader",
            pacman: "vulkan-icd-loader",
            brew: "vulkan-loader",
        },
        source: "https://github.com/KhronosGroup/Vulkan-Loader",
    },
    Requirement {
        name: "lavapipe",
        sign: Sign::LavapipeManifest,
        packages: Packages {
            apt: "mesa-vulkan-drivers",
            dnf: "mesa-vulkan-drivers",
            pacman: "vulkan-swrast",
            brew: "mesa",
        },
        source: "https://docs.mesa3d.org/drivers/llvmpipe.html",
    },
    Requirement {
        name: "libEGL",
        sign: Sign::Egl,
        packages: Packages { apt: "libegl1", dnf: "libglvnd-egl", pacman: "libglvnd", brew: "mesa" },
        source: "https://gitlab.freedesktop.org/glvnd/libglvnd",
    },
    Requirement {
        name: "llvmpipe",
        sign: Sign::Llvmpipe,
        packages: Packages { apt: "libgl1-mesa-dri", dnf: "mesa-dri-drivers", pacman: "mesa", brew: "mesa" },
        source: "https://docs.mesa3d.org/drivers/llvmpipe.html",
    },
];

/// What the examples need beside.
pub const OF_EXAMPLES: [Requirement; 1] = [Requirement {
    name: "g++",
    sign: Sign::Program(&["g++"]),
    packages: Packages { apt: "g++", dnf: "gcc-c++", pacman: "gcc", brew: "gcc" },
    source: "https://gcc.gnu.org",
}];

const fn spirv_tool(name: &'static str, programs: &'static [&'static str]) -> Requirement {
    Requirement {
        name,
        sign: Sign::Program(programs),
        packages: Packages { apt: "spirv-tools", dnf: "spirv-tools", pacman: "spirv-tools", brew: "spirv-tools" },
        source: "https://github.com/KhronosGroup/SPIRV-Tools",
    }
}
