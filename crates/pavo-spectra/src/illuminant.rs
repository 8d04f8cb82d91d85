//! Illuminants: relative spectral power over the wavelength.

use std::sync::{Arc, LazyLock};

use crate::interpolation::linear_held;
use crate::names::UnknownName;
use crate::table::{Column, Range, Table, TableError};

const EXAMPLE_HEADER: &str = "wavelength_nm,value";

/// The light that makes white. Only the shape of its spectrum matters: sensitivities are normalised.
#[derive(Debug, Clone, PartialEq)]
pub enum Illuminant {
    /// Equal power at every wavelength.
    E,
    /// Average daylight, 6500 K (ISO/CIE 11664-2, 5 nm table, linear between).
    D65,
    /// Horizon daylight, 5000 K (CIE 15, 5 nm table, linear between).
    D50,
    /// Tungsten light, 2856 K, by the formula of ISO/CIE 11664-2.
    A,
    /// A user's own spectrum.
    Custom(CustomIlluminant),
}

/// A spectrum read from a table, linear in wavelength between its samples. Cheap to clone.
#[derive(Debug, Clone, PartialEq)]
pub struct CustomIlluminant {
    name: Arc<str>,
    table: Arc<Table<1>>,
}

impl Illuminant {
    /// The names that [`Illuminant::from_name`] knows.
    pub const NAMES: [&'static str; 4] = ["E", "D65", "D50", "A"];

    /// The standard illuminant of that name.
    ///
    /// # Errors
    /// An unknown name, with the known ones.
    pub fn from_name(name: &str) -> Result<Self, UnknownName> {
        match name {
            "E" => Ok(Illuminant::E),
            "D65" => Ok(Illuminant::D65),
            "D50" => Ok(Illuminant::D50),
            "A" => Ok(Illuminant::A),
            _ => Err(UnknownName::new("illuminant", name, &Self::NAMES)),
        }
    }

    /// Reads a spectrum from comma-separated text with the columns `wavelength_nm` or `wavelength_um`, and `value`:
    /// relative spectral power, 0 or above, in any unit that is linear in power per wavelength. `name` stands for it
    /// in messages.
    ///
    /// # Errors
    /// What is wrong in the table, and on which line.
    pub fn from_csv(name: &str, text: &str) -> Result<Self, TableError> {
        let columns = [Column { name: "value", range: Range::NotNegative, default: None }];
        let table = Table::read(name, text, EXAMPLE_HEADER, &columns)?;
        Ok(Illuminant::Custom(CustomIlluminant { name: name.into(), table: Arc::new(table) }))
    }

    /// The illuminant's name: a standard one, or that given to [`Illuminant::from_csv`].
    pub fn name(&self) -> &str {
        match self {
            Illuminant::E => "E",
            Illuminant::D65 => "D65",
            Illuminant::D50 => "D50",
            Illuminant::A => "A",
            Illuminant::Custom(custom) => &custom.name,
        }
    }

    /// Relative spectral power at a wavelength in nanometres, above 0. Beyond a table's ends its end values are held;
    /// see [`Illuminant::warnings_for_range`].
    pub fn power(&self, wavelength_nm: f64) -> f64 {
        static D65: LazyLock<Table<1>> = LazyLock::new(|| read_standard(include_str!("../data/cie_d65.csv")));
        static D50: LazyLock<Table<1>> = LazyLock::new(|| read_standard(include_str!("../data/cie_d50.csv")));
        match self {
            Illuminant::E => 100.0,
            Illuminant::D65 => power_in(&D65, wavelength_nm),
            Illuminant::D50 => power_in(&D50, wavelength_nm),
            Illuminant::A => illuminant_a(wavelength_nm),
            Illuminant::Custom(custom) => power_in(&custom.table, wavelength_nm),
        }
    }

    /// What a user should know before the illuminant is used from `low_nm` to `high_nm`: where a table of the user's
    /// ends short of that. Empty for the standard illuminants over the visible range.
    pub fn warnings_for_range(&self, low_nm: f64, high_nm: f64) -> Vec<String> {
        let Illuminant::Custom(custom) = self else { return Vec::new() };
        let name = &custom.name;
        let (first, last) = custom.table.range_nm();
        let mut warnings = Vec::new();
        if low_nm < first {
            warnings.push(format!("{name}: begins at {first} nm; its power there is held down to {low_nm} nm"));
        }
        if high_nm > last {
            warnings.push(format!("{name}: ends at {last} nm; its power there is held up to {high_nm} nm"));
        }
        warnings
    }
}

fn power_in(table: &Table<1>, wavelength_nm: f64) -> f64 {
    linear_held(&table.wavelengths_nm, &table.columns[0], wavelength_nm)
}

/// CIE standard illuminant A: S = 100 (560 / lambda)^5 (exp(1.435e7 / (2848 * 560)) - 1) /
/// (exp(1.435e7 / (2848 lambda)) - 1), lambda in nanometres (ISO/CIE 11664-2).
fn illuminant_a(wavelength_nm: f64) -> f64 {
    let exponent = |wavelength_nm: f64| (1.435e7 / (2848.0 * wavelength_nm)).exp_m1();
    100.0 * (560.0 / wavelength_nm).powi(5) * exponent(560.0) / exponent(wavelength_nm)
}

fn read_standard(text: &str) -> Table<1> {
    let columns = [Column { name: "value", range: Range::NotNegative, default: None }];
    Table::read("standard illuminant", text, EXAMPLE_HEADER, &columns)
        .expect("the table is compiled in, and the tests read it")
}
