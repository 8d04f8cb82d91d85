//! From what a scene says of its materials and colours to the data behind the names.

use crate::scene::{Base, Colour, Scene};
use miette::Diagnostic;
use pavo_spectra::illuminant::Illuminant;
use pavo_spectra::{ColourSpace, Observer, OpticalConstants, Sensitivities};
use thiserror::Error;

/// Why the data of a scene cannot be had.
#[derive(Debug, Error, Diagnostic)]
pub enum MediaError {
    /// A file that cannot be read.
    #[error("{path}: {cause}")]
    #[diagnostic(
        code(pavo::media),
        help("base.csv names a file beside the scene, with the columns wavelength_nm (or wavelength_um), n and k")
    )]
    File {
        /// The file.
        path: String,
        /// Why it cannot be read.
        cause: std::io::Error,
    },
    /// What the data themselves refuse.
    #[error("{message}")]
    #[diagnostic(code(pavo::media))]
    Data {
        /// What is wrong, and what would be right.
        message: String,
    },
}

fn data(error: impl std::fmt::Display) -> MediaError {
    MediaError::Data { message: error.to_string() }
}

/// The sensitivities of a scene's colours.
pub(crate) fn sensitivities(colour: &Colour) -> Result<Sensitivities, MediaError> {
    let observer = Observer::from_name(&colour.observer).map_err(data)?;
    let illuminant = Illuminant::from_name(&colour.illuminant).map_err(data)?;
    let space = ColourSpace::from_name(&colour.space).map_err(data)?;
    Sensitivities::new(observer, illuminant, space).map_err(data)
}

/// The index of a base over the spectrum, where it depends on the wavelength.
pub(crate) fn dispersive_base(scene: &Scene) -> Result<Option<OpticalConstants>, MediaError> {
    match &scene.base {
        Base::Metal { name } => OpticalConstants::built_in(name).map(Some).map_err(data),
        Base::Table { path } => {
            let shown = path.display().to_string();
            let text =
                std::fs::read_to_string(path).map_err(|cause| MediaError::File { path: shown.clone(), cause })?;
            OpticalConstants::from_csv(&shown, &text).map(Some).map_err(data)
        }
        Base::Dielectric { .. } | Base::Conductor { .. } | Base::Metalness => Ok(None),
    }
}
