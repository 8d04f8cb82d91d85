//! The exact spectral reference: a film's reflectance in colour, by the complex Airy formula at every wavelength of the
//! fine grid, in f64. Every fast method is judged against it, so it shares no formula with any.

mod airy;
mod stack;

pub use stack::{Point, Stack, StackError};

use num_complex::Complex64;

use self::airy::FilmAtAngle;
use self::stack::Medium;
use crate::parallel::map_each;
use crate::sensitivity::Sensitivities;
use crate::wavelength::fine_grid;

/// The reference for one set of sensitivities.
#[derive(Debug, Clone)]
pub struct Reference {
    wavelengths_nm: Vec<f64>,
    weights: Vec<[f64; 3]>,
}

/// A stack whose optical constants are sampled on the grid of a [`Reference`]: many points then cost little each.
#[derive(Debug)]
pub struct PreparedStack<'r> {
    reference: &'r Reference,
    ambient_ior: f64,
    film: Medium,
    base: Medium,
}

impl Reference {
    /// The reference over the fine grid, with the sensitivities' weights there.
    pub fn new(sensitivities: &Sensitivities) -> Self {
        Self { wavelengths_nm: fine_grid(), weights: sensitivities.fine_weights().to_vec() }
    }

    /// Samples a stack's optical constants on the grid. Where its data fall short of 360 to 830 nm they are extended, as
    /// [`Stack::warnings`] says.
    pub fn prepare(&self, stack: &Stack) -> PreparedStack<'_> {
        PreparedStack {
            reference: self,
            ambient_ior: stack.ambient_ior(),
            film: Medium::sample(stack.film(), &self.wavelengths_nm),
            base: Medium::sample(stack.base(), &self.wavelengths_nm),
        }
    }

    /// The reflectance per output channel at one point of a stack. For many points of one stack, prepare it.
    pub fn reflectance(&self, stack: &Stack, point: Point) -> [f64; 3] {
        self.prepare(stack).reflectance(point)
    }

    /// The reflectance per output channel for many points, each with a stack of its own, in parallel.
    pub fn reflectance_of_each(&self, samples: &[(Stack, Point)]) -> Vec<[f64; 3]> {
        map_each(samples, |(stack, point)| self.reflectance(stack, *point))
    }

    /// The reflectance where each output channel has a complex base index of its own, the same at every wavelength: what
    /// a base asks for that is known by its reflectance at normal incidence. All real parts are above 0.
    pub fn reflectance_per_channel(
        &self,
        ambient_ior: f64,
        film_ior: f64,
        base: [(f64, f64); 3],
        point: Point,
    ) -> [f64; 3] {
        let film = Complex64::from(film_ior);
        std::array::from_fn(|channel| {
            let (n, k) = base[channel];
            let film = FilmAtAngle::new(ambient_ior, film, Complex64::new(n, k), point.cos_theta1);
            self.integrate(|index| film.reflectance(point.thickness_nm / self.wavelengths_nm[index]))[channel]
        })
    }

    /// The sum over the grid of a reflectance, by the index of the wavelength, times the weights.
    fn integrate(&self, reflectance: impl Fn(usize) -> f64) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for (index, weight) in self.weights.iter().enumerate() {
            let value = reflectance(index);
            for (sum, weight) in sums.iter_mut().zip(weight) {
                *sum += value * weight;
            }
        }
        sums
    }
}

impl PreparedStack<'_> {
    /// The reflectance per output channel at one point.
    pub fn reflectance(&self, point: Point) -> [f64; 3] {
        let Point { cos_theta1, thickness_nm } = point;
        let wavelengths_nm = &self.reference.wavelengths_nm;
        if let (&Medium::Constant(film), &Medium::Constant(base)) = (&self.film, &self.base) {
            // Nothing but the phase depends on the wavelength.
            let film = FilmAtAngle::new(self.ambient_ior, film, base, cos_theta1);
            return self.reference.integrate(|index| film.reflectance(thickness_nm / wavelengths_nm[index]));
        }
        self.reference.integrate(|index| {
            FilmAtAngle::new(self.ambient_ior, self.film.at(index), self.base.at(index), cos_theta1)
                .reflectance(thickness_nm / wavelengths_nm[index])
        })
    }

    /// The reflectance per output channel at many points, in parallel.
    pub fn reflectance_of_each(&self, points: &[Point]) -> Vec<[f64; 3]> {
        map_each(points, |&point| self.reflectance(point))
    }
}
