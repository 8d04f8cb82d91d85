//! Fits of the reflectance of one scene: indices fixed, thickness free within a range.
//!
//! [`fit_scene`] takes the media and the range of thickness, and gives the coefficients of a short form
//! ([`pavo_optics::fitted`]) with the error that it leaves, measured in `f32` on points that the fit has not seen.
//!
//! The parameters of a form (a window, polynomials in the angle, wave numbers, weights) begin at what the Fresnel formulas
//! give, with wave numbers spread over the visible range and shifted at random. Several such starts run
//! Levenberg-Marquardt against the exact spectral reflectance over part of the points; the best go on over all of them.
//! The same request gives the same fit.

mod choose;
mod error;
mod layout;
mod model;
mod plan;
mod problem;
mod random;
mod request;
mod solve;
mod start;
mod wave;

pub use choose::fit_scene;
pub use error::SceneFitError;
pub use plan::Form;
pub use request::{MAX_NODES, SceneFit, SceneFitRequest};
