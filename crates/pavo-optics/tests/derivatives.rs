//! Derivatives of the film's colour by its thickness, its index and the angle, by dual numbers, against differences of
//! the same code in `f64`.

mod common;

use common::{Case, DIELECTRIC, colour, film, moderate_cases, order_sums};
use pavo_optics::film::film_reflectance;
use pavo_optics::{BaseKind, Film};
use pavo_shade::{Dual, Real};

/// What the colour is differentiated by.
const VARIABLES: [&str; 3] = ["thickness", "film_ior", "cos_theta1"];

/// Steps that balance the error of fourth order against the rounding of `f64`.
const STEPS: [f64; 3] = [0.1, 1e-4, 1e-4];

/// Errors are relative to the derivative and these: a change of the colour by 1 over 1000 nm, and over all angles.
const SCALES: [f64; 3] = [1e-3, 1.0, 1.0];

fn at(case: &Case, [thickness_nm, film_ior, cos_theta1]: [f64; 3]) -> Case {
    Case { thickness_nm, film_ior, cos_theta1, ..*case }
}

fn variables(case: &Case) -> [f64; 3] {
    [case.thickness_nm, case.film_ior, case.cos_theta1]
}

/// The colour with its derivatives.
fn dual_colour(film: &Film, case: &Case) -> [Dual<3>; 3] {
    let [thickness_nm, film_ior, cos_theta1] = Dual::variables(variables(case));
    let [ambient_ior, base_ior, base_kappa] = [case.ambient_ior, case.base_ior, case.base_kappa].map(Dual::lit);
    film_reflectance::<Dual<3>, Dual<3>>(film, cos_theta1, thickness_nm, ambient_ior, film_ior, base_ior, base_kappa).0
}

/// The derivatives of the channels by a variable, from central differences with an error of fourth order.
fn differences(film: &Film, case: &Case, variable: usize) -> [f64; 3] {
    let step = STEPS[variable];
    let moved = |multiple: f64| {
        let mut moved = variables(case);
        moved[variable] += multiple * step;
        colour(film, &at(case, moved))
    };
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(moved);
    core::array::from_fn(|channel| (8.0 * (c[channel] - b[channel]) - (d[channel] - a[channel])) / (12.0 * step))
}

/// Bases, and whether the code provides for total reflection into the film. The cases have none. No case of these seeds
/// is at a kink, where the kernel under a window stops closing.
const KINDS: [(u64, BaseKind, bool); 4] = [
    (90, DIELECTRIC, false),
    (90, BaseKind::Dielectric { total_reflection: true }, true),
    (91, BaseKind::Conductor, false),
    (91, BaseKind::Conductor, true),
];

#[test]
fn derivatives_of_each_sum_over_orders_are_those_of_differences() {
    for method in order_sums() {
        for (seed, base, total_reflection) in KINDS {
            let film = film(base, total_reflection, method.clone());
            let mut largest = [0.0_f64; 3];
            for case in moderate_cases(seed, base, 0.7, 300) {
                let dual = dual_colour(&film, &case);
                assert_eq!(dual.map(f64::from), colour(&film, &case), "{case:?}");
                for variable in 0..3 {
                    for (dual, expected) in dual.iter().zip(differences(&film, &case, variable)) {
                        let found = dual.derivatives[variable];
                        let error = (found - expected).abs() / (expected.abs() + SCALES[variable]);
                        let name = VARIABLES[variable];
                        assert!(error <= 1e-8, "{method:?}, {case:?}: {found} by {name}, not {expected}");
                        largest[variable] = largest[variable].max(error);
                    }
                }
            }
            println!("{base:?}: largest errors {largest:?} by {VARIABLES:?}, allowed 1e-8");
        }
    }
}
