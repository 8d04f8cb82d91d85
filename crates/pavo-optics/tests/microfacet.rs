//! GGX and Smith-Schlick against their printed forms, and GGX's normalisation.

mod common;

use common::Random;
use pavo_optics::microfacet::{
    cook_torrance, ggx_distribution, smith_schlick_k_image_based, smith_schlick_k_punctual, smith_schlick_over_cosine,
};
use std::f64::consts::PI;

/// GGX as it is printed: `alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2)`.
fn printed_ggx(n_dot_h: f64, alpha: f64) -> f64 {
    let spread = n_dot_h * n_dot_h * (alpha * alpha - 1.0) + 1.0;
    alpha * alpha / (PI * spread * spread)
}

/// Smith-Schlick as it is printed: `G1(v) = (n.v) / ((n.v)(1 - k) + k)`.
fn printed_smith_schlick(cosine: f64, k: f64) -> f64 {
    cosine / (cosine * (1.0 - k) + k)
}

#[test]
fn the_projected_microfacets_cover_the_surface_once() {
    for alpha in [1.0, 0.7, 0.25, 0.1, 0.01, 0.0025] {
        // With s the squared sine, the integral of D(h) (n.h) over the hemisphere is that of pi D over s; with
        // s = alpha^2 (e^y - 1) its integrand is smooth at any alpha. Simpson's rule.
        let square = alpha * alpha;
        let end = (1.0 / square + 1.0_f64).ln();
        let intervals = 2000;
        let integrand = |step: i32| {
            let growth = (end * f64::from(step) / f64::from(intervals)).exp();
            let sine_squared = (square * (growth - 1.0)).min(1.0);
            PI * ggx_distribution((1.0 - sine_squared).sqrt(), alpha) * square * growth
        };
        let weight = |step: i32| match step {
            0 => 1.0,
            step if step == intervals => 1.0,
            step if step % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let sum: f64 = (0..=intervals).map(|step| weight(step) * integrand(step)).sum();
        let integral = sum * end / f64::from(intervals) / 3.0;
        assert!((integral - 1.0).abs() <= 1e-9, "alpha {alpha}: {integral}");
    }
}

#[test]
fn ggx_is_its_printed_form() {
    let mut random = Random::new(50);
    for _ in 0..20_000 {
        let (n_dot_h, alpha) = (random.unit(), random.within(0.05, 1.0));
        let (found, expected) = (ggx_distribution(n_dot_h, alpha), printed_ggx(n_dot_h, alpha));
        // The printed form cancels near n.h = 1, by 1 / alpha^2.
        let allowed = 4e-16 * (4.0 + 2.0 / (alpha * alpha));
        assert!((found / expected - 1.0).abs() <= allowed, "{n_dot_h}, {alpha}: {found}, not {expected}");
    }
}

#[test]
fn ggx_peaks_at_the_normal() {
    for alpha in [1.0, 0.3, 0.01, 0.0025] {
        let peak: f64 = ggx_distribution(1.0, alpha);
        assert!((peak * PI * alpha * alpha - 1.0).abs() <= 1e-15, "{alpha}: {peak}");
    }
    assert!((ggx_distribution(0.3_f64, 1.0) - 1.0 / PI).abs() <= 1e-16, "alpha 1 is uniform");
}

#[test]
fn ggx_keeps_its_accuracy_in_f32_on_smooth_surfaces() {
    let alpha = 0.0025_f32;
    let mut largest = 0.0_f64;
    for step in 0..20_000 {
        // Every cosine that f32 has just below 1, then wider steps.
        let n_dot_h =
            if step < 1000 { f32::from_bits(1.0_f32.to_bits() - step) } else { 1.0 - (step - 1000) as f32 / 19_000.0 };
        let expected = ggx_distribution(f64::from(n_dot_h), f64::from(alpha));
        largest = largest.max((f64::from(ggx_distribution(n_dot_h, alpha)) / expected - 1.0).abs());
    }
    println!("largest relative error {largest:e}, allowed 1e-6");
    assert!(largest <= 1e-6, "{largest:e}");
}

#[test]
fn smith_schlick_times_the_cosine_is_its_printed_form() {
    let mut random = Random::new(51);
    for _ in 0..20_000 {
        let (cosine, k) = (random.unit(), random.within(1e-3, 1.0));
        let found = smith_schlick_over_cosine(cosine, k) * cosine;
        assert!((found - printed_smith_schlick(cosine, k)).abs() <= 4e-16, "{cosine}, {k}: {found}");
        assert!((0.0..=1.0).contains(&found));
    }
    assert_eq!(smith_schlick_over_cosine(1.0, 0.3), 1.0);
    assert_eq!(smith_schlick_over_cosine(0.0, 0.25), 4.0, "finite at the horizon");
}

#[test]
fn k_depends_on_the_roughness_as_for_punctual_lights_and_for_images() {
    assert_eq!([0.0, 0.5, 1.0].map(smith_schlick_k_punctual), [0.125, 0.28125, 0.5]);
    assert_eq!([0.0, 0.5, 1.0].map(smith_schlick_k_image_based), [0.0, 0.125, 0.5]);
}

#[test]
fn cook_torrance_without_fresnel_is_g_d_over_four_cosines() {
    let mut random = Random::new(52);
    for _ in 0..5000 {
        let [n_dot_l, n_dot_v, n_dot_h, alpha, k] = core::array::from_fn(|_| random.within(0.05, 1.0));
        let found = cook_torrance(n_dot_l, n_dot_v, n_dot_h, alpha, k);
        let shadowing = printed_smith_schlick(n_dot_l, k) * printed_smith_schlick(n_dot_v, k);
        let expected = shadowing * printed_ggx(n_dot_h, alpha) / (4.0 * n_dot_l * n_dot_v);
        assert!((found / expected - 1.0).abs() <= 1e-11, "{found}, not {expected}");
        let exchanged = cook_torrance(n_dot_v, n_dot_l, n_dot_h, alpha, k);
        assert!((found / exchanged - 1.0).abs() <= 4e-16, "light and view may be exchanged");
    }
}
