//! What a fragment shader costs on a graphics card, as the card's compiler counts it. No card is needed.
//!
//! RADV, Mesa's driver for AMD, compiles for any family of cards and tells how many instructions it wrote and how long
//! its model of the card takes them to be. The numbers are those of a model: they are the same in each run of the same
//! driver and shader, and of use to compare shaders with each other. Three things to know:
//!
//! - Code behind an early `return` or `discard` is discounted although every lane runs it: leave those out of both
//!   shaders, or say that they are there.
//! - A loop of up to about 32 rounds is unrolled; one that stays is taken to run 8 times.
//! - Reading inputs and writing the colour costs too: subtract a shader that does only that ([`net`]).
//!
//! The inputs of the shader should be interpolated, as newer releases of Mesa move what depends on flat inputs alone to
//! the vertex stage.
//!
//! ```no_run
//! use pavo_check::static_cost::{StaticCompiler, net};
//!
//! let navi21 = StaticCompiler::open("navi21")?;
//! let shader = "@fragment fn main(@location(0) x: f32) -> @location(0) vec4f { return vec4f(cos(x)); }";
//! let empty = "@fragment fn main(@location(0) x: f32) -> @location(0) vec4f { return vec4f(x); }";
//! let cost = net(&navi21.wgsl("shader.wgsl", shader, "main")?, &navi21.wgsl("empty.wgsl", empty, "main")?)?;
//! assert!(cost.instructions > 0);
//! # Ok::<(), pavo_check::CheckError>(())
//! ```
//!
//! RADV takes the family from the environment variable `RADV_FORCE_FAMILY` and by no other way. It is set while a
//! [`StaticCompiler`] is opened and then restored; this crate opens and compiles nothing else meanwhile. A program whose
//! other threads call C code that reads the environment should open its compilers before it starts them.

mod family;
mod net;

use serde::Serialize;

pub use family::{FAMILIES, Family};
pub use net::{NetCost, net};

use crate::install::RADV;
use crate::judge::{Stage, glsl_to_spirv, wgsl_to_spirv};
use crate::vulkan::{Statistic, StatisticsDevice};
use crate::{CheckError, DeviceDescription};

/// What the compiler of one family counts in a fragment shader. Cycles are those of its model for one wave.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct StaticCost {
    /// The family of graphics cards, one of [`FAMILIES`].
    pub family: &'static str,
    /// Instructions.
    pub instructions: u64,
    /// Cycles in which one wave keeps the busiest unit from others: what counts when many waves run.
    pub inverse_throughput: u64,
    /// Cycles from the first to the last instruction of one wave: what counts when few waves run.
    pub latency: u64,
    /// Vector registers, which limit how many waves run at once.
    pub vgprs: u64,
    /// Scalar registers. RDNA gives each wave 128, whatever it needs.
    pub sgprs: u64,
    /// Vector registers that did not fit and lie in memory.
    pub spilled_vgprs: u64,
    /// Scalar registers that did not fit and lie in vector registers.
    pub spilled_sgprs: u64,
    /// Bytes of machine code.
    pub code_size: u64,
    /// The driver, `radv`.
    pub driver: String,
    /// The driver's version, such as `Mesa 22.3.6`.
    pub driver_version: String,
}

/// RADV, opened for one family of graphics cards. It can be shared between threads. Keep it for all shaders:
/// each then takes 1 to 3 ms.
pub struct StaticCompiler {
    family: &'static Family,
    device: StatisticsDevice,
}

impl StaticCompiler {
    /// Opens RADV for one of [`FAMILIES`], in 10 ms, or 300 ms for RDNA. Sets the environment variable `RADV_FORCE_FAMILY` for the
    /// moment; the module's documentation says what follows from that.
    ///
    /// # Errors
    /// [`CheckError::Input`] for a name that is none of the families, with their list; [`CheckError::Missing`] with
    /// what to install when RADV is not here or too old for the family; [`CheckError::Vulkan`] when the driver fails.
    pub fn open(family: &str) -> Result<StaticCompiler, CheckError> {
        let known = FAMILIES.iter().find(|known| known.name == family);
        let family = known.ok_or_else(|| CheckError::Input(unknown_family(family)))?;
        if let Some(device) = StatisticsDevice::radv(family.driver_names)? {
            return Ok(StaticCompiler { family, device });
        }
        Err(CheckError::Missing {
            what: format!("a release of RADV that knows {} ({})", family.name, family.description),
            install: RADV.install.to_owned(),
            found: None,
        })
    }

    /// The family that this compiler is for.
    pub fn family(&self) -> &'static Family {
        self.family
    }

    /// What the driver says of itself.
    pub fn description(&self) -> &DeviceDescription {
        self.device.description()
    }

    /// The cost of a fragment shader as SPIR-V. It writes a colour to location 0, and reads scalars and vectors of
    /// 32-bit numbers that are interpolated or flat, each at a location of its own; it has no buffers, textures and
    /// push constants.
    ///
    /// The module must be valid ([`judge_spirv`](crate::judge_spirv)); a driver may do anything with one that is not.
    ///
    /// # Errors
    /// [`CheckError::Input`] when the module has no such fragment entry, or one with other inputs or resources;
    /// [`CheckError::Limit`] when it has too many inputs; [`CheckError::Vulkan`] when the driver fails.
    pub fn spirv(&self, words: &[u32], entry: &str) -> Result<StaticCost, CheckError> {
        let statistics = self.device.fragment(words, entry)?;
        let description = self.device.description();
        let value = |name: &'static str| find(&statistics, name);
        Ok(StaticCost {
            family: self.family.name,
            instructions: value("Instructions")?,
            inverse_throughput: value("Inverse Throughput")?,
            latency: value("Latency")?,
            vgprs: value("VGPRs")?,
            sgprs: value("SGPRs")?,
            spilled_vgprs: value("Spilled VGPRs")?,
            spilled_sgprs: value("Spilled SGPRs")?,
            code_size: value("Code size")?,
            driver: description.driver_name.clone(),
            driver_version: description.driver_info.clone(),
        })
    }

    /// The cost of a fragment shader in WGSL, by naga. `file` is the name to use in messages.
    ///
    /// # Errors
    /// Those of [`StaticCompiler::spirv`] and of [`wgsl_to_spirv`].
    pub fn wgsl(&self, file: &str, text: &str, entry: &str) -> Result<StaticCost, CheckError> {
        self.spirv(&wgsl_to_spirv(file, text)?, entry)
    }

    /// The cost of a complete fragment shader in GLSL for Vulkan, by glslang. `file` is the name to use in messages.
    ///
    /// # Errors
    /// Those of [`StaticCompiler::spirv`] and of [`glsl_to_spirv`].
    pub fn glsl(&self, file: &str, text: &str) -> Result<StaticCost, CheckError> {
        self.spirv(&glsl_to_spirv(file, text, Stage::Fragment)?, "main")
    }
}

fn unknown_family(name: &str) -> String {
    let known: Vec<&str> = FAMILIES.iter().map(|family| family.name).collect();
    format!("no family of graphics cards `{name}` is known: expected one of {}", known.join(", "))
}

/// A statistic by its name; releases of Mesa differ in capitals.
fn find(statistics: &[Statistic], name: &'static str) -> Result<u64, CheckError> {
    let found = statistics.iter().find(|statistic| statistic.name.eq_ignore_ascii_case(name));
    found.map(|statistic| statistic.value).ok_or_else(|| {
        let names: Vec<&str> = statistics.iter().map(|statistic| statistic.name.as_str()).collect();
        let reason = format!("the driver has no `{name}`: it has {}", names.join(", "));
        CheckError::Vulkan { action: "read the statistics of a pipeline", reason }
    })
}
