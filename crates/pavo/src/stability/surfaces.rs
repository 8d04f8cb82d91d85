//! The surfaces that built-in variants are examined on: general ones with everything at run time, and of the starter
//! scenes those that have variants of their own.

use super::StabilityError;
use crate::fitting::FitCache;
use crate::scene::Scene;
use crate::shading::{Shading, ShadingError};
use crate::variant::Variant;
use rayon::prelude::*;
use std::path::Path;

/// A surface with its scene, and the variants that it is for.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// The name, which is also the scene's.
    pub name: &'static str,
    /// The scene.
    pub text: &'static str,
    /// Patterns of variants, `*` for any text.
    variants: &'static [&'static str],
}

macro_rules! surface {
    ($name:literal) => {
        BuiltIn {
            name: $name,
            text: include_str!(concat!("../../../../templates/stability/surfaces/", $name, ".toml")),
            variants: &["*"],
        }
    };
    ($name:literal, $variants:expr) => {
        BuiltIn {
            name: $name,
            text: include_str!(concat!("../../../../templates/scenes/", $name, ".toml")),
            variants: &$variants,
        }
    };
}

impl BuiltIn {
    /// All surfaces.
    pub const ALL: [BuiltIn; 11] = [
        surface!("dielectric"),
        surface!("any-dielectric"),
        surface!("conductor"),
        surface!("any-conductor"),
        surface!("metalness"),
        surface!("bare-dielectric"),
        surface!("bare-conductor"),
        surface!("bare-metalness"),
        surface!("soap-bubble", ["series:m=3,fit=xyz-gauss", "windowed:k=6", "poles:*", "fitted:*", "table:*"]),
        surface!("coated-lens", ["baked:*", "table:*", "fitted:*"]),
        surface!("lacquered-gold", ["windowed:*", "spectral:n=81", "nodes:n=16"]),
    ];
}

/// A variant on a surface.
#[derive(Clone, Debug)]
pub struct Placed {
    /// The surface by the variant.
    pub shading: Shading,
    /// Whether the surface is one of [`BuiltIn::ALL`], which the catalogue knows by name.
    pub is_built_in: bool,
}

impl Placed {
    /// A surface; the catalogue knows those of [`BuiltIn::ALL`] by name.
    pub fn new(shading: Shading) -> Self {
        let is_built_in = BuiltIn::ALL.iter().any(|surface| surface.name == shading.scene().name);
        Self { shading, is_built_in }
    }
}

/// The variants of one surface.
pub(super) struct Surface<'a> {
    pub is_built_in: bool,
    pub variants: Vec<&'a Shading>,
}

/// What is placed, by surface, in the order in which each comes first.
pub(super) fn group(placed: &[Placed]) -> Vec<Surface<'_>> {
    let mut surfaces: Vec<Surface<'_>> = Vec::new();
    for Placed { shading, is_built_in } in placed {
        let name = &shading.scene().name;
        match surfaces.iter_mut().find(|surface| surface.variants[0].scene().name == *name) {
            Some(surface) => surface.variants.push(shading),
            None => surfaces.push(Surface { is_built_in: *is_built_in, variants: vec![shading] }),
        }
    }
    surfaces
}

/// Every built-in variant, or only one, on each built-in surface that it can be made for.
///
/// # Errors
/// A scene that is none, which the tests rule out.
pub fn built_in(only: Option<&Variant>, cache: &dyn FitCache) -> Result<Vec<Placed>, StabilityError> {
    let mut wanted: Vec<(Scene, Variant)> = Vec::new();
    for surface in BuiltIn::ALL {
        let scene = Scene::from_toml(&format!("{}.toml", surface.name), surface.text, Path::new("."))
            .map_err(|error| StabilityError::Data(error.to_string()))?;
        let variants = Variant::candidates_for(&scene).into_iter();
        let is_for = |variant: &Variant| {
            let is_wanted = only.is_none_or(|only| only == variant);
            is_wanted && surface.variants.iter().any(|pattern| matches(pattern, &variant.to_string()))
        };
        wanted.extend(variants.filter(is_for).map(|variant| (scene.clone(), variant)));
    }
    let made = wanted.par_iter().map(|(scene, variant)| place(scene, variant, cache));
    Ok(made.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
}

/// The variants of one scene that can be made.
///
/// # Errors
/// A scene whose data cannot be had.
pub fn by_variant(scene: &Scene, variants: &[Variant], cache: &dyn FitCache) -> Result<Vec<Placed>, StabilityError> {
    let made = variants.par_iter().map(|variant| place(scene, variant, cache));
    Ok(made.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
}

/// A variant on a surface; nothing where it cannot be made for it.
fn place(scene: &Scene, variant: &Variant, cache: &dyn FitCache) -> Result<Option<Placed>, StabilityError> {
    match Shading::with_cache(scene, variant, cache) {
        Err(ShadingError::Variant { .. }) => Ok(None),
        other => Ok(Some(Placed::new(other?))),
    }
}

/// Whether a text is one of a pattern, in which `*` stands for any text.
pub(super) fn matches(pattern: &str, text: &str) -> bool {
    let mut pieces = pattern.split('*');
    let first = pieces.next().unwrap_or_default();
    let Some(mut rest) = text.strip_prefix(first) else { return false };
    let pieces: Vec<&str> = pieces.collect();
    let Some((last, middle)) = pieces.split_last() else { return rest.is_empty() };
    for piece in middle {
        let Some(place) = rest.find(piece) else { return false };
        rest = &rest[place + piece.len()..];
    }
    rest.ends_with(last)
}

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn a_star_stands_for_any_text() {
        for (pattern, text, expected) in [
            ("*", "poles:k=5", true),
            ("poles:*", "poles:k=5", true),
            ("poles:*", "windowed:k=5", false),
            ("windowed:*,groups=*", "windowed:k=6,groups=2", true),
            ("windowed:*,groups=*", "windowed:k=6", false),
            ("poles:k=5", "poles:k=5", true),
            ("poles:k=5", "poles:k=55", false),
            ("any-*", "any-dielectric", true),
        ] {
            assert_eq!(matches(pattern, text), expected, "{pattern} {text}");
        }
    }
}
