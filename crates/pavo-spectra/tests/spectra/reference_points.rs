//! The reference against points of an independent code (`tests/data/README.md`).

use std::fs;
use std::path::Path;

use pavo_spectra::{ColourSpace, Illuminant, Observer, OpticalConstants, Point, Reference, Sensitivities, Stack};

/// The largest error that a channel may have. The points hold D65 beyond 780 nm and use another rounding of the sRGB
/// matrix, which makes up to 2.3e-7.
const ALLOWED: f64 = 5e-7;

fn points_of(scene: &str) -> Vec<(Point, [f64; 3])> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(format!("{scene}.csv"));
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("cos_theta1,thickness_nm,r,g,b"), "{scene}");
    lines
        .map(|line| {
            let numbers: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
            let [cos_theta1, thickness_nm, r, g, b] = numbers[..] else { panic!("{scene}: {line}") };
            (Point { cos_theta1, thickness_nm }, [r, g, b])
        })
        .collect()
}

fn medium(text: &str) -> OpticalConstants {
    let numbers: Option<Vec<f64>> = text.split('+').map(|part| part.parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[n]) => OpticalConstants::constant(n, 0.0).unwrap(),
        Some(&[n, k]) => OpticalConstants::constant(n, k).unwrap(),
        _ => OpticalConstants::built_in(text).unwrap(),
    }
}

#[test]
fn every_point_of_the_independent_code_is_met() {
    let sensitivities =
        Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb).unwrap();
    let reference = Reference::new(&sensitivities);
    for (scene, ambient_ior, film, base) in [
        ("soap", 1.0, "1.33", "1"),
        ("oil", 1.0, "1.5", "1.33"),
        ("thick_oil", 1.0, "1.5", "1.33"),
        ("mgf2", 1.0, "1.38", "1.52"),
        ("nacre", 1.0, "1.53", "1.66"),
        ("high_contrast", 1.0, "2.5", "1.2"),
        ("inverted", 1.5, "1", "1.5"),
        ("tio2_on_ti", 1.0, "2.4", "2.7+3.8"),
        ("sio2_on_si", 1.0, "1.46", "4.1+0.04"),
        ("copper_spectral", 1.0, "2.6", "Cu"),
        ("gold_spectral", 1.0, "1.77", "Au"),
        ("silver_spectral", 1.0, "2.0", "Ag"),
        ("titanium_spectral", 1.0, "TiO2", "Ti"),
        ("silicon_spectral", 1.0, "SiO2", "Si"),
    ] {
        let stack = Stack::new(ambient_ior, medium(film), medium(base)).unwrap();
        let expected = points_of(scene);
        assert_eq!(expected.len(), 355, "{scene}");
        let points: Vec<Point> = expected.iter().map(|&(point, _)| point).collect();
        let found = reference.prepare(&stack).reflectance_of_each(&points);
        let mut largest: (f64, Option<Point>) = (0.0, None);
        for ((point, expected), found) in expected.into_iter().zip(found) {
            for (expected, found) in expected.into_iter().zip(found) {
                let error = (found - expected).abs();
                assert!(error.is_finite(), "{scene}: {found} at {point:?}");
                if error > largest.0 {
                    largest = (error, Some(point));
                }
            }
        }
        println!("{scene}: largest error {:.1e}", largest.0);
        assert!(largest.0 <= ALLOWED, "{scene}: off by {:e} at {:?}, allowed {ALLOWED:e}", largest.0, largest.1);
    }
}

#[test]
fn single_points_and_batches_agree() {
    let sensitivities = Sensitivities::new(Observer::Cie1964TenDegree, Illuminant::D50, ColourSpace::AcesCg).unwrap();
    let reference = Reference::new(&sensitivities);
    let samples: Vec<(Stack, Point)> = [("1.5", "Au"), ("SiO2", "1.33"), ("1.4", "2.7+3.8")]
        .into_iter()
        .zip([0.0, 120.0, 800.0])
        .map(|((film, base), thickness)| {
            (Stack::new(1.0, medium(film), medium(base)).unwrap(), Point::new(0.6, thickness))
        })
        .collect();
    let found = reference.reflectance_of_each(&samples);
    assert_eq!(found.len(), samples.len());
    for ((stack, point), found) in samples.iter().zip(found) {
        assert_eq!(reference.reflectance(stack, *point), found);
        assert_eq!(reference.prepare(stack).reflectance(*point), found);
        // The colour is the weighted sum of the single wavelengths.
        for channel in 0..3 {
            let sum: f64 = pavo_spectra::wavelength::fine_grid()
                .into_iter()
                .zip(sensitivities.fine_weights())
                .map(|(wavelength, weight)| stack.reflectance_at(wavelength, *point) * weight[channel])
                .sum();
            crate::assert_close("weighted sum", found[channel], sum, 1e-13);
        }
    }
}

#[test]
fn with_an_index_per_channel_each_channel_is_that_of_its_own_stack() {
    let sensitivities =
        Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb).unwrap();
    let reference = Reference::new(&sensitivities);
    let base = [(1.2, 0.0), (1.9, 0.3), (0.2, 3.5)];
    for point in [Point::new(1.0, 0.0), Point::new(0.7, 333.0), Point::new(0.05, 900.0)] {
        let found = reference.reflectance_per_channel(1.0, 1.4, base, point);
        for (channel, (n, k)) in base.into_iter().enumerate() {
            let index = |n, k| OpticalConstants::constant(n, k).unwrap();
            let stack = Stack::new(1.0, index(1.4, 0.0), index(n, k)).unwrap();
            assert_eq!(found[channel], reference.reflectance(&stack, point)[channel], "{point:?}");
        }
    }
}
