//! Fits that are not built in: made on demand by `pavo-fit`, where the feature `fit` brings it.

#[cfg(not(feature = "fit"))]
mod absent;
#[cfg(feature = "fit")]
mod solver;

#[cfg(not(feature = "fit"))]
pub(crate) use absent::{groups_fit, rational_fit, scene_fit, sensitivity_fit};
#[cfg(feature = "cli")]
pub(crate) use solver::form;
#[cfg(feature = "fit")]
pub(crate) use solver::{groups_fit, rational_fit, scene_fit, sensitivity_fit};

use crate::variant::FittedForm;
use pavo_spectra::fits::FitFamily;
use pavo_spectra::{Sensitivities, Stack};

/// A place that keeps fits, so that each is made once.
pub trait FitCache: Sync {
    /// What was stored under a key.
    fn load(&self, key: &str) -> Option<String>;
    /// Stores a text under a key. That it cannot be stored is no error: the fit is then made again next time.
    fn store(&self, key: &str, text: &str);
}

/// Keeps nothing.
#[derive(Clone, Copy, Debug)]
pub struct NoCache;

impl FitCache for NoCache {
    fn load(&self, _: &str) -> Option<String> {
        None
    }
    fn store(&self, _: &str, _: &str) {}
}

/// A fit of sensitivities that is asked for.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(not(feature = "fit"), allow(dead_code))]
pub(crate) struct SensitivityRequest<'a> {
    pub family: FitFamily,
    /// Number of terms.
    pub count: usize,
    pub sensitivities: &'a Sensitivities,
    /// The largest optical path difference, um.
    pub max_opd_um: f64,
}

/// A fit of wave numbers in groups that is asked for.
#[derive(Clone, Debug)]
#[cfg_attr(not(feature = "fit"), allow(dead_code))]
pub(crate) struct GroupsRequest<'a> {
    pub media: &'a Stack,
    /// The smallest and the largest thickness, nm.
    pub thickness_nm: [f64; 2],
    pub sensitivities: &'a Sensitivities,
    /// Number of wave numbers.
    pub count: usize,
    pub groups: usize,
}

/// A fit of one scene's reflectance that is asked for.
#[derive(Clone, Debug)]
#[cfg_attr(not(feature = "fit"), allow(dead_code))]
pub(crate) struct SceneRequest<'a> {
    pub media: &'a Stack,
    /// The smallest and the largest thickness, nm.
    pub thickness_nm: [f64; 2],
    pub sensitivities: &'a Sensitivities,
    pub form: Option<FittedForm>,
    /// Number of waves, or the most where the form is left open.
    pub count: usize,
    pub rms_error: f64,
}
