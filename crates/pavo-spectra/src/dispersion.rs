//! Dispersion: published formulas of the refractive index over the wavelength.

mod dielectrics;
mod lorentz_drude;

pub(crate) use dielectrics::{
    CHITIN, FUSED_SILICA, KERATIN, MAGNESIUM_FLUORIDE, N_BK7, PMMA, RUTILE, SAPPHIRE, SILICON_NITRIDE, WATER,
    ZINC_SULFIDE,
};
pub(crate) use lorentz_drude::{
    ALUMINIUM, BERYLLIUM, CHROMIUM, COPPER, GOLD, LorentzDrude, NICKEL, PALLADIUM, PLATINUM, SILVER, TITANIUM, TUNGSTEN,
};

/// Where the formulas of dielectrics are continued to beyond their measurements, in nanometres: the index is smooth over
/// this range, and further out it is held. No resonance of theirs lies in it: that of rutile is at 283 nm, that of water
/// at 3271 nm.
const CONTINUED_NM: (f64, f64) = (350.0, 2500.0);

/// A dielectric's published formula: a constant and terms in the wavelength that sum to n^2, or to n itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DispersionFormula {
    /// The range that was measured, in nanometres.
    pub(crate) measured_nm: (f64, f64),
    sums_to: SumsTo,
    constant: f64,
    terms: &'static [Term],
}

/// What the terms of a formula sum to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SumsTo {
    /// n^2, as Sellmeier.
    SquaredIndex,
    /// n, as Cauchy.
    Index,
}

/// One term of a formula, with the vacuum or air wavelength lambda in micrometres as the publication has it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Term {
    /// strength lambda^2 / (lambda^2 - resonance), the resonance in um^2.
    Sellmeier { strength: f64, resonance: f64 },
    /// strength / (lambda^2 - resonance), the strength and the resonance in um^2. Cauchy's B / lambda^2 has resonance 0.
    Pole { strength: f64, resonance: f64 },
}

impl DispersionFormula {
    /// The real refractive index at a wavelength in nanometres: the formula's over the range that was measured and over
    /// 350 to 2500 nm; held beyond.
    pub(crate) fn refractive_index(&self, wavelength_nm: f64) -> f64 {
        let (measured_low, measured_high) = self.measured_nm;
        let low = measured_low.min(CONTINUED_NM.0);
        let high = measured_high.max(CONTINUED_NM.1);
        let square = (wavelength_nm.clamp(low, high) / 1000.0).powi(2);
        let sum = self.terms.iter().fold(self.constant, |sum, term| sum + term.at(square));
        match self.sums_to {
            SumsTo::SquaredIndex => sum.sqrt(),
            SumsTo::Index => sum,
        }
    }
}

impl Term {
    /// A Sellmeier term whose resonance is printed as a wavelength in micrometres.
    const fn sellmeier(strength: f64, resonance_um: f64) -> Self {
        Term::Sellmeier { strength, resonance: resonance_um * resonance_um }
    }

    /// A Sellmeier term whose resonance is printed as the square of a wavelength, in um^2.
    const fn sellmeier_squared(strength: f64, resonance: f64) -> Self {
        Term::Sellmeier { strength, resonance }
    }

    /// A pole whose resonance is printed as the square of a wavelength, in um^2.
    const fn pole(strength: f64, resonance: f64) -> Self {
        Term::Pole { strength, resonance }
    }

    /// The term at the square of a wavelength, in um^2.
    fn at(self, square: f64) -> f64 {
        match self {
            Term::Sellmeier { strength, resonance } => strength * square / (square - resonance),
            Term::Pole { strength, resonance } => strength / (square - resonance),
        }
    }
}
