//! Compiles pipelines for a graphics card that need not be here, and reads what the compiler says of them.
//!
//! RADV makes a device for any family that `RADV_FORCE_FAMILY` names when it is opened. Such a device compiles and does
//! nothing else: no image and no memory is made on it, and nothing is submitted.

use std::path::Path;

use ash::vk;

use super::device::{DeviceDescription, describe};
use super::driver::{Driver, failure};
use super::environment;
use super::graphics_pipeline::{GraphicsPipeline, render_pass};
use super::module_interface::{FRAGMENT, ModuleInterface};
use super::radv;
use super::render::RenderShaders;
use super::varyings::{varyings, vertex_text};
use crate::CheckError;
use crate::install::RADV;
use crate::judge::wgsl_to_spirv;

/// What a compiler counts in one stage of a pipeline, under the driver's own name for it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Statistic {
    pub name: String,
    pub value: u64,
}

/// A device that compiles for one family of graphics cards.
pub(crate) struct StatisticsDevice {
    device: ash::Device,
    executables: ash::khr::pipeline_executable_properties::Device,
    limits: vk::PhysicalDeviceLimits,
    description: DeviceDescription,
    // The last field, as it is dropped last: the instance outlives its devices.
    _driver: Driver,
}

impl StatisticsDevice {
    /// Opens RADV for a family, by the first of the names for it that the driver knows. `None` when it knows none.
    pub fn radv(family: &[&'static str]) -> Result<Option<StatisticsDevice>, CheckError> {
        for library in radv::libraries()? {
            if let Some(name) = radv::known_name(&library, family)
                && let Some(device) = StatisticsDevice::of_library(&library, name)?
            {
                return Ok(Some(device));
            }
        }
        Ok(None)
    }

    fn of_library(library: &Path, family: &str) -> Result<Option<StatisticsDevice>, CheckError> {
        let variables = [
            ("RADV_FORCE_FAMILY", Some(family)),
            // What is told is what this driver's compiler does now; other programs share the cache on disk.
            ("MESA_SHADER_CACHE_DISABLE", Some("true")),
            // The driver would say on standard error that it is young on the newest cards.
            ("MESA_VK_IGNORE_CONFORMANCE_WARNING", Some("true")),
            // These change the compiler or what it does.
            ("RADV_DEBUG", None),
            ("RADV_PERFTEST", None),
        ];
        environment::with_variables(&variables, || {
            let Some(driver) = Driver::direct(library) else { return Ok(None) };
            let devices = driver.physical_devices()?;
            let radv =
                devices.into_iter().find(|&device| describe(&driver.instance, device).driver_name == RADV_DRIVER_NAME);
            radv.map(|device| StatisticsDevice::open(driver, device)).transpose()
        })
    }

    fn open(driver: Driver, physical_device: vk::PhysicalDevice) -> Result<StatisticsDevice, CheckError> {
        let instance = &driver.instance;
        let description = describe(instance, physical_device);
        // SAFETY: the instance is alive and the physical device is one of its own, here and below.
        let offered = unsafe { instance.enumerate_device_extension_properties(physical_device) }
            .map_err(|result| failure("list the extensions of the device", result))?;
        let wanted = ash::khr::pipeline_executable_properties::NAME;
        if !offered.iter().any(|extension| extension.extension_name_as_c_str() == Ok(wanted)) {
            return Err(CheckError::Missing {
                what: format!("the extension {} of {description}", wanted.to_string_lossy()),
                install: format!("{}, of a newer release", RADV.install),
                found: None,
            });
        }
        let limits = unsafe { instance.get_physical_device_properties(physical_device) }.limits;
        let available = unsafe { instance.get_physical_device_features(physical_device) };
        let features = vk::PhysicalDeviceFeatures {
            shader_float64: available.shader_float64,
            shader_int64: available.shader_int64,
            ..vk::PhysicalDeviceFeatures::default()
        };
        let extensions = [wanted.as_ptr()];
        let mut with_statistics =
            vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default().pipeline_executable_info(true);
        let priorities = [1.0];
        let queues = [vk::DeviceQueueCreateInfo::default().queue_family_index(0).queue_priorities(&priorities)];
        let information = vk::DeviceCreateInfo::default()
            .queue_create_infos(&queues)
            .enabled_extension_names(&extensions)
            .enabled_features(&features)
            .push_next(&mut with_statistics);
        let device = unsafe { instance.create_device(physical_device, &information, None) }
            .map_err(|result| failure("open the device", result))?;
        let executables = ash::khr::pipeline_executable_properties::Device::new(instance, &device);
        Ok(StatisticsDevice { device, executables, limits, description, _driver: driver })
    }

    /// What the device says of itself.
    pub fn description(&self) -> &DeviceDescription {
        &self.description
    }

    /// Compiles a fragment shader without resources, and returns what the compiler counts in it.
    pub fn fragment(&self, spirv: &[u32], entry: &str) -> Result<Vec<Statistic>, CheckError> {
        let interface = ModuleInterface::read(spirv)?;
        interface.entry_point(entry, FRAGMENT)?;
        interface.check_resources(&[])?;
        let most_locations = self.limits.max_vertex_output_components.min(self.limits.max_fragment_input_components);
        let vertex = wgsl_to_spirv("the vertex stage", &vertex_text(&varyings(spirv, entry, most_locations / 4)?))?;
        let shaders = RenderShaders { vertex: &vertex, vertex_entry: "main", fragment: spirv, fragment_entry: entry };
        let _unchanged = environment::unchanged();
        let pass = render_pass(&self.device)?;
        let extent = vk::Extent2D { width: 1, height: 1 };
        let flags = vk::PipelineCreateFlags::CAPTURE_STATISTICS_KHR;
        let pipeline = GraphicsPipeline::new(&self.device, &shaders, pass.handle, extent, flags)?;
        self.read(pipeline.handle())
    }

    /// The statistics of the fragment stage.
    fn read(&self, pipeline: vk::Pipeline) -> Result<Vec<Statistic>, CheckError> {
        let action = "read the statistics of a pipeline";
        // SAFETY: the pipeline is one of this device, made with the flag that captures statistics; of the union each
        // field is read that the format names.
        unsafe {
            let executables = self
                .executables
                .get_pipeline_executable_properties(&vk::PipelineInfoKHR::default().pipeline(pipeline))
                .map_err(|result| failure(action, result))?;
            let index = executables.iter().position(|one| one.stages.contains(vk::ShaderStageFlags::FRAGMENT));
            let index = index.and_then(|index| u32::try_from(index).ok()).ok_or_else(|| CheckError::Vulkan {
                action,
                reason: format!("{} compiled no fragment stage", self.description),
            })?;
            let information = vk::PipelineExecutableInfoKHR::default().pipeline(pipeline).executable_index(index);
            let statistics = self
                .executables
                .get_pipeline_executable_statistics(&information)
                .map_err(|result| failure(action, result))?;
            let numbers = statistics.iter().filter_map(|statistic| {
                let name = statistic.name_as_c_str().ok()?.to_string_lossy().into_owned();
                let value = match statistic.format {
                    vk::PipelineExecutableStatisticFormatKHR::UINT64 => statistic.value.u64,
                    vk::PipelineExecutableStatisticFormatKHR::INT64 => u64::try_from(statistic.value.i64).ok()?,
                    _ => return None,
                };
                Some(Statistic { name, value })
            });
            Ok(numbers.collect())
        }
    }
}

/// What RADV calls itself.
const RADV_DRIVER_NAME: &str = "radv";

impl Drop for StatisticsDevice {
    fn drop(&mut self) {
        // SAFETY: the device is alive, nothing was ever submitted to it, and what was created on it borrows it.
        unsafe { self.device.destroy_device(None) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_family_that_the_driver_does_not_know_is_none() {
        let device = StatisticsDevice::radv(&["NO_SUCH_FAMILY"]).unwrap_or_else(|error| panic!("{error}"));
        assert!(device.is_none());
    }
}
