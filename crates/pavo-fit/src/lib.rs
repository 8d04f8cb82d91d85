//! Fits: of spectral sensitivities ([`sensitivity`]) and of the reflectance of one scene ([`scene`]).

mod media;
mod method;
pub mod scene;
pub mod sensitivity;
