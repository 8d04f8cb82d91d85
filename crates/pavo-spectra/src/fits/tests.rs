use super::text::{read, stored_space, write};
use super::*;
use crate::{ColourSpace, Illuminant, Observer, Sensitivities};

fn sensitivities(observer: Observer, illuminant: Illuminant, space: ColourSpace) -> Sensitivities {
    Sensitivities::new(observer, illuminant, space).expect("a standard illuminant has a white")
}

fn d65(space: ColourSpace) -> Sensitivities {
    sensitivities(Observer::Cie1931TwoDegree, Illuminant::D65, space)
}

/// The sum over the fine grid, written out apart from [`SpectralTransform`], with the errors at D that are not those
/// of [`SensitivityFit::measure`].
fn recomputed_errors(fit: &SensitivityFit, sensitivities: &Sensitivities, samples: usize) -> (f64, f64) {
    let (mut max, mut sum) = (0.0f64, 0.0);
    for sample in 0..samples {
        let opd_um = fit.max_opd_um * (sample as f64 + 0.5) / samples as f64;
        let fitted = fit.transform_at(opd_um);
        for channel in 0..3 {
            let (mut re, mut im) = (0.0, 0.0);
            for (index, weights) in sensitivities.fine_weights().iter().enumerate() {
                let phase = std::f64::consts::TAU * opd_um * 1e3 / (360.0 + 0.25 * index as f64);
                re += weights[channel] * phase.cos();
                im += weights[channel] * phase.sin();
            }
            let error = (fitted[channel].re - re).hypot(fitted[channel].im - im);
            max = max.max(error);
            sum += error * error;
        }
    }
    (max, (sum / (3 * samples) as f64).sqrt())
}

fn assert_weights_close(fit: &SensitivityFit, what: &str) {
    for channel in 0..3 {
        let re: f64 = fit.terms.iter().map(|term| term.weight_re[channel]).sum();
        let im: f64 = fit.terms.iter().map(|term| term.weight_im[channel]).sum();
        assert!((re - 1.0).abs() < 4e-15 && im.abs() < 4e-15, "{what} channel {channel}: {re} + {im}i");
    }
    for value in fit.transform_at(0.0) {
        assert!((value.re - 1.0).abs() < 4e-15 && value.im.abs() < 4e-15, "{what}: {value} at D = 0");
    }
}

#[test]
fn every_stored_fit_keeps_a_mirror_white_and_terms_in_the_visible() {
    for spectrum in &BUILT_IN_SPECTRA {
        for fit in spectrum.stored_fits() {
            let what = format!("{} {} {}", spectrum.file, fit.family.name(), fit.terms.len());
            assert_weights_close(&fit, &what);
            assert_eq!(fit.window_um.is_some(), fit.family == FitFamily::WindowedNodes, "{what}");
            for term in &fit.terms {
                assert!(term.wave_number.iter().all(|nu| (1.0..3.0).contains(nu)), "{what}: {term:?}");
                assert!(term.decay.iter().all(|decay| *decay >= 0.0), "{what}: {term:?}");
                assert!(fit.family != FitFamily::Poles || term.decay[0] >= 0.02, "{what}: {term:?}");
            }
        }
    }
}

#[test]
fn every_family_and_count_is_built_in_for_each_spectrum() {
    for spectrum in &BUILT_IN_SPECTRA {
        let sensitivities = sensitivities(spectrum.observer, spectrum.illuminant.clone(), ColourSpace::LinearSrgb);
        for family in FitFamily::ALL {
            for count in family.counts() {
                let fit = built_in(family, count, &sensitivities, 1.0);
                assert!(fit.is_some(), "{} {} {count}", spectrum.file, family.name());
            }
            assert_eq!(built_in(family, family.counts().end() + 1, &sensitivities, 1.0), None);
        }
    }
}

#[test]
fn the_stated_errors_are_those_against_the_sum_over_the_spectrum() {
    for spectrum in &BUILT_IN_SPECTRA {
        for fit in spectrum.stored_fits() {
            // One fit per family and spectrum: the sums are slow.
            if fit.terms.len() != (fit.family.counts().start() + fit.family.counts().end()) / 2 {
                continue;
            }
            let space = stored_space(fit.family);
            let sensitivities = sensitivities(spectrum.observer, spectrum.illuminant.clone(), space);
            let (max, rms) = recomputed_errors(&fit, &sensitivities, 240);
            let what = format!("{} {} {}", spectrum.file, fit.family.name(), fit.terms.len());
            let (stated_max, stated_rms) = (fit.max_error, fit.rms_error);
            assert!(max < 1.005 * stated_max && max > 0.97 * stated_max, "{what}: max {max:e}, stated {stated_max:e}");
            assert!((rms / stated_rms - 1.0).abs() < 0.01, "{what}: rms {rms:e}, stated {stated_rms:e}");
        }
    }
}

#[test]
fn the_poles_reach_their_accuracy() {
    let limits = [(3, 0.095), (4, 0.040), (5, 0.0125), (6, 0.007), (7, 0.0045), (8, 0.0032)];
    for (count, limit) in limits {
        let fit = built_in(FitFamily::Poles, count, &d65(ColourSpace::LinearSrgb), 12.0).expect("it is built in");
        assert!(fit.max_error <= limit, "{count} poles: {:e}", fit.max_error);
    }
}

#[test]
fn every_stored_fit_stays_bounded_far_beyond_its_range() {
    for spectrum in &BUILT_IN_SPECTRA {
        for fit in spectrum.stored_fits() {
            let what = format!("{} {} {}", spectrum.file, fit.family.name(), fit.terms.len());
            let largest_from = |opd_um: f64| {
                (0..400)
                    .flat_map(|index| fit.transform_at(opd_um + 0.25 * f64::from(index)))
                    .map(|value| value.norm())
                    .fold(0.0, f64::max)
            };
            // The exact transform of red reaches 1.4 at 1.8 um, since red is negative in the blue-green.
            assert!(largest_from(fit.max_opd_um) < 3.0, "{what}: {}", largest_from(fit.max_opd_um));
            // A quadrature returns to the sum of its weights' sizes; everything else dies away.
            assert!(fit.family == FitFamily::Nodes || largest_from(60.0) < 0.1, "{what}: {}", largest_from(60.0));
        }
    }
}

#[test]
fn the_smallest_range_that_reaches_is_chosen_and_else_the_largest() {
    let sensitivities = d65(ColourSpace::LinearSrgb);
    for (asked, chosen) in [(0.0, 1.8), (1.8, 1.8), (1.81, 3.2), (5.0, 12.0), (12.0, 12.0), (100.0, 12.0)] {
        let fit = built_in(FitFamily::Poles, 5, &sensitivities, asked).expect("it is built in");
        assert_eq!(fit.max_opd_um, chosen, "asked for {asked}");
    }
}

#[test]
fn other_spectra_have_no_fit() {
    let custom = Illuminant::from_csv("D65", "wavelength_nm,value\n300,1\n900,1\n").expect("a sound table");
    for (observer, illuminant) in [(Observer::Cie1964TenDegree, Illuminant::A), (Observer::Cie1931TwoDegree, custom)] {
        let sensitivities = sensitivities(observer, illuminant, ColourSpace::LinearSrgb);
        assert_eq!(built_in(FitFamily::Poles, 5, &sensitivities, 12.0), None);
    }
    assert_eq!(built_in(FitFamily::RgbGaussians, 2, &d65(ColourSpace::Rec2020), 12.0), None);
}

#[test]
fn a_fit_carried_to_another_space_is_as_good_there() {
    for space in ColourSpace::ALL {
        let sensitivities = d65(space);
        for family in [FitFamily::Poles, FitFamily::WindowedNodes, FitFamily::SharedGaussians, FitFamily::XyzGaussians]
        {
            let fit = built_in(family, 5, &sensitivities, 12.0).expect("it is built in");
            let what = format!("{} in {}", family.name(), space.name());
            assert_weights_close(&fit, &what);
            let (max, _) = recomputed_errors(&fit, &sensitivities, 240);
            assert!((max / fit.max_error - 1.0).abs() < 0.03, "{what}: {max:e}, stated {:e}", fit.max_error);
            // The rows from normalised X, Y, Z to linear sRGB have absolute sums up to 5.2; other maps magnify less.
            let stored = built_in(family, 5, &d65(stored_space(family)), 12.0).expect("it is built in");
            assert!(fit.max_error < 5.3 * stored.max_error, "{what}: {:e}", fit.max_error);
            let tripled = family == FitFamily::XyzGaussians && space != ColourSpace::Xyz;
            assert_eq!(fit.terms.len(), if tripled { 15 } else { 5 }, "{what}");
        }
    }
}

#[test]
fn carrying_a_fit_there_and_back_changes_nothing() {
    let fit = built_in(FitFamily::Poles, 5, &d65(ColourSpace::LinearSrgb), 12.0).expect("it is built in");
    let there = combine_channels(&fit, ColourSpace::LinearSrgb, ColourSpace::AcesCg).expect("both have a white");
    let back = combine_channels(&there, ColourSpace::AcesCg, ColourSpace::LinearSrgb).expect("both have a white");
    for (term, original) in back.terms.iter().zip(&fit.terms) {
        for channel in 0..3 {
            assert!((term.weight_re[channel] - original.weight_re[channel]).abs() < 1e-12);
            assert!((term.weight_im[channel] - original.weight_im[channel]).abs() < 1e-12);
        }
    }
}

#[test]
fn text_gives_back_what_was_written() {
    for spectrum in &BUILT_IN_SPECTRA {
        let fits = spectrum.stored_fits();
        let text: String = fits.iter().map(write).collect();
        assert_eq!(read(&text).expect("it was written here"), fits, "{}", spectrum.file);
    }
}

#[test]
fn text_that_is_no_fit_is_refused_with_its_line() {
    let cases = [
        ("1,2,3", 1, "begins with `fit`"),
        ("# x\nfit,poles,1", 2, "7 cells"),
        ("fit,pole,1,12,,0,0", 1, "unknown family"),
        ("fit,nodes,0,12,,0,0", 1, "from 1 to 64"),
        ("fit,nodes,1,twelve,,0,0", 1, "finite number"),
        ("fit,nodes,1,12,,0,0\n2,1,1", 2, "4 numbers"),
        ("fit,nodes,1,12,,0,0\n2,1,1,nan", 2, "finite number"),
        ("fit,nodes,2,12,,0,0\n2,1,1,1", 2, "1 line(s)"),
        ("fit,nodes,2,12,,0,0\nfit,nodes,1,12,,0,0", 2, "lacks 2"),
    ];
    for (text, line, message) in cases {
        let error = read(text).expect_err(text);
        assert!(error.line == line && error.message.contains(message), "{text:?}: {error}");
    }
}

#[test]
fn families_are_found_by_their_names() {
    for family in FitFamily::ALL {
        assert_eq!(FitFamily::from_name(family.name()), Ok(family));
    }
    assert!(FitFamily::from_name("pole").is_err_and(|error| error.to_string().contains("poles")));
}
