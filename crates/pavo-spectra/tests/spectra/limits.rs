//! Where the Airy formula is 0 / 0, or has a known closed value.

use pavo_spectra::{OpticalConstants, Point, Stack};

use crate::assert_close;

fn stack(ambient_ior: f64, film: (f64, f64), base: (f64, f64)) -> Stack {
    let medium = |(n, k)| OpticalConstants::constant(n, k).unwrap();
    Stack::new(ambient_ior, medium(film), medium(base)).unwrap()
}

fn reflectance(stack: &Stack, cos_theta1: f64, thickness_nm: f64) -> f64 {
    stack.reflectance_at(550.0, Point { cos_theta1, thickness_nm })
}

#[test]
fn without_a_film_the_base_is_bare() {
    // Fresnel at normal incidence: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), relative to the ambient medium.
    for (ambient, n, k) in [(1.0, 1.5, 0.0), (1.0, 0.3, 2.9), (1.33, 2.4, 0.0), (1.5, 1.0, 0.0), (1.0, 4.1, 0.04)] {
        let expected = ((n - ambient) * (n - ambient) + k * k) / ((n + ambient) * (n + ambient) + k * k);
        let stack = stack(ambient, (1.77, 0.0), (n, k));
        for thickness in [0.0, -5.0, 1e-12] {
            assert_close(&format!("{ambient}/{n}+{k}i"), reflectance(&stack, 1.0, thickness), expected, 1e-13);
        }
    }
}

#[test]
fn a_film_of_the_ambient_or_of_the_base_is_no_film() {
    for (ambient, film, base) in
        [(1.0, (1.0, 0.0), (1.5, 0.0)), (1.0, (1.5, 0.0), (1.5, 0.0)), (1.0, (0.3, 2.9), (0.3, 2.9))]
    {
        let stack = stack(ambient, film, base);
        for cos_theta1 in [1.0, 0.6, 0.1, 1e-3, 0.0] {
            let bare = reflectance(&stack, cos_theta1, 0.0);
            for thickness in [1.0, 100.0, 1234.5] {
                let what = format!("{film:?} on {base:?} at {cos_theta1}, {thickness} nm");
                assert_close(&what, reflectance(&stack, cos_theta1, thickness), bare, 1e-13);
            }
        }
    }
}

#[test]
fn where_nothing_has_contrast_nothing_reflects() {
    let nothing = stack(1.33, (1.33, 0.0), (1.33, 0.0));
    let absent_soap = stack(1.0, (1.33, 0.0), (1.0, 0.0));
    for cos_theta1 in [1.0, 0.5, 1e-6, 0.0] {
        assert_eq!(reflectance(&nothing, cos_theta1, 500.0), 0.0);
        assert_eq!(reflectance(&nothing, cos_theta1, 0.0), 0.0);
        assert_eq!(reflectance(&absent_soap, cos_theta1, 0.0), 0.0);
    }
}

#[test]
fn at_grazing_incidence_everything_reflects() {
    for stack in [
        stack(1.0, (1.33, 0.0), (1.0, 0.0)),
        stack(1.0, (1.5, 0.0), (1.33, 0.0)),
        stack(1.0, (2.0, 0.0), (0.3, 2.9)),
        stack(1.5, (1.0, 0.0), (1.5, 0.0)),
        stack(1.0, (1.0, 0.0), (1.5, 0.0)),
    ] {
        // A film of 1e-15 nm changes no phase in f64, yet is a film: the formula would be 0 / 0.
        for thickness in [1e-15, 300.0] {
            assert_eq!(reflectance(&stack, 0.0, thickness), 1.0);
        }
        assert_eq!(reflectance(&stack, -0.5, 300.0), 1.0);
        assert_close("nearly grazing", reflectance(&stack, 1e-9, 300.0), 1.0, 1e-6);
    }
}

#[test]
fn at_critical_incidence_the_limit_joins_both_sides() {
    // sin(theta1) = film / ambient: the cosine in the film is 0 to rounding, where the formula itself is 0 / 0.
    for (ambient, film, base) in [(1.5, 1.0, (1.5, 0.0)), (2.0, 1.25, (1.2, 0.0)), (1.5, 1.25, (0.3, 2.9))] {
        let stack = stack(ambient, (film, 0.0), base);
        let critical = (1.0_f64 - (film / ambient) * (film / ambient)).sqrt();
        for thickness in [10.0, 300.0, 2000.0] {
            let at = reflectance(&stack, critical, thickness);
            let below = reflectance(&stack, critical - 1e-9, thickness);
            let above = reflectance(&stack, critical + 1e-9, thickness);
            assert!(at.is_finite());
            // The mean of both sides cancels the slope.
            assert_close(&format!("{ambient}/{film}/{base:?} at {thickness} nm"), at, (below + above) / 2.0, 1e-9);
        }
    }
}

#[test]
fn a_negative_zero_is_zero_absorption() {
    // The square root of a negative number on the wrong side of its cut would be a wave that grows.
    let (positive, negative) = (stack(1.5, (1.2, 0.1), (1.0, 0.0)), stack(1.5, (1.2, 0.1), (1.0, -0.0)));
    assert_eq!(reflectance(&positive, 0.2, 100.0), reflectance(&negative, 0.2, 100.0));
}

#[test]
fn no_number_in_gives_no_number_out() {
    let soap = stack(1.0, (1.33, 0.0), (1.0, 0.0));
    assert!(reflectance(&soap, f64::NAN, 300.0).is_nan());
    assert!(reflectance(&soap, 0.5, f64::NAN).is_nan());
}

#[test]
fn stacks_need_an_ambient_index_and_say_where_data_fall_short() {
    let glass = OpticalConstants::constant(1.5, 0.0).unwrap();
    for ambient in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = Stack::new(ambient, glass.clone(), glass.clone()).unwrap_err();
        assert!(error.to_string().starts_with(&format!("the ambient index is {ambient}; it should be")));
    }
    let rutile = OpticalConstants::built_in("TiO2").unwrap();
    let warnings = Stack::new(1.0, rutile, glass).unwrap().warnings();
    assert_eq!(warnings, ["TiO2: the data begin at 430 nm; the formula is continued from there down to 360 nm"]);
}
