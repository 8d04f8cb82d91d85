//! Prints a shader graph as WGSL and GLSL.

/// A text language that the printer writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Language {
    /// WGSL.
    Wgsl,
    /// GLSL 4.50 core, for Vulkan.
    Glsl450,
    /// GLSL 3.30 core.
    Glsl330,
    /// GLSL ES 3.00.
    Essl300,
}

/// What stands around the functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Form {
    /// Functions only, no entry point.
    Library,
    /// A compute entry that evaluates a buffer of points.
    Compute,
    /// A fragment entry that shades a sphere.
    Fragment,
}
