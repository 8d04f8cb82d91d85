//! Fits: of spectral sensitivities ([`sensitivity`]) and of the reflectance of one scene ([`scene`]).

pub mod scene;
pub mod sensitivity;
