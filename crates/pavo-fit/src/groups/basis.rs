//! The wave numbers' reflectances as columns, over the window and the groups' indices.

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use pavo_optics::{Window, WindowGroup};
use pavo_spectra::fits::SensitivityFit;
use pavo_spectra::{OpticalConstants, Point};
use rayon::prelude::*;

use super::GroupsRequest;
use super::error::GREEN_NM;
use crate::film_point::FilmPoint;
use crate::media::Media;
use crate::method::angular;
use crate::separable::Basis;

/// Step of the central differences, relative to parameters of size 0.1 to 2.
const DIFFERENCE: f64 = 1e-5;

/// Parameters before those of the groups: mean wave number and spacing in 1/um, logarithm of the width in um.
const WINDOW_PARAMETERS: usize = 3;

/// Extinction coefficients below this count as none.
const NO_KAPPA: f64 = 1e-6;

/// How many wave numbers each group has.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cut(Vec<usize>);

impl Cut {
    /// Every way to cut so many wave numbers into so many groups.
    pub fn all(nodes: usize, groups: usize) -> Vec<Self> {
        if groups <= 1 {
            return vec![Self(vec![nodes])];
        }
        let of_first = |first: usize| {
            let rest = Self::all(nodes - first, groups - 1);
            rest.into_iter().map(move |rest| Self(core::iter::once(first).chain(rest.0).collect()))
        };
        (1..=nodes + 1 - groups).flat_map(of_first).collect()
    }

    fn nodes(&self) -> usize {
        self.0.iter().sum()
    }

    /// The wave numbers of each group, by their places.
    fn ranges(&self) -> impl Iterator<Item = core::ops::Range<usize>> {
        self.0.iter().scan(0, |start, &count| {
            *start += count;
            Some(*start - count..*start)
        })
    }
}

/// Which indices the groups have for themselves, and what the others are.
#[derive(Clone, Debug)]
pub(super) struct Indices {
    ambient: f64,
    film: OpticalConstants,
    base: OpticalConstants,
}

impl Indices {
    pub fn new(request: &GroupsRequest<'_>) -> Self {
        Self { ambient: request.ambient_ior, film: request.film.clone(), base: request.base.clone() }
    }

    fn own_base(&self) -> bool {
        self.base.as_constant().is_none()
    }

    fn own_film(&self) -> bool {
        self.film.as_constant().is_none()
    }

    fn parameters_per_group(&self) -> usize {
        2 * usize::from(self.own_base()) + usize::from(self.own_film())
    }

    /// A group's parameters at a wavelength: the logarithms of n and k of the base, and of what the film's index has over
    /// the ambient one.
    fn start(&self, wavelength_nm: f64) -> Vec<f64> {
        let mut parameters = Vec::new();
        if self.own_base() {
            let (n, k) = self.base.extended_at(wavelength_nm);
            parameters.extend([n.ln(), k.max(0.1 * NO_KAPPA).ln()]);
        }
        if self.own_film() {
            parameters.push((self.film.extended_at(wavelength_nm).0 - self.ambient).max(1e-6).ln());
        }
        parameters
    }

    /// The media that a group's parameters stand for.
    fn media(&self, parameters: &[f64]) -> Media {
        let (own_base, own_film) = parameters.split_at(2 * usize::from(self.own_base()));
        let base = match own_base {
            [n, k] => (n.exp(), if k.exp() < NO_KAPPA { 0.0 } else { k.exp() }),
            _ => self.base.extended_at(GREEN_NM),
        };
        let film = match own_film {
            [excess] => self.ambient + excess.exp(),
            _ => self.film.extended_at(GREEN_NM).0,
        };
        Media { ambient: self.ambient, film, base: Complex64::new(base.0, base.1) }
    }
}

/// The columns of one cut.
pub(super) struct GroupBasis {
    pub cut: Cut,
    pub indices: Indices,
    pub points: Vec<Point>,
}

impl GroupBasis {
    /// Parameters to begin with: those of a fit of windowed nodes, and the indices at the groups' mean wave numbers.
    pub fn start(&self, fit: &SensitivityFit) -> DVector<f64> {
        let terms = &fit.terms;
        let (first, last) = (terms[0].wave_number[0], terms[terms.len() - 1].wave_number[0]);
        let spacing = (last - first) / (terms.len() - 1).max(1) as f64;
        let mut parameters = vec![0.5 * (first + last), spacing, fit.window_um.unwrap_or(1e3).ln()];
        for range in self.cut.ranges() {
            let size = |term: &pavo_spectra::fits::FitTerm| -> f64 { term.weight_re.iter().map(|w| w.abs()).sum() };
            let terms = &terms[range];
            let (sum, moment) = terms.iter().fold((1e-9, 1e-9 * terms[0].wave_number[0]), |(sum, moment), term| {
                (sum + size(term), moment + size(term) * term.wave_number[0])
            });
            parameters.extend(self.indices.start(1e3 * sum / moment));
        }
        DVector::from_vec(parameters)
    }

    /// The window and the groups that parameters and weights stand for.
    pub fn method(&self, parameters: &[f64], weights: &DMatrix<f64>) -> (Window, Vec<WindowGroup>) {
        let window = Window {
            first: self.wave_number(parameters, 0),
            step: angular(parameters[1]),
            width_nm: parameters[2].exp() * 1e3,
            weights: weights.row_iter().map(|row| [row[0], row[1], row[2]]).collect(),
        };
        let groups = self.cut.0.iter().zip(self.media(parameters)).map(|(&nodes, media)| WindowGroup {
            nodes,
            base: self.indices.own_base().then_some((media.base.re, media.base.im)),
            film: self.indices.own_film().then_some(media.film),
        });
        (window, groups.collect())
    }

    /// Radians per nm.
    fn wave_number(&self, parameters: &[f64], node: usize) -> f64 {
        angular(parameters[0] + parameters[1] * (node as f64 - 0.5 * (self.cut.nodes() - 1) as f64))
    }

    /// The media of each group.
    fn media(&self, parameters: &[f64]) -> Vec<Media> {
        let count = self.indices.parameters_per_group();
        let own = |group: usize| &parameters[WINDOW_PARAMETERS + count * group..][..count];
        (0..self.cut.0.len()).map(|group| self.indices.media(own(group))).collect()
    }
}

impl Basis for GroupBasis {
    fn count(&self) -> usize {
        self.cut.nodes()
    }

    fn has_complex_weights(&self) -> bool {
        false
    }

    fn columns(&self, parameters: &[f64]) -> DMatrix<f64> {
        let width_nm = parameters[2].exp() * 1e3;
        let media = self.media(parameters);
        let mut rows = Vec::with_capacity(self.points.len() * self.count());
        for &point in &self.points {
            for (range, &media) in self.cut.ranges().zip(&media) {
                let wave_numbers = range.map(|node| self.wave_number(parameters, node));
                rows.extend(FilmPoint::new(media, point).windowed_nodes(width_nm, wave_numbers));
            }
        }
        DMatrix::from_row_slice(self.points.len(), self.count(), &rows)
    }

    fn slopes(&self, parameters: &[f64], weights: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        let moved = |parameter: usize, step: f64| {
            let mut parameters = parameters.to_vec();
            parameters[parameter] += step;
            self.columns(&parameters) * weights
        };
        let slope = |p: usize| (moved(p, DIFFERENCE) - moved(p, -DIFFERENCE)) / (2.0 * DIFFERENCE);
        (0..parameters.len()).into_par_iter().map(slope).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Cut;

    #[test]
    fn every_cut_is_there_once() {
        let cuts = Cut::all(6, 3);
        assert_eq!(cuts.len(), 10);
        assert!(cuts.iter().all(|cut| cut.nodes() == 6 && cut.0.len() == 3 && cut.0.iter().all(|&count| count > 0)));
        assert!(cuts.iter().enumerate().all(|(index, cut)| !cuts[..index].contains(cut)));
        assert_eq!(Cut::all(4, 4), [Cut(vec![1; 4])]);
    }
}
