//! Airy's closed form in real numbers against the amplitudes in complex numbers, at one wavelength, for each
//! polarisation.

mod common;

use common::{Case, Random, at_wavelength, film};
use pavo_optics::BaseKind;
use pavo_optics::airy::airy_reflectance;
use pavo_optics::film::{Media, film_reflectance, film_terms};
use std::f64::consts::PI;

/// Cases of one class.
const CASES: usize = 20_000;

/// What a class of cases is: which code is made for it, and how its cases are drawn.
struct Class {
    base: BaseKind,
    total_reflection: bool,
    seed: u64,
    draw: fn(&mut Random) -> Case,
    /// The largest error allowed, absolute.
    tolerance: f64,
}

/// Reflectance for s and p polarisation by the closed form.
fn closed_form(base: BaseKind, total_reflection: bool, case: &Case) -> [f64; 2] {
    let Case { cos_theta1, ambient_ior, film_ior, base_ior, base_kappa, .. } = *case;
    let media = Media { cos_theta1, ambient_ior, film_ior };
    let wave = media.wave(total_reflection);
    let terms = film_terms::<f64, f64>(total_reflection, media, wave, media.base_wave(base, base_ior, base_kappa));
    let phase = 2.0 * PI * case.thickness_nm * wave.q2 / case.wavelength_nm;
    // The mean of a polarisation with itself is that polarisation.
    [terms.s, terms.p].map(|terms| airy_reflectance(total_reflection, terms, terms, wave.q2_squared, phase))
}

/// Both polarisations agree with the complex amplitudes, and the film's reflectance is their mean.
fn check(class: &Class) {
    let mut random = Random::new(class.seed);
    let mut largest = 0.0_f64;
    for _ in 0..CASES {
        let case = (class.draw)(&mut random);
        let expected = case.reflectance_by_polarisation();
        let found = closed_form(class.base, class.total_reflection, &case);
        for (found, expected) in found.into_iter().zip(expected) {
            let error = (found - expected).abs();
            assert!(error <= class.tolerance, "{case:?}: {found} instead of {expected}, error {error:e}");
            largest = largest.max(error);
        }
        let Case { cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa, .. } = case;
        let film = film(class.base, class.total_reflection, at_wavelength(case.wavelength_nm));
        let colour =
            film_reflectance::<f64, f64>(&film, cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa);
        let mean = 0.5 * (found[0] + found[1]);
        assert!((colour - mean).abs().max_element() <= 1e-13, "{case:?}: {colour} instead of {mean}");
    }
    println!("largest error {largest:e}, allowed {:e}", class.tolerance);
}

/// A case with indices drawn by a function.
fn case(random: &mut Random, cos_theta1: f64, [ambient_ior, film_ior, base_ior, base_kappa]: [f64; 4]) -> Case {
    let thickness_nm = random.within(0.0, 2000.0);
    let wavelength_nm = random.within(380.0, 780.0);
    Case { cos_theta1, thickness_nm, wavelength_nm, ambient_ior, film_ior, base_ior, base_kappa }
}

#[test]
fn a_film_on_a_dielectric_reflects_as_its_amplitudes_say() {
    check(&Class {
        base: BaseKind::Dielectric { total_reflection: false },
        total_reflection: false,
        seed: 1,
        draw: |random| {
            let ambient = random.within(1.0, 1.4);
            let indices = [ambient, random.within(ambient, 2.7), random.within(ambient, 4.0), 0.0];
            let cos_theta1 = random.within(0.01, 1.0);
            case(random, cos_theta1, indices)
        },
        tolerance: 3e-13,
    });
}

#[test]
fn a_film_on_a_conductor_reflects_as_its_amplitudes_say() {
    check(&Class {
        base: BaseKind::Conductor,
        total_reflection: false,
        seed: 2,
        draw: |random| {
            let ambient = random.within(1.0, 1.4);
            let indices = [ambient, random.within(ambient, 2.7), random.within(0.04, 4.0), random.within(0.0, 8.0)];
            let cos_theta1 = random.within(0.01, 1.0);
            case(random, cos_theta1, indices)
        },
        tolerance: 3e-13,
    });
}

#[test]
fn a_base_that_may_reflect_totally_reflects_as_its_amplitudes_say() {
    check(&Class {
        base: BaseKind::Dielectric { total_reflection: true },
        total_reflection: false,
        seed: 3,
        draw: |random| {
            let base = random.within(1.0, 1.4);
            let ambient = random.within(base, 1.8);
            let indices = [ambient, random.within(ambient, 2.7), base, 0.0];
            let cos_theta1 = random.within(0.01, 1.0);
            case(random, cos_theta1, indices)
        },
        tolerance: 3e-13,
    });
}

/// An angle at which the film's normal component is away from 0, where the complex amplitudes cancel.
fn away_from_the_critical_angle(random: &mut Random, indices: [f64; 4]) -> Case {
    loop {
        let cos_theta1 = random.within(0.01, 1.0);
        let case = case(random, cos_theta1, indices);
        if case.film_normal_squared().abs() > 1e-4 {
            return case;
        }
    }
}

#[test]
fn a_film_under_frustrated_total_reflection_reflects_as_its_amplitudes_say() {
    check(&Class {
        base: BaseKind::Dielectric { total_reflection: true },
        total_reflection: true,
        seed: 4,
        draw: |random| {
            let film = random.within(1.0, 1.6);
            let indices = [random.within(film, 2.0), film, random.within(1.0, 2.0), 0.0];
            away_from_the_critical_angle(random, indices)
        },
        tolerance: 2e-12,
    });
}

#[test]
fn an_absorbing_base_under_frustrated_total_reflection_reflects_as_its_amplitudes_say() {
    check(&Class {
        base: BaseKind::Conductor,
        total_reflection: true,
        seed: 5,
        draw: |random| {
            let film = random.within(1.0, 1.6);
            let indices = [random.within(film, 2.0), film, random.within(0.04, 4.0), random.within(0.0, 8.0)];
            away_from_the_critical_angle(random, indices)
        },
        tolerance: 3e-13,
    });
}
