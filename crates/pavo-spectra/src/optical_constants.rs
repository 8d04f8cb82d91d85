//! Optical constants: the complex refractive index n + ik over the wavelength.
//!
//! Nothing is extrapolated silently. [`OpticalConstants::at`] refuses a wavelength outside the data. A caller who needs a
//! value there anyway says so with [`OpticalConstants::extended_at`], and shows
//! [`OpticalConstants::warnings_for_range`] to the user.

mod built_in;

use std::sync::Arc;

use self::built_in::{BUILT_INS, BuiltInData, count_of, names, names_of};
use crate::dispersion::{DispersionFormula, LorentzDrude};
use crate::interpolation::linear_held;
use crate::names::UnknownName;
use crate::table::{Column, Range, Table, TableError};

const EXAMPLE_HEADER: &str = "wavelength_nm,n,k";

/// A material's refractive index n and extinction coefficient k: constant, or over the wavelength. Cheap to clone.
#[derive(Debug, Clone, PartialEq)]
pub struct OpticalConstants {
    name: Arc<str>,
    kind: Option<MaterialKind>,
    source: Option<&'static str>,
    data: Data,
}

/// What a built-in material is, and so where in a stack it makes sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MaterialKind {
    /// A metal: a base.
    Metal,
    /// A semiconductor, which absorbs some of the visible light: a base.
    Semiconductor,
    /// A dielectric with k = 0: a film, or a base.
    Dielectric,
}

#[derive(Debug, Clone, PartialEq)]
enum Data {
    Constant { n: f64, k: f64 },
    Table(Arc<Table<2>>),
    Formula(&'static DispersionFormula),
    LorentzDrude(&'static LorentzDrude),
}

/// Why optical constants cannot be made, or not be given at a wavelength.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OpticalConstantsError {
    /// A constant index that no medium has.
    #[error("the constant index n = {n}, k = {k}: n should be a finite number above 0, and k one of 0 or above")]
    Constant {
        /// Refractive index.
        n: f64,
        /// Extinction coefficient.
        k: f64,
    },
    /// A wavelength outside the data.
    #[error("{name}: no data at {wavelength_nm} nm; they run from {low_nm} to {high_nm} nm")]
    OutsideData {
        /// Name of the material.
        name: String,
        /// The wavelength in nanometres.
        wavelength_nm: f64,
        /// Where the data begin, in nanometres.
        low_nm: f64,
        /// Where the data end, in nanometres.
        high_nm: f64,
    },
}

impl OpticalConstants {
    /// The names that [`OpticalConstants::built_in`] knows, sorted.
    pub const BUILT_IN_NAMES: [&'static str; BUILT_INS.len()] = names();

    /// Those of [`OpticalConstants::BUILT_IN_NAMES`] that absorb: metals, and silicon.
    pub const ABSORBING_NAMES: [&'static str; count_of(false)] = names_of(false);

    /// Those of [`OpticalConstants::BUILT_IN_NAMES`] that are dielectrics.
    pub const DIELECTRIC_NAMES: [&'static str; count_of(true)] = names_of(true);

    /// The same index at every wavelength.
    ///
    /// # Errors
    /// An n that is not finite and above 0, or a k that is not finite and at least 0.
    pub fn constant(n: f64, k: f64) -> Result<Self, OpticalConstantsError> {
        if n.is_finite() && n > 0.0 && k.is_finite() && k >= 0.0 {
            let name = if k == 0.0 { format!("n = {n}") } else { format!("n = {n}, k = {k}") };
            Ok(Self { name: name.into(), kind: None, source: None, data: Data::Constant { n, k } })
        } else {
            Err(OpticalConstantsError::Constant { n, k })
        }
    }

    /// A built-in material. Each has its publication in [`OpticalConstants::source`].
    ///
    /// - Metals by measurement: Ag, Au, Cu (Johnson and Christy 1972), Cr, Fe, Ni, Pd, Ti (Johnson and Christy 1974).
    /// - Metals by the Lorentz-Drude model of Rakic et al. 1998: Al, Be, Pt, W; and, as Ag-Rakic, Au-Rakic, Cr-Rakic,
    ///   Cu-Rakic, Ni-Rakic, Pd-Rakic and Ti-Rakic, those that were measured. The model follows other measurements, and
    ///   smooths them: it may be off by a tenth and more where a metal takes on its colour.
    /// - Silicon: Si (Aspnes and Studna 1983).
    /// - Dielectrics: Al2O3 (sapphire), BK7, MgF2, PMMA, Si3N4, SiO2 (fused silica), TiO2 (rutile), ZnS, chitin, keratin
    ///   and water; the ordinary ray of those that have two.
    ///
    /// # Errors
    /// An unknown name, with the known ones.
    pub fn built_in(name: &str) -> Result<Self, UnknownName> {
        let found = BUILT_INS.iter().find(|material| material.name == name);
        let material = found.ok_or_else(|| UnknownName::new("material", name, &Self::BUILT_IN_NAMES))?;
        let data = match material.data {
            BuiltInData::Table(text) => {
                Data::Table(Arc::new(read(name, text).expect("the table is compiled in and tested")))
            }
            BuiltInData::Formula(formula) => Data::Formula(formula),
            BuiltInData::LorentzDrude(model) => Data::LorentzDrude(model),
        };
        Ok(Self { name: name.into(), kind: Some(material.kind), source: Some(material.source), data })
    }

    /// Reads a table from comma-separated text with the columns `wavelength_nm` or `wavelength_um`, `n`, and `k` (0 where
    /// the column is left out), linear in wavelength between its lines. `name` stands for it in messages.
    ///
    /// # Errors
    /// What is wrong in the table, and on which line.
    pub fn from_csv(name: &str, text: &str) -> Result<Self, TableError> {
        let table = read(name, text)?;
        Ok(Self { name: name.into(), kind: None, source: None, data: Data::Table(Arc::new(table)) })
    }

    /// The material's name: the built-in one, that given to [`OpticalConstants::from_csv`], or the constant in words.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What a built-in material is.
    pub fn kind(&self) -> Option<MaterialKind> {
        self.kind
    }

    /// Whether nothing is absorbed: k is 0 at every wavelength.
    pub fn is_dielectric(&self) -> bool {
        match &self.data {
            Data::Constant { k, .. } => *k == 0.0,
            Data::Table(table) => table.columns[1].iter().all(|k| *k == 0.0),
            Data::Formula(_) => true,
            Data::LorentzDrude(_) => false,
        }
    }

    /// The publication of a built-in material.
    pub fn source(&self) -> Option<&'static str> {
        self.source
    }

    /// The index (n, k), where it is the same at every wavelength.
    pub fn as_constant(&self) -> Option<(f64, f64)> {
        match self.data {
            Data::Constant { n, k } => Some((n, k)),
            Data::Table(_) | Data::Formula(_) | Data::LorentzDrude(_) => None,
        }
    }

    /// Where the data begin and end, in nanometres; `None` for a constant, which has no end.
    pub fn range_nm(&self) -> Option<(f64, f64)> {
        match &self.data {
            Data::Constant { .. } => None,
            Data::Table(table) => Some(table.range_nm()),
            Data::Formula(formula) => Some(formula.measured_nm),
            Data::LorentzDrude(model) => Some(model.fitted_nm()),
        }
    }

    /// Whether the data reach from `low_nm` to `high_nm`.
    pub fn covers(&self, low_nm: f64, high_nm: f64) -> bool {
        self.range_nm().is_none_or(|(first, last)| first <= low_nm && high_nm <= last)
    }

    /// The index (n, k) at a wavelength in nanometres.
    ///
    /// # Errors
    /// A wavelength outside the data.
    pub fn at(&self, wavelength_nm: f64) -> Result<(f64, f64), OpticalConstantsError> {
        match self.range_nm() {
            Some((low_nm, high_nm)) if !(low_nm..=high_nm).contains(&wavelength_nm) => {
                Err(OpticalConstantsError::OutsideData { name: self.name.to_string(), wavelength_nm, low_nm, high_nm })
            }
            _ => Ok(self.extended_at(wavelength_nm)),
        }
    }

    /// The index (n, k) at any wavelength in nanometres. Beyond its ends a table holds its first or last value, and so does
    /// a Lorentz-Drude model; a formula is continued over 350 to 2500 nm and then held. [`OpticalConstants::warnings_for_range`] says so in words.
    pub fn extended_at(&self, wavelength_nm: f64) -> (f64, f64) {
        match &self.data {
            Data::Constant { n, k } => (*n, *k),
            Data::Table(table) => {
                let [n, k] = &table.columns;
                let value = |column| linear_held(&table.wavelengths_nm, column, wavelength_nm);
                (value(n), value(k))
            }
            Data::Formula(formula) => (formula.refractive_index(wavelength_nm), 0.0),
            Data::LorentzDrude(model) => model.refractive_index(wavelength_nm),
        }
    }

    /// What a user should know before [`OpticalConstants::extended_at`] is used from `low_nm` to `high_nm`: one line for
    /// each end at which the data fall short. Empty where they reach.
    pub fn warnings_for_range(&self, low_nm: f64, high_nm: f64) -> Vec<String> {
        let Some((first, last)) = self.range_nm() else { return Vec::new() };
        let name = &self.name;
        let how = match self.data {
            Data::Formula(_) => "the formula is continued",
            _ => "n and k are held constant",
        };
        let mut warnings = Vec::new();
        if low_nm < first {
            warnings.push(format!("{name}: the data begin at {first} nm; {how} from there down to {low_nm} nm"));
        }
        if high_nm > last {
            warnings.push(format!("{name}: the data end at {last} nm; {how} from there up to {high_nm} nm"));
        }
        warnings
    }
}

fn read(name: &str, text: &str) -> Result<Table<2>, TableError> {
    let columns = [
        Column { name: "n", range: Range::Positive, default: None },
        Column { name: "k", range: Range::NotNegative, default: Some(0.0) },
    ];
    Table::read(name, text, EXAMPLE_HEADER, &columns)
}
