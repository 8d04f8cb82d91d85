//! Tables of points: CSV whose header names run-time inputs.

use crate::media::MediaError;
use crate::scene::{FilmMedium, Quantity, Scene, SceneError};
use crate::shading::ShadingError;
use miette::Diagnostic;
use pavo_shade::{Input, Type};
use thiserror::Error;

/// Why a table of points was refused: what is wrong, where, and what would be right.
#[derive(Clone, Debug, PartialEq, Eq, Error, Diagnostic)]
#[error("{message}")]
#[diagnostic(help("{help}"))]
pub struct PointsError {
    message: String,
    help: String,
}

impl PointsError {
    fn new(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { message: message.into(), help: help.into() }
    }

    /// What would be right.
    pub fn help_text(&self) -> &str {
        &self.help
    }
}

// Wherever tables are read, the errors of a scene can be drawn: the fuzzer draws them, without the command.
const _: [fn(); 3] = [can_be_drawn::<SceneError>, can_be_drawn::<MediaError>, can_be_drawn::<ShadingError>];

fn can_be_drawn<T: Diagnostic>() {}

/// The most points that a table may have: with what was written they take some 300 bytes each, and at each, the longest
/// variant takes some 20 thousand operations.
pub const MAXIMUM_POINTS: usize = 1_000_000;

/// What a point takes in memory, with what was written and its colour.
const BYTES_PER_POINT: f64 = 300.0;

/// The points of a table.
#[derive(Debug)]
pub struct PointsTable {
    /// The names of the columns that the evaluation takes.
    pub columns: Vec<String>,
    /// The points, a number for each column.
    pub points: Vec<Vec<f64>>,
    /// The points as they were written, for the output.
    pub written: Vec<Vec<String>>,
    /// The columns r, g and b of the table, if it has them: what somebody expects.
    pub expected: Option<Vec<[f64; 3]>>,
    /// Names of columns that nothing takes.
    pub ignored: Vec<String>,
    /// How many points lie outside of a declared range.
    pub out_of_range: usize,
}

/// The names of the columns of an input: its own, or one for each component of a colour or a direction.
pub fn column_names(input: &Input) -> Vec<String> {
    let is_direction = ["normal", "light_direction", "view_direction"].contains(&input.name.as_str());
    match input.ty {
        Type::Vec3 if is_direction => ["x", "y", "z"].map(|axis| format!("{}_{axis}", input.name)).to_vec(),
        Type::Vec3 => ["r", "g", "b"].map(|component| format!("{}_{component}", input.name)).to_vec(),
        _ => vec![input.name.clone()],
    }
}

impl PointsTable {
    /// Reads the table `text`, which errors call `name`, for these inputs of a scene.
    ///
    /// # Errors
    /// Text that is no CSV, more than [`MAXIMUM_POINTS`] points, columns that are missing or stand twice, and fields that are no finite numbers.
    pub fn parse(name: &str, text: &[u8], scene: &Scene, inputs: &[Input]) -> Result<Self, PointsError> {
        let columns: Vec<String> = inputs.iter().flat_map(column_names).collect();
        let help = format!("the points need a header and the columns {}", columns.join(","));
        let broken = |error: csv::Error| PointsError::new(format!("{name}: {error}"), &help);
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(text);
        let header: Vec<String> = reader.headers().map_err(broken)?.iter().map(str::to_owned).collect();
        for (index, column) in header.iter().enumerate() {
            if header[..index].contains(column) {
                return Err(PointsError::new(format!("{name}: the column `{}` stands twice", shown(column)), &help));
            }
            if let Some(value) = fixed_in(scene, column) {
                return Err(PointsError::new(
                    format!("{name}: `{column}` is fixed at {value} in the scene {}", scene.name),
                    "leave the column out, or make it a range [low, high] in the scene to vary it",
                ));
            }
        }
        let place = |column: &String| {
            header
                .iter()
                .position(|other| other == column)
                .ok_or_else(|| PointsError::new(format!("{name}: the column `{column}` is missing"), &help))
        };
        let places = columns.iter().map(place).collect::<Result<Vec<usize>, PointsError>>()?;
        let expected_places: Vec<usize> =
            ["r", "g", "b"].iter().filter_map(|column| header.iter().position(|other| other == column)).collect();
        let ranges: Vec<[f64; 2]> =
            inputs.iter().flat_map(|input| std::iter::repeat_n([input.low, input.high], input.components())).collect();
        let mut table = Self {
            ignored: ignored(&header, &columns),
            columns,
            points: Vec::new(),
            written: Vec::new(),
            expected: (expected_places.len() == 3).then(Vec::new),
            out_of_range: 0,
        };
        for record in reader.records() {
            let record = record.map_err(broken)?;
            if table.points.len() == MAXIMUM_POINTS {
                let read = record.position().map_or(1, csv::Position::byte).max(1);
                let estimate = text.len() as f64 / read as f64 * MAXIMUM_POINTS as f64;
                return Err(PointsError::new(
                    format!(
                        "{name}: there are about {estimate:.2e} points, which would take about {:.1e} bytes of memory; the \
                         most that are read are {MAXIMUM_POINTS}",
                        estimate * BYTES_PER_POINT
                    ),
                    "divide the table, with the header at the top of each part",
                ));
            }
            let line = record.position().map_or(0, csv::Position::line);
            let number = |place: usize| -> Result<f64, PointsError> {
                let field = &record[place];
                field.parse::<f64>().ok().filter(|value| (*value as f32).is_finite()).ok_or_else(|| {
                    PointsError::new(
                        format!(
                            "{name}:{line}: `{}` in the column `{}` is not a finite number",
                            shown(field),
                            header[place]
                        ),
                        "write a number such as 0.75 or 1.2e3, within the range of a 32-bit float",
                    )
                })
            };
            let point = places.iter().map(|&place| number(place)).collect::<Result<Vec<f64>, PointsError>>()?;
            if point.iter().zip(&ranges).any(|(value, [low, high])| value < low || value > high) {
                table.out_of_range += 1;
            }
            if let Some(expected) = &mut table.expected {
                expected.push([number(expected_places[0])?, number(expected_places[1])?, number(expected_places[2])?]);
            }
            table.written.push(places.iter().map(|&place| record[place].to_owned()).collect());
            table.points.push(point);
        }
        if table.points.is_empty() {
            return Err(PointsError::new(format!("{name}: there are no points under the header"), &help));
        }
        Ok(table)
    }

    /// The table again, with the colours that were found.
    pub fn with_colors(&self, colors: &[[f64; 3]]) -> Vec<u8> {
        let mut text = format!("{},r,g,b\n", self.columns.join(","));
        if self.columns.is_empty() {
            text = "r,g,b\n".to_owned();
        }
        for (written, [r, g, b]) in self.written.iter().zip(colors) {
            let mut fields = written.clone();
            fields.extend([digits(*r), digits(*g), digits(*b)]);
            text.push_str(&fields.join(","));
            text.push('\n');
        }
        text.into_bytes()
    }
}

/// A number with twelve significant digits.
pub fn digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-5..12).contains(&magnitude) {
        return format!("{value:.11e}");
    }
    format!("{value:.*}", (11 - magnitude).max(0) as usize)
}

fn ignored(header: &[String], columns: &[String]) -> Vec<String> {
    let known = |name: &String| columns.contains(name) || ["r", "g", "b", "tolerance"].contains(&name.as_str());
    header.iter().filter(|name| !known(name)).cloned().collect()
}

/// The value of an input that the scene fixes.
fn fixed_in(scene: &Scene, column: &str) -> Option<f64> {
    let quantity = match column {
        "thickness_nm" => scene.film.as_ref().map(|film| film.thickness_nm),
        "film_ior" => scene.film.as_ref().and_then(|film| match film.medium {
            FilmMedium::Index(ior) => Some(ior),
            FilmMedium::Material(_) | FilmMedium::Table(_) => None,
        }),
        "ambient_ior" => Some(scene.ambient.ior),
        "roughness" => Some(scene.surface.roughness),
        "metalness" => scene.surface.metalness,
        "base_ior" => match scene.base {
            crate::scene::Base::Dielectric { ior } | crate::scene::Base::Conductor { ior, .. } => Some(ior),
            _ => None,
        },
        "base_kappa" => match scene.base {
            crate::scene::Base::Conductor { kappa, .. } => Some(kappa),
            _ => None,
        },
        _ => None,
    };
    quantity.and_then(Quantity::fixed)
}

/// User text in a message: short, and without control characters.
fn shown(text: &str) -> String {
    text.chars().take(60).flat_map(char::escape_debug).collect()
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn numbers_have_twelve_significant_digits() {
        let cases = [
            (0.25, "0.250000000000"),
            (1234.5, "1234.50000000"),
            (-0.001_234_567_890_123, "-0.00123456789012"),
            (1e-9, "1.00000000000e-9"),
            (0.0, "0"),
        ];
        for (value, expected) in cases {
            assert_eq!(digits(value), expected);
        }
    }
}
