//! A film under one angle as the windowed fits see it: what does not depend on the fit is computed once.

use pavo_optics::series::SeriesTerms;
use pavo_optics::windowed::WindowedFilm;
use pavo_spectra::Point;

use crate::media::Media;

/// A film at one angle and thickness.
#[derive(Debug, Clone, Copy)]
pub(super) struct FilmPoint {
    opd_nm: f64,
    /// Coefficients of the series for s and p polarisation.
    series: [SeriesTerms<f64>; 2],
}

impl FilmPoint {
    /// The film of `media` at an angle of incidence (the cosine above 0, to 1) and a thickness.
    pub(super) fn new(media: Media, point: Point) -> Self {
        Self { opd_nm: media.opd_per_nm(point.cos_theta1) * point.thickness_nm, series: media.series(point.cos_theta1) }
    }

    /// The reflectance for a node of weight 1 at each of the angular wave numbers, radians per nm, under a window of this
    /// width.
    pub(super) fn windowed_nodes(
        &self,
        width_nm: f64,
        angular_wave_numbers: impl Iterator<Item = f64>,
    ) -> impl Iterator<Item = f64> {
        let film = WindowedFilm::new(width_nm, self.series, self.opd_nm);
        let opd_nm = self.opd_nm;
        angular_wave_numbers.map(move |wave_number| {
            let (sine, cosine) = (wave_number * opd_nm).sin_cos();
            film.rest - film.node(cosine, sine)
        })
    }
}
