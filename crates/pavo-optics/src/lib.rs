//! The thin-film BRDF, once. Each function is generic over its number type: it runs on `f32` and `f64`, and recorded
//! as a graph it becomes shader code.
//!
//! Conventions: time factor `e^(-i omega t)`, complex index `n + i kappa` with `kappa >= 0`, lengths in nanometres,
//! angles only as cosines. Media: 1 ambient, 2 film, 3 base. `theta1` is the angle between the half vector and the
//! light (or the view). `q_i` is the normal component of the wave vector in medium i in units of the vacuum wave
//! number, `q_i = n_i cos(theta_i)`.
//!
//! Sources: L. Belcour and P. Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying
//! Iridescence", ACM Transactions on Graphics 36(4), 2017; P. Yeh, "Optical Waves in Layered Media", 2005; M. Born and
//! E. Wolf, "Principles of Optics".

pub mod airy;
pub mod baked;
pub mod cosines;
pub mod f0;
pub mod film;
pub mod fitted;
pub mod fresnel;
pub mod grouped;
pub mod lambert;
pub mod light;
pub mod metalness;
pub mod microfacet;
pub mod poles;
pub mod precision;
pub mod relative;
pub mod series;
pub mod spectral;
pub mod surface;
pub mod table;
pub mod tabulated;
pub mod wave;
pub mod windowed;

pub use baked::BakedFilm;
pub use film::{BaseKind, Film, Method};
pub use grouped::WindowGroup;
pub use poles::Pole;
pub use precision::Precision;
pub use series::{GaussianFit, GaussianTerm};
pub use spectral::SpectralNode;
pub use surface::{Directions, Finish, Geometry, Layers, Light, Specular, Surface, VisibilityK};
pub use table::FilmTable;
pub use tabulated::TransformTable;
pub use windowed::Window;
