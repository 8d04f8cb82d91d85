//! The sums over orders where base or film reflect totally.

mod common;

use common::{Case, Random, colour, film, order_sums};
use pavo_optics::film::film_reflectance;
use pavo_optics::{BaseKind, Film};

#[test]
fn a_base_that_reflects_totally_gives_back_all_light() {
    let base = BaseKind::Dielectric { total_reflection: true };
    let mut random = Random::new(16);
    for method in order_sums() {
        let film_on_base = film(base, false, method);
        for _ in 0..200 {
            let (base_ior, ambient_ior) = (random.within(1.0, 1.3), random.within(1.5, 1.8));
            // Beyond the critical angle of the base.
            let cos_theta1 = random.unit() * (1.0 - (base_ior / ambient_ior).powi(2)).sqrt();
            let film_ior = random.within(ambient_ior, 2.5);
            let thickness_nm = random.within(0.0, 1000.0);
            let case = Case {
                cos_theta1,
                thickness_nm,
                wavelength_nm: 500.0,
                ambient_ior,
                film_ior,
                base_ior,
                base_kappa: 0.0,
            };
            let lost = colour(&film_on_base, &case).map(|channel| (channel - 1.0).abs());
            // Under the window the base is taken to let in 1e-12 of what a clear one does.
            assert!(lost.into_iter().all(|lost| lost <= 1e-11), "{lost:?}: {film_on_base:?}, {case:?}");
        }
    }
}

/// A film that may reflect totally, above the base.
fn frustrated_case(cos_theta1: f64) -> Case {
    Case {
        cos_theta1,
        thickness_nm: 90.0,
        wavelength_nm: 500.0,
        ambient_ior: 1.7,
        film_ior: 1.3,
        base_ior: 1.6,
        base_kappa: 0.0,
    }
}

#[test]
fn below_the_critical_angle_of_the_film_the_sum_over_orders_is_used() {
    let base = BaseKind::Dielectric { total_reflection: true };
    // The film reflects totally below a cosine of 0.644.
    for cos_theta1 in [0.65, 0.7, 0.8, 0.9, 1.0] {
        let case = frustrated_case(cos_theta1);
        assert!(case.film_normal_squared() > 0.0);
        for method in order_sums() {
            let with_choice = colour(&film(base, true, method.clone()), &case);
            let without = colour(&film(base, false, method.clone()), &case);
            assert_eq!(with_choice, without, "{method:?} at {cos_theta1}");
        }
    }
}

#[test]
fn beyond_the_critical_angle_of_the_film_each_channel_is_exact_at_its_wavelength() {
    for (base, base_kappa) in [(BaseKind::Dielectric { total_reflection: true }, 0.0), (BaseKind::Conductor, 2.5)] {
        for cos_theta1 in [0.01, 0.1, 0.3, 0.5, 0.64] {
            let case = Case { base_kappa, ..frustrated_case(cos_theta1) };
            assert!(case.film_normal_squared() < 0.0);
            for method in order_sums() {
                let film = film(base, true, method);
                let found = colour(&film, &case);
                for (found, wavelength_nm) in found.into_iter().zip(film.channel_wavelengths_nm) {
                    let expected = Case { wavelength_nm, ..case }.reflectance();
                    assert!((found - expected).abs() <= 1e-12, "{film:?}, {case:?}: {found} instead of {expected}");
                }
            }
        }
    }
}

/// The colour in `f32` and in `f64`, for the same numbers.
fn in_both_precisions(film: &Film, case: &Case) -> [[f64; 3]; 2] {
    let Case { cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa, .. } = *case;
    let numbers = [cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa].map(|number| number as f32);
    let [a, b, c, d, e, f] = numbers;
    let single = film_reflectance::<f32, f32>(film, a, b, c, d, e, f).to_array().map(f64::from);
    let [a, b, c, d, e, f] = numbers.map(f64::from);
    [single, film_reflectance::<f64, f64>(film, a, b, c, d, e, f).to_array()]
}

#[test]
fn around_the_critical_angle_of_the_film_single_precision_keeps_its_digits() {
    let critical = (1.0 - (1.3_f64 / 1.7).powi(2)).sqrt();
    let mut largest = 0.0_f64;
    for (base, base_kappa) in [(BaseKind::Dielectric { total_reflection: true }, 0.0), (BaseKind::Conductor, 2.5)] {
        for offset in [-1e-3, -1e-5, -1e-6, -1e-7, 0.0, 1e-7, 1e-6, 1e-5, 1e-3] {
            for thickness_nm in [90.0, 1500.0] {
                let case = Case { base_kappa, thickness_nm, ..frustrated_case(critical + offset) };
                for method in order_sums() {
                    let [single, double] = in_both_precisions(&film(base, true, method), &case);
                    let differences = single.into_iter().zip(double).map(|(single, double)| (single - double).abs());
                    largest = differences.fold(largest, f64::max);
                }
            }
        }
    }
    assert!(largest <= 5e-5, "{largest:e}");
}
