//! Points that are no numbers, beside ordinary ones.

use super::StabilityError;
use super::catalogue::Case;
use super::checks::Largest;
use super::examine::Examination;
use super::part::Part;
use crate::roads::Prepared;

/// The case whose points stand beside those that are no numbers.
const ORDINARY: &str = "ordinary";

impl Examination<'_> {
    /// How many of the ordinary points get another colour where every other point is one of a case, with how many there
    /// are. The device computes several points at once: what one of them is must not matter to the others.
    pub(super) fn contained(
        &self,
        part: &Part<'_>,
        by_wgsl: &Prepared,
        first: usize,
        case: &Case,
    ) -> Result<(Largest, usize), StabilityError> {
        let ordinary = part.cases.iter().find(|cases| cases.case.name == ORDINARY).ok_or_else(|| {
            StabilityError::Data(format!("catalogue.toml: {}: there is no case {ORDINARY} beside it", case.name))
        })?;
        let count = case.points.min(ordinary.case.points);
        let point = |index: usize| &part.points[index * part.width..(index + 1) * part.width];
        let alone: Vec<f32> = (0..count).flat_map(|place| point(ordinary.first + place)).copied().collect();
        let beside: Vec<f32> =
            (0..count).flat_map(|place| [point(ordinary.first + place), point(first + place)].concat()).collect();
        let [alone, beside] = [by_wgsl.evaluate(self.device, &alone)?, by_wgsl.evaluate(self.device, &beside)?];
        let mut changed = Largest::default();
        for place in 0..count {
            let is_changed = alone[place].map(f32::to_bits) != beside[2 * place].map(f32::to_bits);
            changed.add(ordinary.first + place, f64::from(u8::from(is_changed)));
        }
        Ok((changed, count))
    }
}
