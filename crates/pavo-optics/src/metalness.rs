//! The metalness workflow: one base colour for diffuse and specular reflection.

use pavo_shade::{Real, Scalar, Vector, shade};

/// Diffuse and specular colour.
#[shade]
pub struct Colors<V: Real> {
    /// Diffuse colour: the albedo of what enters.
    pub diffuse_color: V,
    /// Specular colour: the reflectance at normal incidence.
    pub specular_color: V,
}

/// Diffuse and specular colour of the metalness workflow. At 0 the base colour is diffuse and 4 % are reflected; at 1
/// nothing is diffuse and the base colour is reflected.
///
/// Source: Burley 2012, Karis 2013: the metalness workflow; between its two ends, linear.
#[shade]
pub fn metalness_colors<S: Scalar>(
    /// Base colour, linear, [0, 1].
    base_color: S::Vec3,
    /// Metalness, [0, 1].
    metalness: S,
) -> Colors<S::Vec3> {
    Colors {
        diffuse_color: base_color * (1.0 - metalness),
        specular_color: S::Vec3::mix(S::Vec3::lit(0.04), base_color, S::Vec3::splat(metalness)),
    }
}
