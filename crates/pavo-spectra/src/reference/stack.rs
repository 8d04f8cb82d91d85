//! What the reference is asked about: a stack of media, and a point of it.

use num_complex::Complex64;

use super::airy::FilmAtAngle;
use crate::optical_constants::OpticalConstants;
use crate::wavelength::{VISIBLE_HIGH_NM, VISIBLE_LOW_NM};

/// Angle and thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Cosine of the angle of incidence in the ambient medium, from 0 (grazing) to 1; values outside are clamped.
    pub cos_theta1: f64,
    /// Thickness of the film in nanometres; 0, or below, is a bare base.
    pub thickness_nm: f64,
}

impl Point {
    /// A point from the cosine of the angle of incidence and the thickness in nanometres.
    pub fn new(cos_theta1: f64, thickness_nm: f64) -> Self {
        Self { cos_theta1, thickness_nm }
    }
}

/// A film between two half spaces. A bare surface is a film of thickness 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Stack {
    ambient_ior: f64,
    film: OpticalConstants,
    base: OpticalConstants,
}

/// A stack that is none.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the ambient index is {ambient_ior}; it should be a finite number above 0 (1 for air)")]
pub struct StackError {
    /// The index as it was given.
    pub ambient_ior: f64,
}

impl Stack {
    /// A stack of an ambient medium, which does not absorb and has the same index at every wavelength, a film, and a base.
    ///
    /// # Errors
    /// An ambient index that is not finite and above 0.
    pub fn new(ambient_ior: f64, film: OpticalConstants, base: OpticalConstants) -> Result<Self, StackError> {
        if ambient_ior.is_finite() && ambient_ior > 0.0 {
            Ok(Self { ambient_ior, film, base })
        } else {
            Err(StackError { ambient_ior })
        }
    }

    /// Refractive index of the ambient medium.
    pub fn ambient_ior(&self) -> f64 {
        self.ambient_ior
    }

    /// The film.
    pub fn film(&self) -> &OpticalConstants {
        &self.film
    }

    /// The base.
    pub fn base(&self) -> &OpticalConstants {
        &self.base
    }

    /// Where the data of film and base fall short of 360 to 830 nm, in words; empty where they reach.
    pub fn warnings(&self) -> Vec<String> {
        [&self.film, &self.base]
            .into_iter()
            .flat_map(|constants| constants.warnings_for_range(VISIBLE_LOW_NM, VISIBLE_HIGH_NM))
            .collect()
    }

    /// The reflectance, the mean of both polarisations, at one vacuum wavelength in nanometres, above 0.
    pub fn reflectance_at(&self, wavelength_nm: f64, point: Point) -> f64 {
        let index = |constants: &OpticalConstants| complex_index(constants, wavelength_nm);
        FilmAtAngle::new(self.ambient_ior, index(&self.film), index(&self.base), point.cos_theta1)
            .reflectance(point.thickness_nm / wavelength_nm)
    }
}

/// A medium's complex index on a grid of wavelengths.
#[derive(Debug)]
pub(super) enum Medium {
    Constant(Complex64),
    PerWavelength(Vec<Complex64>),
}

impl Medium {
    pub(super) fn sample(constants: &OpticalConstants, wavelengths_nm: &[f64]) -> Self {
        match constants.as_constant() {
            Some((n, k)) => Medium::Constant(Complex64::new(n, k)),
            None => Medium::PerWavelength(
                wavelengths_nm.iter().map(|&wavelength_nm| complex_index(constants, wavelength_nm)).collect(),
            ),
        }
    }

    pub(super) fn at(&self, index: usize) -> Complex64 {
        match self {
            Medium::Constant(value) => *value,
            Medium::PerWavelength(values) => values[index],
        }
    }
}

fn complex_index(constants: &OpticalConstants, wavelength_nm: f64) -> Complex64 {
    let (n, k) = constants.extended_at(wavelength_nm);
    Complex64::new(n, k)
}
