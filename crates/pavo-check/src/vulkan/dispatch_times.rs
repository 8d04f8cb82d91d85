//! How long dispatches take on a device.

use std::time::Instant;

use ash::vk;
use serde::Serialize;

use super::buffer::Buffer;
use super::compute::{ComputeShader, point_count};
use super::compute_pipeline::ComputePipeline;
use super::device::Device;
use super::driver::failure;
use super::owned::Owned;
use crate::CheckError;

/// What tells the time of a dispatch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Clock {
    /// The device's own timestamps, before and after the dispatch.
    Timestamps,
    /// The CPU's clock, from the submission until the wait for it ends; for devices without timestamps.
    WallClock,
}

/// A compute shader and the points that it evaluates, all in one dispatch.
#[derive(Clone, Copy)]
pub(crate) struct Dispatch<'call> {
    pub shader: ComputeShader<'call>,
    pub inputs: &'call [f32],
    pub inputs_per_point: usize,
    pub outputs_per_point: usize,
}

impl Device {
    /// The nanoseconds of each dispatch in each round: a list of rounds for every dispatch.
    ///
    /// All dispatches run in every round, by turns from the first to the last and from the last to the first, after one
    /// round that is not counted, as some drivers compile then. Dispatches with one slice of inputs share its buffer.
    pub(crate) fn dispatch_times(
        &self,
        dispatches: &[Dispatch<'_>],
        rounds: usize,
    ) -> Result<(Clock, Vec<Vec<f64>>), CheckError> {
        let mut points = Vec::new();
        for dispatch in dispatches {
            points.push(self.check_dispatch(dispatch)?);
        }
        let storage = vk::BufferUsageFlags::STORAGE_BUFFER;
        let mut inputs: Vec<(&[f32], Buffer<'_>)> = Vec::new();
        for dispatch in dispatches {
            if !inputs.iter().any(|(slice, _)| std::ptr::eq(*slice, dispatch.inputs)) {
                let mut buffer = Buffer::new(self, dispatch.inputs.len(), storage)?;
                buffer.write(dispatch.inputs);
                inputs.push((dispatch.inputs, buffer));
            }
        }
        let output_lengths: Vec<usize> =
            dispatches.iter().zip(&points).map(|(dispatch, points)| points * dispatch.outputs_per_point).collect();
        let outputs = Buffer::new(self, output_lengths.iter().copied().max().unwrap_or(1), storage)?;
        let mut pipelines = Vec::new();
        for ((dispatch, &points), &output_length) in dispatches.iter().zip(&points).zip(&output_lengths) {
            let pipeline = ComputePipeline::new(self, &dispatch.shader)?;
            for (slice, buffer) in &inputs {
                if std::ptr::eq(*slice, dispatch.inputs) {
                    pipeline.bind(buffer, dispatch.inputs.len(), &outputs, output_length);
                }
            }
            let groups = points.div_ceil(dispatch.shader.workgroup_size as usize);
            pipelines.push((pipeline, u32::try_from(groups).unwrap_or(u32::MAX)));
        }

        let stopwatch = Stopwatch::new(self)?;
        for (pipeline, groups) in &pipelines {
            stopwatch.time(pipeline, *groups)?;
        }
        let mut times = vec![Vec::new(); dispatches.len()];
        for round in 0..rounds {
            for turn in 0..pipelines.len() {
                let index = if round % 2 == 0 { turn } else { pipelines.len() - 1 - turn };
                let (pipeline, groups) = &pipelines[index];
                times[index].push(stopwatch.time(pipeline, *groups)?);
            }
        }
        Ok((stopwatch.clock(), times))
    }

    /// Compares a dispatch with its shader and with the device, and returns the number of its points.
    fn check_dispatch(&self, dispatch: &Dispatch<'_>) -> Result<usize, CheckError> {
        self.check_shader(&dispatch.shader)?;
        let (per_point, outputs) = (dispatch.inputs_per_point, dispatch.outputs_per_point);
        let points = point_count(dispatch.inputs.len(), per_point, outputs)?;
        if per_point == 0 || points == 0 {
            return Err(CheckError::Input("a kernel without inputs has no points to be timed at".to_owned()));
        }
        let allowed = self.points_per_run(&dispatch.shader, per_point.max(outputs))?;
        if points > allowed {
            let what = "the number of points of one dispatch".to_owned();
            return Err(CheckError::Limit { what, asked: points as u64, allowed: allowed as u64 });
        }
        Ok(points)
    }
}

/// Times single dispatches.
struct Stopwatch<'device> {
    device: &'device Device,
    /// Two timestamps; nothing where the device has none.
    queries: Option<Owned<'device, vk::QueryPool>>,
}

impl<'device> Stopwatch<'device> {
    fn new(device: &'device Device) -> Result<Self, CheckError> {
        if device.timestamp_bits == 0 {
            return Ok(Stopwatch { device, queries: None });
        }
        let information = vk::QueryPoolCreateInfo::default().query_type(vk::QueryType::TIMESTAMP).query_count(2);
        // SAFETY: the device is alive and the structure is complete.
        let pool = unsafe {
            let pool = device
                .device
                .create_query_pool(&information, None)
                .map_err(|result| failure("create a query pool", result))?;
            Owned::new(&device.device, pool, |device, pool| device.destroy_query_pool(pool, None))
        };
        Ok(Stopwatch { device, queries: Some(pool) })
    }

    fn clock(&self) -> Clock {
        if self.queries.is_some() { Clock::Timestamps } else { Clock::WallClock }
    }

    /// Runs that many workgroups and returns how many nanoseconds they take.
    fn time(&self, pipeline: &ComputePipeline<'_>, group_count: u32) -> Result<f64, CheckError> {
        let device = &self.device.device;
        let start = Instant::now();
        self.device.run(|commands| {
            // SAFETY: the commands are being recorded, and all objects belong to this device.
            unsafe {
                if let Some(queries) = &self.queries {
                    device.cmd_reset_query_pool(commands, queries.handle, 0, 2);
                    device.cmd_write_timestamp(commands, vk::PipelineStageFlags::TOP_OF_PIPE, queries.handle, 0);
                }
                pipeline.record(commands, group_count);
                if let Some(queries) = &self.queries {
                    device.cmd_write_timestamp(commands, vk::PipelineStageFlags::BOTTOM_OF_PIPE, queries.handle, 1);
                }
            }
        })?;
        let Some(queries) = &self.queries else { return Ok(start.elapsed().as_secs_f64() * 1.0e9) };
        let mut ticks = [0_u64; 2];
        let flags = vk::QueryResultFlags::TYPE_64 | vk::QueryResultFlags::WAIT;
        // SAFETY: both queries were written by commands that have ended.
        unsafe { device.get_query_pool_results(queries.handle, 0, &mut ticks, flags) }
            .map_err(|result| failure("read the timestamps", result))?;
        let valid = u64::MAX >> (64 - self.device.timestamp_bits.min(64));
        let elapsed = ticks[1].wrapping_sub(ticks[0]) & valid;
        Ok(elapsed as f64 * f64::from(self.device.limits.timestamp_period))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judge::wgsl_to_spirv;

    #[test]
    fn a_device_without_timestamps_is_timed_by_the_clock_of_the_cpu() {
        let text = "@group(0) @binding(0) var<storage, read> inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;
@compute @workgroup_size(8) fn run(@builtin(global_invocation_id) id: vec3u) { outputs[id.x] = inputs[id.x]; }";
        let spirv = wgsl_to_spirv("run.wgsl", text).unwrap();
        let shader = ComputeShader { spirv: &spirv, entry: "run", workgroup_size: 8, tables: &[] };
        let inputs = [1.0; 64];
        let dispatch = Dispatch { shader, inputs: &inputs, inputs_per_point: 1, outputs_per_point: 1 };
        let mut device = Device::lavapipe().unwrap_or_else(|error| panic!("{error}"));
        for (bits, expected) in [(device.timestamp_bits, Clock::Timestamps), (0, Clock::WallClock)] {
            device.timestamp_bits = bits;
            let (clock, times) = device.dispatch_times(&[dispatch, dispatch], 3).unwrap();
            assert_eq!(clock, expected);
            assert!(times.iter().all(|times| times.len() == 3 && times.iter().all(|&time| time > 0.0)), "{times:?}");
        }
    }
}
