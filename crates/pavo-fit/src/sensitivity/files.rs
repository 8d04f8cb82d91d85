//! The committed files of fits.

use std::fmt::Write as _;

use pavo_spectra::fits::text::{stored_space, write};
use pavo_spectra::fits::{BUILT_IN_SPECTRA, BuiltInSpectrum, ERROR_SAMPLES, FitFamily};
use rayon::prelude::*;

use super::{FitError, FitRequest, fit};

/// Seed of the built-in fits.
pub const BUILT_IN_SEED: u64 = 1;

/// The ranges of the optical path difference, in micrometres, that a family is built in for.
fn ranges_um(family: FitFamily) -> &'static [f64] {
    match family {
        FitFamily::SharedGaussians | FitFamily::RgbGaussians | FitFamily::XyzGaussians => &[12.0],
        FitFamily::Poles | FitFamily::WindowedNodes => &[1.8, 3.2, 12.0],
        FitFamily::Nodes => &[1.8, 3.2, 6.0],
    }
}

/// The range, in micrometres, of the built-in fits of a family that serves an optical path difference: the smallest that
/// reaches so far, or the largest there is.
pub fn built_in_range_um(family: FitFamily, max_opd_um: f64) -> f64 {
    let ranges = ranges_um(family);
    let largest = ranges[ranges.len() - 1];
    ranges.iter().copied().find(|&range| range >= max_opd_um).unwrap_or(largest)
}

/// What is built in for one observer and illuminant.
pub fn built_in_requests(spectrum: &BuiltInSpectrum) -> Vec<FitRequest> {
    let mut requests = Vec::new();
    for family in FitFamily::ALL {
        for count in family.counts() {
            for &max_opd_um in ranges_um(family) {
                requests.push(FitRequest {
                    family,
                    count,
                    observer: spectrum.observer,
                    illuminant: spectrum.illuminant.clone(),
                    space: stored_space(family),
                    max_opd_um,
                    seed: BUILT_IN_SEED,
                });
            }
        }
    }
    requests
}

/// The text of one observer's and illuminant's file. `progress` is called with a line after every fit. A request that no
/// bounded fit meets is left out, with a progress line that says so.
///
/// # Errors
/// A request that cannot be fitted at all, which none of those built in is.
pub fn built_in_file(spectrum: &BuiltInSpectrum, progress: &(dyn Fn(String) + Sync)) -> Result<String, FitError> {
    let (observer, illuminant) = (spectrum.observer.name(), spectrum.illuminant.name());
    let made = |request: FitRequest| -> Result<String, FitError> {
        let (family, count, range) = (request.family.name(), request.count, request.max_opd_um);
        match fit(&request) {
            Ok(fit) => {
                let errors = format!("max {:.2e}, rms {:.2e}", fit.max_error, fit.rms_error);
                progress(format!("{observer} {illuminant} {family} {count} {range} um: {errors}"));
                Ok(write(&fit))
            }
            Err(error @ FitError::NoneFound { .. }) => {
                progress(format!("{observer} {illuminant} left out: {error}"));
                Ok(String::new())
            }
            Err(error) => Err(error),
        }
    };
    let fits = built_in_requests(spectrum).into_par_iter().map(made).collect::<Result<Vec<String>, FitError>>()?;
    let mut text = String::new();
    let _ = write!(
        text,
        "# Fits of the transforms of the sensitivities of {observer} under {illuminant}: linear sRGB channels;\n\
         # X, Y, Z for xyz-gauss. Made by pavo-fit (`cargo xtask fits`), seed {BUILT_IN_SEED}; do not edit.\n\
         # fit,FAMILY,COUNT,MAX_OPD_UM,WINDOW_UM,MAX_ERROR,RMS_ERROR, and then a line per term:\n\
         # gauss nu,a,w*3; rgb-gauss and xyz-gauss nu*3,a*3,w*3; poles nu,gamma,re*3,im*3; nodes and windowed nu,w*3.\n\
         # nu in 1/um, a in 1/um^2, gamma in 1/um. The errors are |fit - transform| over {ERROR_SAMPLES} steps up to\n\
         # MAX_OPD_UM. Windowed nodes are fitted to the reflectance, the others to the transform's least maximum error.\n"
    );
    text.extend(fits);
    Ok(text)
}

/// Every committed file: its name, and its text.
///
/// # Errors
/// As [`built_in_file`].
pub fn built_in_files() -> Result<Vec<(&'static str, String)>, FitError> {
    BUILT_IN_SPECTRA.iter().map(|spectrum| Ok((spectrum.file, built_in_file(spectrum, &|_| ())?))).collect()
}
