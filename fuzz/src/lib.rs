//! What is fuzzed: each function takes any bytes, and panics where something does not hold.
//!
//! The fuzzer calls these functions, and so does a test of the workspace, which reads this file.

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use pavo::points_table::PointsTable;
use pavo::scene::{Base, FilmMedium, IlluminantSource, Scene, starter};
use pavo::{Shading, ShadingQuantity, Variant};
use pavo_spectra::OpticalConstants;
use pavo_spectra::illuminant::Illuminant;
use std::path::Path;
use std::sync::LazyLock;

/// What is fuzzed.
pub type Target = fn(&[u8]);

/// The targets by name; the corpus of each lies in the folder of that name.
pub const TARGETS: [(&str, Target); 4] =
    [("scene", scene), ("spectrum", spectrum), ("points", points), ("variant", variant)];

/// A scene is read or refused with an error that can be drawn. One that is read is written and read again as the same,
/// and has a graph whose evaluation ends.
pub fn scene(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let scene = match Scene::from_toml("fuzzed.toml", &text, Path::new("")) {
        Ok(scene) => scene,
        Err(error) => {
            assert!(!error.to_string().is_empty() && !error.help_text().is_empty(), "{error:?}");
            if let Some(span) = error.span() {
                assert!(text.get(span.clone()).is_some(), "{span:?} is no span of the text");
            }
            return drawn(&error);
        }
    };
    scene.validate().expect("what was read is valid");
    if names_a_file(&scene) {
        return;
    }
    for variant in ["spectral:n=16", "series:m=1", "fresnel"] {
        let variant: Variant = variant.parse().expect("a variant");
        let shading = match Shading::new(&scene, &variant) {
            Ok(shading) => shading,
            Err(error) => {
                drawn(&error);
                continue;
            }
        };
        let quantity = ShadingQuantity::Reflectance;
        let point: Vec<f64> = shading
            .inputs(quantity)
            .iter()
            .flat_map(|input| std::iter::repeat_n((input.low + input.high) / 2.0, input.components()))
            .collect();
        let colour = shading.evaluate(quantity, &point);
        assert!(colour.iter().all(|channel| channel.is_finite()), "{variant}: {colour:?} at {point:?}");
    }
}

/// A table over the wavelength, of optical constants or of an illuminant, is read or refused with a message. One that is
/// read has finite values everywhere.
pub fn spectrum(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    match OpticalConstants::from_csv("fuzzed.csv", &text) {
        Ok(constants) => {
            for wavelength_nm in [1e-3, 380.0, 555.5, 780.0, 1e6] {
                let (n, k) = constants.extended_at(wavelength_nm);
                assert!(n.is_finite() && n > 0.0 && k.is_finite() && k >= 0.0, "{n} + {k}i at {wavelength_nm} nm");
            }
        }
        Err(error) => printable(&error.to_string()),
    }
    if let Err(error) = Illuminant::from_csv("fuzzed.csv", &text) {
        printable(&error.to_string());
    }
}

/// A table of points is read or refused with an error that can be drawn. One that is read has a finite number for each
/// column of each point, and is written as a table that is read again as the same.
pub fn points(data: &[u8]) {
    static SHADING: LazyLock<Shading> = LazyLock::new(|| {
        let text = starter("starter").expect("a scene may be called so");
        let scene = Scene::from_toml("starter.toml", &text, Path::new("")).expect("the starter is a scene");
        Shading::new(&scene, &"series:m=1".parse().expect("a variant")).expect("it goes with the starter")
    });
    let inputs = SHADING.inputs(ShadingQuantity::Brdf);
    let table = match PointsTable::parse("fuzzed.csv", data, SHADING.scene(), &inputs) {
        Ok(table) => table,
        Err(error) => return drawn(&error),
    };
    for point in &table.points {
        assert_eq!(point.len(), table.columns.len());
        assert!(point.iter().all(|value| value.is_finite()), "{point:?}");
    }
    let colours = vec![[0.25, -0.5, 1e9]; table.points.len()];
    let again = PointsTable::parse("written.csv", &table.with_colors(&colours), SHADING.scene(), &inputs)
        .unwrap_or_else(|error| panic!("what is written is not read: {error}"));
    assert_eq!(again.points, table.points);
    assert_eq!(again.expected, Some(colours));
}

/// A variant is read or refused with a message. One that is read is written, and read again as the same.
pub fn variant(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    match text.parse::<Variant>() {
        Ok(variant) => {
            let written = variant.to_string();
            assert_eq!(written.parse(), Ok(variant), "{text:?} was written as {written:?}");
        }
        Err(error) => {
            printable(&error.to_string());
            assert!(!error.help().is_empty());
            // The text is shown twice, at most: 60 characters of it, each of which may be escaped.
            assert!(error.to_string().len() < 2 * 60 * "\\u{10ffff}".len() + 200, "{error}");
        }
    }
}

fn names_a_file(scene: &Scene) -> bool {
    matches!(scene.base, Base::Table { .. })
        || matches!(scene.colour.illuminant, IlluminantSource::Table(_))
        || scene.film.as_ref().is_some_and(|film| matches!(film.medium, FilmMedium::Table(_)))
}

/// Draws an error as the command does, the lines of the text at fault included.
fn drawn(error: &dyn Diagnostic) {
    printable(&error.to_string());
    let mut drawing = String::new();
    GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor())
        .render_report(&mut drawing, error)
        .unwrap_or_else(|_| panic!("{error:?} cannot be drawn"));
    printable(&drawing);
}

/// A message has no control characters: none of a user's text reaches the terminal as a command.
fn printable(message: &str) {
    let odd = message.chars().find(|character| character.is_control() && *character != '\n');
    assert!(!message.is_empty() && odd.is_none(), "{message:?}");
}
