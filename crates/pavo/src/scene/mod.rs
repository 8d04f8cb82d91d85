//! Scenes: what a surface is made of, what of it varies at run time, and what is to be emitted for it.
//!
//! A scene is a small TOML file. A number in it is fixed and becomes a constant of the emitted code; a pair
//! `[low, high]` is an input of the emitted code, promised to stay within that range. The same scene can be built in
//! Rust by [`Scene::builder`] or from the public fields; [`Scene::validate`] holds for all roads.
//!
//! ```
//! use std::path::Path;
//! use pavo::scene::{FilmMedium, Quantity, Scene};
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
//! let film = scene.film.expect("the scene has a film");
//! assert_eq!(film.medium, FilmMedium::Index(Quantity::Fixed(1.33)));
//! assert!(film.thickness_nm.is_input());
//! # Ok::<(), pavo::scene::SceneError>(())
//! ```

mod builder;
#[cfg(feature = "points")]
mod diagnostic;
mod error;
mod fault;
mod load;
mod model;
mod places;
mod read;
#[cfg(feature = "serde")]
mod serialise;
mod shown;
mod starter;
mod suggest;
mod table;
mod validate;
mod vocabulary;

#[cfg(test)]
mod tests;

pub use builder::SceneBuilder;
pub use error::SceneError;
pub use load::MAXIMUM_FILE_BYTES;
pub use model::{
    Ambient, Base, Budget, Colour, ColourQuantity, Emit, Film, FilmMedium, IlluminantSource, Lights, Precision,
    Quantity, Scene, Surface, VisibilityK,
};
pub use starter::{STARTER, starter};
pub use vocabulary::{
    DEFAULT_TARGETS, DEFAULT_VARIANT, FILM_MATERIALS, ILLUMINANTS, MAXIMUM_IDENTIFIER_LENGTH, MAXIMUM_INDEX,
    MAXIMUM_THICKNESS_NM, METALS, MINIMUM_INDEX, OBSERVERS, PRECISIONS, RATED_INPUTS, RATES, SPACES, TARGETS,
};
