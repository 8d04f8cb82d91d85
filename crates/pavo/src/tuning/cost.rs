//! The cost of an evaluation of the reflectance: operations, what the compiler of a graphics card counts, or time.

use super::TuningError;
use crate::entries::{cost, cost_baseline};
use crate::inputs::ShadingQuantity;
use crate::points::spread;
use crate::roads::{Road, table_numbers};
use crate::shading::Shading;
use pavo_check::static_cost::StaticCost;
use pavo_check::static_cost::{FAMILIES, StaticCompiler, net};
use pavo_check::timing::{Candidate, Timings, compare};
use pavo_check::{ComputeShader, Device};
use pavo_emit::{Language, WORKGROUP_SIZE};
use pavo_shade::{Input, Operations};
use rayon::prelude::*;

const QUANTITY: ShadingQuantity = ShadingQuantity::Reflectance;

/// What a root, a quotient, a sine and the like count, and a row of a table, where a sum or a product counts 1.
const TRANSCENDENTAL: f64 = 4.0;
const FETCH: f64 = 16.0;

/// Points and rounds of a measurement of time.
const TIMED_POINTS: usize = 500_000;
const ROUNDS: usize = 7;

/// What the cost counts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CostKind {
    /// Operations of the emitted program; roots, quotients, sines and the like count 4, rows of tables 16.
    Operations,
    /// Cycles of inverse throughput on a family of graphics cards, by RADV's compiler, net of an empty shader.
    Family(&'static str),
    /// Nanoseconds on a Vulkan device, net of reading and writing.
    Device(String),
}

impl CostKind {
    /// The kind of this name: `ops`, a family such as `navi21`, or `lavapipe`.
    ///
    /// # Errors
    /// The names that there are.
    pub fn from_name(name: &str) -> Result<Self, String> {
        let family = FAMILIES.iter().find(|family| family.name == name);
        match (name, family) {
            ("ops", _) => Ok(CostKind::Operations),
            ("lavapipe", _) => Ok(CostKind::Device("llvmpipe".to_owned())),
            (_, Some(family)) => Ok(CostKind::Family(family.name)),
            (_, None) => {
                let families: Vec<&str> = FAMILIES.iter().map(|family| family.name).collect();
                Err(format!(
                    "unknown cost `{}`; the costs are ops, {}, lavapipe",
                    name.escape_debug(),
                    families.join(", ")
                ))
            }
        }
    }

    /// The name in reports.
    pub fn name(&self) -> &str {
        match self {
            CostKind::Operations => "ops",
            CostKind::Family(family) => family,
            CostKind::Device(device) => device,
        }
    }

    /// The unit of the numbers.
    pub fn unit(&self) -> &'static str {
        match self {
            CostKind::Operations => "operations",
            CostKind::Family(_) => "cycles of inverse throughput",
            CostKind::Device(_) => "ns",
        }
    }

    /// Whether the same shader costs the same each time.
    pub fn is_repeatable(&self) -> bool {
        !matches!(self, CostKind::Device(_))
    }
}

/// Measures costs of one kind.
pub enum Meter {
    /// By counting operations.
    Operations,
    /// By RADV's compiler.
    Family(Box<StaticCompiler>),
    /// By running on a device.
    Device(Box<Device>),
}

impl Meter {
    /// Opens what the kind of cost needs.
    ///
    /// # Errors
    /// If the driver is missing.
    pub fn new(kind: &CostKind) -> Result<Self, TuningError> {
        Ok(match kind {
            CostKind::Operations => Meter::Operations,
            CostKind::Family(family) => Meter::Family(Box::new(StaticCompiler::open(family)?)),
            CostKind::Device(name) => Meter::Device(Box::new(Device::named(name)?)),
        })
    }

    /// The cost of the reflectance of each.
    ///
    /// # Errors
    /// If a shader cannot be emitted, compiled or run.
    pub fn costs(&self, shadings: &[&Shading]) -> Result<Vec<f64>, TuningError> {
        match self {
            Meter::Operations => {
                Ok(shadings.par_iter().map(|shading| operations(shading.program(QUANTITY).operations())).collect())
            }
            // The longest take most of the time: each core takes one after the other.
            Meter::Family(compiler) => shadings
                .par_iter()
                .with_max_len(1)
                .map(|shading| {
                    let compiled = |text: &str| compiler.wgsl("cost.wgsl", text, "main");
                    let whole: StaticCost = compiled(&cost(shading, QUANTITY, Language::Wgsl)?)?;
                    let baseline = compiled(&cost_baseline(shading, QUANTITY, Language::Wgsl)?)?;
                    Ok(net(&whole, &baseline)?.inverse_throughput as f64)
                })
                .collect(),
            Meter::Device(device) => {
                // The longest of all makes the steadiest reference; only the absolute times are taken.
                let operations = |shading: &&&Shading| operations(shading.program(QUANTITY).operations()) as u64;
                let Some(reference) = shadings.iter().max_by_key(operations) else { return Ok(Vec::new()) };
                let timings = time(device, shadings, &reference.variant().to_string())?;
                Ok(timings.timings.iter().map(|timing| timing.net.median).collect())
            }
        }
    }
}

/// Operations as one number.
fn operations(operations: Operations) -> f64 {
    let Operations { arithmetic, roots, transcendental, fetches } = operations;
    arithmetic as f64 + TRANSCENDENTAL * (roots + transcendental) as f64 + FETCH * fetches as f64
}

/// Times the reflectance of each on a device, all by turns, and compares them with the variant that is called
/// `reference`.
///
/// # Errors
/// If a shader cannot be emitted or run, or the reference is none of them or does next to nothing.
pub fn time(device: &Device, shadings: &[&Shading], reference: &str) -> Result<Timings, TuningError> {
    struct Kernel {
        name: String,
        words: Vec<u32>,
        tables: Vec<Vec<f32>>,
        /// The place of its points among those of all.
        points: usize,
        inputs_per_point: usize,
    }
    // Kernels with the same inputs share their points, and the buffer that they lie in.
    let mut points: Vec<(Vec<Input>, Vec<f32>)> = Vec::new();
    let mut kernels = Vec::new();
    for shading in shadings {
        let words = Road::Wgsl.spirv(shading, QUANTITY)?;
        let program = shading.program(QUANTITY);
        let known = points.iter().position(|(inputs, _)| inputs == program.inputs());
        let place = known.unwrap_or(points.len());
        if known.is_none() {
            let numbers = spread(program.inputs(), TIMED_POINTS, 3).into_iter().flatten();
            points.push((program.inputs().to_vec(), numbers.map(|number| number as f32).collect()));
        }
        kernels.push(Kernel {
            name: shading.variant().to_string(),
            words,
            tables: program.tables().iter().map(table_numbers).collect(),
            points: place,
            inputs_per_point: program.input_components(),
        });
    }
    let candidates: Vec<Candidate<'_>> = kernels
        .iter()
        .map(|kernel| Candidate {
            name: &kernel.name,
            shader: ComputeShader {
                spirv: &kernel.words,
                entry: "main",
                workgroup_size: WORKGROUP_SIZE,
                tables: &kernel.tables,
            },
            inputs: &points[kernel.points].1,
            inputs_per_point: kernel.inputs_per_point,
            outputs_per_point: 3,
        })
        .collect();
    Ok(compare(device, &candidates, reference, ROUNDS)?)
}
