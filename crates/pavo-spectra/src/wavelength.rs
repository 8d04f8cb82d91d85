//! The visible range and the fine wavelength grid of the reference.

/// Shortest wavelength of the CIE colour matching functions, in nanometres (CIE 018).
pub const VISIBLE_LOW_NM: f64 = 360.0;

/// Longest wavelength of the CIE colour matching functions, in nanometres (CIE 018).
pub const VISIBLE_HIGH_NM: f64 = 830.0;

/// Step of the fine grid, in nanometres. At 1 nm a sum over wavelengths is off by 8e-3 for a film of 3 um at grazing
/// angles, where the reflectance oscillates faster than that step resolves.
pub const FINE_STEP_NM: f64 = 0.25;

/// Number of wavelengths of the fine grid.
pub const FINE_COUNT: usize = 1881;

/// The fine grid: [`FINE_COUNT`] wavelengths in nanometres, ascending, from [`VISIBLE_LOW_NM`] to [`VISIBLE_HIGH_NM`]
/// inclusive, [`FINE_STEP_NM`] apart. An integral over it is the plain sum over its points.
pub fn fine_grid() -> Vec<f64> {
    (0..FINE_COUNT).map(|index| VISIBLE_LOW_NM + FINE_STEP_NM * index as f64).collect()
}
