//! Evaluates a compute shader over a list of points.

use ash::vk;

use super::buffer::Buffer;
use super::compute_pipeline::{ComputePipeline, RESOURCES};
use super::device::Device;
use super::module_interface::{COMPUTE, ModuleInterface};
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
    /// The contents of further storage buffers at set 0, bindings 2 and on; none is empty. A vector of three numbers
    /// takes four there.
    pub tables: &'module [Vec<f32>],
}

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

        let pipeline = ComputePipeline::new(self, shader)?;
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
    pub(super) fn check_shader(&self, shader: &ComputeShader<'_>) -> Result<(), CheckError> {
        let interface = ModuleInterface::read(shader.spirv)?;
        self.check_precision(&interface)?;
        let entry = interface.entry_point(shader.entry, COMPUTE)?;
        let tables = (RESOURCES.len() as u32..).take(shader.tables.len()).map(|binding| (0, binding));
        interface.check_resources(&RESOURCES.into_iter().chain(tables).collect::<Vec<_>>())?;
        if shader.tables.iter().any(Vec::is_empty) {
            return Err(CheckError::Input("a table has no numbers".to_owned()));
        }
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
    pub(super) fn points_per_run(
        &self,
        shader: &ComputeShader<'_>,
        floats_per_point: usize,
    ) -> Result<usize, CheckError> {
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
pub(super) fn point_count(
    length: usize,
    inputs_per_point: usize,
    outputs_per_point: usize,
) -> Result<usize, CheckError> {
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
