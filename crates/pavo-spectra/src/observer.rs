//! CIE standard colorimetric observers.

use std::sync::LazyLock;

use crate::interpolation::UniformCubicSpline;
use crate::names::UnknownName;
use crate::table::{Column, Range, Table};
use crate::wavelength::VISIBLE_LOW_NM;

/// A standard colorimetric observer: three colour matching functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Observer {
    /// CIE 1931, for fields of 2 degrees: the one that RGB colour spaces are defined with.
    Cie1931TwoDegree,
    /// CIE 1964, for fields of 10 degrees.
    Cie1964TenDegree,
}

impl Observer {
    /// Every observer.
    pub const ALL: [Observer; 2] = [Observer::Cie1931TwoDegree, Observer::Cie1964TenDegree];

    /// The names that [`Observer::from_name`] knows, in the order of [`Observer::ALL`].
    pub const NAMES: [&'static str; 2] = ["cie1931-2deg", "cie1964-10deg"];

    /// The observer of that name.
    ///
    /// # Errors
    /// An unknown name, with the known ones.
    pub fn from_name(name: &str) -> Result<Self, UnknownName> {
        Self::ALL
            .into_iter()
            .find(|observer| observer.name() == name)
            .ok_or_else(|| UnknownName::new("observer", name, &Self::NAMES))
    }

    /// The name that [`Observer::from_name`] reads.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// The colour matching functions (x, y, z) at a wavelength in nanometres: the 1 nm table of CIE 018 and
    /// ISO/CIE 11664-1, by a natural cubic spline; zero outside 360 to 830 nm, where the standard has no values.
    pub fn at(self, wavelength_nm: f64) -> [f64; 3] {
        self.spline().at(wavelength_nm)
    }

    fn spline(self) -> &'static UniformCubicSpline {
        static TWO_DEGREES: LazyLock<UniformCubicSpline> =
            LazyLock::new(|| read(include_str!("../data/cie_1931_2deg.csv")));
        static TEN_DEGREES: LazyLock<UniformCubicSpline> =
            LazyLock::new(|| read(include_str!("../data/cie_1964_10deg.csv")));
        match self {
            Observer::Cie1931TwoDegree => &TWO_DEGREES,
            Observer::Cie1964TenDegree => &TEN_DEGREES,
        }
    }
}

fn read(text: &str) -> UniformCubicSpline {
    let column = |name| Column { name, range: Range::NotNegative, default: None };
    let columns = [column("x_bar"), column("y_bar"), column("z_bar")];
    let table = Table::read("colour matching functions", text, "wavelength_nm,x_bar,y_bar,z_bar", &columns)
        .expect("the table is compiled in, and the tests read it");
    let [x, y, z] = table.columns;
    let samples = x.into_iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z]).collect();
    UniformCubicSpline::new(VISIBLE_LOW_NM, 1.0, samples)
}
