//! A scene as TOML or JSON again, in the shape that [`Scene::from_toml`](super::Scene::from_toml) reads.

use std::collections::BTreeMap;

use pavo_shade::Rate;
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::model::{Base, ColourQuantity, FilmMedium, IlluminantSource, Quantity, VisibilityK};

/// Rates by their names.
pub(super) fn rates<S: Serializer>(rates: &BTreeMap<String, Rate>, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(rates.iter().map(|(input, rate)| (input, rate.name())))
}

impl Serialize for Quantity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Quantity::Fixed(value) => serializer.serialize_f64(*value),
            Quantity::Range { low, high } => [low, high].serialize(serializer),
        }
    }
}

impl Serialize for ColourQuantity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            ColourQuantity::Fixed(colour) => colour.serialize(serializer),
            ColourQuantity::Input => serializer.serialize_str("input"),
        }
    }
}

impl Serialize for VisibilityK {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            VisibilityK::Punctual => serializer.serialize_str("punctual"),
            VisibilityK::ImageBased => serializer.serialize_str("ibl"),
            VisibilityK::Value(k) => k.serialize(serializer),
        }
    }
}

impl Serialize for FilmMedium {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        match self {
            FilmMedium::Index(ior) => map.serialize_entry("ior", ior)?,
            FilmMedium::Material(name) => map.serialize_entry("material", name)?,
            FilmMedium::Table(path) => map.serialize_entry("csv", path)?,
        }
        map.end()
    }
}

impl Serialize for IlluminantSource {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        match self {
            IlluminantSource::Named(name) => map.serialize_entry("illuminant", name)?,
            IlluminantSource::Table(path) => map.serialize_entry("illuminant_csv", path)?,
        }
        map.end()
    }
}

impl Serialize for Base {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        match self {
            Base::Dielectric { ior } => map.serialize_entry("ior", ior)?,
            Base::Conductor { ior, kappa } => {
                map.serialize_entry("ior", ior)?;
                map.serialize_entry("kappa", kappa)?;
            }
            Base::Metal { name } => map.serialize_entry("metal", name)?,
            Base::Table { path } => map.serialize_entry("csv", path)?,
            Base::F0 { f0, edge_tint } => {
                map.serialize_entry("workflow", "f0")?;
                map.serialize_entry("f0", f0)?;
                if let Some(edge_tint) = edge_tint {
                    map.serialize_entry("edge_tint", edge_tint)?;
                }
            }
            Base::Metalness => map.serialize_entry("workflow", "metalness")?,
        }
        map.end()
    }
}
