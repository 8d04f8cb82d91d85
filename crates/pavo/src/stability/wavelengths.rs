//! The reflectance at single wavelengths, by the methods that evaluate such.

use super::StabilityError;
use super::checks::{Largest, outside};
use super::examine::{Examination, Examined, in_f64_of, largest_of};
use super::finding::{Check, Finding, SWEEP};
use crate::roads::{Prepared, Road};
use crate::shading::Shading;
use rayon::prelude::*;

impl Examination<'_> {
    /// Holds the reflectance at three wavelengths within [0, 1], in the cases that ask for it of the colour, and over the
    /// sweep.
    pub(super) fn single_wavelengths(&self, shading: &Shading, examined: &mut Examined) -> Result<(), StabilityError> {
        let Some(single) = shading.at_single_wavelengths() else { return Ok(()) };
        let part = &self.reflectance;
        let prepared = Prepared::new(Road::Wgsl, &single, part.quantity)?;
        let points: Vec<Vec<f32>> = part.points.chunks_exact(part.width).map(<[f32]>::to_vec).collect();
        let double: Vec<Vec<f64>> = points.iter().map(|point| point.iter().copied().map(f64::from).collect()).collect();
        let evaluated = [
            ("cpu f64", single.evaluate_each(part.quantity, &double)),
            ("cpu f32", in_f64_of(&single.evaluate_each_f32(part.quantity, &points))),
            (Road::Wgsl.name(), in_f64_of(&prepared.evaluate(self.device, &part.points)?)),
        ];
        examined.device_points += points.len();
        for cases in part.cases.iter().filter(|cases| cases.case.checks.contains(&Check::Range)) {
            let range = cases.first..cases.first + cases.case.points;
            let (evaluator, largest) = largest_of(evaluated.iter().map(|(name, reflectances)| {
                (*name, Largest::of(range.clone().map(|index| (index, outside(reflectances[index])))))
            }));
            let worst = largest.index.map_or(Vec::new(), |index| points[index].clone());
            let count = cases.case.points;
            let finding = self.finding(shading, &cases.case.name, Check::Wavelength, evaluator, count, largest.value);
            examined.findings.push(Finding { worst, ..finding });
        }
        let width = part.width.max(1);
        let count = self.share(shading).min(self.sweep.len() / width);
        if count > 0 {
            let sweep = &self.sweep[..count * width];
            let reflectances = prepared.evaluate(self.device, sweep)?;
            examined.device_points += reflectances.len();
            let largest = reflectances
                .par_iter()
                .enumerate()
                .fold(Largest::default, |mut largest, (index, reflectance)| {
                    largest.take(index, outside(reflectance.map(f64::from)));
                    largest
                })
                .reduce(Largest::default, Largest::or);
            let worst = largest.index.map_or(Vec::new(), |index| sweep[index * width..(index + 1) * width].to_vec());
            let finding = self.finding(shading, SWEEP, Check::Wavelength, Road::Wgsl.name(), count, largest.value);
            examined.findings.push(Finding { worst, ..finding });
        }
        Ok(())
    }
}
