//! Dispersion formulas of dielectrics: published fits of the refractive index over the wavelength.

/// A dielectric by its published formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum DispersionFormula {
    /// Fused silica: I. H. Malitson, "Interspecimen comparison of the refractive index of fused silica",
    /// J. Opt. Soc. Am. 55, 1205 (1965).
    MalitsonSilica,
    /// Rutile, the ordinary ray: J. R. DeVore, "Refractive indices of rutile and sphalerite",
    /// J. Opt. Soc. Am. 41, 416 (1951).
    DevoreRutile,
}

/// Where the formulas are continued to beyond their measurements, in nanometres: the index is smooth over this range, and
/// further out it is held. The resonance of rutile, at 283 nm, lies outside.
const CONTINUED_NM: (f64, f64) = (350.0, 2500.0);

impl DispersionFormula {
    /// The range that was measured, in nanometres.
    pub(crate) fn measured_nm(self) -> (f64, f64) {
        match self {
            DispersionFormula::MalitsonSilica => (210.0, 3710.0),
            DispersionFormula::DevoreRutile => (430.0, 1530.0),
        }
    }

    /// The real refractive index at a wavelength in nanometres: the formula's over the range that was measured and over
    /// 350 to 2500 nm; held beyond.
    pub(crate) fn refractive_index(self, wavelength_nm: f64) -> f64 {
        let (measured_low, measured_high) = self.measured_nm();
        let low = measured_low.min(CONTINUED_NM.0);
        let high = measured_high.max(CONTINUED_NM.1);
        let square = (wavelength_nm.clamp(low, high) / 1000.0).powi(2);
        match self {
            DispersionFormula::MalitsonSilica => {
                let term =
                    |strength: f64, resonance_um: f64| strength * square / (square - resonance_um * resonance_um);
                let terms =
                    term(0.696_166_3, 0.068_404_3) + term(0.407_942_6, 0.116_241_4) + term(0.897_479_4, 9.896_161);
                (1.0 + terms).sqrt()
            }
            DispersionFormula::DevoreRutile => (5.913 + 0.2441 / (square - 0.0803)).sqrt(),
        }
    }
}
