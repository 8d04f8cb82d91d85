//! What tells two functions apart besides their arguments: constants and types in generics, and where they stand.

mod common;

use common::check_program;
use pavo_shade::{Real, shade};

/// Several times a number.
#[shade]
fn times<R: Real, const N: usize>(x: R) -> R {
    (1..N).fold(x, |sum, _| sum + x)
}

#[test]
fn a_const_generic_makes_a_definition_for_each_value() {
    check_program(
        |[x, _, _]| vec![times::<_, 2>(x), times::<_, 3>(x)],
        &["times(x) = (x + x)", "times(x) = ((x + x) + x)"],
        &["times(x)", "times(x)"],
    );
}

/// A choice made by a type.
trait Choice {
    const FACTOR: f64;
}

struct Two;
struct Three;

impl Choice for Two {
    const FACTOR: f64 = 2.0;
}

impl Choice for Three {
    const FACTOR: f64 = 3.0;
}

/// A multiple, by a type.
#[shade]
fn multiple<R: Real, C: Choice>(x: R) -> R {
    x * R::lit(C::FACTOR)
}

#[test]
fn a_type_parameter_makes_a_definition_for_each_type() {
    check_program(
        |[x, _, _]| vec![multiple::<_, Two>(x), multiple::<_, Three>(x)],
        &["multiple(x) = (x * 2)", "multiple(x) = (x * 3)"],
        &["multiple(x)", "multiple(x)"],
    );
}

fn plus_one<R: Real>(x: R) -> R {
    /// Not the other one.
    #[shade]
    fn helper<R: Real>(x: R) -> R {
        x + 1.0
    }
    helper(x)
}

fn plus_two<R: Real>(x: R) -> R {
    /// Not the other one.
    #[shade]
    fn helper<R: Real>(x: R) -> R {
        x + 2.0
    }
    helper(x)
}

#[test]
fn two_functions_of_one_name_in_one_module_stay_two() {
    check_program(
        |[x, _, _]| vec![plus_one(x), plus_two(x)],
        &["helper(x) = (x + 1)", "helper(x) = (x + 2)"],
        &["helper(x)", "helper(x)"],
    );
}
