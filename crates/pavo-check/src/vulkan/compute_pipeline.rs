//! A compute pipeline that reads one buffer and writes another.

use std::ffi::CString;

use ash::vk;

use super::buffer::Buffer;
use super::compute::ComputeShader;
use super::device::{Device, shader_module};
use super::driver::failure;
use super::owned::Owned;
use crate::CheckError;

/// The descriptor set and bindings of the inputs and the outputs.
pub(super) const RESOURCES: [(u32, u32); 2] = [(0, 0), (0, 1)];

/// The bits of a float that is no number, with which the outputs are filled beforehand.
const NOT_A_NUMBER: u32 = 0x7fc0_0000;

/// A compute pipeline with one descriptor set for the two buffers.
pub(super) struct ComputePipeline<'device> {
    device: &'device Device,
    set: vk::DescriptorSet,
    // In the order in which they are to be destroyed.
    pipeline: Owned<'device, vk::Pipeline>,
    layout: Owned<'device, vk::PipelineLayout>,
    _tables: Vec<Buffer<'device>>,
    _pool: Owned<'device, vk::DescriptorPool>,
    _set_layout: Owned<'device, vk::DescriptorSetLayout>,
}

impl<'device> ComputePipeline<'device> {
    /// Compiles a shader that was compared with the call and with the device.
    pub fn new(device: &'device Device, shader: &ComputeShader<'_>) -> Result<Self, CheckError> {
        let entry = entry_name(shader.entry)?;
        let handle = &device.device;
        let module = shader_module(handle, shader.spirv)?;
        let count = (RESOURCES.len() + shader.tables.len()) as u32;
        let binding = |binding: u32| {
            vk::DescriptorSetLayoutBinding::default()
                .binding(binding)
                .descriptor_type(vk::DescriptorType::STORAGE_BUFFER)
                .descriptor_count(1)
                .stage_flags(vk::ShaderStageFlags::COMPUTE)
        };
        let bindings: Vec<_> = (0..count).map(binding).collect();
        let tables = tables(device, shader)?;
        // SAFETY: all objects belong to this device and outlive what is made of them; the entry point was found in the
        // module, and its resources are those of the layout.
        unsafe {
            let information = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
            let set_layout = handle
                .create_descriptor_set_layout(&information, None)
                .map_err(|result| failure("create a descriptor set layout", result))?;
            let set_layout = Owned::new(handle, set_layout, |device, layout| {
                device.destroy_descriptor_set_layout(layout, None);
            });
            let set_layouts = [set_layout.handle];

            let sizes =
                [vk::DescriptorPoolSize::default().ty(vk::DescriptorType::STORAGE_BUFFER).descriptor_count(count)];
            let information = vk::DescriptorPoolCreateInfo::default().max_sets(1).pool_sizes(&sizes);
            let pool = handle
                .create_descriptor_pool(&information, None)
                .map_err(|result| failure("create a descriptor pool", result))?;
            let pool = Owned::new(handle, pool, |device, pool| device.destroy_descriptor_pool(pool, None));
            let information =
                vk::DescriptorSetAllocateInfo::default().descriptor_pool(pool.handle).set_layouts(&set_layouts);
            let sets = handle
                .allocate_descriptor_sets(&information)
                .map_err(|result| failure("allocate a descriptor set", result))?;

            let information = vk::PipelineLayoutCreateInfo::default().set_layouts(&set_layouts);
            let layout = handle
                .create_pipeline_layout(&information, None)
                .map_err(|result| failure("create a pipeline layout", result))?;
            let layout = Owned::new(handle, layout, |device, layout| device.destroy_pipeline_layout(layout, None));

            let stage = vk::PipelineShaderStageCreateInfo::default()
                .stage(vk::ShaderStageFlags::COMPUTE)
                .module(module.handle)
                .name(&entry);
            let information = [vk::ComputePipelineCreateInfo::default().stage(stage).layout(layout.handle)];
            let pipelines = handle
                .create_compute_pipelines(vk::PipelineCache::null(), &information, None)
                .map_err(|(_, result)| failure("create the compute pipeline", result))?;
            let pipeline = Owned::new(handle, pipelines[0], |device, pipeline| device.destroy_pipeline(pipeline, None));
            for (binding, table) in (RESOURCES.len() as u32..).zip(&tables) {
                write_binding(device, sets[0], binding, table, vk::WHOLE_SIZE);
            }
            Ok(ComputePipeline {
                device,
                set: sets[0],
                pipeline,
                layout,
                _tables: tables,
                _pool: pool,
                _set_layout: set_layout,
            })
        }
    }

    /// Binds the first floats of the two buffers.
    pub fn bind(&self, inputs: &Buffer<'_>, input_length: usize, outputs: &Buffer<'_>, output_length: usize) {
        for ((_, binding), (buffer, length)) in RESOURCES.iter().zip([(inputs, input_length), (outputs, output_length)])
        {
            // SAFETY: set and buffers belong to this device, and no commands are pending.
            unsafe { write_binding(self.device, self.set, *binding, buffer, length as u64 * 4) };
        }
    }

    /// Fills the outputs with NaN, runs that many workgroups, and makes the outputs visible to the CPU.
    pub fn run(&self, outputs: &Buffer<'_>, group_count: usize) -> Result<(), CheckError> {
        let group_count = u32::try_from(group_count).unwrap_or(u32::MAX);
        let device = &self.device.device;
        self.device.run(|commands| {
            let filled = [vk::MemoryBarrier::default()
                .src_access_mask(vk::AccessFlags::TRANSFER_WRITE)
                .dst_access_mask(vk::AccessFlags::SHADER_WRITE | vk::AccessFlags::SHADER_READ)];
            let written = [vk::MemoryBarrier::default()
                .src_access_mask(vk::AccessFlags::SHADER_WRITE)
                .dst_access_mask(vk::AccessFlags::HOST_READ)];
            let (transfer, compute) = (vk::PipelineStageFlags::TRANSFER, vk::PipelineStageFlags::COMPUTE_SHADER);
            let none = vk::DependencyFlags::empty();
            // SAFETY: the commands are being recorded, and all objects belong to this device, and the buffers
            // were bound.
            unsafe {
                device.cmd_fill_buffer(commands, outputs.handle(), 0, vk::WHOLE_SIZE, NOT_A_NUMBER);
                device.cmd_pipeline_barrier(commands, transfer, compute, none, &filled, &[], &[]);
                self.record(commands, group_count);
                device.cmd_pipeline_barrier(commands, compute, vk::PipelineStageFlags::HOST, none, &written, &[], &[]);
            }
        })
    }

    /// Records the run of that many workgroups.
    ///
    /// # Safety
    /// `commands` is of this pipeline's device and is being recorded, and buffers are bound.
    pub unsafe fn record(&self, commands: vk::CommandBuffer, group_count: u32) {
        let device = &self.device.device;
        let bind_point = vk::PipelineBindPoint::COMPUTE;
        // SAFETY: by the contract of this function; all objects belong to this device and are bound as the layout says.
        unsafe {
            device.cmd_bind_pipeline(commands, bind_point, self.pipeline.handle);
            device.cmd_bind_descriptor_sets(commands, bind_point, self.layout.handle, 0, &[self.set], &[]);
            device.cmd_dispatch(commands, group_count, 1, 1);
        }
    }
}

/// The buffers of a shader's tables, filled.
fn tables<'device>(device: &'device Device, shader: &ComputeShader<'_>) -> Result<Vec<Buffer<'device>>, CheckError> {
    let filled = |table: &Vec<f32>| {
        let mut buffer = Buffer::new(device, table.len(), vk::BufferUsageFlags::STORAGE_BUFFER)?;
        buffer.write(table);
        Ok(buffer)
    };
    shader.tables.iter().map(filled).collect()
}

/// Binds the first bytes of a buffer.
///
/// # Safety
/// The set and the buffer belong to this device, and no commands that use the set are pending.
unsafe fn write_binding(device: &Device, set: vk::DescriptorSet, binding: u32, buffer: &Buffer<'_>, bytes: u64) {
    let range = [vk::DescriptorBufferInfo::default().buffer(buffer.handle()).offset(0).range(bytes)];
    let write = vk::WriteDescriptorSet::default()
        .dst_set(set)
        .dst_binding(binding)
        .descriptor_type(vk::DescriptorType::STORAGE_BUFFER)
        .buffer_info(&range);
    // SAFETY: by the contract of this function.
    unsafe { device.device.update_descriptor_sets(&[write], &[]) }
}

/// The name of an entry point as Vulkan takes it.
pub(super) fn entry_name(name: &str) -> Result<CString, CheckError> {
    CString::new(name).map_err(|_| CheckError::Input(format!("the entry point {name:?} has a NUL byte in its name")))
}
