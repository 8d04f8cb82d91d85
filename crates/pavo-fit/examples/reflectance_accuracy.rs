//! Errors of the reflectance that the built-in fits give, in f64, against the exact spectral reference: the five dielectric
//! and the five conductor classes, 2 degree observer, D65, linear sRGB.
//!
//! `cargo run --release -p pavo-fit --example reflectance_accuracy [FILE]`; a file of fits stands in for the built-in ones.

use pavo_fit::sensitivity::{FilmSamples, film_classes};
use pavo_spectra::fits::{BUILT_IN_SPECTRA, FitFamily, text};
use pavo_spectra::{ColourSpace, Illuminant, Observer, Point, Sensitivities};

/// Points of each class in a low-discrepancy sequence (Roberts 2018, R2), and on the edges.
fn places(thickest_nm: f64, count: usize) -> Vec<Point> {
    let scale = |fraction: f64| 0.01 + 0.99 * fraction;
    let mut places: Vec<Point> = (0..count)
        .map(|index| {
            let sequence = |step: f64| (0.5 + step * index as f64).fract();
            let cos_theta1 = scale(sequence(0.754_877_666_246_692_7));
            Point { cos_theta1, thickness_nm: thickest_nm * sequence(0.569_840_290_998_053_2) }
        })
        .collect();
    for index in 0..33 {
        let fraction = f64::from(index) / 32.0;
        places.extend([1.0, 0.01].map(|cos_theta1| Point { cos_theta1, thickness_nm: thickest_nm * fraction }));
        places.push(Point { cos_theta1: scale(fraction), thickness_nm: 0.0 });
    }
    places
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let sensitivities = Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb)?;
    let fits = match std::env::args_os().nth(1) {
        Some(path) => text::read(&std::fs::read_to_string(path)?)?,
        None => BUILT_IN_SPECTRA[0].stored_fits(),
    };
    println!("family, count, fitted to um, thickest nm: dielectric rms, max; conductor rms, max");
    for thickest_nm in [600.0, 3000.0] {
        let of_kind = |is_conductor: bool| {
            let classes: Vec<_> =
                film_classes().into_iter().filter(|class| class.is_conductor == is_conductor).collect();
            FilmSamples::new(&sensitivities, &classes, |_| places(thickest_nm, 2048))
        };
        let kinds = [of_kind(false), of_kind(true)];
        for fit in &fits {
            if fit.family == FitFamily::Nodes && fit.max_opd_um * 1e3 < 2.0 * thickest_nm {
                continue;
            }
            let errors: Vec<_> = kinds.iter().filter_map(|samples| samples.errors(fit)).collect();
            if let [dielectric, conductor] = errors.as_slice() {
                println!(
                    "{:8} {:2} {:4} {thickest_nm:5}: {:.2e} {:.1e}; {:.2e} {:.1e}",
                    fit.family.name(),
                    fit.terms.len(),
                    fit.max_opd_um,
                    dielectric.rms,
                    dielectric.max,
                    conductor.rms,
                    conductor.max
                );
            }
        }
    }
    Ok(())
}
