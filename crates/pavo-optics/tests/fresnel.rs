//! Reflectance of bare surfaces against the textbook's formulas in angles and in complex numbers.

mod common;

use common::{Case, Random};
use pavo_optics::fresnel::{
    boundary_reflectance, fresnel_conductor, fresnel_dielectric, fresnel_schlick, ior_from_reflectance,
};
use pavo_optics::wave::{NormalComponent, normal_component_absorbing, normal_component_squared, p_component_absorbing};

/// A bare base.
fn case(cos_theta1: f64, ambient_ior: f64, base_ior: f64, base_kappa: f64) -> Case {
    // Thickness, wavelength and index of the film take no part.
    Case { cos_theta1, thickness_nm: 0.0, wavelength_nm: 550.0, ambient_ior, film_ior: 1.5, base_ior, base_kappa }
}

/// The mean of both polarisations of the bare base in complex numbers.
fn bare(case: &Case) -> f64 {
    let [s, p] = case.bare_reflectance_by_polarisation();
    0.5 * (s + p)
}

#[test]
fn a_dielectric_reflects_as_the_sine_and_tangent_laws_say() {
    let mut random = Random::new(40);
    for _ in 0..5000 {
        let (ambient, base) = (random.within(1.0, 2.5), random.within(1.0, 2.5));
        let incidence = random.within(0.01, 1.56);
        let sine = ambient / base * incidence.sin();
        if sine >= 0.999 || (ambient - base).abs() < 0.01 {
            continue;
        }
        let refraction = sine.asin();
        // Born and Wolf, section 1.5.2, equation 21a.
        let s = ((incidence - refraction).sin() / (incidence + refraction).sin()).powi(2);
        let p = ((incidence - refraction).tan() / (incidence + refraction).tan()).powi(2);
        let found = fresnel_dielectric(incidence.cos(), ambient, base);
        let expected = 0.5 * (s + p);
        assert!((found - expected).abs() <= 1e-12, "{ambient} to {base} at {incidence}: {found}, not {expected}");
    }
}

#[test]
fn beyond_the_critical_angle_a_dielectric_reflects_all() {
    let mut random = Random::new(41);
    for _ in 0..5000 {
        let base = random.within(1.0, 1.8);
        let ambient = base + random.within(0.01, 1.0);
        let critical = (1.0 - (base / ambient).powi(2)).sqrt();
        let found = fresnel_dielectric(random.unit() * critical, ambient, base);
        assert_eq!(found, 1.0, "{ambient} to {base}");
        let just_above = fresnel_dielectric((critical + 1e-3).min(1.0), ambient, base);
        assert!(just_above < 0.99, "{ambient} to {base}: {just_above}");
    }
}

#[test]
fn at_brewsters_angle_p_polarisation_is_not_reflected() {
    for (ambient, base) in [(1.0_f64, 1.5_f64), (1.0, 2.4), (1.33, 1.5), (1.5, 1.0), (1.5, 1.33)] {
        let angle = (base / ambient).atan();
        let cos_theta1 = angle.cos();
        let q1 = ambient * cos_theta1 / (ambient * ambient);
        let q3 = normal_component_squared(cos_theta1, ambient, base).sqrt() / (base * base);
        let p = boundary_reflectance(q1, NormalComponent { re: q3, im: 0.0, modulus: q3 * q3 });
        assert!(p <= 1e-30, "{ambient} to {base}: {p:e}");
        // Refracted and reflected ray stand at a right angle: r_s = cos^2 - sin^2 of the angle of incidence.
        let s = (2.0 * angle).cos().powi(2);
        let found = fresnel_dielectric(cos_theta1, ambient, base);
        assert!((found - 0.5 * s).abs() <= 1e-15, "{ambient} to {base}: {found}");
    }
}

#[test]
fn at_normal_incidence_the_indices_alone_count() {
    for (ambient, base) in [(1.0, 1.5), (1.5, 1.0), (1.33, 2.4), (1.0, 1.0)] {
        let expected = f64::powi((ambient - base) / (ambient + base), 2);
        let found = fresnel_dielectric(1.0, ambient, base);
        assert!((found - expected).abs() <= 1e-16, "{ambient} to {base}: {found}");
    }
}

#[test]
fn a_conductor_reflects_as_its_complex_amplitudes_say() {
    let mut random = Random::new(42);
    let mut largest = 0.0_f64;
    for _ in 0..20_000 {
        let (cos_theta1, ambient_ior) = (random.unit(), random.within(1.0, 1.8));
        let (base_ior, base_kappa) = (random.within(0.02, 5.0), random.within(0.0, 10.0));
        let found = fresnel_conductor(cos_theta1, ambient_ior, base_ior, base_kappa);
        let case = case(cos_theta1, ambient_ior, base_ior, base_kappa);
        let error = (found - bare(&case)).abs();
        assert!(error <= 1e-14, "{case:?}: {found}, error {error:e}");
        largest = largest.max(error);
    }
    println!("largest error {largest:e}, allowed 1e-14");
}

#[test]
fn a_conductor_without_extinction_is_a_dielectric() {
    let mut random = Random::new(43);
    for _ in 0..5000 {
        let (cos_theta1, ambient, base) = (random.unit(), random.within(1.0, 2.0), random.within(1.0, 2.5));
        let conductor = fresnel_conductor(cos_theta1, ambient, base, 0.0);
        let dielectric = fresnel_dielectric(cos_theta1, ambient, base);
        let message = format!("{ambient} to {base} at {cos_theta1}: {conductor} and {dielectric}");
        assert!((conductor - dielectric).abs() <= 1e-12, "{message}");
    }
}

#[test]
fn the_normal_component_in_an_absorbing_medium_is_the_root_with_both_parts_positive() {
    let mut random = Random::new(44);
    for _ in 0..20_000 {
        let (cos_theta1, ambient) = (random.unit(), random.within(1.0, 1.8));
        let ior = num_complex::Complex64::new(random.within(0.02, 5.0), random.within(0.0, 10.0));
        let tangential = ambient * (1.0 - cos_theta1 * cos_theta1).sqrt();
        let expected = (ior * ior - tangential * tangential).sqrt();
        let found = normal_component_absorbing(cos_theta1, ambient, ior.re, ior.im);
        assert!(found.re >= 0.0 && found.im >= 0.0);
        let error = (num_complex::Complex64::new(found.re, found.im) - expected).norm();
        assert!(error <= 1e-13 * (1.0 + expected.norm()), "{ior} at {cos_theta1}: {found:?}, not {expected}");
        let p = p_component_absorbing(found, ior.re, ior.im);
        let expected = expected / (ior * ior);
        let error = (num_complex::Complex64::new(p.re, p.im) - expected).norm();
        assert!(error <= 1e-12 * (1.0 + expected.norm()), "{ior} at {cos_theta1}: {p:?}, not {expected}");
    }
}

#[test]
fn the_square_of_the_normal_component_keeps_its_digits_between_near_indices() {
    let mut random = Random::new(45);
    for _ in 0..5000 {
        let cos_theta1 = 10.0_f64.powf(random.within(-4.0, 0.0)) as f32;
        let ambient = random.within(1.0, 1.8) as f32;
        let ior = ambient + 10.0_f64.powf(random.within(-5.0, 0.0)) as f32;
        let found = f64::from(normal_component_squared(cos_theta1, ambient, ior));
        let [cos_theta1, ambient, ior] = [cos_theta1, ambient, ior].map(f64::from);
        let expected = normal_component_squared(cos_theta1, ambient, ior);
        let error = (found / expected - 1.0).abs();
        assert!(error <= 3e-7, "{ambient} to {ior} at {cos_theta1}: {found}, not {expected}, error {error:e}");
    }
}

#[test]
fn schlick_is_the_specular_colour_at_normal_and_white_at_grazing_incidence() {
    let specular = glam::DVec3::new(0.04, 0.5, 1.0);
    assert_eq!(fresnel_schlick::<f64>(1.0, specular), specular);
    assert_eq!(fresnel_schlick::<f64>(0.0, specular), glam::DVec3::ONE);
    let between = fresnel_schlick::<f64>(0.5, specular);
    let expected = specular + (1.0 - specular) / 32.0;
    assert!((between - expected).abs().max_element() <= 1e-16, "{between}");
}

#[test]
fn schlick_stays_near_fresnel_for_ordinary_glass() {
    for step in 0..=1000 {
        let cos_theta1 = f64::from(step) / 1000.0;
        let error =
            fresnel_schlick::<f64>(cos_theta1, glam::DVec3::splat(0.04)).x - fresnel_dielectric(cos_theta1, 1.0, 1.5);
        assert!(error.abs() <= 0.036, "at {cos_theta1}: {error}");
    }
}

#[test]
fn the_index_found_from_a_reflectance_reflects_that_much() {
    for ambient in [1.0, 1.33, 1.7] {
        for step in 0..=999 {
            let reflectance = f64::from(step) / 1000.0;
            let found = fresnel_dielectric(1.0, ambient, ior_from_reflectance(reflectance, ambient));
            assert!((found - reflectance).abs() <= 1e-13, "{reflectance} above {ambient}: {found}");
        }
    }
}

#[test]
fn no_reflectance_gives_an_index_that_is_not_a_number() {
    for reflectance in [-0.1, 0.0, 1e-12, 0.9998, 0.999_999, 1.0, 1.5] {
        let ior = ior_from_reflectance(reflectance, 1.0);
        assert!((1.0..=2e4).contains(&ior), "{reflectance}: {ior}");
    }
    let most = fresnel_dielectric(1.0_f64, 1.0, ior_from_reflectance(1.0, 1.0));
    assert!((most - 0.9998).abs() < 1e-5, "{most}");
}
