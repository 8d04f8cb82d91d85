//! Optical constants against published figures, and what is said beyond their ends.

use pavo_spectra::OpticalConstants;
use pavo_spectra::optical_constants::OpticalConstantsError;

use crate::assert_close;

fn built_in(name: &str) -> OpticalConstants {
    OpticalConstants::built_in(name).unwrap()
}

#[test]
fn built_in_materials_have_the_published_values() {
    for (name, wavelength, n, k, tolerance) in [
        ("Au", 548.6, 0.43, 2.455, 1e-12),
        ("Au", (548.6 + 582.1) / 2.0, 0.36, 2.659, 1e-12),
        ("Ag", 892.0, 0.04, 6.312, 1e-12),
        ("Cu", 342.5, 1.36, 1.864, 1e-12),
        ("Ti", 354.0, 1.82, 2.87, 1e-12),
        ("Si", 826.6, 3.673, 0.005, 1e-12),
        ("SiO2", 587.561_8, 1.458_46, 0.0, 5e-6),
        ("SiO2", 404.656, 1.469_62, 0.0, 5e-6),
        ("TiO2", 589.3, 2.613, 0.0, 5e-4),
    ] {
        let (found_n, found_k) = built_in(name).at(wavelength).unwrap();
        assert_close(&format!("n of {name} at {wavelength} nm"), found_n, n, tolerance);
        assert_close(&format!("k of {name} at {wavelength} nm"), found_k, k, tolerance);
    }
}

#[test]
fn built_in_names_are_all_there_and_others_are_refused() {
    for name in OpticalConstants::BUILT_IN_NAMES {
        assert_eq!(built_in(name).name(), name);
        assert!(built_in(name).source().is_some());
    }
    let error = OpticalConstants::built_in("Unobtainium").unwrap_err();
    assert_eq!(error.to_string(), "unknown material `Unobtainium`; known are Ag, Au, Cu, Si, SiO2, Ti, TiO2");
}

#[test]
fn over_the_visible_range_only_rutile_is_continued() {
    for name in OpticalConstants::BUILT_IN_NAMES {
        let constants = built_in(name);
        let expected: &[&str] = match name {
            "TiO2" => &["TiO2: the data begin at 430 nm; the formula is continued from there down to 360 nm"],
            _ => &[],
        };
        assert_eq!(constants.warnings_for_range(360.0, 830.0), expected);
        assert_eq!(constants.covers(360.0, 830.0), expected.is_empty(), "{name}");
    }
}

#[test]
fn far_from_its_data_a_formula_is_held() {
    for (name, low, high) in [("SiO2", 210.0, 3710.0), ("TiO2", 350.0, 2500.0)] {
        let constants = built_in(name);
        for (wavelength, held) in [(low / 2.0, low), (0.0, low), (high * 10.0, high)] {
            assert_eq!(constants.extended_at(wavelength), constants.extended_at(held), "{name} at {wavelength} nm");
            assert!(constants.at(wavelength).is_err());
        }
        assert_ne!(constants.extended_at(low), constants.extended_at(low + 1.0));
        assert_ne!(constants.extended_at(high), constants.extended_at(high - 1.0));
    }
}

#[test]
fn beyond_its_ends_a_table_is_refused_or_held_and_said() {
    let film = OpticalConstants::from_csv("film", "wavelength_nm,n,k\n400,1.5,0.25\n780,1.25,0\n").unwrap();
    assert_eq!(film.range_nm(), Some((400.0, 780.0)));
    assert!(film.covers(400.0, 780.0) && !film.covers(399.0, 780.0) && !film.covers(400.0, 781.0));
    for (wavelength, held) in [(399.9, (1.5, 0.25)), (780.1, (1.25, 0.0)), (1e9, (1.25, 0.0))] {
        let error = film.at(wavelength).unwrap_err();
        assert_eq!(
            error,
            OpticalConstantsError::OutsideData {
                name: "film".into(),
                wavelength_nm: wavelength,
                low_nm: 400.0,
                high_nm: 780.0
            }
        );
        assert_eq!(film.extended_at(wavelength), held);
    }
    assert_eq!(film.at(830.0).unwrap_err().to_string(), "film: no data at 830 nm; they run from 400 to 780 nm");
    assert_eq!(
        film.warnings_for_range(360.0, 830.0),
        [
            "film: the data begin at 400 nm; n and k are held constant from there down to 360 nm",
            "film: the data end at 780 nm; n and k are held constant from there up to 830 nm"
        ]
    );
    assert!(film.at(f64::NAN).is_err());
}

#[test]
fn constants_hold_everywhere_and_must_be_indices() {
    let glass = OpticalConstants::constant(1.5, 0.0).unwrap();
    assert_eq!((glass.name(), glass.as_constant(), glass.range_nm()), ("n = 1.5", Some((1.5, 0.0)), None));
    assert_eq!(glass.at(1.0), Ok((1.5, 0.0)));
    assert!(glass.covers(0.0, f64::INFINITY) && glass.warnings_for_range(0.0, 1e9).is_empty());
    assert_eq!(OpticalConstants::constant(2.7, 3.8).unwrap().name(), "n = 2.7, k = 3.8");
    for (n, k) in [(0.0, 0.0), (-1.5, 0.0), (1.5, -0.1), (f64::NAN, 0.0), (1.5, f64::NAN), (f64::INFINITY, 0.0)] {
        let error = OpticalConstants::constant(n, k).unwrap_err();
        assert!(error.to_string().starts_with(&format!("the constant index n = {n}, k = {k}: n should be")));
    }
}
