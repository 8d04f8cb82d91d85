//! The films that fits are made on and judged by.

use num_complex::Complex64;
use pavo_spectra::OpticalConstants;

use crate::media::Media;

/// A kind of film.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmClass {
    /// Its name, for tables.
    pub name: &'static str,
    /// Whether the base absorbs.
    pub is_conductor: bool,
    /// Its media, with the same indices at every wavelength.
    pub media: Media,
}

/// Wavelength at which a metal's constant index is taken, in nanometres.
const METAL_WAVELENGTH_NM: f64 = 555.0;

/// Five dielectric films: a soap film, oil on water, MgF2 on glass, nacre, and one of high contrast; and five on
/// conductors: TiO2 on titanium, SiO2 on silicon, and films on copper, gold and silver (Johnson and Christy 1972).
pub fn film_classes() -> Vec<FilmClass> {
    let dielectric = |name, film, base: f64| FilmClass {
        name,
        is_conductor: false,
        media: Media { ambient: 1.0, film, base: base.into() },
    };
    let conductor = |name, film, n, k| FilmClass {
        name,
        is_conductor: true,
        media: Media { ambient: 1.0, film, base: Complex64::new(n, k) },
    };
    let mut classes = vec![
        dielectric("soap film", 1.33, 1.0),
        dielectric("oil on water", 1.5, 1.33),
        dielectric("MgF2 on glass", 1.38, 1.52),
        dielectric("nacre", 1.53, 1.66),
        dielectric("high contrast", 2.5, 1.2),
        conductor("TiO2 on Ti", 2.4, 2.7, 3.8),
        conductor("SiO2 on Si", 1.46, 4.1, 0.04),
    ];
    for (name, film, metal) in [("2.6 on Cu", 2.6, "Cu"), ("1.77 on Au", 1.77, "Au"), ("2.0 on Ag", 2.0, "Ag")] {
        // The names are built in.
        if let Ok(constants) = OpticalConstants::built_in(metal) {
            let (n, k) = constants.extended_at(METAL_WAVELENGTH_NM);
            classes.push(conductor(name, film, n, k));
        }
    }
    classes
}
