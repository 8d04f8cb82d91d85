//! Emulated single precision: what `f32` gives where nothing is asked for, and no more than what the policy allows.

mod common;
mod random;

use pavo_shade::emulated::{Contracting, Emulated, Exact, Flushing, Loose, Policy, SwiftShader, Vulkan};
use pavo_shade::{Real, Scalar, Triple, Vector};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use random::{Step, Values, program};

/// All values of a program, numbers first.
fn values<S: Scalar>(steps: &[Step], [x, y, v @ ..]: [S; 5]) -> Vec<S> {
    let [a, b, c] = v;
    let Values { numbers, vectors, .. } = Values::new(x, y, S::Vec3::new(a, b, c)).run(steps);
    let components = vectors.into_iter().flat_map(|vector| [vector.x(), vector.y(), vector.z()]);
    numbers.into_iter().chain(components).collect()
}

/// Runs random programs with the numbers of a type and with those of `f32`.
fn compare<S: Scalar>(number: fn(f32) -> S, compare: impl Fn(&[S], &[f32]) -> Result<(), TestCaseError>) {
    let config = Config { cases: 4000, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let outcome = runner.run(&program(), |(steps, point)| {
        let point = point.map(|number| number as f32);
        compare(&values(&steps, point.map(number)), &values(&steps, point))
    });
    assert!(outcome.is_ok(), "{}", outcome.err().map_or_else(String::new, |failure| failure.to_string()));
}

#[test]
fn exact_emulation_is_f32_bit_for_bit() {
    compare(Emulated::<Exact>::new, |emulated, native| {
        for (emulated, native) in emulated.iter().map(|number| number.value()).zip(native) {
            // Which zero, and which NaN, a minimum gives is left open.
            let same = emulated.to_bits() == native.to_bits() || emulated == *native;
            prop_assert!(same || (emulated.is_nan() && native.is_nan()), "{emulated:e}, not {native:e}");
        }
        Ok(())
    });
}

#[test]
fn emulation_gives_the_same_bits_each_time() {
    let config = Config { cases: 200, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let outcome = runner.run(&program(), |(steps, point)| {
        let run =
            || values(&steps, point.map(Emulated::<Vulkan>::lit)).into_iter().map(|number| number.value().to_bits());
        prop_assert!(run().eq(run()));
        Ok(())
    });
    assert!(outcome.is_ok(), "{}", outcome.err().map_or_else(String::new, |failure| failure.to_string()));
}

type C = Emulated<Contracting>;

#[test]
fn products_are_contracted_where_they_are_added_and_nowhere_else() {
    let one = C::new(1.0);
    let [a, b, c, d] = [1.1_f32, 1.3, -1.43, 0.7];
    let [x, y, z, w] = [a, b, c, d].map(C::new);
    assert_ne!(a.mul_add(b, c), a * b + c, "numbers that tell");
    let cases = [
        ("product plus", x * y + z, a.mul_add(b, c)),
        ("plus product", z + x * y, a.mul_add(b, c)),
        ("product minus", x * y - z, a.mul_add(b, -c)),
        ("minus product", z - x * y, (-a).mul_add(b, c)),
        ("negated product", -(x * y) + z, (-a).mul_add(b, c)),
        ("two products", x * y + z * w, a.mul_add(b, c * d)),
        ("a product of a product", x * y * w + z, (a * b).mul_add(d, c)),
        ("a sum of a sum", x * y + z + z, a.mul_add(b, c) + c),
        ("a selected product", C::select(true, x * y, z) + z, a * b + c),
        ("a minimum", (x * y).min(x * y) + z, a * b + c),
        ("a quotient of a product", x * y / one + z, a * b + c),
        ("a scalar product", Triple([x, y, z]).dot(Triple([y, z, w])), c.mul_add(d, a.mul_add(b, b * c))),
    ];
    for (name, found, expected) in cases {
        assert_eq!(found.value(), expected, "{name}");
    }
}

#[test]
fn small_numbers_become_zero_and_keep_their_sign() {
    let small = f32::MIN_POSITIVE;
    let new = Emulated::<Flushing>::new;
    let cases = [
        ("a number", new(-0.5 * small), -0.0),
        ("the smallest that stays", new(small), small),
        ("a product", new(small) * new(-0.5), -0.0),
        ("a quotient", new(small) / new(2.0), 0.0),
        ("a difference", new(1.5 * small) - new(small), 0.0),
        ("a literal", Real::lit(1e-39), 0.0),
        ("an exponential", new(-90.0).exp(), 0.0),
    ];
    for (name, found, expected) in cases {
        assert_eq!(found.value().to_bits(), f32::to_bits(expected), "{name}");
    }
    assert_eq!((Emulated::<Exact>::new(small) * Real::lit(0.5)).value(), 0.5 * small);
}

/// The largest error of an operation over many numbers within [0.01, 100], ulp of the exact result.
fn largest_error<P: Policy>(
    operation: impl Fn(Emulated<P>, Emulated<P>) -> Emulated<P>,
    exact: impl Fn(f64, f64) -> f64,
    unit: impl Fn(f64, f64) -> f64,
) -> f64 {
    let mut rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut number = || 10.0_f32.powf(4.0 * rng.random::<f32>() - 2.0);
    let errors = (0..100_000).map(|_| {
        let (a, b) = (number(), number());
        let found = f64::from(operation(Emulated::new(a), Emulated::new(b)));
        let (a, b) = (f64::from(a), f64::from(b));
        (found - exact(a, b)).abs() / unit(a, exact(a, b))
    });
    errors.fold(0.0, f64::max)
}

/// The distance between the numbers of `f32` around a number.
fn ulp(number: f64) -> f64 {
    2.0_f64.powi(number.abs().log2().floor() as i32 - 23)
}

#[test]
fn errors_use_what_the_policy_allows_and_no_more() {
    type V = Emulated<Vulkan>;
    let in_ulp = |_: f64, exact: f64| ulp(exact);
    let in_exponent = |a: f64, exact: f64| ulp(exact) * (3.0 + a);
    let half = V::lit(0.5);
    let cases = [
        ("sum", largest_error::<Vulkan>(|a, b| a + b, |a, b| a + b, in_ulp), 1.0),
        ("difference", largest_error::<Vulkan>(|a, b| a - b, |a, b| a - b, in_ulp), 1.0),
        ("product", largest_error::<Vulkan>(|a, b| a * b, |a, b| a * b, in_ulp), 1.0),
        ("quotient", largest_error::<Vulkan>(|a, b| a / b, |a, b| a / b, in_ulp), 2.5),
        ("inverse root", largest_error::<Vulkan>(|a, _| a.inverse_sqrt(), |a, _| 1.0 / a.sqrt(), in_ulp), 2.0),
        // Up to 4 ulp from the inverse of the root, and that of the quotient.
        ("root", largest_error::<Vulkan>(|a, _| a.sqrt(), |a, _| a.sqrt(), in_ulp), 6.5),
        ("exponential", largest_error::<Vulkan>(|a, _| (a * half).exp(), |a, _| (0.5 * a).exp(), in_exponent), 1.0),
        ("fused", largest_error::<Vulkan>(|a, b| a * b + V::lit(1.0), |a, b| a * b + 1.0, in_ulp), 1.0),
    ];
    for (name, found, allowed) in cases {
        println!("{name}: {found:.3} of {allowed} allowed");
        assert!(found <= allowed && found >= 0.7 * allowed, "{name}: {found} of {allowed}");
    }
    // The angle in turns is off by up to 2^-23 of itself.
    let absolute = |allowed: f64| move |a: f64, _: f64| allowed + a * 2.0_f64.powi(-23);
    let sines = [
        largest_error::<SwiftShader>(|a, _| a.sin(), |a, _| a.sin(), absolute(2e-4)),
        largest_error::<SwiftShader>(|a, _| a.cos(), |a, _| a.cos(), absolute(2e-4)),
        largest_error::<Vulkan>(|a, _| a.sin(), |a, _| a.sin(), absolute(1.0 / 2048.0)),
        largest_error::<Loose>(|a, _| a.cos(), |a, _| a.cos(), absolute(4e-7)),
    ];
    for found in sines {
        assert!((0.7..=1.0).contains(&found), "a sine: {found}");
    }
}

#[test]
fn exact_results_stay_exact_and_what_is_no_number_passes_through() {
    type V = Emulated<Vulkan>;
    let lit = V::lit;
    let exact = [
        (lit(1.0) + lit(2.0), 3.0),
        (lit(1.5) * lit(1.5), 2.25),
        (lit(1.5) - lit(1.5), 0.0),
        (lit(0.0) / lit(3.0), 0.0),
        (lit(0.0).sqrt(), 0.0),
        (lit(f64::INFINITY).sqrt(), f32::INFINITY),
        (lit(0.0).inverse_sqrt(), f32::INFINITY),
        (lit(-1000.0).exp(), 0.0),
        (lit(1000.0).exp(), f32::INFINITY),
        (lit(1e38) * lit(1e38), f32::INFINITY),
        (lit(f64::NEG_INFINITY).exp(), 0.0),
        (lit(f64::NAN).max(lit(1.0)), 1.0),
    ];
    for (index, (found, expected)) in exact.into_iter().enumerate() {
        assert_eq!(found.value(), expected, "number {index}");
    }
    let none = lit(f64::NAN);
    let nothing = [none + none, none * none, none.exp(), none.sin(), lit(-1.0).sqrt(), lit(f64::INFINITY).cos()];
    assert!(nothing.into_iter().all(|number| number.value().is_nan()));
}
