//! Reading of comma-separated tables over the wavelength: the one reader for built-in data and for users' files.
//!
//! A table is a header line, which names the columns in any order, and one line per wavelength. Wavelengths ascend.
//! The column `wavelength_nm` or `wavelength_um` says the unit. Empty lines and lines that begin with `#` are skipped.

mod error;

pub use error::TableError;

use crate::wavelength::{VISIBLE_HIGH_NM, VISIBLE_LOW_NM};

/// What the values of a column may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Range {
    Positive,
    NotNegative,
}

impl Range {
    fn holds(self, value: f64) -> bool {
        match self {
            Range::Positive => value > 0.0,
            Range::NotNegative => value >= 0.0,
        }
    }

    fn in_words(self) -> &'static str {
        match self {
            Range::Positive => "above 0",
            Range::NotNegative => "0 or above",
        }
    }
}

/// A column of values beside the wavelength.
pub(crate) struct Column {
    pub(crate) name: &'static str,
    pub(crate) range: Range,
    /// The value that stands for the column where the header leaves it out; `None` where it must be there.
    pub(crate) default: Option<f64>,
}

/// A table that was read: wavelengths in nanometres, strictly ascending, at least two, and the columns asked for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Table<const N: usize> {
    pub(crate) wavelengths_nm: Vec<f64>,
    pub(crate) columns: [Vec<f64>; N],
}

impl<const N: usize> Table<N> {
    /// Reads `text`; `table` names it in errors, `example` is a header that would be right.
    pub(crate) fn read(table: &str, text: &str, example: &str, wanted: &[Column; N]) -> Result<Self, TableError> {
        let mut lines = text
            .trim_start_matches('\u{feff}')
            .lines()
            .enumerate()
            .map(|(index, line)| (index + 1, line.trim()))
            .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));

        let (header_line, header_text) =
            lines.next().ok_or_else(|| TableError::Empty { table: table.into(), example: example.into() })?;
        let header = Header::read(table, header_line, header_text, example, wanted)?;

        let mut wavelengths: Vec<f64> = Vec::new();
        let mut columns: [Vec<f64>; N] = std::array::from_fn(|_| Vec::new());
        for (line, text) in lines {
            let fields = fields(text);
            if fields.len() != header.count {
                let (expected, found) = (header.count, fields.len());
                return Err(TableError::FieldCount { table: table.into(), line, expected, found });
            }
            let number =
                |position: usize, column: &str, range: Range| number(table, line, column, fields[position], range);

            let wavelength = number(header.wavelength, header.unit.column(), Range::Positive)?;
            if let Some(&previous) = wavelengths.last() {
                if wavelength == previous {
                    return Err(TableError::DuplicateWavelength { table: table.into(), line, value: wavelength });
                }
                if wavelength < previous {
                    return Err(TableError::Unsorted { table: table.into(), line, previous, value: wavelength });
                }
            }
            wavelengths.push(wavelength);
            for ((values, column), position) in columns.iter_mut().zip(wanted).zip(header.positions) {
                values.push(match position {
                    Some(position) => number(position, column.name, column.range)?,
                    None => column.default.unwrap_or_default(),
                });
            }
        }

        let wavelengths_nm: Vec<f64> = wavelengths.into_iter().map(|value| header.unit.to_nm(value)).collect();
        match wavelengths_nm[..] {
            [low_nm, .., high_nm] if high_nm < VISIBLE_LOW_NM || low_nm > VISIBLE_HIGH_NM => {
                Err(TableError::NothingVisible { table: table.into(), low_nm, high_nm })
            }
            [_, .., _] => Ok(Self { wavelengths_nm, columns }),
            _ => Err(TableError::TooFewRows { table: table.into(), rows: wavelengths_nm.len() }),
        }
    }

    /// First and last wavelength, in nanometres.
    pub(crate) fn range_nm(&self) -> (f64, f64) {
        (self.wavelengths_nm[0], self.wavelengths_nm[self.wavelengths_nm.len() - 1])
    }
}

#[derive(Clone, Copy)]
enum Unit {
    Nanometres,
    Micrometres,
}

impl Unit {
    fn column(self) -> &'static str {
        match self {
            Unit::Nanometres => "wavelength_nm",
            Unit::Micrometres => "wavelength_um",
        }
    }

    fn to_nm(self, value: f64) -> f64 {
        match self {
            Unit::Nanometres => value,
            Unit::Micrometres => value * 1000.0,
        }
    }
}

/// Where the columns stand in a line.
struct Header<const N: usize> {
    count: usize,
    unit: Unit,
    wavelength: usize,
    positions: [Option<usize>; N],
}

impl<const N: usize> Header<N> {
    fn read(table: &str, line: usize, text: &str, example: &str, wanted: &[Column; N]) -> Result<Self, TableError> {
        let names = fields(text);
        let missing = |column: &str| TableError::MissingColumn {
            table: table.into(),
            line,
            column: column.into(),
            example: example.into(),
        };
        let unexpected = |column: &str, fault: &'static str| TableError::UnexpectedColumn {
            table: table.into(),
            line,
            column: shown(column),
            fault,
            example: example.into(),
        };
        let position = |name: &str| names.iter().position(|&field| field == name);

        let (unit, wavelength) = match (position("wavelength_nm"), position("wavelength_um")) {
            (Some(wavelength), None) => (Unit::Nanometres, wavelength),
            (None, Some(wavelength)) => (Unit::Micrometres, wavelength),
            (None, None) => return Err(missing("`wavelength_nm` or `wavelength_um`")),
            (Some(_), Some(_)) => return Err(unexpected("wavelength_um", "there beside `wavelength_nm`")),
        };
        let positions = std::array::from_fn(|column| position(wanted[column].name));
        for (column, position) in wanted.iter().zip(positions) {
            if position.is_none() && column.default.is_none() {
                return Err(missing(&format!("`{}`", column.name)));
            }
        }
        for (index, &name) in names.iter().enumerate() {
            if name != unit.column() && wanted.iter().all(|column| column.name != name) {
                return Err(unexpected(name, "not known"));
            }
            if names[..index].contains(&name) {
                return Err(unexpected(name, "there twice"));
            }
        }
        Ok(Self { count: names.len(), unit, wavelength, positions })
    }
}

/// The fields of a line, without the blanks and quotes around them.
fn fields(line: &str) -> Vec<&str> {
    line.split(',').map(|field| field.trim().trim_matches('"')).collect()
}

/// A user's text as a message shows it: short, and with control characters escaped, so that none reaches a terminal.
fn shown(text: &str) -> String {
    let mut shown: String = text.chars().take(60).flat_map(char::escape_debug).collect();
    if text.chars().count() > 60 {
        shown.push('…');
    }
    shown
}

fn number(table: &str, line: usize, column: &str, text: &str, range: Range) -> Result<f64, TableError> {
    let value = text.parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| TableError::NotANumber {
        table: table.into(),
        line,
        column: column.into(),
        text: shown(text),
    })?;
    if range.holds(value) {
        Ok(value)
    } else {
        let expected = range.in_words();
        Err(TableError::OutOfRange { table: table.into(), line, column: column.into(), value, expected })
    }
}
