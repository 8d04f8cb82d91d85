//! What to install for each thing that this crate needs from the system.

/// Something of the system that a judge or a run needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Requirement {
    /// What it is called where people look for it.
    pub name: &'static str,
    /// How to get it, as a sentence without a full stop.
    pub install: &'static str,
}

/// The reference compiler of GLSL.
pub(crate) const GLSLANG: Requirement = Requirement {
    name: "glslangValidator",
    install: "install the package `glslang-tools` (Debian, Ubuntu), or build with the feature `bundled`",
};

/// The validator of SPIR-V.
pub(crate) const SPIRV_VAL: Requirement = Requirement {
    name: "spirv-val",
    install: "install the package `spirv-tools` (Debian, Ubuntu), or build with the feature `bundled`",
};

/// The disassembler of SPIR-V.
pub(crate) const SPIRV_DIS: Requirement = Requirement {
    name: "spirv-dis",
    install: "install the package `spirv-tools` (Debian, Ubuntu), or build with the feature `bundled`",
};

/// The assembler of SPIR-V.
pub(crate) const SPIRV_AS: Requirement = Requirement {
    name: "spirv-as",
    install: "install the package `spirv-tools` (Debian, Ubuntu), or build with the feature `bundled`",
};

/// The library that finds Vulkan drivers.
pub(crate) const VULKAN_LOADER: Requirement =
    Requirement { name: "the Vulkan loader (libvulkan)", install: "install the package `libvulkan1` (Debian, Ubuntu)" };

/// Mesa's Vulkan driver that runs on the CPU.
pub(crate) const LAVAPIPE: Requirement = Requirement {
    name: "lavapipe (Mesa's Vulkan driver for the CPU)",
    install: "install the packages `mesa-vulkan-drivers` and `libvulkan1` (Debian, Ubuntu)",
};

/// Mesa's Vulkan driver for AMD's graphics cards, whose compiler works without one.
pub(crate) const RADV: Requirement = Requirement {
    name: "RADV (Mesa's Vulkan driver for AMD)",
    install: "install the package `mesa-vulkan-drivers` (Debian, Ubuntu)",
};
