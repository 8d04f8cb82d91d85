//! Windowed nodes, fitted to the reflectance itself.
//!
//! Their resummation carries the window's damping exactly in orders 1 and 2 only, so that the best weights, spacing and
//! window are not those of the transform. The reflectance is linear in the weights once they sum to 1, which makes it
//! separable too: three parameters (mean wave number, spacing, log of the window's width) are iterated on.

use nalgebra::{DMatrix, DVector};
use pavo_spectra::{Point, Sensitivities};

use super::classes::film_classes;
use super::film_samples::FilmSamples;
use super::random::SplitMix64;
use super::transform_basis::{Form, TransformBasis, equispaced};
use super::transform_fit::{Samples, Solution, first_fits, weights_are_bounded};
use crate::film_point::FilmPoint;
use crate::method::angular;
use crate::separable::{Basis, Separable};

/// Points of each class of films.
const POINTS_PER_CLASS: usize = 200;

/// One point in this many is drawn from all thicknesses.
const BEYOND: usize = 4;

/// Thickest film, in nanometres.
const THICKEST_NM: f64 = 3000.0;

/// Least cosine of the angle of incidence.
const LEAST_COSINE: f64 = 0.01;

/// Fits of the transform that are taken further.
const STARTS: usize = 3;

/// Step of the central differences, relative to parameters of size 0.1 to 2.
const DIFFERENCE: f64 = 1e-5;

/// Points of every class: cosines uniform in [0.01, 1], thicknesses uniform up to 3000 nm or to where the optical path
/// difference reaches the range, whichever is less. One point in [`BEYOND`] knows no range, so that a fit for thin films
/// stays sound on thick ones.
pub(super) fn training_samples(sensitivities: &Sensitivities, max_opd_um: f64, seed: u64) -> FilmSamples {
    let mut random = SplitMix64::new(seed);
    FilmSamples::new(sensitivities, &film_classes(), |class| {
        let mut place = |index: usize| {
            let cos_theta1 = random.between(LEAST_COSINE, 1.0);
            let opd_um_per_nm = 2e-3 * class.media.path_per_nm(cos_theta1);
            let reach_nm = if index.is_multiple_of(BEYOND) { THICKEST_NM } else { max_opd_um / opd_um_per_nm };
            Point { cos_theta1, thickness_nm: random.uniform() * THICKEST_NM.min(reach_nm) }
        };
        (0..POINTS_PER_CLASS).map(&mut place).collect()
    })
}

struct ReflectanceBasis {
    count: usize,
    points: Vec<FilmPoint>,
}

impl Basis for ReflectanceBasis {
    fn count(&self) -> usize {
        self.count
    }

    fn has_complex_weights(&self) -> bool {
        false
    }

    fn columns(&self, parameters: &[f64]) -> DMatrix<f64> {
        let width_nm = parameters[2].exp() * 1e3;
        let wave_numbers = (0..self.count).map(|k| angular(equispaced(parameters[0], parameters[1], self.count, k)));
        let nodes = self.points.iter().flat_map(|point| point.windowed_nodes(width_nm, wave_numbers.clone()));
        DMatrix::from_row_iterator(self.points.len(), self.count, nodes)
    }

    fn slopes(&self, parameters: &[f64], weights: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        let moved = |parameter: usize, step: f64| {
            let mut parameters = parameters.to_vec();
            parameters[parameter] += step;
            self.columns(&parameters) * weights
        };
        let slope = |p: usize| (moved(p, DIFFERENCE) - moved(p, -DIFFERENCE)) / (2.0 * DIFFERENCE);
        (0..parameters.len()).map(slope).collect()
    }
}

/// The windowed nodes of least mean square of the reflectance's error, begun from the best fits of the transform.
pub(super) fn fit_windowed(
    count: usize,
    transform: &Samples,
    reflectance: &FilmSamples,
    seed: u64,
) -> Option<Solution> {
    let start_basis = TransformBasis { form: Form::WindowedNodes, count, opds_um: transform.opds_um.clone() };
    let points = reflectance.points.iter().map(|&(media, point)| FilmPoint::new(media, point)).collect();
    let basis = ReflectanceBasis { count, points };
    let values = DMatrix::from_fn(reflectance.values.len(), 3, |row, channel| reflectance.values[row][channel]);
    let ones = DVector::from_element(values.nrows(), 1.0);
    let mut best: Option<(f64, Solution)> = None;
    for start in first_fits(&start_basis, transform, seed).into_iter().take(STARTS) {
        let fit = Separable::new(&basis, &values, &ones, start).minimise(15);
        let sum = fit.sum_of_squares();
        if weights_are_bounded(&start_basis, fit.weights()) && best.as_ref().is_none_or(|(least, _)| sum < *least) {
            let max_error = fit.unscaled_residuals().amax();
            let parameters = fit.parameters().as_slice().to_vec();
            best = Some((sum, Solution { parameters, weights: fit.weights().clone(), max_error }));
        }
    }
    best.map(|(_, solution)| solution)
}
