//! The pairs of scenes, read from a table.

use crate::failure::Failure;
use pavo::scene::Scene;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

const TABLE: &str = include_str!("../../../templates/savings/savings.toml");

/// What is counted of a surface.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Quantity {
    /// The specular reflectance.
    #[default]
    Reflectance,
    /// All that the scene asks for: the BRDF, and the radiance where it has a punctual light.
    Surface,
}

/// Over which points the errors of two variants are compared.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Errors {
    /// Both over the ranges of the second scene.
    #[default]
    To,
    /// Each over the ranges of its own scene.
    Each,
}

/// Two scenes, the second with one more thing fixed.
#[derive(Clone, Debug)]
pub struct Case {
    /// What was fixed.
    pub what: String,
    /// What is counted.
    pub quantity: Quantity,
    /// The scene that leaves it to run time.
    pub from: Scene,
    /// The scene that fixes it.
    pub to: Scene,
    /// The variant of both scenes.
    pub variant: String,
    /// Variants that the second scene may have in its place; none where it has the same.
    pub instead: Vec<String>,
    /// The largest error that they may have; nothing where it is that of the first.
    pub max_rms: Option<f64>,
    /// Over which points they are compared.
    pub errors: Errors,
    /// The largest cost of the second scene, as a part of the first.
    pub at_most: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Cases {
    scene: BTreeMap<String, toml::Table>,
    case: Vec<Row>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    what: String,
    #[serde(default)]
    quantity: Quantity,
    from: String,
    to: String,
    variant: String,
    #[serde(default)]
    instead: Vec<String>,
    rms: Option<f64>,
    #[serde(default)]
    errors: Errors,
    #[serde(default = "no_dearer")]
    at_most: f64,
}

fn no_dearer() -> f64 {
    1.0
}

/// All pairs.
///
/// # Errors
/// If the table or a scene in it is wrong.
pub fn cases() -> Result<Vec<Case>, Failure> {
    let Cases { scene: scenes, case: rows } =
        toml::from_str(TABLE).map_err(|error| Failure::Table(error.to_string()))?;
    let scene = |name: &str| -> Result<Scene, Failure> {
        let content = scenes.get(name).ok_or_else(|| Failure::Table(format!("no scene is called `{name}`")))?;
        let text = toml::to_string(content).map_err(|error| Failure::Table(error.to_string()))?;
        Ok(Scene::from_toml(name, &format!("name = \"{name}\"\n{text}"), Path::new("."))?)
    };
    let case = |row: Row| {
        let Row { what, quantity, from, to, variant, instead, rms, errors, at_most } = row;
        let (from, to) = (scene(&from)?, scene(&to)?);
        Ok(Case { what, quantity, from, to, variant, instead, max_rms: rms, errors, at_most })
    };
    rows.into_iter().map(case).collect()
}
