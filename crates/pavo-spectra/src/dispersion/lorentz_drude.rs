//! The Lorentz-Drude model of metals.
//!
//! A. D. Rakic, A. B. Djurisic, J. M. Elazar, and M. L. Majewski, "Optical properties of metallic films for vertical-cavity
//! optoelectronic devices", Appl. Opt. 37, 5271 (1998): a Drude term for the free electrons and Lorentz terms for the bound
//! ones, fitted to measurements. With the photon energy E, the plasma energy P, and for each oscillator j its strength f,
//! width G and resonance W, all in electronvolts,
//!
//! eps(E) = 1 + sum over j of f P^2 / (W^2 - E^2 - i G E),
//!
//! the free electrons being j = 0, with W = 0. The square root of eps is n + ik, k >= 0.

use num_complex::Complex64;

/// h c / e, in electronvolts times nanometres (exact in the SI of 2019, rounded).
const ELECTRONVOLT_NANOMETRES: f64 = 1_239.841_984_332;

/// A metal by its oscillators.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LorentzDrude {
    /// Where the fit ends, as photon energies in electronvolts.
    fitted_ev: (f64, f64),
    /// The plasma energy in electronvolts.
    plasma_ev: f64,
    /// Each oscillator's strength (no unit), width and resonance (in electronvolts), the free electrons first.
    oscillators: &'static [(f64, f64, f64)],
}

impl LorentzDrude {
    /// The range of the fit, in nanometres.
    pub(crate) fn fitted_nm(&self) -> (f64, f64) {
        let (low, high) = self.fitted_ev;
        (ELECTRONVOLT_NANOMETRES / high, ELECTRONVOLT_NANOMETRES / low)
    }

    /// The index (n, k) at a wavelength in nanometres, held beyond the range of the fit.
    pub(crate) fn refractive_index(&self, wavelength_nm: f64) -> (f64, f64) {
        let (shortest, longest) = self.fitted_nm();
        let energy = ELECTRONVOLT_NANOMETRES / wavelength_nm.clamp(shortest, longest);
        let plasma_square = self.plasma_ev * self.plasma_ev;
        let permittivity = self.oscillators.iter().fold(Complex64::ONE, |sum, &(strength, width, resonance)| {
            sum + strength * plasma_square / Complex64::new(resonance * resonance - energy * energy, -width * energy)
        });
        let index = permittivity.sqrt();
        (index.re, index.im)
    }
}

/// Silver.
pub(crate) const SILVER: LorentzDrude = LorentzDrude {
    fitted_ev: (0.1, 5.0),
    plasma_ev: 9.01,
    oscillators: &[
        (0.845, 0.048, 0.0),
        (0.065, 3.886, 0.816),
        (0.124, 0.452, 4.481),
        (0.011, 0.065, 8.185),
        (0.840, 0.916, 9.083),
        (5.646, 2.419, 20.29),
    ],
};

/// Gold.
pub(crate) const GOLD: LorentzDrude = LorentzDrude {
    fitted_ev: (0.2, 5.0),
    plasma_ev: 9.03,
    oscillators: &[
        (0.760, 0.053, 0.0),
        (0.024, 0.241, 0.415),
        (0.010, 0.345, 0.830),
        (0.071, 0.870, 2.969),
        (0.601, 2.494, 4.304),
        (4.384, 2.214, 13.32),
    ],
};

/// Copper.
pub(crate) const COPPER: LorentzDrude = LorentzDrude {
    fitted_ev: (0.1, 6.0),
    plasma_ev: 10.83,
    oscillators: &[
        (0.575, 0.030, 0.0),
        (0.061, 0.378, 0.291),
        (0.104, 1.056, 2.957),
        (0.723, 3.213, 5.300),
        (0.638, 4.305, 11.18),
    ],
};

/// Aluminium.
pub(crate) const ALUMINIUM: LorentzDrude = LorentzDrude {
    fitted_ev: (0.005, 20.0),
    plasma_ev: 14.98,
    oscillators: &[
        (0.523, 0.047, 0.0),
        (0.227, 0.333, 0.162),
        (0.050, 0.312, 1.544),
        (0.166, 1.351, 1.808),
        (0.030, 3.382, 3.473),
    ],
};

/// Beryllium.
pub(crate) const BERYLLIUM: LorentzDrude = LorentzDrude {
    fitted_ev: (0.02, 5.0),
    plasma_ev: 18.51,
    oscillators: &[
        (0.084, 0.035, 0.0),
        (0.031, 1.664, 0.100),
        (0.140, 3.395, 1.032),
        (0.530, 4.454, 3.183),
        (0.130, 1.802, 4.604),
    ],
};

/// Chromium.
pub(crate) const CHROMIUM: LorentzDrude = LorentzDrude {
    fitted_ev: (0.02, 5.0),
    plasma_ev: 10.75,
    oscillators: &[
        (0.168, 0.047, 0.0),
        (0.151, 3.175, 0.121),
        (0.150, 1.305, 0.543),
        (1.149, 2.676, 1.970),
        (0.825, 1.335, 8.775),
    ],
};

/// Nickel.
pub(crate) const NICKEL: LorentzDrude = LorentzDrude {
    fitted_ev: (0.2, 5.0),
    plasma_ev: 15.92,
    oscillators: &[
        (0.096, 0.048, 0.0),
        (0.100, 4.511, 0.174),
        (0.135, 1.334, 0.582),
        (0.106, 2.178, 1.597),
        (0.729, 6.292, 6.089),
    ],
};

/// Palladium.
pub(crate) const PALLADIUM: LorentzDrude = LorentzDrude {
    fitted_ev: (0.1, 5.0),
    plasma_ev: 9.72,
    oscillators: &[
        (0.330, 0.008, 0.0),
        (0.649, 2.950, 0.336),
        (0.121, 0.555, 0.501),
        (0.638, 4.621, 1.659),
        (0.453, 3.236, 5.715),
    ],
};

/// Platinum.
#[expect(clippy::approx_constant, reason = "the third resonance is 3.141 eV, and has nothing to do with pi")]
pub(crate) const PLATINUM: LorentzDrude = LorentzDrude {
    fitted_ev: (0.1, 5.0),
    plasma_ev: 9.59,
    oscillators: &[
        (0.333, 0.080, 0.0),
        (0.191, 0.517, 0.780),
        (0.659, 1.838, 1.314),
        (0.547, 3.668, 3.141),
        (3.576, 8.517, 9.249),
    ],
};

/// Titanium.
pub(crate) const TITANIUM: LorentzDrude = LorentzDrude {
    fitted_ev: (0.04, 5.0),
    plasma_ev: 7.29,
    oscillators: &[
        (0.148, 0.082, 0.0),
        (0.899, 2.276, 0.777),
        (0.393, 2.518, 1.545),
        (0.187, 1.663, 2.509),
        (0.001, 1.762, 19.43),
    ],
};

/// Tungsten.
pub(crate) const TUNGSTEN: LorentzDrude = LorentzDrude {
    fitted_ev: (0.1, 5.0),
    plasma_ev: 13.22,
    oscillators: &[
        (0.206, 0.064, 0.0),
        (0.054, 0.530, 1.004),
        (0.166, 1.281, 1.917),
        (0.706, 3.332, 3.580),
        (2.590, 5.836, 7.498),
    ],
};
