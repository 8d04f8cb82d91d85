//! What is asked for, and what is given.

use super::error::SceneFitError;
use super::plan::Form;
use pavo_optics::fitted::FittedFilm;
use pavo_spectra::{OpticalConstants, Sensitivities};

/// The most waves that a fit has.
pub const MAX_NODES: usize = 12;

/// The greatest thickness, nm. Beyond it the colours of a film have long faded, and the points of a fit no longer resolve
/// its fringes.
pub(super) const THICKEST_NM: f64 = 20_000.0;

/// A scene whose reflectance is to be fitted.
#[derive(Clone, Debug)]
pub struct SceneFitRequest<'a> {
    /// Refractive index of the ambient medium, > 0.
    pub ambient_ior: f64,
    /// The film; its index, at 555 nm, is above that of the ambient medium.
    pub film: OpticalConstants,
    /// The base.
    pub base: OpticalConstants,
    /// The smallest and the largest thickness, nm, from 0 to 20,000; the same twice for a film of one thickness.
    pub thickness_nm: [f64; 2],
    /// The sensitivities of the output channels.
    pub sensitivities: &'a Sensitivities,
    /// The form. Without one, that with the fewest operations that keeps to the errors asked for; with none asked for,
    /// the one that comes closest.
    pub form: Option<Form>,
    /// How many waves, 1 to [`MAX_NODES`]; where the form is left open, how many at most. A film of one thickness takes
    /// none.
    pub nodes: usize,
    /// What the random numbers of the starts begin with. The same seed gives the same fit.
    pub seed: u64,
    /// The root of the mean square error that is asked for, > 0.
    pub rms_error: Option<f64>,
    /// The largest error that is asked for, > 0.
    pub max_error: Option<f64>,
}

/// A fitted scene, with its error.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFit {
    /// The coefficients.
    pub film: FittedFilm,
    /// The form.
    pub form: Form,
    /// Roughly what an evaluation costs: multiply-and-adds and the like count 1; roots, reciprocals, exponentials, sines and
    /// cosines 4.
    pub cost: usize,
    /// The root of the mean square error over the held-out points and the channels, evaluated in `f32`.
    pub rms: f64,
    /// The largest error in any channel of any held-out point, evaluated in `f32`.
    pub max: f64,
    /// How many points were held out.
    pub points: usize,
}

impl SceneFitRequest<'_> {
    /// Whether a fit keeps to the errors that are asked for.
    pub(super) fn is_met_by(&self, fit: &SceneFit) -> bool {
        self.rms_error.is_none_or(|asked| fit.rms <= asked) && self.max_error.is_none_or(|asked| fit.max <= asked)
    }

    /// Checks the request.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn check(&self) -> Result<(), SceneFitError> {
        let [thinnest, thickest] = self.thickness_nm;
        if !(thinnest >= 0.0 && thinnest <= thickest && thickest > 0.0 && thickest <= THICKEST_NM) {
            return Err(SceneFitError::Thickness { thinnest, thickest });
        }
        if !(1..=MAX_NODES).contains(&self.nodes) {
            return Err(SceneFitError::Nodes { nodes: self.nodes });
        }
        for (name, asked) in [("rms_error", self.rms_error), ("max_error", self.max_error)] {
            if let Some(asked) = asked
                && !(asked.is_finite() && asked > 0.0)
            {
                return Err(SceneFitError::AskedError { name, asked });
            }
        }
        if self.form == Some(Form::AngleOnly) && thinnest < thickest {
            return Err(SceneFitError::AngleOnly { thinnest, thickest });
        }
        Ok(())
    }
}
