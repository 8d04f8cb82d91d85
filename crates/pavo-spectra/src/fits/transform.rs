//! The exact transform of the sensitivities.

use std::f64::consts::PI;

use num_complex::Complex64;

use crate::sensitivity::Sensitivities;
use crate::wavelength::fine_grid;

/// S^_j(D) = integral of S_j(nu) exp(2 pi i nu D) over the wave number nu, which is the sum over the fine wavelength
/// grid of weight_j(lambda) exp(2 pi i D / lambda), weights summing to 1: S^_j(0) = 1.
#[derive(Debug, Clone)]
pub struct SpectralTransform {
    wave_numbers: Vec<f64>,
    weights: Vec<[f64; 3]>,
}

impl SpectralTransform {
    /// The transform of a set of sensitivities.
    pub fn new(sensitivities: &Sensitivities) -> Self {
        let wave_numbers = fine_grid().into_iter().map(|wavelength_nm| 1e3 / wavelength_nm).collect();
        Self { wave_numbers, weights: sensitivities.fine_weights().to_vec() }
    }

    /// S^_j(D) for each channel at the optical path difference D in micrometres.
    pub fn at(&self, opd_um: f64) -> [Complex64; 3] {
        let mut sums = [Complex64::ZERO; 3];
        for (wave_number, weights) in self.wave_numbers.iter().zip(&self.weights) {
            let wave = Complex64::cis(2.0 * PI * wave_number * opd_um);
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum += wave * weight;
            }
        }
        sums
    }
}
