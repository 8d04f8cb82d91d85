//! Runs SPIR-V on a Vulkan device: lavapipe by default, so that results do not depend on a graphics card.
//!
//! Nothing is linked: the drivers are opened at run time. Modules should have passed
//! [`judge_spirv`](crate::judge_spirv) before they run; a driver may do anything with one that is not valid. What a
//! module declares (entry points, workgroup size, resources) is compared with what this crate provides before it
//! reaches the driver.

mod buffer;
mod compute;
mod compute_pipeline;
mod device;
mod dispatch_times;
mod driver;
mod environment;
mod graphics_pipeline;
mod manifest;
mod module_interface;
mod owned;
mod radv;
mod render;
mod statistics;
mod varyings;

pub use compute::ComputeShader;
pub use device::{Device, DeviceDescription};
pub use dispatch_times::Clock;
pub use render::RenderShaders;

pub(crate) use dispatch_times::Dispatch;
pub(crate) use driver::Driver;
pub(crate) use manifest::{LAVAPIPE_MANIFEST, RADV_MANIFEST, manifests};
pub(crate) use statistics::{Statistic, StatisticsDevice};
