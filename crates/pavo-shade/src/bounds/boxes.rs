//! Boxes: a range for each parameter of a function, by component.

use crate::function::Input;
use crate::interval::{Interval, Precision};

/// The ranges of a function's parameters, by component.
pub(super) type Parameters<P> = Vec<Interval<P>>;

impl Input {
    /// Its range, once for each component.
    pub(super) fn range<P: Precision>(&self) -> Parameters<P> {
        vec![Interval::new(self.low, self.high); self.components()]
    }
}

/// The parameter of which the most of its range is left, among those in a mask.
pub(super) fn widest<P: Precision>(part: &[Interval<P>], whole: &[Interval<P>], mask: u64) -> Option<usize> {
    let share = |index: usize| (part[index].high() - part[index].low()) / (whole[index].high() - whole[index].low());
    let wide = (0..part.len()).filter(|&index| mask & (1 << (index % 64)) != 0).filter(|&index| share(index) > 1e-6);
    wide.max_by(|&a, &b| share(a).total_cmp(&share(b)).then(b.cmp(&a)))
}

/// Both halves of a box along one parameter.
pub(super) fn halves<P: Precision>(part: &[Interval<P>], dimension: usize) -> [Parameters<P>; 2] {
    part[dimension].halves().map(|half| {
        let mut part = part.to_vec();
        part[dimension] = half;
        part
    })
}

/// A box halved along its widest parameters in turn.
pub(super) fn halved<P: Precision>(whole: Parameters<P>, most: usize) -> Vec<Parameters<P>> {
    let mut parts = vec![whole.clone()];
    while parts.len() * 2 <= most {
        let Some(dimension) = widest(&parts[0], &whole, u64::MAX) else { break };
        parts = parts.iter().flat_map(|part| halves(part, dimension)).collect();
    }
    parts
}

/// Up to `count` points of a box: corners for a third, the rest spread within.
pub(super) fn points<P: Precision>(whole: &[Interval<P>], count: usize) -> impl Iterator<Item = Parameters<P>> {
    // Multiples of the golden ratio, with another factor for each parameter.
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let corners = (1_usize << whole.len().min(5)).min(count.div_ceil(3));
    let fraction = move |number: usize, index: usize| match number < corners {
        true => f64::from(u8::from(number >> (index % 5) & 1 == 1)),
        false => (number as f64 * (index as f64 + 1.0).sqrt() * GOLDEN).fract(),
    };
    (0..count).map(move |number| {
        let at = |(index, range): (usize, &Interval<P>)| range.point_within(fraction(number, index));
        whole.iter().enumerate().map(at).collect()
    })
}
