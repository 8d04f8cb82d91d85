//! Why a scene cannot be fitted.

use super::request::{MAX_NODES, SceneFit, THICKEST_NM};
use pavo_spectra::reference::StackError;
use thiserror::Error;

/// Why a scene cannot be fitted.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SceneFitError {
    /// The ambient index makes no sense.
    #[error(transparent)]
    Ambient(#[from] StackError),
    /// The film would reflect totally.
    #[error(
        "the film's index {film_ior} at {wavelength_nm} nm is not above the ambient one, {ambient_ior}: \
         a fitted form has no total reflection; use a run-time method for such a film"
    )]
    FilmIndex {
        /// Index of the ambient medium.
        ambient_ior: f64,
        /// Index of the film.
        film_ior: f64,
        /// The wavelength, nm.
        wavelength_nm: f64,
    },
    /// The range of thickness is none.
    #[error(
        "the thickness runs from {thinnest} to {thickest} nm; both should be numbers from 0 to {THICKEST_NM}, \
         the second above 0 and not below the first"
    )]
    Thickness {
        /// The smallest thickness, nm.
        thinnest: f64,
        /// The largest thickness, nm.
        thickest: f64,
    },
    /// The number of waves is out of range.
    #[error("nodes = {nodes}; a fit has 1 to {MAX_NODES}")]
    Nodes {
        /// The number that was given.
        nodes: usize,
    },
    /// An error that nothing can keep to.
    #[error("{name} = {asked}; an error that is asked for is a finite number above 0")]
    AskedError {
        /// Which one.
        name: &'static str,
        /// The number that was given.
        asked: f64,
    },
    /// A form without thickness for a film that has a range of it.
    #[error(
        "the form angle-only is for a film of one thickness; this one runs from {thinnest} to {thickest} nm: \
         leave the form open, or give one with waves"
    )]
    AngleOnly {
        /// The smallest thickness, nm.
        thinnest: f64,
        /// The largest thickness, nm.
        thickest: f64,
    },
    /// The best fit is not good enough.
    #[error(
        "the best fit that was found has an RMS error of {:.1e} and a largest one of {:.1e}{}; allow more error or \
         more nodes, narrow the range of thickness, or use a run-time method",
        best.rms, best.max, asked(*rms_error, *max_error)
    )]
    Missed {
        /// The best fit, which may serve all the same.
        best: Box<SceneFit>,
        /// The root of the mean square error that was asked for.
        rms_error: Option<f64>,
        /// The largest error that was asked for.
        max_error: Option<f64>,
    },
}

fn asked(rms_error: Option<f64>, max_error: Option<f64>) -> String {
    let named = [("RMS", rms_error), ("largest", max_error)];
    let parts = named.iter().filter_map(|(name, asked)| asked.map(|asked| format!("{name} {asked:.1e}")));
    let parts: Vec<String> = parts.collect();
    if parts.is_empty() { String::new() } else { format!("; asked for: {}", parts.join(", ")) }
}
