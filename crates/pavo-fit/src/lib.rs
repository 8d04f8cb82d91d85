//! Fits: of spectral sensitivities ([`sensitivity`]), of the reflectance of one scene ([`scene`]), of the indices that groups
//! of wave numbers have in one scene ([`groups`]), and of one film of one thickness ([`baked`]).

pub mod baked;
mod film_point;
pub mod groups;
mod media;
mod method;
mod points;
pub mod scene;
pub mod sensitivity;
mod separable;
