//! The media of a film at one wavelength, and what `pavo-optics` makes of them.

use num_complex::Complex64;
use pavo_optics::BaseKind;
use pavo_optics::film::{Media as Indices, film_terms};
use pavo_optics::poles::both_series_terms;
use pavo_optics::series::SeriesTerms;

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

impl Media {
    /// The kind of base.
    pub(crate) fn base_kind(&self) -> BaseKind {
        if self.base.im > 0.0 {
            BaseKind::Conductor
        } else {
            BaseKind::Dielectric { total_reflection: self.base.re < self.ambient }
        }
    }

    /// Coefficients of the series over orders for s and p polarisation, at the cosine of an angle of incidence, above 0.
    pub(crate) fn series(&self, cos_theta1: f64) -> [SeriesTerms<f64>; 2] {
        let indices = self.indices(cos_theta1);
        let wave = indices.wave(false);
        let base = indices.base_wave(self.base_kind(), self.base.re, self.base.im);
        both_series_terms(film_terms(false, indices, wave, base), indices, wave.q2, base)
    }

    /// The optical path difference for each nm of thickness.
    pub(crate) fn opd_per_nm(&self, cos_theta1: f64) -> f64 {
        2.0 * self.indices(cos_theta1).wave(false).q2
    }

    /// The angle and the indices above the base.
    fn indices(&self, cos_theta1: f64) -> Indices<f64> {
        Indices { cos_theta1, ambient_ior: self.ambient, film_ior: self.film }
    }
}
