//! The observer, illuminant and colour space that arguments name.

use super::arguments::SpectrumArguments;
use super::failure::Failure;
use crate::media::illuminant_from_file;
use pavo_spectra::names::UnknownName;
use pavo_spectra::{ColourSpace, Illuminant, Observer, Sensitivities};
use std::path::Path;

/// The sensitivities of the output channels.
pub fn sensitivities(arguments: &SpectrumArguments) -> Result<Sensitivities, Failure> {
    let named = |error: UnknownName| Failure::input(error, "take one of the known names");
    let observer = Observer::from_name(&arguments.observer).map_err(named)?;
    let space = ColourSpace::from_name(&arguments.space).map_err(named)?;
    let illuminant = match Path::new(&arguments.illuminant) {
        file if file.extension().is_some_and(|extension| extension == "csv") => illuminant_from_file(file)?,
        _ => Illuminant::from_name(&arguments.illuminant).map_err(named)?,
    };
    Sensitivities::new(observer, illuminant, space).map_err(|error| Failure::input(error, "take another illuminant"))
}
