use pavo_spectra::fits::{BUILT_IN_SPECTRA, FitFamily, SensitivityFit, built_in};
use pavo_spectra::{ColourSpace, Illuminant, Observer, Point, Sensitivities};

use super::random::SplitMix64;
use super::*;

fn request(family: FitFamily, count: usize, max_opd_um: f64) -> FitRequest {
    FitRequest {
        family,
        count,
        observer: Observer::Cie1931TwoDegree,
        illuminant: Illuminant::D65,
        space: ColourSpace::LinearSrgb,
        max_opd_um,
        seed: BUILT_IN_SEED,
    }
}

fn d65() -> Sensitivities {
    Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb).expect("D65 has a white")
}

fn stored(family: FitFamily, count: usize, max_opd_um: f64) -> SensitivityFit {
    let fit = built_in(family, count, &d65(), max_opd_um).expect("it is built in");
    assert_eq!(fit.max_opd_um, max_opd_um);
    fit
}

/// Points that no fit was made on.
fn samples(is_conductor: bool, thickest_nm: f64) -> FilmSamples {
    let classes: Vec<FilmClass> =
        film_classes().into_iter().filter(|class| class.is_conductor == is_conductor).collect();
    assert_eq!(classes.len(), 5);
    let mut random = SplitMix64::new(77);
    FilmSamples::new(&d65(), &classes, |_| {
        let mut place =
            || Point { cos_theta1: random.between(0.01, 1.0), thickness_nm: random.between(0.0, thickest_nm) };
        (0..400).map(|_| place()).collect()
    })
}

#[test]
fn making_a_built_in_fit_again_gives_the_committed_data() {
    // Libraries of mathematics differ in the last digit, and many iterations follow one another: hence a tolerance.
    for (family, count, max_opd_um) in [(FitFamily::Poles, 3, 12.0), (FitFamily::Nodes, 6, 1.8)] {
        let made = fit(&request(family, count, max_opd_um)).expect("a built-in request is sound");
        let stored = stored(family, count, max_opd_um);
        assert!((made.max_error / stored.max_error - 1.0).abs() < 0.01, "{:e}, {:e}", made.max_error, stored.max_error);
        for (made, stored) in made.terms.iter().zip(&stored.terms) {
            for channel in 0..3 {
                assert!((made.wave_number[channel] - stored.wave_number[channel]).abs() < 1e-3, "{made:?} {stored:?}");
                assert!((made.decay[channel] - stored.decay[channel]).abs() < 1e-2, "{made:?} {stored:?}");
                assert!((made.weight_re[channel] - stored.weight_re[channel]).abs() < 2e-2, "{made:?} {stored:?}");
            }
        }
    }
}

#[test]
fn the_same_request_gives_the_same_fit() {
    let request = request(FitFamily::SharedGaussians, 2, 6.0);
    assert_eq!(fit(&request), fit(&request));
}

#[test]
fn every_family_fits_other_spaces_and_keeps_a_mirror_white() {
    for family in FitFamily::ALL {
        let count = (family.counts().start() + family.counts().end()) / 2;
        let request =
            FitRequest { space: ColourSpace::Rec2020, illuminant: Illuminant::A, ..request(family, count, 1.8) };
        let fit = fit(&request).expect("a sound request");
        for value in fit.transform_at(0.0) {
            assert!((value.re - 1.0).abs() < 4e-15 && value.im.abs() < 4e-15, "{}: {value}", family.name());
        }
        assert!(fit.max_error < 0.06, "{}: {:e}", family.name(), fit.max_error);
        let tripled = if family == FitFamily::XyzGaussians { 3 } else { 1 };
        assert_eq!(fit.terms.len(), count * tripled);
    }
}

#[test]
fn the_reflectance_of_windowed_nodes_and_poles_is_as_accurate_as_they_promise() {
    // Root mean square and largest error, dielectric and conductor, films up to 3000 nm.
    let limits = [
        (FitFamily::WindowedNodes, 6, [(1.7e-3, 0.1), (1.8e-3, 0.1)]),
        (FitFamily::WindowedNodes, 8, [(1.2e-3, 0.1), (1.3e-3, 0.1)]),
        (FitFamily::Poles, 5, [(6e-4, 8e-3), (8e-4, 6e-3)]),
        (FitFamily::Poles, 6, [(3.6e-4, 4e-3), (4.7e-4, 3e-3)]),
    ];
    let kinds = [samples(false, 3000.0), samples(true, 3000.0)];
    for (family, count, limits) in limits {
        let fit = stored(family, count, 12.0);
        for (samples, (rms, max)) in kinds.iter().zip(limits) {
            let errors = samples.errors(&fit).expect("the family has a closed form");
            assert!(errors.rms < rms && errors.max < max, "{} {count}: {errors:?}", family.name());
        }
    }
    assert_eq!(kinds[0].errors(&stored(FitFamily::SharedGaussians, 3, 12.0)), None);
}

#[test]
fn the_data_has_every_built_in_request() {
    for spectrum in &BUILT_IN_SPECTRA {
        let fits = spectrum.stored_fits();
        let requests = built_in_requests(spectrum);
        assert_eq!(fits.len(), requests.len(), "{}", spectrum.file);
        for (fit, request) in fits.iter().zip(requests) {
            let found = (fit.family, fit.terms.len(), fit.max_opd_um);
            assert_eq!(found, (request.family, request.count, request.max_opd_um), "{}", spectrum.file);
        }
    }
}

#[test]
fn requests_out_of_bounds_are_refused_with_what_would_be_right() {
    let cases = [
        (request(FitFamily::Poles, 2, 12.0), "3 to 8 terms; 2"),
        (request(FitFamily::Nodes, 17, 12.0), "4 to 16 terms; 17"),
        (request(FitFamily::Nodes, 8, 0.0), "from 0.5 to 40"),
        (request(FitFamily::Nodes, 8, f64::NAN), "from 0.5 to 40"),
    ];
    for (request, message) in cases {
        let error = fit(&request).expect_err(message).to_string();
        assert!(error.contains(message), "{error}");
    }
}

#[test]
fn nodes_are_accurate_on_films_thin_for_their_range() {
    let fit = stored(FitFamily::Nodes, 10, 6.0);
    let thin = samples(false, 100.0).errors(&fit).expect("the family has a closed form");
    let thick = samples(false, 3000.0).errors(&fit).expect("the family has a closed form");
    assert!(thin.rms < 2e-3, "{thin:?}");
    assert!(thick.rms > 5.0 * thin.rms, "nodes ring beyond their range: {thick:?}");
}
