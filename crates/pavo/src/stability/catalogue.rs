//! The catalogue of hard cases.

use super::StabilityError;
use super::draw::Draw;
use super::finding::Check;
use serde::Deserialize;
use std::collections::BTreeMap;

const TEXT: &str = include_str!("../../../../templates/stability/catalogue.toml");

/// The cases, and how inputs are drawn that they do not name.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Catalogue {
    /// Draws of inputs by name, where a case has none.
    pub(super) ordinary: BTreeMap<String, Draw>,
    /// The cases.
    #[serde(rename = "case")]
    pub cases: Vec<Case>,
}

/// A hard case.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// Why it is hard.
    pub why: String,
    /// What is evaluated.
    #[serde(default)]
    of: Of,
    /// Draws of the inputs that matter.
    #[serde(default)]
    pub(super) inputs: BTreeMap<String, Draw>,
    /// The surfaces by name; without any, all that have the inputs.
    #[serde(default)]
    surfaces: Vec<String>,
    /// How many points the case has.
    #[serde(default = "default_points")]
    pub points: usize,
    /// The share in the sweep.
    #[serde(default)]
    pub sweep: usize,
    /// Whether draws may leave the ranges of the surface.
    #[serde(default)]
    pub outside: bool,
    /// What must hold.
    pub checks: Vec<Check>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Of {
    #[default]
    Reflectance,
    Radiance,
}

fn default_points() -> usize {
    96
}

impl Catalogue {
    /// The catalogue that is compiled in.
    ///
    /// # Errors
    /// If it is not as it should be, which the tests rule out.
    pub fn built_in() -> Result<Self, StabilityError> {
        toml::from_str(TEXT).map_err(|error| StabilityError::Data(format!("catalogue.toml: {error}")))
    }
}

impl Case {
    /// Whether the radiance from directions is evaluated, and not the reflectance.
    pub fn is_of_radiance(&self) -> bool {
        self.of == Of::Radiance
    }

    /// Whether the case is one of a surface, whose inputs are these.
    pub(super) fn applies(&self, surface: &str, is_built_in: bool, has: impl Fn(&str) -> bool) -> bool {
        if is_built_in && !self.surfaces.is_empty() {
            return self.surfaces.iter().any(|name| name == surface);
        }
        self.inputs.iter().all(|(name, draw)| has(name) && draw.others().into_iter().all(&has))
    }
}
