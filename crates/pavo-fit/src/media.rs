//! The media of a film at one wavelength, and what `pavo-optics` makes of them.

use num_complex::Complex64;
use pavo_optics::BaseKind;
use pavo_optics::film::Media as Indices;
use pavo_optics::relative::{RelativeFilm, relative_film};
use pavo_optics::series::{SeriesTerms, both_series_terms};

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
        both_series_terms(self.waves(cos_theta1))
    }

    /// The waves outside the film, at the cosine of an angle of incidence, above 0.
    pub(crate) fn waves(&self, cos_theta1: f64) -> RelativeFilm<f64> {
        let indices = self.indices(cos_theta1);
        relative_film(self.base_kind(), indices, indices.wave(false), self.base.re, self.base.im)
    }

    /// The optical path of one pass for each nm of thickness.
    pub(crate) fn path_per_nm(&self, cos_theta1: f64) -> f64 {
        self.indices(cos_theta1).wave(false).q2
    }

    /// The angle and the indices above the base.
    fn indices(&self, cos_theta1: f64) -> Indices<f64> {
        Indices { cos_theta1, ambient_ior: self.ambient, film_ior: self.film }
    }
}
