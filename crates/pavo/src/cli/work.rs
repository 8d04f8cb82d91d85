//! What a request would take, estimated before the work begins, and how much is done.

use super::failure::Failure;
use crate::emission::library;
use crate::inputs::ShadingQuantity;
use crate::scene::Scene;
use crate::shading::Shading;
use crate::variant::{Excess, Variant};
use pavo_emit::Language;
use std::fmt;
use std::path::Path;

/// Of each kind of request the most that is done, and what one of its units takes: bytes of memory, and seconds of
/// processor time as measured on 2026-11-29 on a shared machine with two cores.
#[derive(Debug)]
pub struct Limit {
    /// What is counted.
    what: &'static str,
    most: f64,
    bytes: f64,
    seconds: f64,
    /// By which power of the count they grow.
    power: i32,
}

/// Points of the sweep of a variant: each is held with its inputs and its colour.
pub const SWEEP_POINTS: Limit = Limit { what: "points of a sweep", most: 1e8, bytes: 80.0, seconds: 3e-7, power: 1 };
/// Pixels on a side of a picture: each pixel is four samples, held as numbers.
pub const PIXELS: Limit = Limit { what: "pixels a side", most: 4096.0, bytes: 190.0, seconds: 7e-7, power: 2 };
/// Scenes of a report: each is surveyed, with all its variants.
pub const SCENES: Limit = Limit { what: "scenes of a report", most: 32.0, bytes: 2e6, seconds: 46.0, power: 1 };
/// Waves of a fit to a scene: a step of the solver goes by the square of what is fitted.
pub const WAVES: Limit = Limit { what: "waves of a fit", most: 12.0, bytes: 1e5, seconds: 0.01, power: 2 };
/// Terms of a fit of sensitivities.
pub const TERMS: Limit = Limit { what: "terms of a fit", most: 16.0, bytes: 1e5, seconds: 0.05, power: 2 };

/// Seconds of processor time for each operation of an evaluation that `pavo build` takes: with four targets, their judges and all roads
/// `spectral:n=512` took 61 s for its 15 thousand.
const BUILD_SECONDS_PER_OPERATION: f64 = 4e-3;
/// The same for the square of the entries of a table: a judge of GLSL reads it in a time that grows so.
const BUILD_SECONDS_PER_ENTRY_SQUARED: f64 = 2.5e-7;

impl Limit {
    /// Refuses more than is done.
    ///
    /// # Errors
    /// `count` is above the limit: with what it would take, and what is taken.
    pub fn check(&self, asked: &str, count: f64) -> Result<(), Failure> {
        if count <= self.most {
            return Ok(());
        }
        Err(Failure::input(
            format!("{asked} asks for {} {}: {}", Figure(count), self.what, self.taken(count)),
            format!("the most are {}: {}", Figure(self.most), self.taken(self.most)),
        ))
    }

    fn taken(&self, count: f64) -> String {
        format!(
            "about {} of memory and {} of processor time",
            Bytes(count.powi(self.power) * self.bytes),
            Seconds(count.powi(self.power) * self.seconds)
        )
    }
}

/// What a variant with a number above its range would take: the operations of an evaluation and the bytes of its WGSL, by a
/// straight line through two variants that are within it, and the time of `pavo build`.
///
/// None where neither of them can be made.
pub fn of_variant(excess: &Excess) -> Option<String> {
    let [(low, first), (high, second)] = excess.samples;
    let (first, second) = (measured(first)?, measured(second)?);
    let at = |index: usize| {
        let slope = (second[index] - first[index]) / (high - low) as f64;
        first[index] + slope * (excess.asked - low as f64)
    };
    let [operations, bytes] = [at(0), at(1)];
    let is_table = excess.samples[0].1.parse::<Variant>().is_ok_and(|variant| variant.reads_tables());
    let tables = if is_table { BUILD_SECONDS_PER_ENTRY_SQUARED * excess.asked.powi(2) } else { 0.0 };
    Some(format!(
        "it would take about {} operations an evaluation, {} of WGSL, and {} of processor time to build",
        Figure(operations),
        Bytes(bytes),
        Seconds(operations * BUILD_SECONDS_PER_OPERATION + tables)
    ))
}

/// Operations of an evaluation, and bytes of WGSL, of a variant on a plain film.
fn measured(variant: &str) -> Option<[f64; 2]> {
    let variant: Variant = variant.parse().ok()?;
    // What is made of a uniform film is made for one thickness.
    ["[100, 1200]", "300"].into_iter().find_map(|thickness| {
        let text = format!("name = 'film'\nfilm = {{ ior = 1.33, thickness_nm = {thickness} }}\nbase.ior = 1.5\n");
        let scene = Scene::from_toml("film.toml", &text, Path::new("")).ok()?;
        let shading = Shading::new(&scene, &variant).ok()?;
        let operations = shading.general_program(ShadingQuantity::Reflectance).operations().weight();
        Some([operations as f64, library(&shading, Language::Wgsl).len() as f64])
    })
}

/// A count in a few digits.
struct Figure(f64);

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 < 1e6 { write!(f, "{:.0}", self.0) } else { write!(f, "{:.1e}", self.0) }
    }
}

struct Bytes(f64);

impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        in_units(f, self.0, &[("bytes", 1.0), ("kB", 1e3), ("MB", 1e6), ("GB", 1e9), ("TB", 1e12)])
    }
}

struct Seconds(f64);

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let units =
            [("s", 1.0), ("minutes", 60.0), ("hours", 3600.0), ("days", 86_400.0), ("years", 365.25 * 86_400.0)];
        in_units(f, self.0.max(1.0), &units)
    }
}

/// The amount in the largest unit of which there are two.
fn in_units(f: &mut fmt::Formatter<'_>, amount: f64, units: &[(&str, f64)]) -> fmt::Result {
    let largest = units.iter().rfind(|(_, size)| amount >= 2.0 * size).or(units.first());
    let (name, size) = largest.copied().unwrap_or(("", 1.0));
    write!(f, "{} {name}", Figure(amount / size))
}

/// A whole number as people write large ones: `10000000` or `1e7`.
pub fn count(text: &str) -> Result<f64, String> {
    let number = text.replace('_', "").parse::<f64>().ok().filter(|number| number.fract() == 0.0 && *number >= 0.0);
    number.ok_or_else(|| "write a whole number, such as 1000000 or 1e6".to_owned())
}

#[cfg(test)]
mod tests {
    use super::{Bytes, Seconds, count, measured};
    use crate::variant::Variant;

    #[test]
    fn amounts_are_said_in_units_that_people_use() {
        let seconds = [
            (0.2, "1 s"),
            (90.0, "90 s"),
            (150.0, "2 minutes"),
            (1e5, "28 hours"),
            (1e9, "32 years"),
            (1e17, "3.2e9 years"),
        ];
        for (amount, expected) in seconds {
            assert_eq!(Seconds(amount).to_string(), expected);
        }
        for (amount, expected) in [(1500.0, "1500 bytes"), (2e6, "2 MB"), (6e13, "60 TB")] {
            assert_eq!(Bytes(amount).to_string(), expected);
        }
    }

    #[test]
    fn whole_numbers_may_have_exponents() {
        let cases =
            [("1e12", Some(1e12)), ("10_000", Some(1e4)), ("1.5", None), ("-1", None), ("nan", None), ("", None)];
        for (text, expected) in cases {
            assert_eq!(count(text).ok(), expected, "{text}");
        }
    }

    #[test]
    fn operations_and_text_grow_in_a_straight_line() {
        // What is told by 16 and 32 wavelengths is right for as many as are allowed.
        let [[low, low_text], [high, high_text], [most, most_text]] =
            ["spectral:n=16", "spectral:n=32", "spectral:n=512"]
                .map(|variant| measured(variant).expect("it can be made"));
        for (low, high, most) in [(low, high, most), (low_text, high_text, most_text)] {
            let told = low + (high - low) / 16.0 * (512.0 - 16.0);
            assert!((told / most - 1.0).abs() < 0.05, "{told} instead of {most}");
        }
    }

    #[test]
    fn every_number_above_its_range_has_an_estimate() {
        for variant in [
            "series:m=9999",
            "poles:k=9999",
            "windowed:k=9999",
            "windowed:k=6,groups=9999",
            "cosines:k=9999",
            "cosines:m=9999",
            "nodes:n=9999",
            "baked:degree=9999",
            "baked:denominator=9999",
            "fitted:k=9999",
            "spectral:n=9999",
            "spectral:n=99999999999999999999999999",
            "table:9999x9999",
        ] {
            let error = variant.parse::<Variant>().expect_err(variant);
            let told = error.excess().and_then(super::of_variant).unwrap_or_else(|| panic!("{variant}: no estimate"));
            assert!(told.contains("operations an evaluation"), "{variant}: {told}");
        }
    }
}
