//! What is checked, and what was found.

use serde::{Deserialize, Serialize};
use std::fmt;

/// The name of the sweep among the cases.
pub const SWEEP: &str = "sweep";

/// What must hold. Each check has a figure that is 0 where it holds in full.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Check {
    /// How many numbers are NaN or infinite.
    Finite,
    /// How far a reflectance leaves [0, 1] in CIE XYZ over that of white.
    Range,
    /// How far the reflectance leaves [0, 1] at a single wavelength, where the method evaluates such.
    Wavelength,
    /// The largest difference of `f32` on any evaluator from `f64` on the CPU, for the same inputs.
    Single,
    /// What that difference exceeds at one point of a hundred.
    SingleP99,
    /// The largest difference of `f64` from the exact spectral reference, for cosines from 0.01 and films up to 3000 nm.
    Reference,
    /// How far apart the channels are where nothing colours.
    Neutral,
    /// How far the colour jumps between neighbouring numbers of `f32`, beyond three times what the derivative allows.
    Continuity,
    /// How far a white furnace returns more than it sends, in CIE XYZ over that of white.
    Energy,
    /// The difference of the BRDF with light and view exchanged, relative to the larger of it and 1.
    Reciprocity,
    /// How many ordinary points change their colour where every other point is no number.
    Contained,
}

impl Check {
    /// All checks, in the order of reports.
    pub const ALL: [Check; 11] = [
        Check::Finite,
        Check::Range,
        Check::Wavelength,
        Check::Single,
        Check::SingleP99,
        Check::Reference,
        Check::Neutral,
        Check::Continuity,
        Check::Energy,
        Check::Reciprocity,
        Check::Contained,
    ];

    /// The name in data and reports.
    pub fn name(self) -> &'static str {
        match self {
            Check::Finite => "finite",
            Check::Range => "range",
            Check::Wavelength => "wavelength",
            Check::Single => "single",
            Check::SingleP99 => "single-p99",
            Check::Reference => "reference",
            Check::Neutral => "neutral",
            Check::Continuity => "continuity",
            Check::Energy => "energy",
            Check::Reciprocity => "reciprocity",
            Check::Contained => "contained",
        }
    }

    /// What it checks, in words.
    pub fn described(self) -> &'static str {
        match self {
            Check::Finite => "numbers that are NaN or infinite",
            Check::Range => "how far the reflectance leaves 0 to 1, in XYZ over that of white",
            Check::Wavelength => "the same at single wavelengths",
            Check::Single => "single precision against double",
            Check::SingleP99 => "the same, exceeded by one point of a hundred",
            Check::Reference => "double precision against the exact reference",
            Check::Neutral => "colour where nothing colours",
            Check::Continuity => "jumps between neighbouring inputs",
            Check::Energy => "what a white furnace returns over what it sends",
            Check::Reciprocity => "light and view exchanged",
            Check::Contained => "ordinary points beside those that are no numbers",
        }
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The largest figure of a check over one case, on one surface by one variant.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    /// The surface.
    pub surface: String,
    /// The variant.
    pub variant: String,
    /// The case, or [`SWEEP`].
    pub case: String,
    /// What was checked.
    pub check: Check,
    /// The evaluator with the largest figure: a road, or the CPU in `f32` or `f64`.
    pub evaluator: String,
    /// The quantity that was evaluated, as `pavo eval` names it.
    pub quantity: &'static str,
    /// How many points were checked on each evaluator.
    pub points: usize,
    /// The figure.
    pub value: f64,
    /// The point with the largest figure, a number for each component of each input; empty where it is over all points.
    pub worst: Vec<f32>,
}
