//! A film's boundaries under one angle, in complex f64, and the closed forms of its reflectance over a fit.
//!
//! With the amplitudes r_12 and r_23 of a polarisation, b = -r_12 r_23 and Q = (1 - R_12)(1 - R_23) / (1 - R_12 R_23), all
//! orders of interference sum to R(lambda) = 1 - Q Re[(1 + b z) / (1 - b z)], z = exp(2 pi i D / lambda).

use std::f64::consts::PI;

use num_complex::Complex64;
use pavo_spectra::fits::SensitivityFit;

/// A film on a base, seen from an ambient medium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Media {
    /// Refractive index of the ambient medium.
    pub ambient: f64,
    /// Refractive index of the film, above the ambient one: no total reflection into it.
    pub film: f64,
    /// Complex index n + ik of the base.
    pub base: Complex64,
}

/// A film at one angle and thickness.
#[derive(Debug, Clone, Copy)]
pub struct FilmPoint {
    /// Optical path difference in micrometres.
    pub opd_um: f64,
    /// b and Q for s and p polarisation.
    pub polarisations: [(Complex64, f64); 2],
}

impl FilmPoint {
    /// The film of `media` at the cosine of the angle of incidence (above 0, to 1) and the thickness in nanometres.
    pub fn new(media: Media, cos_theta1: f64, thickness_nm: f64) -> Self {
        let eps1 = media.ambient * media.ambient;
        let eps2 = media.film * media.film;
        let eps3 = media.base * media.base;
        let q1 = media.ambient * cos_theta1;
        let q2 = (eps2 - eps1 + q1 * q1).max(0.0).sqrt();
        let q3 = (eps3 - eps1 + q1 * q1).sqrt();
        let q3 = if q3.im < 0.0 { -q3 } else { q3 };
        let polarisation = |a1: f64, a2: f64, a3: Complex64| {
            let r12 = (a1 - a2) / (a1 + a2);
            let r23 = (a2 - a3) / (a2 + a3);
            let (power12, power23) = (r12 * r12, r23.norm_sqr());
            (-r12 * r23, (1.0 - power12) * (1.0 - power23) / (1.0 - power12 * power23))
        };
        Self {
            opd_um: 2.0 * q2 * thickness_nm * 1e-3,
            polarisations: [polarisation(q1, q2, q3), polarisation(q1 / eps1, q2 / eps2, q3 / eps3)],
        }
    }

    /// The reflectance of a fit of poles: R_j = 1 - Q - 2 Q Re sum_k w_jk y_k / (1 - y_k),
    /// y_k = b exp((2 pi i nu_k - gamma_k) D), mean of both polarisations.
    pub fn over_poles(&self, fit: &SensitivityFit) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for (b, q) in self.polarisations {
            let mut series = [0.0; 3];
            for term in &fit.terms {
                let size = (-term.decay[0] * self.opd_um).exp();
                let y = b * Complex64::from_polar(size, 2.0 * PI * term.wave_number[0] * self.opd_um);
                let resummed = y / (1.0 - y);
                for (channel, value) in series.iter_mut().enumerate() {
                    *value += (Complex64::new(term.weight_re[channel], term.weight_im[channel]) * resummed).re;
                }
            }
            for (sum, value) in sums.iter_mut().zip(series) {
                *sum += 0.5 * (1.0 - q - 2.0 * q * value);
            }
        }
        sums
    }

    /// The reflectance of a fit of windowed nodes: the sum over nodes of the weight times [`FilmPoint::windowed_node`].
    pub fn over_windowed_nodes(&self, fit: &SensitivityFit) -> [f64; 3] {
        let mut sums = [0.0; 3];
        let window_um = fit.window_um.unwrap_or(f64::INFINITY);
        for term in &fit.terms {
            let value = self.windowed_node(window_um, term.wave_number[0]);
            for (sum, weight) in sums.iter_mut().zip(term.weight_re) {
                *sum += weight * value;
            }
        }
        sums
    }

    /// The reflectance of a fit of plain nodes: the exact reflectance at each wave number, weighted.
    pub fn over_nodes(&self, fit: &SensitivityFit) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for term in &fit.terms {
            let z = Complex64::cis(2.0 * PI * term.wave_number[0] * self.opd_um);
            let exact = |(b, q): (Complex64, f64)| 1.0 - q * ((1.0 + b * z) / (1.0 - b * z)).re;
            let value = 0.5 * (exact(self.polarisations[0]) + exact(self.polarisations[1]));
            for (sum, weight) in sums.iter_mut().zip(term.weight_re) {
                *sum += weight * value;
            }
        }
        sums
    }

    /// What a windowed node of weight 1 contributes: with g = exp(-(D / Dc)^2), g2 = max(g^2, 0.01), kappa = 1 / g2 and
    /// B = b g g2, the mean over both polarisations of
    /// 1 - Q (1 - kappa) - kappa Q (1 - |B|^2) / |1 - B z|^2.
    pub fn windowed_node(&self, window_um: f64, wave_number: f64) -> f64 {
        let g = (-(self.opd_um / window_um).powi(2)).exp();
        let damping = (g * g).max(0.01);
        let kappa = 1.0 / damping;
        let z = Complex64::cis(2.0 * PI * wave_number * self.opd_um);
        let of_polarisation = |(b, q): (Complex64, f64)| {
            let resummed = b * g * damping;
            let kernel = (1.0 - resummed.norm_sqr()) / (1.0 - resummed * z).norm_sqr();
            1.0 - q * (1.0 - kappa) - kappa * q * kernel
        };
        0.5 * (of_polarisation(self.polarisations[0]) + of_polarisation(self.polarisations[1]))
    }
}
