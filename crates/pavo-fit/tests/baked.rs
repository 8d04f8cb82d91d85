//! Quotients over the angle: uniform films on metals and dielectrics, and refusals.

use pavo_fit::baked::{BakedErrors, RationalError, closest, cosines, errors, rational};
use pavo_optics::baked::baked;
use pavo_spectra::{ColourSpace, Illuminant, Observer, OpticalConstants, Point, Reference, Sensitivities, Stack};

fn constants(n: f64) -> OpticalConstants {
    OpticalConstants::constant(n, 0.0).expect("a medium")
}

fn metal(name: &str) -> OpticalConstants {
    OpticalConstants::built_in(name).expect("a metal")
}

/// The exact reflectance of a film of one thickness at these cosines.
fn samples(
    film: &OpticalConstants,
    base: &OpticalConstants,
    thickness_nm: f64,
    cosines: &[f64],
) -> Vec<(f64, [f64; 3])> {
    let sensitivities = Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb);
    let reference = Reference::new(&sensitivities.expect("standard light"));
    let stack = Stack::new(1.0, film.clone(), base.clone()).expect("a stack");
    let points: Vec<Point> = cosines.iter().map(|&cosine| Point::new(cosine, thickness_nm)).collect();
    cosines.iter().copied().zip(reference.prepare(&stack).reflectance_of_each(&points)).collect()
}

/// Cosines that no fit has seen.
fn held_out() -> Vec<f64> {
    (0..=400).map(|step| f64::from(step) / 400.0).collect()
}

#[test]
fn a_quotient_of_ten_coefficients_is_closer_than_a_polynomial_of_ten() {
    // Name, film, base, thickness, and the largest error of the quotient.
    let cases = [
        ("oil on water", constants(1.5), constants(1.33), 400.0, 5e-5),
        ("MgF2 on glass", constants(1.38), constants(1.52), 300.0, 5e-5),
        ("1.77 on Au", constants(1.77), metal("Au"), 250.0, 5e-4),
        ("1.5 on Au", constants(1.5), metal("Au"), 350.0, 5e-4),
        ("2.0 on Ag", constants(2.0), metal("Ag"), 120.0, 5e-4),
        ("1.5 on Ag", constants(1.5), metal("Ag"), 400.0, 5e-4),
    ];
    for (name, film, base, thickness_nm, allowed) in cases {
        let fitted = samples(&film, &base, thickness_nm, &cosines(81));
        let others = samples(&film, &base, thickness_nm, &held_out());
        let of_degrees = |numerator, denominator| -> Result<BakedErrors, RationalError> {
            Ok(errors(&rational(&fitted, numerator, denominator)?, &others))
        };
        let polynomial = of_degrees(9, 0).expect("a polynomial has no pole");
        let quotient = of_degrees(5, 4);
        println!(
            "{name} {thickness_nm} nm: degree 9 {:.1e} max {:.1e}; 5/4 {}",
            polynomial.rms,
            polynomial.max,
            quotient.map_or_else(|error| error.to_string(), |q| format!("{:.1e} max {:.1e}", q.rms, q.max))
        );
        let closest = closest(&fitted, 10).expect("a polynomial at least");
        let best = errors(&closest, &others);
        println!(
            "  closest {}/{}: {:.1e} max {:.1e}",
            9 - closest.denominator.len(),
            closest.denominator.len(),
            best.rms,
            best.max
        );
        assert!(best.max < allowed && best.rms <= polynomial.rms, "{name}: {best:?}");
    }
}

#[test]
fn a_quotient_is_found_again() {
    let function = |cosine: f64| {
        let t = 2.0 * cosine - 1.0;
        [(0.3 + 0.2 * t) / (1.0 + 0.5 * t + 0.2 * t * t), 0.7, 0.1 * t * t / (1.0 - 0.8 * t)]
    };
    let samples: Vec<(f64, [f64; 3])> = cosines(60).into_iter().map(|cosine| (cosine, function(cosine))).collect();
    let film = rational(&samples, 2, 2).expect("no pole");
    for cosine in held_out() {
        let found = baked::<f64>(&film, cosine).to_array();
        for (found, expected) in found.into_iter().zip(function(cosine)) {
            assert!((found - expected).abs() < 1e-10, "{cosine}: {found} {expected}");
        }
    }
}

#[test]
fn a_pole_within_the_range_is_refused() {
    // A function with a pole at cos = 0.55, between the samples.
    let function = |cosine: f64| [0.5, 0.5, 0.01 / (cosine - 0.55)];
    let samples: Vec<(f64, [f64; 3])> = cosines(60).into_iter().map(|cosine| (cosine, function(cosine))).collect();
    let error = rational(&samples, 1, 1).expect_err("it has a pole");
    let RationalError::Pole { channel: 2, cosine, .. } = error else { panic!("{error:?}") };
    assert!((cosine - 0.55).abs() < 0.02, "{error}");
    assert!(error.to_string().contains("channel 2") && error.to_string().contains("take lower degrees"), "{error}");

    // Degrees too high for data with noise: spurious poles.
    let noise = |index: usize| 1e-3 * (index as f64 * 12.9898).sin() * (index as f64 * 78.233).cos();
    let noisy: Vec<(f64, [f64; 3])> =
        cosines(40).into_iter().enumerate().map(|(index, cosine)| (cosine, [0.5 + noise(index); 3])).collect();
    assert!(matches!(rational(&noisy, 12, 12), Err(RationalError::Pole { .. })), "{:?}", rational(&noisy, 12, 12));
}

#[test]
fn samples_that_cannot_serve_are_refused() {
    let samples: Vec<(f64, [f64; 3])> = cosines(9).into_iter().map(|cosine| (cosine, [0.5; 3])).collect();
    assert_eq!(rational(&samples, 5, 4), Err(RationalError::Samples { needed: 10, given: 9 }));
    let mut bad = samples.clone();
    bad[3].1[1] = f64::NAN;
    assert_eq!(rational(&bad, 2, 2), Err(RationalError::NotFinite));
}
