//! What is emitted: a text language, or SPIR-V.

use pavo_emit::{Dialect, Form, Language};
use std::fmt;
use std::str::FromStr;

/// A target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Target {
    /// A text language.
    Text(Language),
    /// SPIR-V as a binary.
    Spirv,
    /// SPIR-V as a disassembly.
    SpirvAssembly,
}

impl Target {
    /// All targets.
    pub const ALL: [Target; 9] = [
        Target::Text(Language::Wgsl),
        Target::Text(Language::Glsl450),
        Target::Text(Language::Glsl330),
        Target::Text(Language::Essl300),
        Target::Text(Language::Hlsl),
        Target::Text(Language::Osl),
        Target::Text(Language::Rust),
        Target::Spirv,
        Target::SpirvAssembly,
    ];

    /// The name on the command line and in scenes.
    pub fn name(self) -> &'static str {
        match self {
            Target::Text(language) => language.name(),
            Target::Spirv => "spirv",
            Target::SpirvAssembly => "spirv-asm",
        }
    }

    /// The ending of a file's name.
    pub fn extension(self) -> &'static str {
        match self {
            Target::Text(language) => Dialect::of(language).extension,
            Target::Spirv => "spv",
            Target::SpirvAssembly => "spvasm",
        }
    }

    /// The form where nothing says which: functions only, but SPIR-V needs an entry point.
    pub fn default_form(self) -> Form {
        match self {
            Target::Text(_) => Form::Library,
            Target::Spirv | Target::SpirvAssembly => Form::Compute,
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Target {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|target| target.name() == text).ok_or_else(|| {
            format!(
                "unknown target `{}`; the targets are {}",
                text.escape_debug(),
                Self::ALL.map(Target::name).join(", ")
            )
        })
    }
}
