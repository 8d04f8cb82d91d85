//! Fits of scenes: the error on points of the test's own, repeatability, refusals, and the description as a graph.

use pavo_fit::scene::{Form, MAX_NODES, SceneFitError, SceneFitRequest, fit_scene};
use pavo_optics::fitted::{FittedFilm, FittedForm, FittedMean, FittedNode, fitted_reflectance};
use pavo_shade::{Graph, Input, Rate, Scalar, interpret};
use pavo_spectra::{ColourSpace, Illuminant, Observer, OpticalConstants, Point, Reference, Sensitivities, Stack};

fn sensitivities() -> Sensitivities {
    Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb).expect("standard light")
}

fn medium(n: f64, k: f64) -> OpticalConstants {
    OpticalConstants::constant(n, k).expect("a medium")
}

/// Oil on water.
fn oil(sensitivities: &Sensitivities) -> SceneFitRequest<'_> {
    SceneFitRequest {
        ambient_ior: 1.0,
        film: medium(1.5, 0.0),
        base: medium(1.33, 0.0),
        thickness_nm: [0.0, 3000.0],
        sensitivities,
        form: Some(Form::Kernel),
        nodes: 3,
        seed: 1,
        rms_error: Some(1.5e-3),
        max_error: None,
    }
}

#[test]
fn a_kernel_with_three_waves_serves_oil_on_water() {
    let sensitivities = sensitivities();
    let request = oil(&sensitivities);
    let fit = fit_scene(&request).expect("the error is reachable");
    assert!(fit.rms <= 1.5e-3 && fit.max <= 1e-2, "{fit:?}");

    // Points that neither the fit nor its own judgement has seen.
    let stack = Stack::new(1.0, request.film.clone(), request.base.clone()).expect("a stack");
    let reference = Reference::new(&sensitivities);
    let fraction = |index: u32, step: f64| (0.77 + step * f64::from(index)).fract();
    let points: Vec<Point> = (1..=600)
        .map(|index| {
            Point::new(0.01 + 0.99 * fraction(index, 2.0_f64.sqrt()), 3000.0 * fraction(index, 3.0_f64.sqrt()))
        })
        .collect();
    let expected = reference.prepare(&stack).reflectance_of_each(&points);
    let mut squares = 0.0;
    for (point, expected) in points.iter().zip(&expected) {
        let found = fitted_reflectance::<f32>(&fit.film, point.cos_theta1 as f32, point.thickness_nm as f32);
        for (found, expected) in found.to_array().into_iter().zip(expected) {
            squares += (f64::from(found) - expected).powi(2);
        }
    }
    let rms = (squares / 1800.0).sqrt();
    assert!(rms < 1.6e-3, "{rms}");

    assert_eq!(fit_scene(&request).as_ref(), Ok(&fit), "the same seed gives the same fit");
    let other = fit_scene(&SceneFitRequest { seed: 2, ..request }).expect("another seed does as well");
    assert!((other.rms - fit.rms).abs() < 1e-4, "{} {}", other.rms, fit.rms);
}

#[test]
fn a_damped_kernel_with_four_waves_serves_a_soap_film() {
    let sensitivities = sensitivities();
    let request = SceneFitRequest {
        film: medium(1.33, 0.0),
        base: medium(1.0, 0.0),
        form: Some(Form::DampedKernel),
        nodes: 4,
        rms_error: Some(6e-3),
        ..oil(&sensitivities)
    };
    let fit = fit_scene(&request).expect("the error is reachable");
    assert!(fit.rms <= 6e-3 && fit.max <= 0.06, "{} {}", fit.rms, fit.max);
}

#[test]
fn a_film_of_one_thickness_needs_the_angle_alone() {
    let sensitivities = sensitivities();
    let request = SceneFitRequest {
        film: medium(1.38, 0.0),
        base: medium(1.52, 0.0),
        thickness_nm: [300.0, 300.0],
        form: None,
        rms_error: Some(5e-4),
        ..oil(&sensitivities)
    };
    let fit = fit_scene(&request).expect("the error is reachable");
    assert_eq!((fit.form, fit.film.nodes.len()), (Form::AngleOnly, 0));
}

#[test]
fn an_unreachable_error_is_refused_with_the_best_fit() {
    let sensitivities = sensitivities();
    let request = SceneFitRequest {
        form: Some(Form::FirstOrder),
        nodes: 1,
        rms_error: Some(1e-6),
        max_error: Some(1e-5),
        ..oil(&sensitivities)
    };
    let error = fit_scene(&request).expect_err("one wave is not enough");
    let SceneFitError::Missed { best, rms_error: Some(1e-6), max_error: Some(1e-5) } = &error else {
        panic!("{error:?}")
    };
    assert!(best.rms > 1e-6 && best.film.nodes.len() == 1);
    assert!(error.to_string().contains("asked for: RMS 1.0e-6, largest 1.0e-5"), "{error}");
}

#[test]
fn bad_requests_are_refused_with_what_would_be_right() {
    let sensitivities = sensitivities();
    let good = || oil(&sensitivities);
    let cases = [
        (SceneFitRequest { ambient_ior: -1.0, ..good() }, "the ambient index is -1"),
        (SceneFitRequest { film: medium(0.9, 0.0), ..good() }, "the film's index 0.9 at 555 nm is not above"),
        (SceneFitRequest { thickness_nm: [300.0, 200.0], ..good() }, "from 300 to 200 nm"),
        (SceneFitRequest { thickness_nm: [-1.0, 200.0], ..good() }, "from -1 to 200 nm"),
        (SceneFitRequest { thickness_nm: [0.0, f64::NAN], ..good() }, "from 0 to NaN nm"),
        (SceneFitRequest { thickness_nm: [0.0, 1e6], ..good() }, "numbers from 0 to 20000"),
        (SceneFitRequest { nodes: 0, ..good() }, "nodes = 0; a fit has 1 to 12"),
        (SceneFitRequest { nodes: MAX_NODES + 1, ..good() }, "nodes = 13; a fit has 1 to 12"),
        (SceneFitRequest { rms_error: Some(0.0), ..good() }, "rms_error = 0; an error"),
        (SceneFitRequest { max_error: Some(f64::NAN), ..good() }, "max_error = NaN; an error"),
        (SceneFitRequest { form: Some(Form::AngleOnly), ..good() }, "is for a film of one thickness"),
    ];
    for (request, message) in cases {
        let error = fit_scene(&request).expect_err(message);
        assert!(error.to_string().contains(message), "{error}");
    }
}

/// A film of each form, with coefficients that mean nothing.
fn films() -> Vec<FittedFilm> {
    let row = |scale: f64| vec![0.31 * scale, -0.07 * scale, 0.013];
    let forms = [
        FittedForm::AngleOnly,
        FittedForm::FirstOrder { contrast: row(1.0) },
        FittedForm::Kernel { contrast: row(1.0), sharpness: row(0.8) },
        FittedForm::DampedKernel {
            contrast: row(1.0),
            round_trip: row(0.8),
            exponent: 3.4,
            damping_slope: 2e-4,
            log_taper: 6.9,
            first_order: None,
        },
        FittedForm::DampedKernel {
            contrast: row(1.0),
            round_trip: row(0.8),
            exponent: 3.4,
            damping_slope: 2e-4,
            log_taper: 6.9,
            first_order: Some(row(0.3)),
        },
        FittedForm::ThreeOrders { cosines: [1.0, 0.7, 0.4].map(row), sines: [0.2, 0.3, 0.5].map(row) },
    ];
    let means = [FittedMean::Shared(row(2.0)), FittedMean::PerChannel(vec![[0.5, 0.6, 0.7], [0.01, 0.02, 0.04]])];
    let node = |index: usize| FittedNode {
        wave_number: 1.6e-3 + 2e-4 * index as f64,
        phase: 0.1 * index as f64,
        weight: [0.4, 0.3, 0.1 + 0.2 * index as f64],
    };
    let film = |form: &FittedForm, mean: &FittedMean| FittedFilm {
        ambient_ior: 1.0,
        film_ior: 1.5,
        thickness_nm: [0.0, 3000.0],
        angle_offset: 0.6,
        window_decay: 2e-7,
        mean: mean.clone(),
        form: form.clone(),
        nodes: (0..3).map(node).collect(),
    };
    forms.iter().flat_map(|form| means.iter().map(move |mean| film(form, mean))).collect()
}

#[test]
fn the_graph_computes_what_the_function_computes() {
    for film in films() {
        let graph = Graph::new();
        let cos_theta1 = graph.input(Input::scalar("cos_theta1", "", 0.0, 1.0, Rate::Pixel));
        // A film of one thickness leaves the second input unused.
        let thickness_nm = graph.input(Input::scalar("thickness_nm", "nm", 0.0, 3000.0, Rate::Pixel));
        graph.output("reflectance", record(&film, cos_theta1, thickness_nm).as_vec3());
        let program = graph.program();
        for (cos, thickness) in [(0.0, 10.0), (0.03, 0.0), (0.4, 333.0), (0.77, 1200.0), (1.0, 3000.0)] {
            let found = interpret::evaluate(&program, &[cos, thickness][..program.input_components()]);
            let expected = fitted_reflectance::<f64>(&film, cos, thickness).to_array();
            assert_eq!(found[0].map(f64::to_bits), expected.map(f64::to_bits), "{film:?} at {cos}, {thickness}");
        }
    }
}

fn record<S: Scalar>(film: &FittedFilm, cos_theta1: S, thickness_nm: S) -> S::Vec3 {
    fitted_reflectance(film, cos_theta1, thickness_nm)
}
