//! Fits each form to scenes that it is for, and prints the errors on held-out points, evaluated in `f32`.
//!
//! `cargo run --release -p pavo-fit --example scene_fits [words of the lines to keep]`

use pavo_fit::scene::{Form, SceneFitError, SceneFitRequest, fit_scene};
use pavo_spectra::{ColourSpace, Illuminant, Observer, OpticalConstants, Sensitivities};
use std::error::Error;
use std::time::Instant;

/// A medium: constant `n` and `k`, or a built-in one by its name.
enum Medium {
    Constant(f64, f64),
    BuiltIn(&'static str),
}

use Form::{AngleOnly, CorrectedKernel, DampedKernel, FirstOrder, Kernel, ThreeOrders};
use Medium::{BuiltIn, Constant};

/// Name, film, base, range of thickness in nm, form (none: chosen for an RMS error), waves, the RMS error to reach.
type Line = (&'static str, Medium, Medium, [f64; 2], Option<Form>, usize, f64);

const OIL: (Medium, Medium) = (Constant(1.5, 0.0), Constant(1.33, 0.0));
const MAGNESIUM_FLUORIDE: (Medium, Medium) = (Constant(1.38, 0.0), Constant(1.52, 0.0));
const NACRE: (Medium, Medium) = (Constant(1.53, 0.0), Constant(1.66, 0.0));
const SOAP: (Medium, Medium) = (Constant(1.33, 0.0), Constant(1.0, 0.0));
const HIGH_CONTRAST: (Medium, Medium) = (Constant(2.5, 0.0), Constant(1.2, 0.0));
const TITANIA_ON_TITANIUM: (Medium, Medium) = (Constant(2.4, 0.0), Constant(2.7, 3.8));

fn line(
    name: &'static str,
    media: (Medium, Medium),
    thickest: f64,
    form: Option<Form>,
    nodes: usize,
    rms: f64,
) -> Line {
    (name, media.0, media.1, [0.0, thickest], form, nodes, rms)
}

fn lines() -> Vec<Line> {
    let mut lines = Vec::new();
    for (name, media) in [("oil", || OIL), ("mgf2", || MAGNESIUM_FLUORIDE), ("nacre", || NACRE)] as [(_, fn() -> _); 3]
    {
        lines.push(line(name, media(), 3000.0, Some(FirstOrder), 3, 2e-3));
        lines.push(line(name, media(), 3000.0, Some(Kernel), 3, 1.5e-3));
        lines.push(line(name, media(), 3000.0, Some(Kernel), 4, 1e-3));
        lines.push(line(name, media(), 600.0, Some(Kernel), 4, 2e-4));
        lines.push((name, media().0, media().1, [100.0, 400.0], Some(Kernel), 3, 6e-4));
        lines.push((name, media().0, media().1, [300.0, 300.0], Some(AngleOnly), 1, 3e-4));
    }
    lines.extend([
        line("soap", SOAP, 3000.0, Some(DampedKernel), 4, 6e-3),
        line("soap", SOAP, 3000.0, Some(DampedKernel), 5, 6e-3),
        line("soap", SOAP, 3000.0, Some(DampedKernel), 6, 2.5e-3),
        line("high-contrast", HIGH_CONTRAST, 3000.0, Some(CorrectedKernel), 5, 1.5e-3),
        line("high-contrast", HIGH_CONTRAST, 3000.0, Some(CorrectedKernel), 6, 1.5e-3),
        ("high-contrast", HIGH_CONTRAST.0, HIGH_CONTRAST.1, [300.0, 300.0], Some(AngleOnly), 1, 2.6e-3),
        line("tio2/ti-constant", TITANIA_ON_TITANIUM, 3000.0, Some(ThreeOrders), 4, 6e-3),
        line("tio2/ti", (BuiltIn("TiO2"), BuiltIn("Ti")), 3000.0, Some(ThreeOrders), 4, 6e-3),
        line("sio2/si", (BuiltIn("SiO2"), BuiltIn("Si")), 3000.0, Some(ThreeOrders), 4, 6e-3),
        line("2.6/cu", (Constant(2.6, 0.0), BuiltIn("Cu")), 3000.0, Some(ThreeOrders), 4, 6e-3),
        line("1.77/au", (Constant(1.77, 0.0), BuiltIn("Au")), 3000.0, Some(ThreeOrders), 4, 6e-3),
        line("2.0/ag", (Constant(2.0, 0.0), BuiltIn("Ag")), 3000.0, Some(ThreeOrders), 4, 6e-3),
    ]);
    for (name, film, base) in [("tio2/ti", "TiO2", "Ti"), ("sio2/si", "SiO2", "Si")] {
        lines.push((name, BuiltIn(film), BuiltIn(base), [100.0, 400.0], Some(ThreeOrders), 4, 9e-3));
    }
    lines.push(("2.6/cu", Constant(2.6, 0.0), BuiltIn("Cu"), [100.0, 400.0], Some(ThreeOrders), 4, 9e-3));
    lines.push(("2.0/ag", Constant(2.0, 0.0), BuiltIn("Ag"), [100.0, 400.0], Some(ThreeOrders), 4, 9e-3));
    lines.extend([
        line("oil-chosen", OIL, 3000.0, None, 6, 1.5e-3),
        line("soap-chosen", SOAP, 3000.0, None, 6, 6e-3),
        line("tio2/ti-chosen", TITANIA_ON_TITANIUM, 3000.0, None, 6, 6e-3),
    ]);
    lines
}

fn constants(medium: &Medium) -> Result<OpticalConstants, Box<dyn Error>> {
    Ok(match *medium {
        Constant(n, k) => OpticalConstants::constant(n, k)?,
        BuiltIn(name) => OpticalConstants::built_in(name)?,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let sensitivities = Sensitivities::new(Observer::Cie1931TwoDegree, Illuminant::D65, ColourSpace::LinearSrgb)?;
    println!(
        "{:<17} {:>9} {:<17} {:>5} {:>4} {:>8} {:>8} {:>8} {:>6}",
        "scene", "nm", "form", "nodes", "cost", "rms", "max", "asked", "s"
    );
    for (name, film, base, thickness_nm, form, nodes, asked) in lines() {
        let thickness = format!("{}-{}", thickness_nm[0], thickness_nm[1]);
        let form_name = form.map_or("chosen", Form::name);
        let text = format!("{name} {thickness} {form_name} {nodes}");
        if !words.iter().all(|word| text.contains(word.as_str())) {
            continue;
        }
        let request = SceneFitRequest {
            ambient_ior: 1.0,
            film: constants(&film)?,
            base: constants(&base)?,
            thickness_nm,
            sensitivities: &sensitivities,
            form,
            nodes,
            seed: 1,
            rms_error: Some(asked),
            max_error: None,
        };
        let begin = Instant::now();
        let (fit, verdict) = match fit_scene(&request) {
            Ok(fit) => (fit, ""),
            Err(SceneFitError::Missed { best, .. }) => (*best, "missed"),
            Err(error) => return Err(error.into()),
        };
        println!(
            "{name:<17} {thickness:>9} {:<17} {:>5} {:>4} {:>8.5} {:>8.4} {asked:>8.4} {:>6.1} {verdict}",
            fit.form.name(),
            fit.film.nodes.len(),
            fit.cost,
            fit.rms,
            fit.max,
            begin.elapsed().as_secs_f64()
        );
    }
    Ok(())
}
