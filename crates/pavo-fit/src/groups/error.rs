//! Why a scene's groups cannot be fitted.

use super::GroupsRequest;
use crate::sensitivity::FitError;
use pavo_spectra::fits::FitFamily;
use pavo_spectra::reference::StackError;
use thiserror::Error;

/// Where an index that the groups share is read, nm: the middle of the eye's sensitivity.
pub(super) const GREEN_NM: f64 = 555.0;

/// Why a scene's groups cannot be fitted.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GroupsError {
    /// The ambient index makes no sense.
    #[error(transparent)]
    Ambient(#[from] StackError),
    /// No windowed nodes to begin with.
    #[error(transparent)]
    Sensitivities(#[from] FitError),
    /// The film would reflect totally.
    #[error(
        "the film's index {film_ior} at {wavelength_nm} nm is not above the ambient one, {ambient_ior}: groups are fitted \
         without total reflection into the film; take spectral or nodes for such a film"
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
    #[error("the thickness runs from {thinnest} to {thickest} nm; it should run from 0 or more to more than that")]
    Thickness {
        /// The smallest thickness, nm.
        thinnest: f64,
        /// The largest thickness, nm.
        thickest: f64,
    },
    /// The number of groups is out of range.
    #[error("{groups} groups of {nodes} wave numbers: there should be at least one group, and a wave number for each")]
    Groups {
        /// The number of wave numbers.
        nodes: usize,
        /// The number of groups.
        groups: usize,
    },
    /// The number of wave numbers is out of range.
    #[error("{nodes} wave numbers under a window; there are {least} to {most}")]
    Nodes {
        /// The number of wave numbers.
        nodes: usize,
        /// The least number.
        least: usize,
        /// The largest number.
        most: usize,
    },
}

impl GroupsRequest<'_> {
    /// Checks the request.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn check(&self) -> Result<(), GroupsError> {
        let &GroupsRequest { ambient_ior, nodes, groups, .. } = self;
        let [thinnest, thickest] = self.thickness_nm;
        if !(thinnest >= 0.0 && thinnest < thickest && thickest.is_finite()) {
            return Err(GroupsError::Thickness { thinnest, thickest });
        }
        let counts = FitFamily::WindowedNodes.counts();
        if !counts.contains(&nodes) {
            return Err(GroupsError::Nodes { nodes, least: *counts.start(), most: *counts.end() });
        }
        if !(1..=nodes).contains(&groups) {
            return Err(GroupsError::Groups { nodes, groups });
        }
        for step in 0..=40 {
            let wavelength_nm = 380.0 + 10.0 * f64::from(step);
            let (film_ior, _) = self.film.extended_at(wavelength_nm);
            if film_ior <= ambient_ior {
                return Err(GroupsError::FilmIndex { ambient_ior, film_ior, wavelength_nm });
            }
        }
        Ok(())
    }
}
