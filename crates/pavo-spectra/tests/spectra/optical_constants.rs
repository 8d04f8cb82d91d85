//! Optical constants against published figures, and what is said beyond their ends.

use pavo_spectra::OpticalConstants;
use pavo_spectra::optical_constants::{MaterialKind, OpticalConstantsError};

use crate::assert_close;

pub fn built_in(name: &str) -> OpticalConstants {
    OpticalConstants::built_in(name).unwrap()
}

#[test]
fn measured_materials_have_the_published_values() {
    for (name, wavelength, n, k, tolerance) in [
        ("Au", 548.6, 0.43, 2.455, 1e-12),
        ("Au", (548.6 + 582.1) / 2.0, 0.36, 2.659, 1e-12),
        ("Ag", 892.0, 0.04, 6.312, 1e-12),
        ("Cu", 342.5, 1.36, 1.864, 1e-12),
        ("Ti", 354.0, 1.82, 2.87, 1e-12),
        ("Si", 826.6, 3.673, 0.005, 1e-12),
    ] {
        let (found_n, found_k) = built_in(name).at(wavelength).unwrap();
        assert_close(&format!("n of {name} at {wavelength} nm"), found_n, n, tolerance);
        assert_close(&format!("k of {name} at {wavelength} nm"), found_k, k, tolerance);
    }
}

#[test]
fn built_in_names_are_sorted_and_all_there_and_others_are_refused() {
    for name in OpticalConstants::BUILT_IN_NAMES {
        assert_eq!(built_in(name).name(), name);
        assert!(built_in(name).source().is_some() && built_in(name).range_nm().is_some());
    }
    assert!(OpticalConstants::BUILT_IN_NAMES.is_sorted());
    let error = OpticalConstants::built_in("Unobtainium").unwrap_err();
    assert_eq!(
        error.to_string(),
        "unknown material `Unobtainium`; known are Ag, Ag-Rakic, Al, Al2O3, Au, Au-Rakic, BK7, Be, Cr, Cr-Rakic, Cu, \
         Cu-Rakic, Fe, MgF2, Ni, Ni-Rakic, PMMA, Pd, Pd-Rakic, Pt, Si, Si3N4, SiO2, Ti, Ti-Rakic, TiO2, W, ZnS, chitin, \
         keratin, water"
    );
    for close in ["", "ag", "Ag ", "Ag-rakic", "Rakic", "H2O"] {
        assert!(OpticalConstants::built_in(close).is_err(), "{close:?}");
    }
}

#[test]
fn every_name_is_either_an_absorbing_or_a_dielectric_one() {
    for name in OpticalConstants::BUILT_IN_NAMES {
        let material = built_in(name);
        let dielectric = OpticalConstants::DIELECTRIC_NAMES.contains(&name);
        assert_ne!(dielectric, OpticalConstants::ABSORBING_NAMES.contains(&name), "{name}");
        assert_eq!(dielectric, material.is_dielectric(), "{name}");
        let expected = match (dielectric, name) {
            (true, _) => MaterialKind::Dielectric,
            (false, "Si") => MaterialKind::Semiconductor,
            (false, _) => MaterialKind::Metal,
        };
        assert_eq!(material.kind(), Some(expected), "{name}");
    }
    assert_eq!(
        OpticalConstants::BUILT_IN_NAMES.len(),
        OpticalConstants::ABSORBING_NAMES.len() + OpticalConstants::DIELECTRIC_NAMES.len()
    );
    for (text, dielectric) in
        [("wavelength_nm,n\n400,1.5\n500,1.4\n", true), ("wavelength_nm,n,k\n400,1.5,0\n500,1.5,0.1\n", false)]
    {
        let table = OpticalConstants::from_csv("film", text).unwrap();
        assert_eq!((table.kind(), table.is_dielectric()), (None, dielectric));
    }
    for (k, dielectric) in [(0.0, true), (0.1, false)] {
        let constant = OpticalConstants::constant(1.5, k).unwrap();
        assert_eq!((constant.kind(), constant.is_dielectric()), (None, dielectric));
    }
}

#[test]
fn every_material_has_an_index_over_the_visible_range() {
    for name in OpticalConstants::BUILT_IN_NAMES {
        let material = built_in(name);
        for quarter in 4 * 360..=4 * 830 {
            let wavelength_nm = f64::from(quarter) / 4.0;
            let (n, k) = material.extended_at(wavelength_nm);
            assert!(n.is_finite() && n > 0.0 && n < 7.0, "n of {name} at {wavelength_nm} nm: {n}");
            assert!(k.is_finite() && (0.0..10.0).contains(&k), "k of {name} at {wavelength_nm} nm: {k}");
            if let Ok(inside) = material.at(wavelength_nm) {
                assert_eq!(inside, (n, k));
            }
        }
    }
}

#[test]
fn over_the_visible_range_only_these_formulas_are_continued() {
    let below = |name: &str, nm: f64| {
        format!("{name}: the data begin at {nm} nm; the formula is continued from there down to 360 nm")
    };
    let above = |name: &str, nm: f64| {
        format!("{name}: the data end at {nm} nm; the formula is continued from there up to 830 nm")
    };
    for name in OpticalConstants::BUILT_IN_NAMES {
        let constants = built_in(name);
        let expected = match name {
            "PMMA" => vec![below(name, 436.8)],
            "TiO2" => vec![below(name, 430.0)],
            "ZnS" => vec![below(name, 405.0)],
            "chitin" | "keratin" => vec![below(name, 400.0), above(name, 600.0)],
            _ => vec![],
        };
        assert_eq!(constants.warnings_for_range(360.0, 830.0), expected);
        assert_eq!(constants.covers(360.0, 830.0), expected.is_empty(), "{name}");
    }
}

#[test]
fn beyond_its_fit_a_lorentz_drude_model_is_held_and_said() {
    let gold = built_in("Au-Rakic");
    let (low, high) = gold.range_nm().unwrap();
    assert_close("low end", low, 247.968, 1e-3);
    assert_close("high end", high, 6199.21, 1e-2);
    for (wavelength, held) in [(100.0, low), (0.0, low), (1e6, high)] {
        assert!(gold.at(wavelength).is_err());
        assert_eq!(gold.extended_at(wavelength), gold.extended_at(held));
    }
    assert_ne!(gold.extended_at(low), gold.extended_at(low + 1.0));
    assert_ne!(gold.extended_at(high), gold.extended_at(high - 1.0));
    let warnings = gold.warnings_for_range(100.0, 830.0);
    assert_eq!(warnings.len(), 1);
    assert!(warnings[0].ends_with("; n and k are held constant from there down to 100 nm"), "{warnings:?}");
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
