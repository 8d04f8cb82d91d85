//! A buffer that both the CPU and the device see.

use std::ffi::c_void;

use ash::vk;

use super::device::Device;
use super::driver::failure;
use super::owned::Owned;
use crate::CheckError;

/// A buffer of 32-bit floats in memory that is mapped for as long as the buffer lives.
pub(super) struct Buffer<'device> {
    mapped: *mut c_void,
    length: usize,
    buffer: Owned<'device, vk::Buffer>,
    // After the buffer, as fields are dropped in order: the memory outlives what is bound to it.
    _memory: Owned<'device, vk::DeviceMemory>,
}

impl<'device> Buffer<'device> {
    /// Creates a buffer for `length` floats, at least one.
    pub fn new(device: &'device Device, length: usize, usage: vk::BufferUsageFlags) -> Result<Self, CheckError> {
        let size = (length as u64).saturating_mul(4);
        if size > device.max_allocation && device.max_allocation > 0 {
            let what = "the size of a buffer in bytes".to_owned();
            return Err(CheckError::Limit { what, asked: size, allowed: device.max_allocation });
        }
        let handle = &device.device;
        let information =
            vk::BufferCreateInfo::default().size(size).usage(usage).sharing_mode(vk::SharingMode::EXCLUSIVE);
        // SAFETY: all objects belong to this device; the memory fits the buffer's requirements and is bound once.
        unsafe {
            let buffer =
                handle.create_buffer(&information, None).map_err(|result| failure("create a buffer", result))?;
            let buffer = Owned::new(handle, buffer, |device, buffer| device.destroy_buffer(buffer, None));
            let requirements = handle.get_buffer_memory_requirements(buffer.handle);
            let visible = vk::MemoryPropertyFlags::HOST_VISIBLE | vk::MemoryPropertyFlags::HOST_COHERENT;
            let memory_type = memory_type(&device.memory, requirements, visible, vk::MemoryPropertyFlags::HOST_CACHED)
                .ok_or_else(|| CheckError::Vulkan {
                    action: "create a buffer",
                    reason: "the device has no memory that the CPU sees".to_owned(),
                })?;
            let memory = allocate(device, requirements.size, memory_type)?;
            handle
                .bind_buffer_memory(buffer.handle, memory.handle, 0)
                .map_err(|result| failure("bind the memory of a buffer", result))?;
            let mapped = handle
                .map_memory(memory.handle, 0, vk::WHOLE_SIZE, vk::MemoryMapFlags::empty())
                .map_err(|result| failure("map the memory of a buffer", result))?;
            Ok(Buffer { mapped, length, buffer, _memory: memory })
        }
    }

    /// The Vulkan object.
    pub fn handle(&self) -> vk::Buffer {
        self.buffer.handle
    }

    /// Copies floats to the start of the buffer; those that do not fit are left out.
    pub fn write(&mut self, values: &[f32]) {
        let count = values.len().min(self.length);
        // SAFETY: the mapping holds `length` floats, is aligned by Vulkan for any scalar, and no commands are pending.
        unsafe { std::ptr::copy_nonoverlapping(values.as_ptr(), self.mapped.cast::<f32>(), count) }
    }

    /// The first floats of the buffer, as many as asked or as there are.
    pub fn read(&self, count: usize) -> &[f32] {
        // SAFETY: as in `write`; every bit pattern is a float, and memory of a device is never uninitialised in the
        // sense of Rust, as it comes from outside.
        unsafe { std::slice::from_raw_parts(self.mapped.cast::<f32>(), count.min(self.length)) }
    }
}

/// Allocates memory of a device.
pub(super) fn allocate(
    device: &Device,
    size: u64,
    memory_type: u32,
) -> Result<Owned<'_, vk::DeviceMemory>, CheckError> {
    let information = vk::MemoryAllocateInfo::default().allocation_size(size).memory_type_index(memory_type);
    // SAFETY: the device is alive and the type is one of its own.
    unsafe {
        let memory =
            device.device.allocate_memory(&information, None).map_err(|result| failure("allocate memory", result))?;
        Ok(Owned::new(&device.device, memory, |device, memory| device.free_memory(memory, None)))
    }
}

/// The index of a memory type that fits the requirements and has the needed properties, with the preferred ones where
/// there is such a type.
pub(super) fn memory_type(
    memory: &vk::PhysicalDeviceMemoryProperties,
    requirements: vk::MemoryRequirements,
    needed: vk::MemoryPropertyFlags,
    preferred: vk::MemoryPropertyFlags,
) -> Option<u32> {
    let find = |flags: vk::MemoryPropertyFlags| {
        (0..memory.memory_type_count).find(|&index| {
            requirements.memory_type_bits & (1 << index) != 0
                && memory.memory_types_as_slice()[index as usize].property_flags.contains(flags)
        })
    };
    find(needed | preferred).or_else(|| find(needed))
}
