//! Illuminants against figures of the standard (CIE 15, ISO/CIE 11664-2).

use pavo_spectra::sensitivity::white_xyz;
use pavo_spectra::{Illuminant, Observer};

use crate::assert_close;

#[test]
fn names_read_back() {
    for name in Illuminant::NAMES {
        assert_eq!(Illuminant::from_name(name).unwrap().name(), name);
    }
    let error = Illuminant::from_name("d65").unwrap_err();
    assert_eq!(error.to_string(), "unknown illuminant `d65`; known are E, D65, D50, A");
}

#[test]
fn powers_are_the_published_ones() {
    for (illuminant, wavelength, expected, tolerance) in [
        (Illuminant::D65, 380.0, 49.9755, 0.0),
        (Illuminant::D65, 560.0, 100.0, 0.0),
        (Illuminant::D65, 562.5, (100.0 + 98.1671) / 2.0, 1e-12),
        (Illuminant::D65, 830.0, 60.3125, 0.0),
        (Illuminant::D50, 450.0, 87.247, 0.0),
        (Illuminant::D50, 560.0, 100.0, 0.0),
        (Illuminant::A, 380.0, 9.795_10, 5e-6),
        (Illuminant::A, 560.0, 100.0, 1e-12),
        (Illuminant::A, 780.0, 241.675, 5e-4),
        (Illuminant::E, 512.3, 100.0, 0.0),
    ] {
        let what = format!("{} at {wavelength} nm", illuminant.name());
        assert_close(&what, illuminant.power(wavelength), expected, tolerance);
    }
}

#[test]
fn white_points_are_the_published_ones() {
    for (observer, illuminant, expected) in [
        (Observer::Cie1931TwoDegree, Illuminant::E, [0.333_31, 0.333_29]),
        (Observer::Cie1931TwoDegree, Illuminant::D65, [0.312_72, 0.329_03]),
        (Observer::Cie1931TwoDegree, Illuminant::D50, [0.345_67, 0.358_51]),
        (Observer::Cie1931TwoDegree, Illuminant::A, [0.447_58, 0.407_45]),
        (Observer::Cie1964TenDegree, Illuminant::E, [0.333_30, 0.333_33]),
        (Observer::Cie1964TenDegree, Illuminant::D65, [0.313_81, 0.330_98]),
        (Observer::Cie1964TenDegree, Illuminant::D50, [0.347_73, 0.359_52]),
        (Observer::Cie1964TenDegree, Illuminant::A, [0.451_17, 0.405_94]),
    ] {
        let [x, y, z] = white_xyz(observer, &illuminant).unwrap();
        let what = format!("{} under {}", illuminant.name(), observer.name());
        assert_close(&what, x / (x + y + z), expected[0], 2e-5);
        assert_close(&what, y / (x + y + z), expected[1], 2e-5);
    }
}

#[test]
fn a_users_spectrum_is_linear_between_its_lines_and_held_beyond_with_a_warning() {
    let text = "# a lamp\nwavelength_um,value\n0.4,1\n0.5,3\n0.7,2\n";
    let lamp = Illuminant::from_csv("lamp", text).unwrap();
    assert_eq!(lamp.name(), "lamp");
    for (wavelength, expected) in [(400.0, 1.0), (450.0, 2.0), (600.0, 2.5), (700.0, 2.0), (360.0, 1.0), (830.0, 2.0)] {
        assert_close(&format!("{wavelength} nm"), lamp.power(wavelength), expected, 1e-12);
    }
    assert_eq!(
        lamp.warnings_for_range(360.0, 830.0),
        [
            "lamp: begins at 400 nm; its power there is held down to 360 nm",
            "lamp: ends at 700 nm; its power there is held up to 830 nm"
        ]
    );
    assert!(lamp.warnings_for_range(400.0, 700.0).is_empty());
    assert!(Illuminant::D65.warnings_for_range(360.0, 830.0).is_empty());
}
