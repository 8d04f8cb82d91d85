//! The observers against figures of the standard (CIE 018, CIE 15).

use pavo_spectra::Observer;

use crate::assert_close;

#[test]
fn names_read_back() {
    for observer in Observer::ALL {
        assert_eq!(Observer::from_name(observer.name()), Ok(observer));
    }
    let error = Observer::from_name("cie1931").unwrap_err();
    assert_eq!(error.to_string(), "unknown observer `cie1931`; known are cie1931-2deg, cie1964-10deg");
}

#[test]
fn one_nanometre_sums_are_the_published_ones() {
    for (observer, sums) in [
        (Observer::Cie1931TwoDegree, [106.865_469_49, 106.856_917_10, 106.892_251_28]),
        (Observer::Cie1964TenDegree, [116.648_519_51, 116.661_877_10, 116.673_980_51]),
    ] {
        for (curve, expected) in sums.into_iter().enumerate() {
            let sum = (360..=830).map(|wavelength| observer.at(f64::from(wavelength))[curve]).sum();
            assert_close(&format!("{} curve {curve}", observer.name()), sum, expected, 6e-9);
        }
    }
}

#[test]
fn samples_are_the_published_ones() {
    for (observer, wavelength, expected) in [
        (Observer::Cie1931TwoDegree, 360.0, [0.000_129_9, 0.000_003_917, 0.000_606_1]),
        (Observer::Cie1931TwoDegree, 445.0, [0.348_06, 0.0298, 1.7826]),
        (Observer::Cie1931TwoDegree, 555.0, [0.512_050_1, 1.0, 0.005_749_999]),
        (Observer::Cie1931TwoDegree, 600.0, [1.0622, 0.631, 0.0008]),
        (Observer::Cie1964TenDegree, 440.0, [0.383_734, 0.062_077, 1.967_28]),
        (Observer::Cie1964TenDegree, 600.0, [1.123_99, 0.658_341, 0.0]),
    ] {
        for (curve, value) in observer.at(wavelength).into_iter().enumerate() {
            assert_close(&format!("{} at {wavelength} nm", observer.name()), value, expected[curve], 1e-6);
        }
    }
}

#[test]
fn between_samples_the_curves_are_smooth() {
    // The cubic through the four nearest samples: a straight line between two is off by up to 1.2e-4.
    let y = |wavelength: f64| Observer::Cie1931TwoDegree.at(wavelength)[1];
    for wavelength in 400..700 {
        let x = f64::from(wavelength);
        let cubic = (9.0 * (y(x) + y(x + 1.0)) - y(x - 1.0) - y(x + 2.0)) / 16.0;
        assert_close(&format!("y at {x} + 0.5 nm"), y(x + 0.5), cubic, 5e-6);
    }
}

#[test]
fn outside_the_standard_the_curves_are_zero() {
    for observer in Observer::ALL {
        for wavelength in [359.99, 830.01, -1.0, f64::INFINITY, f64::NAN] {
            assert_eq!(observer.at(wavelength), [0.0; 3]);
        }
        assert!(observer.at(830.0)[0] > 0.0);
    }
}
