//! What is lost of a conductor where an engine only knows its F0, and what an edge tint brings back.

use super::error::{Judge, QUANTITY};
use crate::media::{MediaError, dispersive_base};
use crate::scene::{Base, ColourQuantity, Scene};
use crate::shading::{Shading, ShadingError, channel_index};
use crate::variant::Variant;
use pavo_spectra::edge_tint::f0_and_edge_tint;
use pavo_spectra::{OpticalConstants, Point, Reference, Stack};
use serde::Serialize;

/// A conductor by what it reflects at normal incidence, and how far its exact colours under the film are from those that
/// it has by its index at each wavelength. A film whose index depends on the wavelength has that in green light then, which
/// is part of the difference.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct F0Loss {
    /// Its colour at normal incidence under air, held within [0, 1].
    pub f0: [f64; 3],
    /// The edge tint of its mean index over each channel, held within [0, 1].
    pub edge_tint: [f64; 3],
    /// The mean of CIEDE2000 over the scene, by F0 alone.
    pub mean_delta_e: f64,
    /// The same by F0 and edge tint.
    pub mean_delta_e_with_edge_tint: f64,
}

impl Judge {
    /// What is lost where the base is known by its F0; nothing where it is no conductor, or not fixed.
    ///
    /// # Errors
    /// If the scene's data cannot be had.
    pub fn f0_loss(&self, shading: &Shading) -> Result<Option<F0Loss>, ShadingError> {
        let scene = shading.scene();
        let Some(base) = conductor(scene)? else { return Ok(None) };
        let sensitivities = shading.sensitivities();
        let means = channel_index(sensitivities, &base);
        let held = |value: f64| value.clamp(0.0, 1.0);
        let edge_tint = std::array::from_fn(|channel| held(f0_and_edge_tint(means[0][channel], means[1][channel]).1));
        let data = |error: &dyn std::fmt::Display| MediaError::Data { message: error.to_string() };
        let air = OpticalConstants::constant(1.0, 0.0).map_err(|error| data(&error))?;
        let bare = Stack::new(1.0, air, base).map_err(|error| data(&error))?;
        let f0 = Reference::new(sensitivities).reflectance(&bare, Point::new(1.0, 0.0)).map(held);
        let by = |edge_tint: Option<[f64; 3]>| -> Result<f64, ShadingError> {
            let edge_tint = edge_tint.map(ColourQuantity::Fixed);
            let scene = Scene { base: Base::F0 { f0: ColourQuantity::Fixed(f0), edge_tint }, ..scene.clone() };
            let known = Shading::new(&scene, &Variant::Spectral { count: 81 })?;
            Ok(self.mean_delta_e(&known.reference_each(QUANTITY, self.points())?))
        };
        Ok(Some(F0Loss { f0, edge_tint, mean_delta_e: by(None)?, mean_delta_e_with_edge_tint: by(Some(edge_tint))? }))
    }
}

/// The index of a scene's base, where it is a conductor that the scene fixes.
fn conductor(scene: &Scene) -> Result<Option<OpticalConstants>, MediaError> {
    let Base::Conductor { ior, kappa } = scene.base else { return dispersive_base(scene) };
    let (Some(ior), Some(kappa)) = (ior.fixed(), kappa.fixed()) else { return Ok(None) };
    OpticalConstants::constant(ior, kappa).map(Some).map_err(|error| MediaError::Data { message: error.to_string() })
}
