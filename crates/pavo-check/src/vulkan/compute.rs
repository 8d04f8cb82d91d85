//! Evaluates a compute shader over a list of points.

use std::ffi::CString;

use ash::vk;

use super::buffer::Buffer;
use super::device::Device;
use super::driver::failure;
use super::module_interface::{COMPUTE, ModuleInterface};
use super::owned::Owned;
use crate::CheckError;

/// A compute shader that evaluates one point in each invocation.
///
/// It reads a storage buffer of floats at set 0, binding 0, and writes one at set 0, binding 1:
///
/// ```wgsl
/// @group(0) @binding(0) var<storage, read> inputs: array<f32>;
/// @group(0) @binding(1) var<storage, read_write> outputs: array<f32>;
/// ```
///
/// ```glsl
/// layout(std430, set = 0, binding = 0) readonly buffer Inputs { float inputs[]; };
/// layout(std430, set = 0, binding = 1) buffer Outputs { float outputs[]; };
/// ```
///
/// Point `i` is that of `global_invocation_id.x == i`; it has its values one after the other in both buffers. The last
/// workgroup may reach beyond the last point, so the shader compares `i` with the number of points, which is
/// `arrayLength(&inputs)` over the inputs of a point.
#[derive(Clone, Copy, Debug)]
pub struct ComputeShader<'module> {
    /// A valid SPIR-V module for Vulkan 1.1.
    pub spirv: &'module [u32],
    /// The name of the entry point: naga keeps that of the text, glslang writes `main`.
    pub entry: &'module str,
    /// The workgroup size along x, as the module declares it; along y and z it is 1.
    pub workgroup_size: u32,
}

/// The descriptor set and bindings of the inputs and the outputs.
const RESOURCES: [(u32, u32); 2] = [(0, 0), (0, 1)];

/// The bits of a float that is no number, with which the outputs are filled beforehand.
const NOT_A_NUMBER: u32 = 0x7fc0_0000;

impl Device {
    /// Evaluates a compute shader at every point and returns the outputs, those of a point one after the other.
    ///
    /// `inputs` holds `inputs_per_point` values for each point. With `inputs_per_point == 0` there is nothing to tell
    /// points apart: `inputs` is empty, one point is evaluated, and a single 0 is bound as its input, as Vulkan has no
    /// empty buffers. Any number of points is allowed: they are run in pieces, each of which sees only its own points,
    /// when the device's limits ask for it. An output that the shader does not write is NaN.
    ///
    /// The module must be valid ([`judge_spirv`](crate::judge_spirv)); a driver may do anything with one that is not.
    ///
    /// # Errors
    /// [`CheckError::Input`] when the module has no such entry point, another workgroup size or other resources, or
    /// when `inputs` is not made of whole points; [`CheckError::Limit`] when one workgroup is beyond the device's
    /// limits; [`CheckError::Vulkan`] when the driver fails.
    pub fn evaluate(
        &self,
        shader: &ComputeShader<'_>,
        inputs: &[f32],
        inputs_per_point: usize,
        outputs_per_point: usize,
    ) -> Result<Vec<f32>, CheckError> {
        self.check_shader(shader)?;
        let points = point_count(inputs.len(), inputs_per_point, outputs_per_point)?;
        let output_count = points.checked_mul(outputs_per_point).ok_or_else(|| {
            CheckError::Input(format!("{points} points of {outputs_per_point} outputs are more than memory can hold"))
        })?;
        if points == 0 {
            return Ok(Vec::new());
        }
        let points_per_run = self.points_per_run(shader, inputs_per_point.max(outputs_per_point))?.min(points);

        let pipeline = Pipeline::new(self, shader)?;
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER;
        let mut input_buffer = Buffer::new(self, (points_per_run * inputs_per_point).max(1), storage)?;
        let filled = storage | vk::BufferUsageFlags::TRANSFER_DST;
        let output_buffer = Buffer::new(self, points_per_run * outputs_per_point, filled)?;
        let mut outputs = Vec::new();
        outputs.try_reserve_exact(output_count).map_err(|error| CheckError::Input(error.to_string()))?;
        let mut first = 0;
        while first < points {
            let count = points_per_run.min(points - first);
            let piece = &inputs[first * inputs_per_point..(first + count) * inputs_per_point];
            input_buffer.write(if piece.is_empty() { &[0.0] } else { piece });
            let input_length = piece.len().max(1);
            let output_length = count * outputs_per_point;
            pipeline.bind(&input_buffer, input_length, &output_buffer, output_length);
            pipeline.run(&output_buffer, count.div_ceil(shader.workgroup_size as usize))?;
            outputs.extend_from_slice(output_buffer.read(output_length));
            first += count;
        }
        Ok(outputs)
    }

    /// Compares what the module declares with the call and with the device.
    fn check_shader(&self, shader: &ComputeShader<'_>) -> Result<(), CheckError> {
        let interface = ModuleInterface::read(shader.spirv)?;
        let entry = interface.entry_point(shader.entry, COMPUTE)?;
        interface.check_resources(&RESOURCES)?;
        let expected = [shader.workgroup_size, 1, 1];
        match entry.local_size {
            Some(size) if size == expected && shader.workgroup_size > 0 => {}
            Some(size) => {
                return Err(CheckError::Input(format!(
                    "the entry point `{}` has the workgroup size {size:?}, expected {expected:?}",
                    shader.entry
                )));
            }
            None => {
                return Err(CheckError::Input(format!(
                    "the entry point `{}` has no fixed workgroup size",
                    shader.entry
                )));
            }
        }
        let allowed = self.limits.max_compute_work_group_size[0].min(self.limits.max_compute_work_group_invocations);
        if shader.workgroup_size > allowed {
            let (what, asked) = ("the workgroup size".to_owned(), u64::from(shader.workgroup_size));
            return Err(CheckError::Limit { what, asked, allowed: u64::from(allowed) });
        }
        Ok(())
    }

    /// The most points that one dispatch and one pair of buffers can hold, in whole workgroups.
    fn points_per_run(&self, shader: &ComputeShader<'_>, floats_per_point: usize) -> Result<usize, CheckError> {
        let group = u64::from(shader.workgroup_size);
        let by_groups = u64::from(self.limits.max_compute_work_group_count[0]).saturating_mul(group);
        let mut bytes = u64::from(self.limits.max_storage_buffer_range);
        if self.max_allocation > 0 {
            bytes = bytes.min(self.max_allocation);
        }
        let bytes_per_point = (floats_per_point as u64).saturating_mul(4);
        let points = by_groups.min(bytes / bytes_per_point) / group * group;
        if points == 0 {
            let what = "the size in bytes of the inputs or outputs of one workgroup".to_owned();
            return Err(CheckError::Limit { what, asked: bytes_per_point.saturating_mul(group), allowed: bytes });
        }
        Ok(usize::try_from(points).unwrap_or(usize::MAX))
    }
}

/// The number of points in `length` inputs.
fn point_count(length: usize, inputs_per_point: usize, outputs_per_point: usize) -> Result<usize, CheckError> {
    if outputs_per_point == 0 {
        return Err(CheckError::Input("a point needs at least one output".to_owned()));
    }
    match (length, inputs_per_point) {
        (0, 0) => Ok(1),
        (_, 0) => Err(CheckError::Input(format!("{length} inputs where a point has none"))),
        _ if !length.is_multiple_of(inputs_per_point) => {
            Err(CheckError::Input(format!("{length} inputs are not whole points of {inputs_per_point} inputs each")))
        }
        _ => Ok(length / inputs_per_point),
    }
}

/// A compute pipeline with one descriptor set for the two buffers.
struct Pipeline<'device> {
    device: &'device Device,
    set: vk::DescriptorSet,
    // In the order in which they are to be destroyed.
    pipeline: Owned<'device, vk::Pipeline>,
    layout: Owned<'device, vk::PipelineLayout>,
    _pool: Owned<'device, vk::DescriptorPool>,
    _set_layout: Owned<'device, vk::DescriptorSetLayout>,
}

impl<'device> Pipeline<'device> {
    fn new(device: &'device Device, shader: &ComputeShader<'_>) -> Result<Self, CheckError> {
        let entry = entry_name(shader.entry)?;
        let handle = &device.device;
        let module = device.shader_module(shader.spirv)?;
        let bindings = RESOURCES.map(|(_, binding)| {
            vk::DescriptorSetLayoutBinding::default()
                .binding(binding)
                .descriptor_type(vk::DescriptorType::STORAGE_BUFFER)
                .descriptor_count(1)
                .stage_flags(vk::ShaderStageFlags::COMPUTE)
        });
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

            let sizes = [vk::DescriptorPoolSize::default()
                .ty(vk::DescriptorType::STORAGE_BUFFER)
                .descriptor_count(RESOURCES.len() as u32)];
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
            Ok(Pipeline { device, set: sets[0], pipeline, layout, _pool: pool, _set_layout: set_layout })
        }
    }

    /// Binds the first floats of the two buffers.
    fn bind(&self, inputs: &Buffer<'_>, input_length: usize, outputs: &Buffer<'_>, output_length: usize) {
        let range = |buffer: &Buffer<'_>, length: usize| {
            [vk::DescriptorBufferInfo::default().buffer(buffer.handle()).offset(0).range(length as u64 * 4)]
        };
        let ranges = [range(inputs, input_length), range(outputs, output_length)];
        let writes = [0, 1].map(|index: usize| {
            vk::WriteDescriptorSet::default()
                .dst_set(self.set)
                .dst_binding(RESOURCES[index].1)
                .descriptor_type(vk::DescriptorType::STORAGE_BUFFER)
                .buffer_info(&ranges[index])
        });
        // SAFETY: set and buffers belong to this device, and no commands are pending.
        unsafe { self.device.device.update_descriptor_sets(&writes, &[]) }
    }

    /// Fills the outputs with NaN, runs that many workgroups, and makes the outputs visible to the CPU.
    fn run(&self, outputs: &Buffer<'_>, group_count: usize) -> Result<(), CheckError> {
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
            // SAFETY: the commands are being recorded, and all objects belong to this device and are bound as the
            // layout says.
            unsafe {
                device.cmd_fill_buffer(commands, outputs.handle(), 0, vk::WHOLE_SIZE, NOT_A_NUMBER);
                device.cmd_pipeline_barrier(commands, transfer, compute, none, &filled, &[], &[]);
                device.cmd_bind_pipeline(commands, vk::PipelineBindPoint::COMPUTE, self.pipeline.handle);
                device.cmd_bind_descriptor_sets(
                    commands,
                    vk::PipelineBindPoint::COMPUTE,
                    self.layout.handle,
                    0,
                    &[self.set],
                    &[],
                );
                device.cmd_dispatch(commands, group_count, 1, 1);
                device.cmd_pipeline_barrier(commands, compute, vk::PipelineStageFlags::HOST, none, &written, &[], &[]);
            }
        })
    }
}

/// The name of an entry point as Vulkan takes it.
pub(super) fn entry_name(name: &str) -> Result<CString, CheckError> {
    CString::new(name).map_err(|_| CheckError::Input(format!("the entry point {name:?} has a NUL byte in its name")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_are_whole_points() {
        for (length, inputs, outputs, expected) in [
            (6, 3, 1, Some(2)),
            (0, 3, 1, Some(0)),
            (0, 0, 2, Some(1)),
            (7, 3, 1, None),
            (1, 0, 1, None),
            (6, 3, 0, None),
        ] {
            assert_eq!(point_count(length, inputs, outputs).ok(), expected, "{length} {inputs} {outputs}");
        }
    }
}
