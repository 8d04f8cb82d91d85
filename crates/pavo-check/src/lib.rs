//! The judges of emitted shaders: naga, glslang and SPIRV-Tools read them, lavapipe runs them.
//!
//! This is the one library of the workspace that touches the outside world: it starts processes
//! (`glslangValidator`, `spirv-val`, `spirv-dis`), opens drivers (Vulkan) and reads files. What it
//! needs and does not find is a [`CheckError::Missing`] that names the package to install.
//!
//! - [`judge`]: is this text, or this SPIR-V, correct? Each judge gives a [`Verdict`]; a refusal is a
//!   [`CheckError::Refused`] with file, line and judge.
//! - [`vulkan`]: what does this SPIR-V compute? Runs compute kernels and renders pictures.
//! - [`static_cost`]: what does a fragment shader cost on a graphics card, as its compiler counts?
//! - [`timing`]: how long do compute kernels take on a device, compared with each other?
//! - [`doctor`]: which of the tools and drivers are here?

pub mod doctor;
pub mod judge;
pub mod static_cost;
pub mod timing;
pub mod vulkan;

mod error;
mod install;

pub use error::CheckError;
pub use judge::{Diagnostic, Judge, Stage, Verdict};
pub use judge::{assemble_spirv, disassemble, glsl_to_spirv, judge_file, judge_glsl, judge_spirv, judge_text};
pub use judge::{hlsl_to_spirv, judge_hlsl, judge_osl, judge_rust, judge_wgsl, wgsl_to_msl, wgsl_to_spirv};
pub use vulkan::{ComputeShader, Device, DeviceDescription, RenderShaders};
