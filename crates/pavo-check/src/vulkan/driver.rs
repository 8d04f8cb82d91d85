//! Opens a Vulkan driver, directly or through the Vulkan loader, and makes an instance.

use std::path::Path;

use ash::vk;
use libloading::Library;

use super::environment;
use super::manifest::{LAVAPIPE_MANIFEST, manifests};
use crate::CheckError;
use crate::install::{LAVAPIPE, VULKAN_LOADER};

/// The version of Vulkan that this crate uses: 1.2, in which a device tells its driver's name, where the driver has it.
const API_VERSION: u32 = vk::API_VERSION_1_2;

/// The version of the interface between loader and driver that is offered to a driver opened directly. From version 2
/// on a driver gives its functions by `vk_icdGetInstanceProcAddr`.
const DRIVER_INTERFACE_VERSION: u32 = 5;

/// A Vulkan instance, destroyed on drop, before the library that it comes from is closed.
pub(crate) struct Driver {
    /// The instance.
    pub instance: ash::Instance,
    entry: ash::Entry,
    _library: Option<Library>,
}

impl Driver {
    /// Opens lavapipe's own library, so that neither other drivers nor layers are loaded; through the loader where no
    /// manifest of lavapipe is found. The loader may give other devices than lavapipe as well.
    pub fn lavapipe() -> Result<Driver, CheckError> {
        let _unchanged = environment::unchanged();
        if let Some(driver) = manifests(LAVAPIPE_MANIFEST).iter().find_map(|found| Driver::direct(&found.library)) {
            return Ok(driver);
        }
        Driver::by_loader().map_err(|error| match error {
            CheckError::Missing { .. } => CheckError::missing(LAVAPIPE),
            other => other,
        })
    }

    /// Every driver of this system, by the Vulkan loader.
    pub fn through_loader() -> Result<Driver, CheckError> {
        let _unchanged = environment::unchanged();
        Driver::by_loader()
    }

    /// Opens a driver library as the loader does. `None` when it is no driver that can be used so. The caller holds the
    /// lock of the environment.
    pub fn direct(library: &Path) -> Option<Driver> {
        // SAFETY: the library is a Vulkan driver, named by its manifest; loading it runs its initialisers. The two
        // functions have the types that the interface between loader and driver gives them, and are not used after the
        // library is closed, as `Driver` holds it.
        unsafe {
            let library = Library::new(library).ok()?;
            type Negotiate = unsafe extern "system" fn(*mut u32) -> vk::Result;
            let negotiate = *library.get::<Negotiate>(b"vk_icdNegotiateLoaderICDInterfaceVersion\0").ok()?;
            let mut version = DRIVER_INTERFACE_VERSION;
            if negotiate(&mut version) != vk::Result::SUCCESS || version < 2 {
                return None;
            }
            let get_instance_proc_addr =
                *library.get::<vk::PFN_vkGetInstanceProcAddr>(b"vk_icdGetInstanceProcAddr\0").ok()?;
            let entry = ash::Entry::from_static_fn(ash::StaticFn { get_instance_proc_addr });
            let instance = create_instance(&entry).ok()?;
            Some(Driver { instance, entry, _library: Some(library) })
        }
    }

    fn by_loader() -> Result<Driver, CheckError> {
        // SAFETY: loading the system's Vulkan loader runs its initialisers, which is what it is for.
        let entry = unsafe { ash::Entry::load() }.map_err(|error| CheckError::Missing {
            what: VULKAN_LOADER.name.to_owned(),
            install: VULKAN_LOADER.install.to_owned(),
            found: Some(error.to_string()),
        })?;
        match create_instance(&entry) {
            Ok(instance) => Ok(Driver { instance, entry, _library: None }),
            Err(vk::Result::ERROR_INCOMPATIBLE_DRIVER) => Err(CheckError::Missing {
                what: "a Vulkan driver".to_owned(),
                install: LAVAPIPE.install.to_owned(),
                found: Some("the Vulkan loader finds no driver".to_owned()),
            }),
            Err(result) => Err(failure("create an instance", result)),
        }
    }

    /// The version of Vulkan that the loader offers, such as `1.3.239`.
    pub fn loader_version(&self) -> Option<String> {
        // SAFETY: the entry is alive.
        let version = unsafe { self.entry.try_enumerate_instance_version() }.ok()?;
        Some(version_text(version.unwrap_or(vk::API_VERSION_1_0)))
    }

    /// The physical devices, in the driver's order.
    pub fn physical_devices(&self) -> Result<Vec<vk::PhysicalDevice>, CheckError> {
        // SAFETY: the instance is alive.
        unsafe { self.instance.enumerate_physical_devices() }.map_err(|result| failure("list the devices", result))
    }
}

impl Drop for Driver {
    fn drop(&mut self) {
        // SAFETY: devices keep their driver alive, so none is left when the driver is dropped.
        unsafe { self.instance.destroy_instance(None) }
    }
}

/// A version of Vulkan as people write it.
pub(super) fn version_text(version: u32) -> String {
    format!("{}.{}.{}", vk::api_version_major(version), vk::api_version_minor(version), vk::api_version_patch(version))
}

/// The error for a Vulkan call that failed.
pub(super) fn failure(action: &'static str, result: vk::Result) -> CheckError {
    CheckError::Vulkan { action, reason: result.to_string() }
}

fn create_instance(entry: &ash::Entry) -> Result<ash::Instance, vk::Result> {
    let application = vk::ApplicationInfo::default().api_version(API_VERSION);
    let information = vk::InstanceCreateInfo::default().application_info(&application);
    // SAFETY: the entry is alive and the structures are complete.
    unsafe { entry.create_instance(&information, None) }
}
