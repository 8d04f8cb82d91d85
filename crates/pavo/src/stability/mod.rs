//! Where the variants break: each on the CPU and on lavapipe by all roads, over a catalogue of hard cases and over a sweep
//! of many points. The cases stand in `templates/stability/catalogue.toml`, what they may exceed in `exceptions.toml`
//! beside it.

mod catalogue;
mod checks;
mod contained;
mod draw;
mod examine;
mod exceptions;
mod finding;
mod furnace;
mod map;
mod part;
mod surfaces;
mod wavelengths;

pub use catalogue::{Case, Catalogue};
pub use exceptions::{Exceptions, Judged, Judgement, Stale};
pub use finding::{Check, Finding, SWEEP};
pub use map::ErrorMap;
pub use surfaces::{BuiltIn, Placed, built_in, by_variant};

use crate::media::MediaError;
use crate::roads::RoadError;
use crate::shading::ShadingError;
use examine::Examination;
use pavo_check::Device;
use rayon::prelude::*;
use thiserror::Error;

/// How thorough an examination is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// The points of the sweep of each variant on the device, shared by its surfaces.
    pub sweep_points: usize,
    /// How many of them are compared with `f64` on the CPU.
    pub compared_points: usize,
    /// How many are compared with the exact reference on each surface.
    pub reference_points: usize,
    /// Whether every surface is run by every road. Otherwise each variant runs by every road on one surface, and by
    /// WGSL on the others.
    pub all_roads: bool,
}

impl Effort {
    /// Ten million points a variant.
    pub const FULL: Effort =
        Effort { sweep_points: 10_000_000, compared_points: 400_000, reference_points: 1500, all_roads: true };
    /// The catalogue and a small sweep.
    pub const QUICK: Effort =
        Effort { sweep_points: 40_000, compared_points: 10_000, reference_points: 150, all_roads: false };
}

/// Why an examination cannot be made.
#[derive(Debug, Error)]
pub enum StabilityError {
    /// The surface cannot be made.
    #[error(transparent)]
    Shading(#[from] ShadingError),
    /// A point is none of the reference.
    #[error(transparent)]
    Media(#[from] MediaError),
    /// A shader cannot be emitted or run.
    #[error(transparent)]
    Road(#[from] RoadError),
    /// The data behind the examination is not what it should be.
    #[error("{0}")]
    Data(String),
}

/// What an examination found.
#[derive(Debug, Default)]
pub struct Stability {
    /// The largest figure of each check, by surface, variant and case.
    pub findings: Vec<Finding>,
    /// Where the error over the sweep lies, by surface and variant.
    pub maps: Vec<ErrorMap>,
    /// The points that ran on the device, by variant.
    pub device_points: Vec<(String, usize)>,
}

/// Examines variants on their surfaces. `progress` is told how many there are and the name of each that starts.
///
/// # Errors
/// A surface that cannot be made, a shader that a judge refuses, a device that fails.
pub fn examine(
    device: &Device,
    placed: &[Placed],
    effort: Effort,
    progress: &(dyn Fn(usize, &str) + Sync),
) -> Result<Stability, StabilityError> {
    let catalogue = Catalogue::built_in()?;
    let mut stability = Stability::default();
    for surface in surfaces::group(placed) {
        let examination = Examination::new(device, &catalogue, &surface, placed, effort)?;
        let examined = surface
            .variants
            .par_iter()
            .map(|shading| {
                progress(placed.len(), &format!("{} on {}", shading.variant(), shading.scene().name));
                examination.variant(shading)
            })
            .collect::<Result<Vec<_>, StabilityError>>()?;
        for examined in examined {
            stability.findings.extend(examined.findings);
            stability.maps.extend(examined.map);
            let name = examined.variant;
            match stability.device_points.iter_mut().find(|(other, _)| *other == name) {
                Some((_, points)) => *points += examined.device_points,
                None => stability.device_points.push((name, examined.device_points)),
            }
        }
    }
    Ok(stability)
}
