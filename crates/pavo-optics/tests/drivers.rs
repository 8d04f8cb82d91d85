//! What drivers may do to single precision, and what it does to the film's colour.

mod common;

use common::{DIELECTRIC, Random, film, poles, wide_fit, window};
use pavo_optics::film::film_reflectance;
use pavo_optics::{BaseKind, Film, Method};
use pavo_shade::emulated::{Contracting, Emulated, Exact, Flushing, Loose, SwiftShader, Vulkan};
use pavo_shade::{Half, Scalar, Vector};

/// A film in air: its name, its base, and the indices of film and base.
type Surface = (&'static str, BaseKind, [f64; 3]);

const SURFACES: [Surface; 2] = [
    // Water in air on both sides.
    ("soap", DIELECTRIC, [1.33, 1.0, 0.0]),
    // An oxide on titanium at 550 nm, rounded.
    ("metal", BaseKind::Conductor, [2.4, 2.0, 2.9]),
];

fn methods() -> [(&'static str, Method); 3] {
    [
        ("windowed", Method::Windowed { window: window(2500.0) }),
        ("poles", Method::Poles { poles: poles() }),
        ("series", Method::Series { order: 3, fit: wide_fit() }),
    ]
}

/// The largest error of a channel over 2,000 angles and thicknesses, against `f64` at the same numbers of `f32`.
fn largest_error<S: Scalar + Into<f64>>(film: &Film, [film_ior, base_ior, base_kappa]: [f64; 3]) -> f64 {
    let mut random = Random::new(95);
    let mut largest = 0.0_f64;
    for _ in 0..2000 {
        let point = [random.within(0.05, 1.0), random.within(0.0, 1000.0), 1.0, film_ior, base_ior, base_kappa];
        let point = point.map(|number| f64::from(number as f32));
        let [a, b, c, d, e, f] = point;
        let expected = film_reflectance::<f64, f64>(film, a, b, c, d, e, f).to_array();
        let [a, b, c, d, e, f] = point.map(S::lit);
        let found = film_reflectance::<S, S>(film, a, b, c, d, e, f);
        for (found, expected) in [found.x(), found.y(), found.z()].into_iter().zip(expected) {
            let error = (found.into() - expected).abs();
            largest = if error.is_nan() { f64::INFINITY } else { largest.max(error) };
        }
    }
    largest
}

/// The arithmetics, in the order of [`BOUNDS`].
const ARITHMETICS: [(&str, Measure); 7] = [
    ("exact", largest_error::<Emulated<Exact>>),
    ("contracting", largest_error::<Emulated<Contracting>>),
    ("flushing", largest_error::<Emulated<Flushing>>),
    ("SwiftShader", largest_error::<Emulated<SwiftShader>>),
    ("loose", largest_error::<Emulated<Loose>>),
    ("Vulkan", largest_error::<Emulated<Vulkan>>),
    ("half", largest_error::<Half>),
];

type Measure = fn(&Film, [f64; 3]) -> f64;

/// Bounds of the error for each method and surface, by arithmetic: what was measured and up to twice as much.
///
/// Rounding, contraction and flushing do next to nothing; the error of sines comes through, under a window several times
/// over, since its phases follow from two of them by a recurrence. In half precision the square of a path above 255 nm is
/// infinite, which closes the window and the Gaussians: there the film loses its colour. Poles need no squares of paths.
const BOUNDS: [(&str, &str, [f64; 7]); 6] = [
    ("windowed", "soap", [2e-6, 2e-6, 2e-6, 3e-3, 6e-6, 5e-3, 0.6]),
    ("windowed", "metal", [3e-6, 3e-6, 3e-6, 4e-3, 7e-6, 8e-3, 0.4]),
    ("poles", "soap", [8e-7, 8e-7, 8e-7, 4e-4, 1.5e-6, 1.2e-3, 6e-3]),
    ("poles", "metal", [8e-7, 8e-7, 8e-7, 2e-4, 1e-6, 4e-4, 4e-3]),
    ("series", "soap", [1e-6, 1e-6, 1e-6, 5e-4, 2e-6, 1e-3, 0.7]),
    ("series", "metal", [8e-7, 8e-7, 8e-7, 1.5e-4, 1.5e-6, 4e-4, 0.5]),
];

#[test]
fn colours_stay_within_their_bounds_whatever_a_driver_does() {
    for (method_name, method) in methods() {
        for (surface, base, indices) in SURFACES {
            let film = film(base, false, method.clone());
            let (.., bounds) = BOUNDS.into_iter().find(|row| (row.0, row.1) == (method_name, surface)).expect("a row");
            for ((arithmetic, measure), bound) in ARITHMETICS.into_iter().zip(bounds) {
                let error = measure(&film, indices);
                println!("{method_name}, {surface}, {arithmetic}: {error:.2e}, allowed {bound:e}");
                assert!(error <= bound, "{method_name}, {surface}, {arithmetic}: {error:e}, allowed {bound:e}");
            }
        }
    }
}

#[test]
fn exact_emulation_has_the_errors_of_f32() {
    for (_, method) in methods() {
        for (_, base, indices) in SURFACES {
            let film = film(base, false, method.clone());
            assert_eq!(largest_error::<Emulated<Exact>>(&film, indices), largest_error::<f32>(&film, indices));
        }
    }
}
