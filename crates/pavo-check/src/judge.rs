//! Judges whether shader texts and SPIR-V are correct, by the field's own readers.
//!
//! | input | judges |
//! |---|---|
//! | WGSL | naga; with an entry point also spirv-val, on the SPIR-V that naga writes |
//! | GLSL 4.40 to 4.60 | naga, but for half precision, glslang for Vulkan 1.1, spirv-val on the SPIR-V that glslang writes |
//! | GLSL 3.30, ES 3.00 and other versions | glslang's classic front end, with linking |
//! | HLSL | glslang for Vulkan 1.1, spirv-val on the SPIR-V that it writes |
//! | OSL | glslang's front end for HLSL, with OSL's names defined: no OSL compiler |
//! | SPIR-V | spirv-val for Vulkan 1.1 |
//! | Rust | syn, which reads the syntax and no types |
//!
//! A refusal is a [`CheckError::Refused`](crate::CheckError::Refused) with the verdicts of all judges, so that a `?`
//! never lets a refused text through.

mod file;
mod glsl;
mod glsl_source;
mod glslang;
mod hlsl;
mod naga_reader;
mod osl;
mod rust;
mod spirv;
mod text;
mod verdict;
mod wgsl;

pub use file::{FILE_EXTENSIONS, judge_file};
pub use glsl::{glsl_to_spirv, judge_glsl};
pub use hlsl::{hlsl_to_spirv, judge_hlsl};
pub use osl::judge_osl;
pub use rust::judge_rust;
pub use spirv::{assemble_spirv, disassemble, judge_spirv};
pub use text::judge_text;
pub use verdict::{Diagnostic, Judge, Stage, Verdict};
pub use wgsl::{judge_wgsl, wgsl_to_msl, wgsl_to_spirv};

pub(crate) use glslang::version as glslang_version;
pub(crate) use naga_reader::NAGA_VERSION;
pub(crate) use rust::SYN_VERSION;
pub(crate) use spirv::tool_version as spirv_tool_version;
