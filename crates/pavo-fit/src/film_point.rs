//! A film under one angle as the windowed fits see it: what does not depend on the fit is computed once.

use pavo_optics::relative::RelativeFilm;
use pavo_optics::windowed::{Phase, WindowedFilm};
use pavo_optics::{BaseKind, Precision};
use pavo_spectra::Point;

use crate::media::Media;

/// A film at one angle and thickness.
#[derive(Debug, Clone, Copy)]
pub(super) struct FilmPoint {
    path_nm: f64,
    base: BaseKind,
    waves: RelativeFilm<f64>,
}

impl FilmPoint {
    /// The film of `media` at an angle of incidence (the cosine above 0, to 1) and a thickness.
    pub(super) fn new(media: Media, point: Point) -> Self {
        Self {
            path_nm: media.path_per_nm(point.cos_theta1) * point.thickness_nm,
            base: media.base_kind(),
            waves: media.waves(point.cos_theta1),
        }
    }

    /// The reflectance for a node of weight 1 at each of the angular wave numbers, radians per nm, under a window of this
    /// width.
    pub(super) fn windowed_nodes(
        &self,
        width_nm: f64,
        angular_wave_numbers: impl Iterator<Item = f64>,
    ) -> impl Iterator<Item = f64> {
        let film = WindowedFilm::new(width_nm, self.base, self.waves, self.path_nm);
        let (base, path_nm) = (self.base, self.path_nm);
        angular_wave_numbers.map(move |wave_number| {
            let phase = 2.0 * wave_number * path_nm;
            let phase = if base.is_real() {
                Phase::HalfSineSquared((0.5 * phase).sin().powi(2))
            } else {
                Phase::Wave([phase.cos(), phase.sin()])
            };
            film.rest - 2.0 * film.node(Precision::FULL, phase)
        })
    }
}
