//! Dielectrics' formulas against published indices.

use crate::assert_close;
use crate::optical_constants::built_in;

/// Each index to the digits printed: half a unit of the last one may be lost to rounding.
#[test]
fn formulas_give_the_published_indices_to_the_digits_printed() {
    for (name, wavelength_nm, printed) in [
        // At the helium d line.
        ("Al2O3", 587.561_8, "1.768"),
        ("BK7", 587.561_8, "1.51680"),
        ("MgF2", 587.561_8, "1.3777"),
        ("PMMA", 587.561_8, "1.491"),
        ("SiO2", 587.561_8, "1.45846"),
        ("ZnS", 587.561_8, "2.368"),
        ("water", 587.561_8, "1.3334"),
        // BK7 by its data sheet, from the mercury h line to the t line.
        ("BK7", 404.656_1, "1.53024"),
        ("BK7", 479.991_4, "1.52283"),
        ("BK7", 486.132_7, "1.52238"),
        ("BK7", 546.074, "1.51872"),
        ("BK7", 656.272_5, "1.51432"),
        ("BK7", 852.11, "1.50980"),
        ("BK7", 1013.98, "1.50731"),
        // Sapphire as optics makers list it.
        ("Al2O3", 488.0, "1.7753"),
        ("Al2O3", 532.0, "1.7717"),
        ("Al2O3", 632.8, "1.7659"),
        ("Al2O3", 780.0, "1.76068"),
        ("Al2O3", 1064.0, "1.75449"),
        // Fused silica at the h line, PMMA at the g, F and C lines, ZnS at the e line, silicon nitride at 1550 nm.
        ("SiO2", 404.656, "1.46962"),
        ("PMMA", 486.132_7, "1.497"),
        ("PMMA", 656.272_5, "1.488"),
        ("ZnS", 546.074, "2.388"),
        ("Si3N4", 1550.0, "1.9963"),
        // Rutile at the sodium D line.
        ("TiO2", 589.3, "2.613"),
        // Chitin and keratin, printed beside their formula.
        ("chitin", 400.0, "1.572"),
        ("chitin", 500.0, "1.552"),
        ("chitin", 600.0, "1.541"),
        ("keratin", 400.0, "1.569"),
        ("keratin", 500.0, "1.556"),
        ("keratin", 600.0, "1.548"),
    ] {
        let decimals = printed.len() as i32 - 2;
        let (n, k) = built_in(name).at(wavelength_nm).unwrap();
        let tolerance = 0.5001 * 10.0_f64.powi(-decimals);
        assert_close(&format!("n of {name} at {wavelength_nm} nm"), n, printed.parse().unwrap(), tolerance);
        assert_eq!(k, 0.0, "{name}");
    }
}

/// The formulas with their published coefficients, by a separate code, to six decimals: far from the visible middle each
/// coefficient shows.
#[test]
fn formulas_agree_with_a_separate_code_at_both_ends() {
    for (name, at_360, at_1550) in [
        ("Al2O3", 1.794_672, 1.746_182),
        ("BK7", 1.537_190, 1.500_652),
        ("MgF2", 1.386_558, 1.370_519),
        ("PMMA", 1.514_905, 1.479_017),
        ("Si3N4", 2.125_887, 1.996_280),
        ("SiO2", 1.475_289, 1.444_024),
        ("TiO2", 3.296_107, 2.453_185),
        ("ZnS", 2.670_358, 2.271_671),
        ("chitin", 1.584_901, 1.520_663),
        ("keratin", 1.577_448, 1.534_452),
        ("water", 1.348_072, 1.316_014),
    ] {
        for (wavelength_nm, expected) in [(360.0, at_360), (1550.0, at_1550)] {
            let (n, _) = built_in(name).extended_at(wavelength_nm);
            assert_close(&format!("n of {name} at {wavelength_nm} nm"), n, expected, 0.5001e-6);
        }
    }
}

/// Water's formula is relative to a vacuum; the index 1.33299 of the tables is relative to air (n = 1.000271 at 20 degrees
/// Celsius), on the sodium D line.
#[test]
fn water_relative_to_air_has_the_index_of_the_tables() {
    let (n, _) = built_in("water").at(589.3).unwrap();
    assert_close("water against air", n / 1.000_271, 1.332_99, 1e-5);
}

/// Away from resonances an index falls with the wavelength: so must every formula, where it is continued too.
#[test]
fn formulas_fall_with_the_wavelength_wherever_they_are_continued() {
    for name in pavo_spectra::OpticalConstants::DIELECTRIC_NAMES {
        let constants = built_in(name);
        let at = |wavelength_nm: f64| constants.extended_at(wavelength_nm).0;
        for wavelength_nm in 350..2500 {
            let (here, next) = (at(f64::from(wavelength_nm)), at(f64::from(wavelength_nm + 1)));
            assert!(next < here && next > 1.0, "{name}: {here} at {wavelength_nm} nm, then {next}");
        }
    }
}
