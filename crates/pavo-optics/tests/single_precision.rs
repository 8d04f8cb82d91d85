//! The film in `f32` against the same code in `f64` at the same numbers, where formulas are prone to cancel: around
//! critical angles, at grazing incidence, and in films between equal media.

mod common;

use common::{Random, at_wavelength, film};
use pavo_optics::BaseKind;
use pavo_optics::film::film_reflectance;

/// `cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa`.
type Point = [f32; 6];

/// Reflectance at 550 nm in `f32` and in `f64`.
fn both(base: BaseKind, total_reflection: bool, point: Point) -> [f64; 2] {
    let film = film(base, total_reflection, at_wavelength(550.0));
    let [a, b, c, d, e, f] = point;
    let single = f64::from(film_reflectance::<f32, f32>(&film, a, b, c, d, e, f).x);
    let [a, b, c, d, e, f] = point.map(f64::from);
    [single, film_reflectance::<f64, f64>(&film, a, b, c, d, e, f).x]
}

/// The errors over all points, in order of size.
fn errors(base: BaseKind, total_reflection: bool, seed: u64, draw: impl Fn(&mut Random) -> [f64; 6]) -> Vec<f64> {
    let mut random = Random::new(seed);
    let mut errors: Vec<f64> = (0..20_000)
        .map(|_| {
            let point = draw(&mut random).map(|number| number as f32);
            let [single, double] = both(base, total_reflection, point);
            assert!((-1e-4..=1.0 + 1e-4).contains(&single), "{point:?}: {single} in f32, {double} in f64");
            (single - double).abs()
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    errors
}

/// All but one in a hundred errors are below the first bound, and all below the second.
fn check(errors: &[f64], most: f64, all: f64) {
    let (ninety_ninth, largest) = (errors[errors.len() * 99 / 100], errors[errors.len() - 1]);
    println!("99th percentile {ninety_ninth:e}, largest {largest:e}");
    assert!(ninety_ninth <= most && largest <= all, "99th percentile {ninety_ninth:e}, largest {largest:e}");
}

/// A cosine with its logarithm spread evenly, down to 1e-6.
fn grazing(random: &mut Random) -> f64 {
    10.0_f64.powf(random.within(-6.0, 0.0))
}

/// A cosine near the one at which a medium of this relative index starts to reflect totally.
fn near_critical(random: &mut Random, relative: f64) -> f64 {
    let critical = (1.0 - relative * relative).sqrt();
    let offset = 10.0_f64.powf(random.within(-7.0, -1.0));
    (critical + if random.unit() < 0.5 { offset } else { -offset }).clamp(0.0, 1.0)
}

#[test]
fn a_film_on_a_dielectric_keeps_its_accuracy_down_to_grazing_incidence() {
    let errors = errors(BaseKind::Dielectric { total_reflection: false }, false, 30, |random| {
        let cos_theta1 = grazing(random);
        [cos_theta1, random.within(0.0, 1000.0), 1.0, random.within(1.2, 2.5), random.within(1.1, 3.0), 0.0]
    });
    check(&errors, 5e-7, 3e-6);
}

#[test]
fn a_film_on_a_conductor_keeps_its_accuracy_down_to_grazing_incidence() {
    let errors = errors(BaseKind::Conductor, false, 31, |random| {
        let (cos_theta1, thickness_nm) = (grazing(random), random.within(0.0, 1000.0));
        [cos_theta1, thickness_nm, 1.0, random.within(1.2, 2.5), random.within(0.1, 4.0), random.within(0.5, 8.0)]
    });
    check(&errors, 3e-6, 5e-4);
}

#[test]
fn a_film_keeps_its_accuracy_around_the_critical_angle_of_the_base() {
    let errors = errors(BaseKind::Dielectric { total_reflection: true }, false, 32, |random| {
        let (ambient, base) = (1.6, random.within(1.1, 1.4));
        let cos_theta1 = near_critical(random, base / ambient);
        [cos_theta1, random.within(0.0, 1000.0), ambient, random.within(1.6, 2.5), base, 0.0]
    });
    check(&errors, 1e-3, 3e-3);
}

#[test]
fn a_film_keeps_its_accuracy_around_its_own_critical_angle() {
    let errors = errors(BaseKind::Dielectric { total_reflection: true }, true, 33, |random| {
        let (ambient, film) = (1.6, random.within(1.1, 1.4));
        let cos_theta1 = near_critical(random, film / ambient);
        [cos_theta1, random.within(0.0, 1000.0), ambient, film, random.within(1.5, 2.5), 0.0]
    });
    check(&errors, 2e-5, 1e-4);
}

#[test]
fn a_film_between_equal_media_stays_within_zero_and_one() {
    let errors = errors(BaseKind::Dielectric { total_reflection: false }, false, 34, |random| {
        let cos_theta1 = grazing(random);
        [cos_theta1, random.within(0.0, 1000.0), 1.0, 1.33, 1.0, 0.0]
    });
    check(&errors, 5e-6, 3e-3);
}

#[test]
fn at_grazing_incidence_all_light_is_reflected() {
    let bases = [
        (BaseKind::Dielectric { total_reflection: false }, [1.0, 1.4, 1.5, 0.0]),
        (BaseKind::Dielectric { total_reflection: false }, [1.0, 1.0, 1.5, 0.0]),
        (BaseKind::Dielectric { total_reflection: false }, [1.0, 1.4, 1.4, 0.0]),
        (BaseKind::Dielectric { total_reflection: true }, [1.5, 1.6, 1.2, 0.0]),
        (BaseKind::Dielectric { total_reflection: true }, [1.5, 1.2, 1.4, 0.0]),
        (BaseKind::Conductor, [1.0, 1.4, 0.2, 3.0]),
        (BaseKind::Conductor, [1.5, 1.3, 0.2, 3.0]),
    ];
    for (base, [ambient, film, base_ior, base_kappa]) in bases {
        for thickness_nm in [0.0, 1.0, 250.0, 3000.0] {
            let point = [0.0, thickness_nm, ambient, film, base_ior, base_kappa];
            for reflectance in both(base, film < ambient, point) {
                assert_eq!(reflectance, 1.0, "{base:?}, {point:?}");
            }
        }
    }
}
