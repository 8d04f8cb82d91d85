//! How long compute kernels take on a device, compared with each other.
//!
//! All kernels run by turns in each of several rounds, so that what slows the machine down slows down all of them, and
//! ratios are taken within a round. What it costs to read the inputs and write the outputs is measured in the same
//! rounds, by a kernel that does only that, and subtracted. Times are those of whole dispatches: take so many points
//! that one takes some milliseconds, such as a million on lavapipe, and ten rounds or more.
//!
//! Time on a device that has rendered no picture: once lavapipe has, it writes both timestamps of a dispatch at its end,
//! and all times are next to nothing.
//!
//! On lavapipe the environment variable `LP_NUM_THREADS=1`, set before the process starts, steadies the times at the
//! price of making them longer. Nothing here sets it.

mod copy_kernel;
mod spread;

use serde::Serialize;

pub use crate::vulkan::Clock;
pub use spread::Spread;

use crate::vulkan::Dispatch;
use crate::{CheckError, ComputeShader, Device, DeviceDescription};
use copy_kernel::copy_kernel;

/// A kernel to be timed.
#[derive(Clone, Copy, Debug)]
pub struct Candidate<'call> {
    /// The name in the report, different from the others.
    pub name: &'call str,
    /// The kernel.
    pub shader: ComputeShader<'call>,
    /// The inputs of its points, those of a point one after the other. Candidates that are given the same slice share
    /// one buffer on the device.
    pub inputs: &'call [f32],
    /// How many inputs a point has, at least one.
    pub inputs_per_point: usize,
    /// How many outputs a point has, at least one.
    pub outputs_per_point: usize,
}

/// What was measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timings {
    /// The device.
    pub device: DeviceDescription,
    /// What told the time.
    pub clock: Clock,
    /// The number of points that each kernel evaluated in each round.
    pub points: usize,
    /// The number of rounds.
    pub rounds: usize,
    /// The name of the candidate that the others are compared with.
    pub reference: String,
    /// The candidates, in the order in which they were given.
    pub timings: Vec<Timing>,
}

/// What was measured of one candidate, over the rounds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// The candidate.
    pub name: String,
    /// Nanoseconds for one evaluation, reading and writing included.
    pub gross: Spread,
    /// Nanoseconds for the reading and writing of one evaluation alone, by a kernel that does nothing else.
    pub copy: Spread,
    /// Nanoseconds for one evaluation, less those of a kernel that only reads and writes, in the same round. Noise can
    /// make it negative for a kernel that does next to nothing.
    pub net: Spread,
    /// The net time as a multiple of the reference's in the same round; 1 for the reference itself.
    pub ratio: Spread,
}

/// Times candidates at the same number of points each, and compares them with the one that is called `reference`.
///
/// The modules must be valid ([`judge_spirv`](crate::judge_spirv)); a driver may do anything with one that is not.
///
/// # Errors
/// [`CheckError::Input`] when a candidate does not fit its inputs as in [`Device::evaluate`], when two have one name or
/// other numbers of points, when none is the reference, when there is no round, or when the reference takes no longer
/// than reading and writing; [`CheckError::Limit`] when the points do not fit one dispatch; [`CheckError::Vulkan`] when
/// the driver fails.
pub fn compare(
    device: &Device,
    candidates: &[Candidate<'_>],
    reference: &str,
    rounds: usize,
) -> Result<Timings, CheckError> {
    let (reference_index, points) = check(candidates, reference, rounds)?;
    let copies = Copies::new(candidates)?;
    let mut dispatches: Vec<Dispatch<'_>> = candidates.iter().map(|candidate| dispatch(candidate, None)).collect();
    dispatches.extend(copies.kernels.iter().map(|(of, words)| dispatch(&candidates[*of], Some(words))));
    let (clock, times) = device.dispatch_times(&dispatches, rounds)?;

    let per_point = |times: &[f64]| -> Vec<f64> { times.iter().map(|time| time / points as f64).collect() };
    let gross: Vec<Vec<f64>> = times.iter().map(|times| per_point(times)).collect();
    let net: Vec<Vec<f64>> = (0..candidates.len())
        .map(|index| pairwise(&gross[index], &gross[candidates.len() + copies.of[index]], |own, copy| own - copy))
        .collect();
    let reference_net = &net[reference_index];
    if Spread::of(reference_net.clone()).median <= 0.0 {
        return Err(CheckError::Input(format!(
            "`{reference}` takes no longer than reading its inputs and writing its outputs, so that nothing can be \
             compared with it: take more points than {points}, or a kernel that does more"
        )));
    }
    let timing = |(index, candidate): (usize, &Candidate<'_>)| {
        // Where noise makes the reference's time nothing or less, a ratio says nothing; that is less than half of them.
        let mut ratios = pairwise(&net[index], reference_net, |own, reference| own / reference);
        let mut references = reference_net.iter();
        ratios.retain(|_| references.next().is_some_and(|&reference| reference > 0.0));
        Timing {
            name: candidate.name.to_owned(),
            gross: Spread::of(gross[index].clone()),
            copy: Spread::of(gross[candidates.len() + copies.of[index]].clone()),
            net: Spread::of(net[index].clone()),
            ratio: Spread::of(ratios),
        }
    };
    let timings = candidates.iter().enumerate().map(timing).collect();
    let device = device.description().clone();
    Ok(Timings { device, clock, points, rounds, reference: reference.to_owned(), timings })
}

/// The index of the reference and the number of points.
fn check(candidates: &[Candidate<'_>], reference: &str, rounds: usize) -> Result<(usize, usize), CheckError> {
    let refused = |message: String| Err(CheckError::Input(message));
    if rounds == 0 {
        return refused("no rounds are asked: at least one is needed, and ten are good".to_owned());
    }
    let names: Vec<&str> = candidates.iter().map(|candidate| candidate.name).collect();
    let Some(reference_index) = names.iter().position(|name| *name == reference) else {
        return refused(format!("no candidate is called `{reference}`: there are {}", names.join(", ")));
    };
    if let Some((index, name)) = names.iter().enumerate().find(|&(index, name)| names[..index].contains(name)) {
        return refused(format!("candidate {} is called `{name}` as another one is", index + 1));
    }
    let points = |candidate: &Candidate<'_>| candidate.inputs.len() / candidate.inputs_per_point.max(1);
    let expected = points(&candidates[reference_index]);
    if let Some(other) = candidates.iter().find(|candidate| points(candidate) != expected) {
        return refused(format!(
            "`{}` has {} points and `{reference}` has {expected}: give each the same number",
            other.name,
            points(other)
        ));
    }
    Ok((reference_index, expected))
}

fn dispatch<'call>(candidate: &Candidate<'call>, copy: Option<&'call [u32]>) -> Dispatch<'call> {
    let shader = match copy {
        None => candidate.shader,
        Some(spirv) => ComputeShader { spirv, entry: copy_kernel::ENTRY, ..candidate.shader },
    };
    let Candidate { inputs, inputs_per_point, outputs_per_point, .. } = *candidate;
    Dispatch { shader, inputs, inputs_per_point, outputs_per_point }
}

/// The kernels that only read and write: one for each shape of a candidate.
struct Copies {
    /// The index of a candidate that has the shape, and the kernel.
    kernels: Vec<(usize, Vec<u32>)>,
    /// For each candidate, the index of its kernel.
    of: Vec<usize>,
}

impl Copies {
    fn new(candidates: &[Candidate<'_>]) -> Result<Copies, CheckError> {
        let shape = |candidate: &Candidate<'_>| {
            (candidate.shader.workgroup_size, candidate.inputs_per_point, candidate.outputs_per_point)
        };
        let mut copies = Copies { kernels: Vec::new(), of: Vec::new() };
        for (index, candidate) in candidates.iter().enumerate() {
            let known = copies.kernels.iter().position(|&(other, _)| shape(&candidates[other]) == shape(candidate));
            copies.of.push(known.unwrap_or(copies.kernels.len()));
            if known.is_none() {
                let (workgroup_size, inputs, outputs) = shape(candidate);
                copies.kernels.push((index, copy_kernel(workgroup_size, inputs, outputs)?));
            }
        }
        Ok(copies)
    }
}

fn pairwise(left: &[f64], right: &[f64], with: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    left.iter().zip(right).map(|(&left, &right)| with(left, right)).collect()
}
