//! Observers, illuminants, colour spaces, optical constants and the exact spectral reference.
//!
//! - [`observer`]: CIE colour matching functions.
//! - [`illuminant`]: spectral power of the light, standard or the user's own.
//! - [`colour_space`]: XYZ to RGB matrices, and the sRGB transfer function.
//! - [`delta_e`]: CIEDE2000, the difference of two colours as the eye sees it.
//! - [`sensitivity`]: the three joined to one spectral sensitivity per output channel, white being (1, 1, 1).
//! - [`fits`]: short sums in place of the sensitivities' Fourier transforms, built in.
//! - [`optical_constants`]: refractive indices over the wavelength.
//! - [`edge_tint`]: indices from a reflectance at normal incidence and an edge tint, and back.
//! - [`mod@reference`]: a film's exact reflectance, by the complex Airy formula over the fine wavelength grid.
//!
//! Wavelengths and thicknesses are in nanometres unless a name says otherwise; angles appear only as cosines; a
//! complex refractive index is n + ik with k >= 0.
//!
//! Nothing here touches the outside world: data files are compiled in, and a user's tables come as text.

pub mod colour_space;
pub mod delta_e;
pub mod edge_tint;
pub mod fits;
pub mod gaussian;
pub mod illuminant;
pub mod names;
pub mod observer;
pub mod optical_constants;
pub mod parallel;
pub mod reference;
pub mod sensitivity;
pub mod table;
pub mod wavelength;

mod dispersion;
mod interpolation;
mod matrix3;

pub use colour_space::ColourSpace;
pub use gaussian::Gaussian;
pub use illuminant::Illuminant;
pub use observer::Observer;
pub use optical_constants::OpticalConstants;
pub use reference::{Point, PreparedStack, Reference, Stack};
pub use sensitivity::Sensitivities;
