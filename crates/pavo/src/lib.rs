//! Thin-film iridescence shaders, generated and proven.
//!
//! A [`scene::Scene`] says what a surface is made of and what varies at run time; a [`Variant`] says by which method its
//! colour is computed. Together they are a [`Shading`]: it runs on the CPU, and as a graph it becomes shader text.
//!
//! ```
//! use pavo::{Shading, ShadingQuantity, Target, Variant, scene::Scene};
//! use std::path::Path;
//!
//! let text = r#"
//! name = "soap-bubble"
//! [film]
//! ior = 1.33
//! thickness_nm = [0, 1200]
//! [base]
//! ior = 1.0
//! "#;
//! let scene = Scene::from_toml("soap-bubble.toml", text, Path::new("."))?;
//! let shading = Shading::new(&scene, &"spectral:n=16".parse::<Variant>()?)?;
//! let colour = shading.evaluate(ShadingQuantity::Reflectance, &[0.7, 300.0]);
//! assert!(colour.iter().all(|channel| (-0.1..0.3).contains(channel)));
//! let shader = pavo::library(&shading, pavo_emit::Language::Wgsl);
//! assert!(shader.contains("fn shade_surface("));
//! let module = pavo::library(&shading, pavo_emit::Language::Rust);
//! assert!(module.contains("pub fn shade_surface("));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Without the default feature `cli` the library emits text and needs neither the judges nor a driver.

mod baking;
mod build;
mod emission;
#[cfg(feature = "entry")]
mod entries;
mod fitting;
mod fixed_film;
mod inputs;
mod media;
mod methods;
pub mod points;
#[cfg(feature = "points")]
pub mod points_table;
pub mod scene;
mod shading;
pub mod statistics;
mod target;
mod variant;

#[cfg(feature = "cli")]
pub mod cli;
#[cfg(feature = "cli")]
pub mod numerics;
#[cfg(feature = "cli")]
pub mod roads;
#[cfg(feature = "cli")]
pub mod stability;
#[cfg(feature = "cli")]
pub mod tuning;

pub use build::{Build, BuildError, Built};
pub use emission::{Emission, library, library_quantity, prepared_bytes, uniforms};
#[cfg(feature = "entry")]
pub use entries::{compute, cost, cost_baseline, fragment, points_fragment};
pub use fitting::{FitCache, NoCache};
pub use inputs::ShadingQuantity;
pub use media::MediaError;
pub use pavo_emit::Language;
pub use pavo_shade::Rate;
pub use shading::{Shading, ShadingError};
pub use target::Target;
pub use variant::{Fit, FittedForm, Variant, VariantError};
