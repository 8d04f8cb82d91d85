//! The series over orders of interference against the amplitudes in complex numbers and against the closed form.

mod common;

use common::{Case, DIELECTRIC, at_wavelength, colour, film, moderate_cases, series_at_wavelength, wide_fit};
use num_complex::Complex64;
use pavo_optics::film::film_reflectance;
use pavo_optics::{BaseKind, Film, GaussianTerm, Method, TransformTable};
use pavo_shade::{Table, Vector};
use std::f64::consts::TAU;

/// The film's reflectance where all channels are alike.
fn reflectance(film: &Film, case: &Case) -> f64 {
    let [r, g, b] = colour(film, case);
    assert!(r == g && g == b, "the channels are alike");
    r
}

#[test]
fn each_order_is_the_mean_over_both_polarisations_of_the_sum_of_amplitudes() {
    for (seed, base) in [(10, DIELECTRIC), (11, BaseKind::Conductor)] {
        let mut largest = 0.0_f64;
        for case in moderate_cases(seed, base, 1.0, 500) {
            for order in 1..=12 {
                let found = reflectance(&film(base, false, series_at_wavelength(case.wavelength_nm, order)), &case);
                let z = |m: u32| Complex64::from_polar(1.0, TAU * f64::from(m) * case.opd_nm() / case.wavelength_nm);
                let expected = case.sum_over_orders(order as u32, z);
                let error = (found - expected).abs();
                assert!(error <= 3e-14, "{case:?}, order {order}: {found} instead of {expected}");
                largest = largest.max(error);
            }
        }
        println!("{base:?}: largest error {largest:e}, allowed 3e-14");
    }
}

#[test]
fn the_series_converges_to_the_closed_form() {
    for (seed, base) in [(12, DIELECTRIC), (13, BaseKind::Conductor)] {
        for case in moderate_cases(seed, base, 0.8, 200) {
            let exact = reflectance(&film(base, false, at_wavelength(case.wavelength_nm)), &case);
            let error = |order: usize| {
                let series = film(base, false, series_at_wavelength(case.wavelength_nm, order));
                (reflectance(&series, &case) - exact).abs()
            };
            // What the orders above the last one can add at most.
            let amplitude = case.round_trip_amplitude();
            let rest = |order: usize| 2.0 * amplitude.powi(order as i32 + 1) / (1.0 - amplitude) + 1e-12;
            for order in 1..=12 {
                assert!(
                    error(order) <= rest(order),
                    "{case:?}, order {order}: {:e} over {:e}",
                    error(order),
                    rest(order)
                );
            }
            assert!(error(200) <= 1e-9, "{case:?}: {:e}", error(200));
        }
    }
}

#[test]
fn each_further_order_shrinks_the_largest_error_over_the_phase() {
    let case = |thickness_nm: f64| Case {
        cos_theta1: 0.5,
        thickness_nm,
        wavelength_nm: 500.0,
        ambient_ior: 1.0,
        film_ior: 2.4,
        base_ior: 1.4,
        base_kappa: 0.0,
    };
    let largest = |order: usize| {
        let series = film(DIELECTRIC, false, series_at_wavelength(500.0, order));
        let thicknesses = (0..=120).map(f64::from);
        thicknesses.map(case).map(|case| (reflectance(&series, &case) - case.reflectance()).abs()).fold(0.0, f64::max)
    };
    let errors: Vec<f64> = (1..=12).map(largest).collect();
    println!("largest error by order: {errors:?}");
    assert!(errors.is_sorted_by(|before, after| *before > 2.0 * after), "{errors:?}");
}

#[test]
fn a_transform_in_tables_gives_the_series_of_the_gaussians_that_it_was_sampled_from() {
    let (fit, step_nm, rows) = (wide_fit(), 10.0, 4000);
    let carrier = [0.0108, 0.0117, 0.0135];
    let envelope = |row: usize, part: fn(Complex64) -> f64| -> [f64; 3] {
        let opd_nm = row as f64 * step_nm;
        std::array::from_fn(|channel| {
            let of = |term: &GaussianTerm| {
                let decay = -term.decay[channel] * opd_nm * opd_nm;
                let phase = (term.angular_wave_number[channel] - carrier[channel]) * opd_nm;
                term.weight[channel] * Complex64::new(decay, phase).exp()
            };
            part(fit.terms.iter().map(of).sum())
        })
    };
    let table = |name: &str, part: fn(Complex64) -> f64| {
        Table::new(name, "", (0..rows).map(|row| envelope(row, part)).collect())
    };
    let transform =
        TransformTable { step_nm, carrier, re: table("re", |value| value.re), im: table("im", |value| value.im) };
    for (seed, base) in [(15, DIELECTRIC), (16, BaseKind::Conductor)] {
        let by_formula = film(base, false, Method::Series { order: 4, fit: fit.clone() });
        let by_table = film(base, false, Method::TabulatedSeries { order: 4, transform: transform.clone() });
        for case in moderate_cases(seed, base, 0.9, 200) {
            for (found, expected) in colour(&by_table, &case).into_iter().zip(colour(&by_formula, &case)) {
                assert!((found - expected).abs() <= 2e-4, "{case:?}: {found} instead of {expected}");
            }
        }
    }
}

#[test]
fn the_series_of_a_gaussian_is_the_mean_of_the_exact_reflectance_over_it() {
    let fit = wide_fit();
    let series = film(DIELECTRIC, false, Method::Series { order: 100, fit: fit.clone() });
    for case in moderate_cases(15, DIELECTRIC, 0.7, 10) {
        let found = colour(&series, &case);
        for (channel, found) in found.into_iter().enumerate() {
            let steps = 400;
            let mut expected = 0.0;
            for term in &fit.terms {
                let deviation = (2.0 * term.decay[channel]).sqrt();
                for step in -steps..=steps {
                    let offset = 8.0 * f64::from(step) / f64::from(steps);
                    let density = (-0.5 * offset * offset).exp() / TAU.sqrt() * 8.0 / f64::from(steps);
                    let wavelength_nm = TAU / (term.angular_wave_number[channel] + offset * deviation);
                    expected += term.weight[channel] * density * Case { wavelength_nm, ..case }.reflectance();
                }
            }
            let error = (found - expected).abs();
            assert!(error <= 1e-10, "{case:?}, channel {channel}: {error:e}");
        }
    }
}

#[test]
fn channels_with_bases_of_their_own_are_computed_apart() {
    let series = film(BaseKind::Conductor, false, Method::Series { order: 3, fit: wide_fit() });
    let (base_ior, base_kappa) = ([0.2, 0.5, 1.4], [3.4, 2.3, 1.9]);
    let together =
        film_reflectance::<f64, glam::DVec3>(&series, 0.7, 350.0, 1.0, 1.5, base_ior.into(), base_kappa.into());
    for channel in 0..3 {
        let alone = film_reflectance::<f64, f64>(&series, 0.7, 350.0, 1.0, 1.5, base_ior[channel], base_kappa[channel]);
        assert_eq!([together.x(), together.y(), together.z()][channel], alone[channel]);
    }
}

#[test]
fn the_weights_of_the_wavelengths_make_the_colour() {
    let nodes = [(450.0, [0.1, 0.2, 0.7]), (550.0, [0.3, 0.5, 0.3]), (610.0, [0.6, 0.3, 0.0])];
    let node = |(wavelength_nm, weight)| pavo_optics::SpectralNode { wavelength_nm, weight, base: None, film: None };
    let film = film(DIELECTRIC, false, Method::Spectral { nodes: nodes.map(node).to_vec() });
    for case in moderate_cases(17, DIELECTRIC, 1.0, 200) {
        let found = colour(&film, &case);
        for (channel, found) in found.into_iter().enumerate() {
            let term = |(wavelength_nm, weight): &(f64, [f64; 3])| {
                weight[channel] * Case { wavelength_nm: *wavelength_nm, ..case }.reflectance()
            };
            let expected: f64 = nodes.iter().map(term).sum();
            assert!((found - expected).abs() <= 1e-12, "{case:?}, channel {channel}");
        }
    }
}

#[test]
fn a_dispersive_base_has_its_index_at_each_wavelength() {
    // Indices like those of gold.
    let gold = [(450.0, (1.4, 1.9)), (550.0, (0.4, 2.5)), (650.0, (0.15, 3.6))];
    let nodes: Vec<_> = gold
        .iter()
        .zip([[0.0, 0.1, 0.9], [0.2, 0.8, 0.1], [0.8, 0.1, 0.0]])
        .map(|(&(wavelength_nm, base), weight)| pavo_optics::SpectralNode {
            wavelength_nm,
            weight,
            base: Some(base),
            film: None,
        })
        .collect();
    let film = film(BaseKind::Conductor, false, Method::Spectral { nodes: nodes.clone() });
    for thickness_nm in [0.0, 80.0, 500.0] {
        let case = Case {
            cos_theta1: 0.8,
            thickness_nm,
            wavelength_nm: 550.0,
            ambient_ior: 1.0,
            film_ior: 1.45,
            base_ior: 1.0,
            base_kappa: 0.0,
        };
        let found = colour(&film, &case);
        for (channel, found) in found.into_iter().enumerate() {
            let term = |node: &pavo_optics::SpectralNode| {
                let (base_ior, base_kappa) = node.base.expect("each has one");
                let case = Case { wavelength_nm: node.wavelength_nm, base_ior, base_kappa, ..case };
                node.weight[channel] * case.reflectance()
            };
            let expected: f64 = nodes.iter().map(term).sum();
            assert!((found - expected).abs() <= 1e-12, "{thickness_nm} nm, channel {channel}");
        }
    }
}
