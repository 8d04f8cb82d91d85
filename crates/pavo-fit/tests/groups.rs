//! Groups of optical constants: the error on films on coloured metals, a mirror that stays white, and refusals.

use pavo_fit::groups::{GroupsRequest, fit_groups};
use pavo_optics::film::film_reflectance;
use pavo_optics::{BaseKind, Film, Precision};
use pavo_spectra::{ColourSpace, Illuminant, Observer, OpticalConstants, Sensitivities};

fn sensitivities() -> Sensitivities {
    Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb).expect("standard light")
}

fn request<'a>(film_ior: f64, base: &str, sensitivities: &'a Sensitivities) -> GroupsRequest<'a> {
    GroupsRequest {
        ambient_ior: 1.0,
        film: OpticalConstants::constant(film_ior, 0.0).expect("a medium"),
        base: OpticalConstants::built_in(base).expect("a metal"),
        thickness_nm: [0.0, 3000.0],
        sensitivities,
        nodes: 6,
        groups: 3,
    }
}

#[test]
fn three_groups_serve_films_on_coloured_metals() {
    let sensitivities = sensitivities();
    for (film_ior, base, rms) in [(2.6, "Cu", 6e-3), (1.77, "Au", 4e-3)] {
        let fit = fit_groups(&request(film_ior, base, &sensitivities)).expect("a sound request");
        println!("{film_ior} on {base}: rms {:.2e}, max {:.2e}", fit.rms, fit.max);
        assert!(fit.rms <= rms && fit.max <= 0.2, "{film_ior} on {base}: {fit:?}");
        assert_eq!((fit.window.weights.len(), fit.groups.len()), (6, 3));
        assert_eq!(fit.groups.iter().map(|group| group.nodes).sum::<usize>(), 6);
        for channel in 0..3 {
            let sum: f64 = fit.window.weights.iter().map(|weight| weight[channel]).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{sum}");
        }
        // Near grazing incidence everything reflects all.
        let film = Film {
            base: BaseKind::Conductor,
            total_reflection: false,
            method: fit.method(),
            channel_wavelengths_nm: [555.0; 3],
            precision: Precision::FULL,
        };
        let grazing = film_reflectance::<f64, f64>(&film, 1e-6, 300.0, 1.0, film_ior, 1.0, 0.0).to_array();
        assert!(grazing.into_iter().all(|value| (value - 1.0).abs() < 1e-3), "{grazing:?}");
    }
}

#[test]
fn a_dispersive_film_gets_an_index_for_each_group() {
    let sensitivities = sensitivities();
    let film = OpticalConstants::built_in("TiO2").expect("a medium");
    let fit = fit_groups(&GroupsRequest { film, groups: 2, ..request(2.0, "Ti", &sensitivities) });
    let fit = fit.expect("a sound request");
    assert!(fit.rms <= 6e-3, "{fit:?}");
    let indices: Vec<f64> = fit.groups.iter().map(|group| group.film.expect("its own")).collect();
    // Not the material's at any wavelength: the index also stands for how the phase changes over the group.
    assert!(indices.iter().all(|index| (2.3..3.5).contains(index)), "{indices:?}");
}

#[test]
fn bad_requests_are_refused_with_what_would_be_right() {
    let sensitivities = sensitivities();
    let good = || request(2.6, "Cu", &sensitivities);
    let glass = OpticalConstants::constant(1.2, 0.0).expect("a medium");
    let cases = [
        (GroupsRequest { groups: 0, ..good() }, "0 groups of 6"),
        (GroupsRequest { groups: 7, ..good() }, "7 groups of 6"),
        (GroupsRequest { nodes: 3, ..good() }, "3 wave numbers under a window; there are 4 to 10"),
        (GroupsRequest { thickness_nm: [10.0, 10.0], ..good() }, "from 10 to 10 nm"),
        (GroupsRequest { thickness_nm: [0.0, f64::INFINITY], ..good() }, "from 0 to inf nm"),
        (
            GroupsRequest { ambient_ior: 1.33, film: glass, ..good() },
            "1.2 at 380 nm is not above the ambient one, 1.33",
        ),
        (GroupsRequest { ambient_ior: f64::NAN, ..good() }, "the ambient index is NaN"),
    ];
    for (request, message) in cases {
        let error = fit_groups(&request).expect_err(message).to_string();
        assert!(error.contains(message), "{error}");
    }
}
