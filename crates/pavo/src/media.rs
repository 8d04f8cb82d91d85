//! From what a scene says of its materials and colours to the data behind the names.

use crate::scene::{Base, Colour, FilmMedium, IlluminantSource, Scene};
use pavo_files::{read_text_up_to, shown};
use pavo_spectra::illuminant::Illuminant;
use pavo_spectra::wavelength::fine_grid;
use pavo_spectra::{ColourSpace, Observer, OpticalConstants, Sensitivities};
use std::path::Path;
use thiserror::Error;

/// The largest table of optical constants or of an illuminant that is read, in bytes: 16 MiB, a thousand times the usual.
const MAXIMUM_TABLE_BYTES: usize = 16 << 20;

/// What would be right where a file cannot be read.
const FILE_HELP: &str = "csv names a file beside the scene, with the columns wavelength_nm (or wavelength_um), n and k; \
                         that of an illuminant has value in place of n and k";

/// Why the data of a scene cannot be had.
#[derive(Debug, Error)]
#[cfg_attr(feature = "points", derive(miette::Diagnostic))]
pub enum MediaError {
    /// A file that cannot be read.
    #[error("{path}: {cause}")]
    #[cfg_attr(feature = "points", diagnostic(code(pavo::media), help("{}", FILE_HELP)))]
    File {
        /// The file.
        path: String,
        /// Why it cannot be read.
        cause: std::io::Error,
    },
    /// What the data themselves refuse.
    #[error("{message}")]
    #[cfg_attr(feature = "points", diagnostic(code(pavo::media)))]
    Data {
        /// What is wrong, and what would be right.
        message: String,
    },
}

impl MediaError {
    /// What would be right, where the message does not say.
    pub fn help_text(&self) -> Option<&str> {
        match self {
            Self::File { .. } => Some(FILE_HELP),
            Self::Data { .. } => None,
        }
    }
}

fn data(error: impl std::fmt::Display) -> MediaError {
    MediaError::Data { message: error.to_string() }
}

/// The sensitivities of a scene's colours.
pub(crate) fn sensitivities(colour: &Colour) -> Result<Sensitivities, MediaError> {
    let observer = Observer::from_name(&colour.observer).map_err(data)?;
    let illuminant = match &colour.illuminant {
        IlluminantSource::Named(name) => Illuminant::from_name(name).map_err(data)?,
        IlluminantSource::Table(path) => illuminant_from_file(path)?,
    };
    let space = ColourSpace::from_name(&colour.space).map_err(data)?;
    Sensitivities::new(observer, illuminant, space).map_err(data)
}

/// The index of a base over the spectrum, where it depends on the wavelength.
pub(crate) fn dispersive_base(scene: &Scene) -> Result<Option<OpticalConstants>, MediaError> {
    match &scene.base {
        Base::Metal { name } => OpticalConstants::built_in(name).map(Some).map_err(data),
        Base::Table { path } => from_file(path).map(Some),
        Base::Dielectric { .. } | Base::Conductor { .. } | Base::Metalness | Base::F0 { .. } => Ok(None),
    }
}

/// The index of a film over the spectrum, where it depends on the wavelength. It may not absorb.
pub(crate) fn dispersive_film(scene: &Scene) -> Result<Option<OpticalConstants>, MediaError> {
    let film = match scene.film.as_ref().map(|film| &film.medium) {
        Some(FilmMedium::Material(name)) => OpticalConstants::built_in(name).map_err(data)?,
        Some(FilmMedium::Table(path)) => from_file(path)?,
        Some(FilmMedium::Index(_)) | None => return Ok(None),
    };
    let absorbing = fine_grid().into_iter().find(|wavelength| film.extended_at(*wavelength).1 > 0.0);
    match absorbing {
        None => Ok(Some(film)),
        Some(wavelength) => Err(MediaError::Data {
            message: format!(
                "{}: the film absorbs at {wavelength} nm (k = {}); a film must be transparent, with k = 0 throughout",
                film.name(),
                film.extended_at(wavelength).1
            ),
        }),
    }
}

fn from_file(path: &Path) -> Result<OpticalConstants, MediaError> {
    let (name, text) = read(path)?;
    OpticalConstants::from_csv(&name, &text).map_err(data)
}

/// The illuminant of a file.
pub(crate) fn illuminant_from_file(path: &Path) -> Result<Illuminant, MediaError> {
    let (name, text) = read(path)?;
    Illuminant::from_csv(&name, &text).map_err(data)
}

/// The name of a file for messages, and its text.
fn read(path: &Path) -> Result<(String, String), MediaError> {
    let name = shown(path);
    match read_text_up_to(path, MAXIMUM_TABLE_BYTES) {
        Ok(text) => Ok((name, text)),
        Err(cause) => Err(MediaError::File { path: name, cause }),
    }
}
