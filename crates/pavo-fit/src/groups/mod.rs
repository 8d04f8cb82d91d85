//! Groups of optical constants: wave numbers under a window ([`pavo_optics::grouped`]) whose weights, window and indices are
//! fitted to the reflectance of one scene, where base or film depend on the wavelength.
//!
//! The start is the built-in fit of windowed nodes, cut into groups; each group has the indices of its mean wavelength. For
//! each way to cut it the weights are solved for; the best go on by Levenberg-Marquardt over the window (mean wave number,
//! spacing, width) and the groups' indices, with the weights solved for at each step (variable projection), so that a
//! mirror stays white.

mod basis;
mod error;

use pavo_optics::film::film_reflectance;
use pavo_optics::{BaseKind, Film, Method, Precision, Window, WindowGroup};
use pavo_spectra::fits::{FitFamily, SensitivityFit, built_in};
use pavo_spectra::{OpticalConstants, Point, Reference, Sensitivities, Stack};
use rayon::prelude::*;

use self::basis::{Cut, GroupBasis, Indices};
use crate::points::spread;
use crate::sensitivity::{BUILT_IN_SEED, FitRequest, fit};
use crate::separable::Separable;
use nalgebra::{DMatrix, DVector};

pub use self::error::GroupsError;

/// Points within the ranges, points along each edge, and the shift: of the fit, and of the judgement.
const FITTED: (usize, usize, f64) = (1500, 30, 0.137);
const HELD_OUT: (usize, usize, f64) = (2048, 33, 0.611);

/// How many cuts go on, and the evaluations for each parameter.
const ROUNDS: [(usize, usize); 2] = [(4, 3), (1, 12)];

/// The scene, and the sizes of the fit.
#[derive(Clone, Debug)]
pub struct GroupsRequest<'a> {
    /// Refractive index of the ambient medium, > 0.
    pub ambient_ior: f64,
    /// The film; its index is above that of the ambient medium over the visible range.
    pub film: OpticalConstants,
    /// The base.
    pub base: OpticalConstants,
    /// The smallest and the largest thickness, nm, from 0 on; the second above the first.
    pub thickness_nm: [f64; 2],
    /// The sensitivities of the output channels.
    pub sensitivities: &'a Sensitivities,
    /// How many wave numbers, within the counts of [`FitFamily::WindowedNodes`].
    pub nodes: usize,
    /// How many groups, from 1 to the number of wave numbers.
    pub groups: usize,
}

/// Wave numbers in groups, fitted to a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct GroupsFit {
    /// The wave numbers, with weights that sum to 1 in each channel.
    pub window: Window,
    /// The groups. Base and film have own indices where they depend on the wavelength.
    pub groups: Vec<WindowGroup>,
    /// The root of the mean square error over held-out points and channels, evaluated in `f32`.
    pub rms: f64,
    /// The largest error in any channel of any held-out point, evaluated in `f32`.
    pub max: f64,
    /// How many points were held out.
    pub points: usize,
}

impl GroupsFit {
    /// The method.
    pub fn method(&self) -> Method {
        Method::WindowedGroups { window: self.window.clone(), groups: self.groups.clone() }
    }
}

/// Fits groups of indices to a scene: over `cos(theta1)` from 0.01 to 1 and the range of thickness.
///
/// # Errors
/// A request that makes no sense, or sensitivities that no windowed nodes can be fitted to.
pub fn fit_groups(request: &GroupsRequest<'_>) -> Result<GroupsFit, GroupsError> {
    request.check()?;
    let stack = Stack::new(request.ambient_ior, request.film.clone(), request.base.clone())?;
    let reference = Reference::new(request.sensitivities);
    let prepared = reference.prepare(&stack);
    let points = |(inner, edge, shift)| spread(request.thickness_nm, inner, edge, shift);
    let fitted = points(FITTED);
    let values = prepared.reflectance_of_each(&fitted);
    let targets = DMatrix::from_fn(fitted.len(), 3, |row, channel| values[row][channel]);
    let ones = DVector::from_element(fitted.len(), 1.0);

    let start = request.start()?;
    let basis = |cut: &Cut| GroupBasis { cut: cut.clone(), indices: Indices::new(request), points: fitted.clone() };
    let mut candidates: Vec<(f64, Cut, DVector<f64>)> = Cut::all(request.nodes, request.groups)
        .into_par_iter()
        .map(|cut| {
            let basis = basis(&cut);
            let parameters = basis.start(&start);
            let sum = Separable::new(&basis, &targets, &ones, parameters.clone()).sum_of_squares();
            (sum, cut, parameters)
        })
        .collect();
    for (count, patience) in ROUNDS {
        candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
        candidates.truncate(count);
        candidates = candidates
            .into_par_iter()
            .map(|(_, cut, parameters)| {
                let basis = basis(&cut);
                let fit = Separable::new(&basis, &targets, &ones, parameters).minimise(patience);
                (fit.sum_of_squares(), cut, fit.parameters().clone())
            })
            .collect();
    }
    let (_, cut, parameters) = candidates.swap_remove(0);
    let basis = basis(&cut);
    let weights = Separable::new(&basis, &targets, &ones, parameters.clone()).weights().clone();
    let (window, groups) = basis.method(parameters.as_slice(), &weights);

    let held_out = points(HELD_OUT);
    let expected = prepared.reflectance_of_each(&held_out);
    let mut fit = GroupsFit { window, groups, rms: 0.0, max: 0.0, points: held_out.len() };
    (fit.rms, fit.max) = request.errors(&fit, &held_out, &expected);
    Ok(fit)
}

impl GroupsRequest<'_> {
    /// The windowed nodes to begin with.
    fn start(&self) -> Result<SensitivityFit, GroupsError> {
        let (film_ior, _) = self.film.extended_at(error::GREEN_NM);
        let max_opd_um = 2e-3 * film_ior * self.thickness_nm[1];
        let (family, count) = (FitFamily::WindowedNodes, self.nodes);
        if let Some(found) = built_in(family, count, self.sensitivities, max_opd_um) {
            return Ok(found);
        }
        let (observer, space) = (self.sensitivities.observer(), self.sensitivities.space());
        let illuminant = self.sensitivities.illuminant().clone();
        let max_opd_um = max_opd_um.clamp(1.8, 12.0);
        Ok(fit(&FitRequest { family, count, observer, illuminant, space, max_opd_um, seed: BUILT_IN_SEED })?)
    }

    /// The root of the mean square and the largest of the errors in `f32`; infinite where it is not finite.
    fn errors(&self, fit: &GroupsFit, points: &[Point], expected: &[[f64; 3]]) -> (f64, f64) {
        let film = Film {
            base: BaseKind::Conductor,
            total_reflection: false,
            method: fit.method(),
            // Without total reflection they are not used.
            channel_wavelengths_nm: [error::GREEN_NM; 3],
            precision: Precision::FULL,
        };
        let [(film_ior, _), (ior, kappa)] = [&self.film, &self.base].map(|medium| medium.extended_at(error::GREEN_NM));
        let [ambient_ior, film_ior, ior, kappa] = [self.ambient_ior, film_ior, ior, kappa].map(|number| number as f32);
        let (mut squares, mut largest) = (0.0, 0.0_f64);
        for (point, expected) in points.iter().zip(expected) {
            let [cos_theta1, thickness] = [point.cos_theta1, point.thickness_nm].map(|number| number as f32);
            let found = film_reflectance::<f32, f32>(&film, cos_theta1, thickness, ambient_ior, film_ior, ior, kappa)
                .to_array();
            for (found, expected) in found.into_iter().zip(expected) {
                let difference = (f64::from(found) - expected).abs();
                let difference = if difference.is_nan() { f64::INFINITY } else { difference };
                squares += difference * difference;
                largest = largest.max(difference);
            }
        }
        ((squares / (3 * points.len()) as f64).sqrt(), largest)
    }
}
