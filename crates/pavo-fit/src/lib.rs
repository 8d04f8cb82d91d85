//! Fits: of spectral sensitivities ([`sensitivity`]), of the reflectance of one scene ([`scene`]), and of that of one film of
//! one thickness ([`baked`]).

pub mod baked;
mod media;
mod method;
pub mod scene;
pub mod sensitivity;
