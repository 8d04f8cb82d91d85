//! From a variant to the method of `pavo-optics` with its data: fits in the units of the shader (nm), nodes with the
//! base's index at each.

use crate::variant::{Fit, Variant};
use pavo_optics::{GaussianFit, GaussianTerm, Method, Pole, SpectralNode, Window};
use pavo_spectra::fits::{FitFamily, FitTerm, SensitivityFit, built_in};
use pavo_spectra::{OpticalConstants, Sensitivities, gaussian};
use std::f64::consts::PI;

/// The shortest wavelength of the equally spaced ones.
pub const FIRST_WAVELENGTH_NM: f64 = 380.0;
/// The longest wavelength of the equally spaced ones.
pub const LAST_WAVELENGTH_NM: f64 = 780.0;

const NM_PER_UM: f64 = 1000.0;

/// What a method is made for.
pub struct MethodRequest<'a> {
    /// The variant.
    pub variant: &'a Variant,
    /// The sensitivities of the output channels.
    pub sensitivities: &'a Sensitivities,
    /// The base, where its index depends on the wavelength.
    pub base: Option<&'a OpticalConstants>,
    /// The film, where its index depends on the wavelength.
    pub film: Option<&'a OpticalConstants>,
    /// The largest optical path difference of a round trip in the scene, nm.
    pub max_opd_nm: f64,
}

/// Why a method cannot be made, and what would be right.
pub type MethodError = (String, &'static str);

impl MethodRequest<'_> {
    /// The method.
    pub fn method(&self) -> Result<Method, MethodError> {
        match *self.variant {
            Variant::Series { order, fit } => Ok(Method::Series { order, fit: self.gaussians(fit)? }),
            Variant::Poles { count } => {
                let fit = self.fit(FitFamily::Poles, count)?;
                Ok(Method::Poles { poles: fit.terms.iter().map(pole).collect() })
            }
            Variant::Windowed { count } => Ok(Method::Windowed { window: self.window(count)? }),
            Variant::Cosines { count, order } => Ok(Method::Cosines { order, window: self.window(count)? }),
            Variant::Nodes { count } => {
                let fit = self.fit(FitFamily::Nodes, count)?;
                let node = |term: &FitTerm| self.node(NM_PER_UM / term.wave_number[0], term.weight_re);
                Ok(Method::Spectral { nodes: fit.terms.iter().map(node).collect() })
            }
            // The surface that a polynomial is taken from.
            Variant::Baked { .. } => Ok(Method::Spectral { nodes: self.spectral_nodes(81)? }),
            Variant::Spectral { count } => Ok(Method::Spectral { nodes: self.spectral_nodes(count)? }),
        }
    }

    /// Equally spaced wavelengths with the sensitivities as weights.
    pub fn spectral_nodes(&self, count: usize) -> Result<Vec<SpectralNode>, MethodError> {
        let step = (LAST_WAVELENGTH_NM - FIRST_WAVELENGTH_NM) / (count - 1) as f64;
        let wavelengths: Vec<f64> = (0..count).map(|index| FIRST_WAVELENGTH_NM + step * index as f64).collect();
        let weights = self
            .sensitivities
            .normalised_weights(&wavelengths)
            .map_err(|error| (error.to_string(), "take more wavelengths, for example spectral:n=16"))?;
        Ok(wavelengths.iter().zip(weights).map(|(wavelength, weight)| self.node(*wavelength, weight)).collect())
    }

    fn node(&self, wavelength_nm: f64, weight: [f64; 3]) -> SpectralNode {
        SpectralNode {
            wavelength_nm,
            weight,
            base: self.base.map(|base| base.extended_at(wavelength_nm)),
            film: self.film.map(|film| film.extended_at(wavelength_nm).0),
        }
    }

    fn gaussians(&self, fit: Fit) -> Result<GaussianFit, MethodError> {
        let (family, count) = match fit {
            Fit::XyzGauss => {
                let (observer, space) = (self.sensitivities.observer(), self.sensitivities.space());
                let gaussians = gaussian::belcour_barla(observer, space)
                    .map_err(|error| (error.to_string(), "use fit=shared-gauss-4, or spectral:n=81"))?;
                let term = |gaussian: &gaussian::Gaussian| GaussianTerm {
                    angular_wave_number: [gaussian.angular_wave_number; 3],
                    decay: [gaussian.decay; 3],
                    weight: gaussian.weight,
                };
                return Ok(GaussianFit { terms: gaussians.iter().map(term).collect() });
            }
            Fit::XyzGaussians(count) => (FitFamily::XyzGaussians, count),
            Fit::RgbGaussians(count) => (FitFamily::RgbGaussians, count),
            Fit::SharedGaussians(count) => (FitFamily::SharedGaussians, count),
        };
        let fit = self.fit(family, count)?;
        let term = |term: &FitTerm| GaussianTerm {
            angular_wave_number: term.wave_number.map(angular),
            decay: term.decay.map(|decay| decay / (NM_PER_UM * NM_PER_UM)),
            weight: term.weight_re,
        };
        Ok(GaussianFit { terms: fit.terms.iter().map(term).collect() })
    }

    fn window(&self, count: usize) -> Result<Window, MethodError> {
        let fit = self.fit(FitFamily::WindowedNodes, count)?;
        let first = fit.terms[0].wave_number[0];
        let last = fit.terms[count - 1].wave_number[0];
        Ok(Window {
            first: angular(first),
            step: angular((last - first) / (count - 1) as f64),
            width_nm: fit.window_um.unwrap_or(f64::INFINITY) * NM_PER_UM,
            weights: fit.terms.iter().map(|term| term.weight_re).collect(),
        })
    }

    fn fit(&self, family: FitFamily, count: usize) -> Result<SensitivityFit, MethodError> {
        built_in(family, count, self.sensitivities, self.max_opd_nm / NM_PER_UM).ok_or_else(|| {
            let (observer, illuminant) = (self.sensitivities.observer().name(), self.sensitivities.illuminant().name());
            let cause = format!(
                "there is no built-in fit of {count} {} for the observer {observer}, the illuminant {illuminant} and the \
                 space {}",
                family.name(),
                self.sensitivities.space().name()
            );
            (cause, "spectral:n=81 and spectral:n=16 need no fit")
        })
    }
}

fn pole(term: &FitTerm) -> Pole {
    Pole {
        angular_wave_number: angular(term.wave_number[0]),
        decay: term.decay[0] / NM_PER_UM,
        weight_re: term.weight_re,
        weight_im: term.weight_im,
    }
}

/// Radians per nm of a wave number in 1/um.
fn angular(wave_number_per_um: f64) -> f64 {
    2.0 * PI * wave_number_per_um / NM_PER_UM
}
