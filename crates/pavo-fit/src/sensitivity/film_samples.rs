//! Points of films with their exact reflectance: what windowed nodes are fitted to, and what every fit is judged by.

use pavo_optics::film::film_reflectance;
use pavo_optics::{BaseKind, Film, Precision};
use pavo_spectra::fits::SensitivityFit;
use pavo_spectra::{OpticalConstants, Point, Reference, Sensitivities, Stack};

use super::classes::FilmClass;
use crate::media::Media;
use crate::method::closed_form;

/// Points of films, and the exact reflectance of each in three channels.
#[derive(Debug, Clone, Default)]
pub struct FilmSamples {
    pub(super) points: Vec<(Media, Point)>,
    pub(super) values: Vec<[f64; 3]>,
}

/// Errors of a fit's reflectance over points and channels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReflectanceErrors {
    /// Largest absolute error.
    pub max: f64,
    /// Root of the mean square.
    pub rms: f64,
}

impl FilmSamples {
    /// The exact reflectance of each class of films at the points that `places` names for it.
    pub fn new(
        sensitivities: &Sensitivities,
        classes: &[FilmClass],
        mut places: impl FnMut(&FilmClass) -> Vec<Point>,
    ) -> Self {
        let reference = Reference::new(sensitivities);
        let mut samples = Self::default();
        for class in classes {
            let media = class.media;
            let film = OpticalConstants::constant(media.film, 0.0);
            let base = OpticalConstants::constant(media.base.re, media.base.im);
            let (Ok(film), Ok(base)) = (film, base) else { continue };
            let Ok(stack) = Stack::new(media.ambient, film, base) else { continue };
            let places = places(class);
            samples.points.extend(places.iter().map(|&place| (media, place)));
            samples.values.extend(reference.prepare(&stack).reflectance_of_each(&places));
        }
        samples
    }

    /// The errors of the reflectance that a fit gives; `None` for the families that are used as a series of orders
    /// (Gaussians), whose error depends on how many are taken.
    pub fn errors(&self, fit: &SensitivityFit) -> Option<ReflectanceErrors> {
        let method = closed_form(fit)?;
        // Without total reflection the channels' wavelengths are not used.
        let channel_wavelengths_nm = [555.0; 3];
        let mut film = Film {
            base: BaseKind::Conductor,
            total_reflection: false,
            method,
            channel_wavelengths_nm,
            precision: Precision::FULL,
        };
        let (mut max, mut sum) = (0.0f64, 0.0);
        for ((media, place), exact) in self.points.iter().zip(&self.values) {
            film.base = media.base_kind();
            let Media { ambient, film: film_ior, base } = *media;
            let &Point { cos_theta1, thickness_nm } = place;
            let fitted =
                film_reflectance::<f64, f64>(&film, cos_theta1, thickness_nm, ambient, film_ior, base.re, base.im);
            for (fitted, exact) in fitted.to_array().into_iter().zip(exact) {
                max = max.max((fitted - exact).abs());
                sum += (fitted - exact).powi(2);
            }
        }
        let count = (3 * self.points.len()).max(1) as f64;
        Some(ReflectanceErrors { max, rms: (sum / count).sqrt() })
    }
}
