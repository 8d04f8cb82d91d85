//! Chooses a Vulkan device and runs commands on it.

use std::sync::Mutex;

use ash::vk;
use serde::Serialize;

use super::driver::{Driver, failure, version_text};
use super::environment;
use super::module_interface::ModuleInterface;
use super::owned::Owned;
use crate::CheckError;
use crate::install::LAVAPIPE;

/// What a Vulkan device says of itself.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct DeviceDescription {
    /// The device, such as `llvmpipe (LLVM 15.0.6, 256 bits)`.
    pub name: String,
    /// The driver, such as `llvmpipe`; empty for drivers older than Vulkan 1.2.
    pub driver_name: String,
    /// The driver's version, such as `Mesa 22.3.6 (LLVM 15.0.6)`; empty for drivers older than Vulkan 1.2.
    pub driver_info: String,
    /// The version of Vulkan that the device offers, such as `1.3.230`.
    pub api_version: String,
    /// Whether the device is lavapipe, Mesa's driver for the CPU.
    pub is_lavapipe: bool,
}

impl std::fmt::Display for DeviceDescription {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}", self.name)?;
        if !self.driver_info.is_empty() {
            write!(formatter, ", {}", self.driver_info)?;
        }
        write!(formatter, ", Vulkan {}", self.api_version)
    }
}

/// A Vulkan device on which shaders run. It can be shared between threads; work is queued.
pub struct Device {
    pub(super) device: ash::Device,
    pub(super) memory: vk::PhysicalDeviceMemoryProperties,
    pub(super) limits: vk::PhysicalDeviceLimits,
    pub(super) max_allocation: u64,
    /// How many bits of a timestamp count; 0 when the queue writes none.
    pub(super) timestamp_bits: u32,
    queue: Mutex<vk::Queue>,
    queue_family: u32,
    description: DeviceDescription,
    has_half_precision: bool,
    // The last field, as it is dropped last: the instance outlives its devices.
    _driver: Driver,
}

impl Device {
    /// Opens lavapipe, Mesa's Vulkan driver for the CPU, whatever other devices this machine has.
    ///
    /// # Errors
    /// [`CheckError::Missing`] with what to install and the devices that were found, when lavapipe is not here;
    /// [`CheckError::Vulkan`] when the driver fails.
    pub fn lavapipe() -> Result<Device, CheckError> {
        let missing = |found: Vec<DeviceDescription>| CheckError::Missing {
            what: LAVAPIPE.name.to_owned(),
            install: LAVAPIPE.install.to_owned(),
            found: Some(list_of_found(&found)),
        };
        Device::open(Driver::lavapipe()?, |description| description.is_lavapipe, missing)
    }

    /// Opens the first device whose name or driver name contains `name`, in either case of letters.
    ///
    /// # Errors
    /// [`CheckError::Missing`] with the devices that were found, when none has that name;
    /// [`CheckError::Vulkan`] when the driver fails.
    pub fn named(name: &str) -> Result<Device, CheckError> {
        let wanted = name.to_lowercase();
        let missing = |found: Vec<DeviceDescription>| CheckError::Missing {
            what: format!("a Vulkan device with `{name}` in its name"),
            install: "install the driver of that device, or choose one of those that are here".to_owned(),
            found: Some(list_of_found(&found)),
        };
        let fits = |description: &DeviceDescription| {
            description.name.to_lowercase().contains(&wanted)
                || description.driver_name.to_lowercase().contains(&wanted)
        };
        Device::open(Driver::through_loader()?, fits, missing)
    }

    /// Describes every Vulkan device of this machine, in the order of the Vulkan loader.
    ///
    /// # Errors
    /// [`CheckError::Missing`] without a Vulkan loader or driver.
    pub fn list() -> Result<Vec<DeviceDescription>, CheckError> {
        let driver = Driver::through_loader()?;
        let _unchanged = environment::unchanged();
        let devices = driver.physical_devices()?;
        Ok(devices.into_iter().map(|device| describe(&driver.instance, device)).collect())
    }

    /// What the device says of itself.
    pub fn description(&self) -> &DeviceDescription {
        &self.description
    }

    /// Whether shaders can compute in half precision, the feature `shaderFloat16`.
    pub fn has_half_precision(&self) -> bool {
        self.has_half_precision
    }

    /// Refuses a module in half precision where the device has none.
    pub(super) fn check_precision(&self, interface: &ModuleInterface) -> Result<(), CheckError> {
        if !interface.has_half_precision || self.has_half_precision {
            return Ok(());
        }
        Err(CheckError::Missing {
            what: format!("half precision in shaders (shaderFloat16) on {}", self.description),
            install: "take another device, or leave `precision = \"half\"` out of the scene".to_owned(),
            found: None,
        })
    }

    fn open(
        driver: Driver,
        fits: impl Fn(&DeviceDescription) -> bool,
        missing: impl FnOnce(Vec<DeviceDescription>) -> CheckError,
    ) -> Result<Device, CheckError> {
        let _unchanged = environment::unchanged();
        let physical_devices = driver.physical_devices()?;
        let descriptions: Vec<DeviceDescription> =
            physical_devices.iter().map(|&device| describe(&driver.instance, device)).collect();
        let Some(index) = descriptions.iter().position(fits) else { return Err(missing(descriptions)) };
        let (physical_device, description) = (physical_devices[index], descriptions[index].clone());

        let instance = &driver.instance;
        // SAFETY: the instance is alive and the physical device is one of its own, here and below.
        let families = unsafe { instance.get_physical_device_queue_family_properties(physical_device) };
        let both = vk::QueueFlags::GRAPHICS | vk::QueueFlags::COMPUTE;
        let queue_family = families.iter().position(|family| family.queue_flags.contains(both)).ok_or_else(|| {
            let reason = format!("{description} has no queue for both graphics and compute");
            CheckError::Vulkan { action: "open the device", reason }
        })?;
        let timestamp_bits = families[queue_family].timestamp_valid_bits;
        let queue_family = u32::try_from(queue_family).unwrap_or(u32::MAX);

        let mut maintenance = vk::PhysicalDeviceMaintenance3Properties::default();
        let mut properties = vk::PhysicalDeviceProperties2::default().push_next(&mut maintenance);
        unsafe { instance.get_physical_device_properties2(physical_device, &mut properties) };
        let limits = properties.properties.limits;
        let memory = unsafe { instance.get_physical_device_memory_properties(physical_device) };

        let has_half_precision = half_precision(instance, physical_device)?;
        // Other types are switched on where the device has them; everything else stays off.
        let available = unsafe { instance.get_physical_device_features(physical_device) };
        let features = vk::PhysicalDeviceFeatures {
            shader_float64: available.shader_float64,
            shader_int64: available.shader_int64,
            ..vk::PhysicalDeviceFeatures::default()
        };
        let priorities = [1.0];
        let queues =
            [vk::DeviceQueueCreateInfo::default().queue_family_index(queue_family).queue_priorities(&priorities)];
        let mut half_precision =
            vk::PhysicalDeviceShaderFloat16Int8Features::default().shader_float16(has_half_precision);
        let extensions = [ash::khr::shader_float16_int8::NAME.as_ptr()];
        let mut information = vk::DeviceCreateInfo::default().queue_create_infos(&queues).enabled_features(&features);
        if has_half_precision {
            information = information.enabled_extension_names(&extensions).push_next(&mut half_precision);
        }
        let device = unsafe { instance.create_device(physical_device, &information, None) }
            .map_err(|result| failure("open the device", result))?;
        let queue = Mutex::new(unsafe { device.get_device_queue(queue_family, 0) });
        let max_allocation = maintenance.max_memory_allocation_size;
        Ok(Device {
            device,
            memory,
            limits,
            max_allocation,
            timestamp_bits,
            queue,
            queue_family,
            description,
            has_half_precision,
            _driver: driver,
        })
    }

    /// Records commands, runs them, and waits until they are done.
    pub(super) fn run(&self, record: impl FnOnce(vk::CommandBuffer)) -> Result<(), CheckError> {
        // A driver compiles at the first run, too.
        let _unchanged = environment::unchanged();
        let device = &self.device;
        // SAFETY: all objects belong to this device; the queue is locked while it is used; the wait at the end sees to
        // it that no command is pending when the objects are dropped.
        unsafe {
            let information = vk::CommandPoolCreateInfo::default()
                .queue_family_index(self.queue_family)
                .flags(vk::CommandPoolCreateFlags::TRANSIENT);
            let pool = device
                .create_command_pool(&information, None)
                .map_err(|result| failure("create a command pool", result))?;
            let pool = Owned::new(device, pool, |device, pool| device.destroy_command_pool(pool, None));
            let fence = device
                .create_fence(&vk::FenceCreateInfo::default(), None)
                .map_err(|result| failure("create a fence", result))?;
            let fence = Owned::new(device, fence, |device, fence| device.destroy_fence(fence, None));

            let information = vk::CommandBufferAllocateInfo::default()
                .command_pool(pool.handle)
                .level(vk::CommandBufferLevel::PRIMARY)
                .command_buffer_count(1);
            let commands = device
                .allocate_command_buffers(&information)
                .map_err(|result| failure("allocate a command buffer", result))?;
            let once = vk::CommandBufferBeginInfo::default().flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
            device.begin_command_buffer(commands[0], &once).map_err(|result| failure("begin commands", result))?;
            record(commands[0]);
            device.end_command_buffer(commands[0]).map_err(|result| failure("record commands", result))?;

            let submission = [vk::SubmitInfo::default().command_buffers(&commands)];
            {
                let queue = self.queue.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
                device
                    .queue_submit(*queue, &submission, fence.handle)
                    .map_err(|result| failure("submit commands", result))?;
            }
            device.wait_for_fences(&[fence.handle], true, u64::MAX).map_err(|result| {
                // The commands may still be pending: nothing may be destroyed before the device is idle or lost.
                let _queue = self.queue.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
                device.device_wait_idle().err().map_or_else(
                    || failure("wait for the commands", result),
                    |lost| failure("wait for the device", lost),
                )
            })
        }
    }
}

impl Drop for Device {
    fn drop(&mut self) {
        // SAFETY: the device is alive, and what was created on it borrows it, so that nothing is left. An error of the
        // wait means that the device is lost; it is destroyed all the same.
        unsafe {
            let _ = self.device.device_wait_idle();
            self.device.destroy_device(None);
        }
    }
}

/// Whether a device has the extension for half precision in shaders, and the feature.
fn half_precision(instance: &ash::Instance, device: vk::PhysicalDevice) -> Result<bool, CheckError> {
    // SAFETY: the instance is alive and the physical device is one of its own, here and below.
    let extensions = unsafe { instance.enumerate_device_extension_properties(device) }
        .map_err(|result| failure("list the extensions of the device", result))?;
    let is_it = |extension: &vk::ExtensionProperties| {
        extension.extension_name_as_c_str() == Ok(ash::khr::shader_float16_int8::NAME)
    };
    if !extensions.iter().any(is_it) {
        return Ok(false);
    }
    let mut half = vk::PhysicalDeviceShaderFloat16Int8Features::default();
    let mut features = vk::PhysicalDeviceFeatures2::default().push_next(&mut half);
    unsafe { instance.get_physical_device_features2(device, &mut features) };
    Ok(half.shader_float16 == vk::TRUE)
}

/// Creates a shader module of words that `module_interface` has looked through.
pub(super) fn shader_module<'device>(
    device: &'device ash::Device,
    words: &[u32],
) -> Result<Owned<'device, vk::ShaderModule>, CheckError> {
    let information = vk::ShaderModuleCreateInfo::default().code(words);
    // SAFETY: the device is alive; that the module is valid is the caller's contract.
    unsafe {
        let module = device
            .create_shader_module(&information, None)
            .map_err(|result| failure("create a shader module", result))?;
        Ok(Owned::new(device, module, |device, module| device.destroy_shader_module(module, None)))
    }
}

pub(super) fn describe(instance: &ash::Instance, device: vk::PhysicalDevice) -> DeviceDescription {
    let mut driver = vk::PhysicalDeviceDriverProperties::default();
    let mut properties = vk::PhysicalDeviceProperties2::default().push_next(&mut driver);
    // SAFETY: the instance is alive and the device is one of its own. A driver older than Vulkan 1.2 leaves the driver's
    // properties as they are.
    unsafe { instance.get_physical_device_properties2(device, &mut properties) };
    let properties = properties.properties;
    let text = |text: Result<&std::ffi::CStr, _>| -> String {
        text.map(|text: &std::ffi::CStr| text.to_string_lossy().into_owned()).unwrap_or_default()
    };
    DeviceDescription {
        name: text(properties.device_name_as_c_str()),
        driver_name: text(driver.driver_name_as_c_str()),
        driver_info: text(driver.driver_info_as_c_str()),
        api_version: version_text(properties.api_version),
        is_lavapipe: driver.driver_id == vk::DriverId::MESA_LLVMPIPE,
    }
}

fn list_of_found(found: &[DeviceDescription]) -> String {
    if found.is_empty() {
        return "no Vulkan device was found".to_owned();
    }
    let names: Vec<String> = found.iter().map(DeviceDescription::to_string).collect();
    format!("the devices found are: {}", names.join("; "))
}
