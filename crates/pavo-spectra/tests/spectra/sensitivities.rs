//! Sensitivities: white is (1, 1, 1), whatever is combined.

use pavo_spectra::sensitivity::{SensitivityError, white_xyz};
use pavo_spectra::wavelength::{FINE_COUNT, fine_grid};
use pavo_spectra::{ColourSpace, Illuminant, Observer, OpticalConstants, Point, Reference, Sensitivities, Stack};

use crate::assert_close;

fn standard_illuminants() -> Vec<Illuminant> {
    Illuminant::NAMES.into_iter().map(|name| Illuminant::from_name(name).unwrap()).collect()
}

#[test]
fn a_perfect_mirror_is_white_in_every_combination() {
    // Total internal reflection at a boundary with air: R = 1 at every wavelength.
    let index = |n| OpticalConstants::constant(n, 0.0).unwrap();
    let mirror = Stack::new(1.5, index(1.5), index(1.0)).unwrap();
    for observer in Observer::ALL {
        for illuminant in standard_illuminants() {
            for space in ColourSpace::ALL {
                let what = format!("{} {} {}", observer.name(), illuminant.name(), space.name());
                let sensitivities = Sensitivities::new(observer, illuminant.clone(), space).unwrap();
                let reference = Reference::new(&sensitivities);
                for value in reference.reflectance(&mirror, Point::new(0.2, 300.0)) {
                    assert_close(&what, value, 1.0, 1e-12);
                }
            }
        }
    }
}

#[test]
fn with_the_light_of_the_space_the_densities_are_the_matrix_of_the_curves() {
    let sensitivities =
        Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb).unwrap();
    let matrix = ColourSpace::LinearSrgb.xyz_to_rgb();
    for wavelength in [400.0, 445.3, 555.5, 612.25, 700.0] {
        let curves = Observer::Cie1931TwoDegree.at(wavelength);
        for (row, value) in matrix.into_iter().zip(sensitivities.at(wavelength)) {
            let expected: f64 = row.iter().zip(curves).map(|(m, curve)| m * curve).sum();
            let expected = expected * Illuminant::D65.power(wavelength);
            assert_close(&format!("{wavelength} nm"), value, expected, 1e-13);
        }
    }
}

#[test]
fn under_other_light_xyz_is_adapted_to_the_space() {
    // A reddish reflectance under illuminant A: XYZ by the definition, scaled to D65's white, then to sRGB.
    let reflectance = |wavelength: f64| if wavelength > 590.0 { 0.8 } else { 0.1 };
    let observer = Observer::Cie1931TwoDegree;
    let mut xyz = [0.0; 3];
    let mut luminance_of_white = 0.0;
    for wavelength in fine_grid() {
        let (curves, power) = (observer.at(wavelength), Illuminant::A.power(wavelength));
        luminance_of_white += curves[1] * power;
        for (sum, curve) in xyz.iter_mut().zip(curves) {
            *sum += reflectance(wavelength) * curve * power;
        }
    }
    let white_a = white_xyz(observer, &Illuminant::A).unwrap();
    let white_d65 = white_xyz(observer, &Illuminant::D65).unwrap();
    let adapted: [f64; 3] = std::array::from_fn(|i| xyz[i] / luminance_of_white * white_d65[i] / white_a[i]);

    let sensitivities = Sensitivities::new(observer, Illuminant::A, ColourSpace::LinearSrgb).unwrap();
    for (channel, row) in ColourSpace::LinearSrgb.xyz_to_rgb().into_iter().enumerate() {
        let of_adapted: f64 = row.iter().zip(adapted).map(|(m, value)| m * value).sum();
        let of_white: f64 = row.iter().zip(white_d65).map(|(m, value)| m * value).sum();
        let weights = sensitivities.fine_weights();
        let found: f64 = fine_grid().iter().zip(weights).map(|(&w, weight)| reflectance(w) * weight[channel]).sum();
        assert_close(&format!("channel {channel}"), found, of_adapted / of_white, 1e-12);
    }
}

#[test]
fn weights_sum_to_one_on_any_grid_that_spans_the_spectrum() {
    let sensitivities = Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::Rec2020).unwrap();
    let coarse: Vec<f64> = (0..8).map(|index| 420.0 + 40.0 * f64::from(index)).collect();
    for grid in [fine_grid(), coarse] {
        let weights = sensitivities.normalised_weights(&grid).unwrap();
        assert_eq!(weights.len(), grid.len());
        for channel in 0..3 {
            assert_close("sum", weights.iter().map(|weight| weight[channel]).sum(), 1.0, 1e-13);
        }
    }
    assert_eq!(sensitivities.fine_weights().len(), FINE_COUNT);
}

#[test]
fn what_cannot_be_normalised_is_refused() {
    let sensitivities =
        Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb).unwrap();
    for (grid, channel) in [
        (vec![], "R"),
        (vec![450.0, 520.0], "R"),
        (vec![650.0], "G"),
        (vec![580.0, 600.0, 620.0], "B"),
        (vec![100.0, 2000.0], "R"),
        (vec![f64::NAN, 450.0], "R"),
    ] {
        let error = sensitivities.normalised_weights(&grid).unwrap_err();
        assert!(
            matches!(error, SensitivityError::NotNormalisable { channel: found, count, .. }
                if found == channel && count == grid.len()),
            "{grid:?}: {error}"
        );
    }
    let message = sensitivities.normalised_weights(&[650.0, 660.0]).unwrap_err().to_string();
    assert!(message.starts_with("channel G cannot be normalised over the 2 given wavelength(s): its samples sum to -"));
}

#[test]
fn an_illuminant_without_a_white_is_refused() {
    for (text, function) in
        [("wavelength_nm,value\n680,0\n690,1\n700,0\n", "Z"), ("wavelength_nm,value\n360,0\n830,0\n", "X")]
    {
        let illuminant = Illuminant::from_csv("laser", text).unwrap();
        for space in ColourSpace::ALL {
            let error = Sensitivities::new(Observer::Cie1931TwoDegree, illuminant.clone(), space).unwrap_err();
            assert_eq!(error, SensitivityError::NoWhite { illuminant: "laser".into(), function });
        }
    }
}
