//! All figures of a scene's report: what is written as `report.json`.

use crate::cli::manifest::{InputRow, Rates};
use crate::scene::Scene;
use crate::tuning::{Pick, VariantErrors, WorstPoint};
use pavo_check::doctor::Finding;
use pavo_check::timing::Spread;
use pavo_check::{DeviceDescription, Verdict};
use pavo_shade::{LeftOut, Operations};
use serde::Serialize;

/// The figures of a scene.
#[derive(Serialize)]
pub struct Figures<'a> {
    /// The version of pavo.
    pub pavo: &'static str,
    /// The file of the scene, as it was named.
    pub scene_file: String,
    /// The scene with all defaults filled in.
    pub scene: &'a Scene,
    /// The run-time inputs of the reflectance, with the ranges over which the errors are measured.
    pub inputs: Vec<InputRow>,
    /// The largest dE2000 that is allowed.
    pub max_delta_e: f64,
    /// The variant that was picked: the cheapest by operations that keeps to the budget.
    pub picked: Option<Pick>,
    /// Why none was picked.
    pub not_picked: Option<String>,
    /// The variant that the rest is about: the one that was picked, or else the one that comes closest.
    pub shown: Pick,
    /// How many points the verification had.
    pub verified_points: usize,
    /// The variants that can be made, the cheapest by operations first.
    pub variants: Vec<VariantFigures>,
    /// The variants that cannot be made, with the reason.
    pub refused: Vec<Refused>,
    /// Costs that were not measured, with the reason.
    pub not_measured: Vec<NotMeasured>,
    /// How times were measured.
    pub timed: Option<Timed>,
    /// The pictures of the sphere.
    pub sphere: SphereFigures,
    /// The names of the numbers of each of the worst points.
    pub worst_columns: Vec<String>,
    /// The points where the shown variant is furthest off, the worst first.
    pub worst_points: Vec<WorstPoint>,
    /// What was found of the numerical stability of the emitted code.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub stability: Vec<StabilityFinding>,
    /// Operations of one evaluation of the reflectance by the shown variant.
    pub operations: Operations,
    /// The emitted code of the shown variant.
    pub code: Vec<CodeFigures>,
    /// The guards that it does without.
    pub left_out: Vec<LeftOut>,
    /// What can be computed once a material.
    pub rates: Rates,
    /// What should be said of the scene's data.
    pub warnings: Vec<String>,
    /// The judges and drivers, without the places where they lie.
    pub tools: Vec<Finding>,
    /// The commands that give the same.
    pub commands: Vec<Command>,
}

/// A variant.
#[derive(Serialize)]
pub struct VariantFigures {
    /// The variant.
    pub variant: String,
    /// Whether it is the shown one.
    pub is_shown: bool,
    /// Its errors against the exact reference.
    #[serde(flatten)]
    pub errors: VariantErrors,
    /// Its cost in operations.
    pub ops: Cost,
    /// Its cost by RADV's compiler for navi21, cycles of inverse throughput.
    pub navi21: Option<Cost>,
    /// Its time on lavapipe, ns, net of reading and writing.
    pub lavapipe: Option<Time>,
}

/// A cost.
#[derive(Clone, Copy, Serialize)]
pub struct Cost {
    /// The cost.
    pub cost: f64,
    /// Whether no other variant is both cheaper and closer.
    pub on_frontier: bool,
}

/// A measured time.
#[derive(Clone, Copy, Serialize)]
pub struct Time {
    /// Nanoseconds for an evaluation.
    pub ns: Spread,
    /// The time as a multiple of the baseline's.
    pub ratio: Spread,
    /// Whether no other variant that was timed is both faster and closer.
    pub on_frontier: bool,
}

/// A variant that cannot be made.
#[derive(Serialize)]
pub struct Refused {
    /// The variant.
    pub variant: String,
    /// Why not.
    pub reason: String,
}

/// A cost that was not measured.
#[derive(Serialize)]
pub struct NotMeasured {
    /// The cost.
    pub cost: &'static str,
    /// Why not.
    pub reason: String,
}

/// How times were measured.
#[derive(Serialize)]
pub struct Timed {
    /// The device.
    pub device: DeviceDescription,
    /// The variant that the others are compared with.
    pub baseline: String,
    /// The points that each variant evaluated in each round.
    pub points: usize,
    /// The rounds, in each of which all variants ran by turns.
    pub rounds: usize,
}

/// The pictures of the sphere.
#[derive(Clone, Serialize)]
pub struct SphereFigures {
    /// The width and height of the pictures in pixels.
    pub size: u32,
    /// The device that ran the emitted shader; nothing where the variant was evaluated on the CPU.
    pub device: Option<DeviceDescription>,
    /// Why the shader was not run.
    pub not_run: Option<String>,
    /// The largest difference between the shader's picture and the variant on the CPU, in levels of 255.
    pub shader_against_cpu: Option<f64>,
    /// The mean of dE2000 between the two pictures, over the sphere.
    pub mean_delta_e: f64,
    /// The largest.
    pub max_delta_e: f64,
    /// Where the colours of the map of differences end.
    pub scale_delta_e: f64,
}

/// Something found of the numerical stability of the emitted code.
#[derive(Serialize)]
pub struct StabilityFinding {
    /// What was checked.
    pub place: String,
    /// What was found.
    pub message: String,
}

/// An emitted text.
#[derive(Serialize)]
pub struct CodeFigures {
    /// The target.
    pub target: &'static str,
    /// The text.
    pub text: String,
    /// What the judges said.
    pub verdicts: Vec<Verdict>,
}

/// A command with what it is good for.
#[derive(Serialize)]
pub struct Command {
    /// What it gives.
    pub gives: &'static str,
    /// The command.
    pub command: String,
}
