//! From a variant to the method of `pavo-optics` with its data: fits in the units of the shader (nm), nodes with the
//! base's index at each.

use crate::fitting::{FitCache, SensitivityRequest, sensitivity_fit};
use crate::variant::{Fit, Variant};
use pavo_optics::{GaussianFit, GaussianTerm, Method, Pole, SpectralNode, TransformTable, Window};
use pavo_shade::Table;
use pavo_spectra::fits::{FitFamily, FitTerm, SensitivityFit, SpectralTransform, built_in};
use pavo_spectra::wavelength::fine_grid;
use pavo_spectra::{OpticalConstants, Sensitivities, gaussian};
use std::f64::consts::PI;

/// The shortest wavelength of the equally spaced ones.
pub const FIRST_WAVELENGTH_NM: f64 = 380.0;
/// The longest wavelength of the equally spaced ones.
pub const LAST_WAVELENGTH_NM: f64 = 780.0;

const NM_PER_UM: f64 = 1000.0;

/// The step of a table of the transform, nm: what is read between two rows is within 3e-4.
const TRANSFORM_STEP_NM: f64 = 40.0;
/// The largest optical path difference in a table of the transform, nm: under D65 less than 3e-3 is left there.
const TRANSFORM_REACH_NM: f64 = 16_000.0;

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
    /// Where fits are kept that are not built in.
    pub cache: &'a dyn FitCache,
}

/// Why a method cannot be made, and what would be right.
pub type MethodError = (String, String);

impl MethodRequest<'_> {
    /// The method.
    pub fn method(&self) -> Result<Method, MethodError> {
        match *self.variant {
            Variant::Series { order, fit: Fit::Exact } => {
                Ok(Method::TabulatedSeries { order, transform: self.transform(order) })
            }
            Variant::Series { order, fit } => Ok(Method::Series { order, fit: self.gaussians(fit)? }),
            Variant::Poles { count } => {
                let fit = self.fit(FitFamily::Poles, count)?;
                Ok(Method::Poles { poles: fit.terms.iter().map(pole).collect() })
            }
            Variant::Windowed { count, .. } => Ok(Method::Windowed { window: self.window(count)? }),
            Variant::Cosines { count, order } => Ok(Method::Cosines { order, window: self.window(count)? }),
            Variant::Nodes { count } => {
                let fit = self.fit(FitFamily::Nodes, count)?;
                let node = |term: &FitTerm| self.node(NM_PER_UM / term.wave_number[0], term.weight_re);
                Ok(Method::Spectral { nodes: fit.terms.iter().map(node).collect() })
            }
            Variant::Fresnel { .. } => Err((
                "it is for a surface without a film".to_owned(),
                "take windowed:k=6, or leave out [film]".to_owned(),
            )),
            // What takes the film's place is made from the exact reflectance; until then any method stands for it.
            Variant::Baked { .. } | Variant::Table { .. } | Variant::Fitted { .. } => {
                Ok(Method::Spectral { nodes: self.spectral_nodes(81)? })
            }
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
            .map_err(|error| (error.to_string(), "take more wavelengths, for example spectral:n=16".to_owned()))?;
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
                    .map_err(|error| (error.to_string(), "use fit=shared-gauss-4, or spectral:n=81".to_owned()))?;
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
            Fit::Exact => unreachable!("it is no sum of Gaussians"),
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
        let (sensitivities, max_opd_um) = (self.sensitivities, self.max_opd_nm / NM_PER_UM);
        match built_in(family, count, sensitivities, max_opd_um) {
            Some(fit) => Ok(fit),
            None => sensitivity_fit(&SensitivityRequest { family, count, sensitivities, max_opd_um }, self.cache),
        }
    }

    /// The exact transform of the sensitivities up to what the orders need, as tables.
    fn transform(&self, order: usize) -> TransformTable {
        let exact = SpectralTransform::new(self.sensitivities);
        let needed_nm = order as f64 * self.max_opd_nm;
        let reach_nm = needed_nm.min(TRANSFORM_REACH_NM);
        let count = (reach_nm / TRANSFORM_STEP_NM).ceil().max(1.0) as usize + 1;
        let carrier = self.mean_wave_numbers();
        let envelope = |row: usize| -> [[f64; 2]; 3] {
            let opd_nm = row as f64 * TRANSFORM_STEP_NM;
            // Beyond its reach the transform is cut off.
            let scale = if needed_nm > reach_nm && row == count - 1 { 0.0 } else { 1.0 };
            let transform = exact.at(opd_nm / NM_PER_UM);
            std::array::from_fn(|channel| {
                let (sine, cosine) = (carrier[channel] * opd_nm).sin_cos();
                let value = transform[channel];
                [scale * (value.re * cosine + value.im * sine), scale * (value.im * cosine - value.re * sine)]
            })
        };
        let envelopes: Vec<[[f64; 2]; 3]> = (0..count).map(envelope).collect();
        let table = |part: usize, name: &str, doc: &str| {
            let doc = format!(
                "{doc} of the sensitivities' Fourier transform without its carrier, by channel: a row every {TRANSFORM_STEP_NM} nm of optical path difference."
            );
            Table::new(name, &doc, envelopes.iter().map(|row| row.map(|value| value[part])).collect())
        };
        TransformTable {
            step_nm: TRANSFORM_STEP_NM,
            carrier,
            re: table(0, "sensitivity_envelope_re", "Real part"),
            im: table(1, "sensitivity_envelope_im", "Imaginary part"),
        }
    }

    /// The mean of each channel's sensitivity over the angular wave number, radians per nm.
    fn mean_wave_numbers(&self) -> [f64; 3] {
        let mut means = [0.0; 3];
        for (wavelength, weight) in fine_grid().iter().zip(self.sensitivities.fine_weights()) {
            for (mean, weight) in means.iter_mut().zip(weight) {
                *mean += weight * 2.0 * PI / wavelength;
            }
        }
        means
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
