//! The index of a base that is known by its F0: it reflects that much, and a conductor's comes back from its F0 and its
//! edge tint.

mod common;

use common::Random;
use pavo_optics::f0::index_from_f0;
use pavo_optics::fresnel::{fresnel_conductor, fresnel_dielectric, ior_from_reflectance};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// The largest reflectance that an index is made for.
const LARGEST: f64 = 0.9999 * 0.9999;

/// Reflectivity and edge tint of a complex index, as Gulbrandsen 2014 has them: `r` from Fresnel's equations at normal
/// incidence, `g` as the place of the index between the largest and the smallest for it.
fn reflectivity_and_edge_tint(ior: f64, kappa: f64) -> [f64; 2] {
    let power = |sum: f64| sum * sum + kappa * kappa;
    let r = power(ior - 1.0) / power(ior + 1.0);
    let largest = (1.0 + r.sqrt()) / (1.0 - r.sqrt());
    let smallest = (1.0 - r) / (1.0 + r);
    [r, (largest - ior) / (largest - smallest)]
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(14),
        ..ProptestConfig::default()
    })]

    #[test]
    fn the_index_comes_back_from_f0_and_edge_tint(ior in 0.02_f64..8.0, kappa in 0.0_f64..8.0) {
        let [f0, edge_tint] = reflectivity_and_edge_tint(ior, kappa);
        // Weak absorbers of an index below 1 lie beyond an edge tint of 1.
        prop_assume!((1e-6..0.999).contains(&f0) && (0.0..=1.0).contains(&edge_tint));
        let found = index_from_f0(f0, edge_tint);
        prop_assert!((found.ior - ior).abs() < 1e-8 * ior.max(1.0), "{} for {}", found.ior, ior);
        // Where kappa vanishes it is a root of what is left of two terms, in the description as in the inverse.
        prop_assert!((found.kappa * found.kappa - kappa * kappa).abs() < 1e-8 * (1.0 + ior * ior + kappa * kappa));
    }

    #[test]
    fn a_conductor_reflects_its_f0_at_normal_incidence(f0 in 0.0..=1.0_f64, edge_tint in 0.0..=1.0_f64) {
        let index = index_from_f0(f0, edge_tint);
        prop_assert!(index.ior > 0.0 && index.kappa >= 0.0);
        let found = fresnel_conductor(1.0, 1.0, index.ior, index.kappa);
        prop_assert!((found - f0.min(LARGEST)).abs() < 1e-10, "{} for {}", found, f0);
    }

    #[test]
    fn in_single_precision_a_base_reflects_its_f0(f0 in 0.0..=1.0_f32, edge_tint in 0.0..=1.0_f32) {
        let expected = f64::from(f0).min(LARGEST);
        let index = index_from_f0(f0, edge_tint);
        let [ior, kappa] = [index.ior, index.kappa].map(f64::from);
        prop_assert!((fresnel_conductor(1.0, 1.0, ior, kappa) - expected).abs() < 1e-6);
        let ior = f64::from(ior_from_reflectance(f0, 1.0));
        prop_assert!((fresnel_dielectric(1.0, 1.0, ior) - expected).abs() < 1e-6);
    }

    #[test]
    fn in_single_precision_the_index_is_stable_up_to_its_ends(
        power in -12.0_f64..-0.01, from_above: bool, edge_tint in 0.0..=1.0_f32
    ) {
        // F0 near 0, or near 1.
        let small = 10.0_f64.powf(power);
        let f0 = if from_above { 1.0 - small } else { small } as f32;
        let single = index_from_f0(f0, edge_tint);
        let double = index_from_f0(f64::from(f0), f64::from(edge_tint));
        // What the rounding of the root of F0 makes of what is missing to 1, and twice that.
        let missing = (1.0 - f64::from(f0).sqrt()).max(1e-4);
        let allowed = 2.0 * f64::from(f32::EPSILON) * (2.0 + 0.5 / missing);
        for (single, double) in [(single.ior, double.ior), (single.kappa, double.kappa)] {
            prop_assert!((f64::from(single) - double).abs() <= allowed * double, "{} for {}, F0 {}", single, double, f0);
        }
    }
}

#[test]
fn without_an_edge_tint_a_conductor_is_the_dielectric_of_its_f0() {
    let mut random = Random::new(14);
    for _ in 0..1000 {
        let f0 = random.unit();
        let index = index_from_f0(f0, 0.0);
        let dielectric = ior_from_reflectance(f0, 1.0);
        assert!(index.kappa == 0.0 && (index.ior / dielectric - 1.0).abs() < 1e-12, "{index:?}, {dielectric}");
    }
}

#[test]
fn what_reflects_nothing_is_air_and_what_reflects_all_is_held_at_its_largest() {
    for edge_tint in [0.0, 0.3, 1.0] {
        let air = index_from_f0(0.0, edge_tint);
        assert_eq!([air.ior, air.kappa], [1.0, 0.0]);
        for beyond in [LARGEST, 1.0, 1.5, f64::INFINITY] {
            let found = index_from_f0(beyond, edge_tint);
            let held = index_from_f0(LARGEST, edge_tint);
            assert!((found.ior / held.ior - 1.0).abs() < 1e-9 && (found.kappa - held.kappa).abs() <= 1e-9 * held.kappa);
        }
    }
}
