//! Outward-rounded bounds of a reflectance over boxes of the ranges of its inputs.
//!
//! Bounds lose what connects two numbers: they are wide where a method divides by a difference of such, as the kernel
//! under a window does, which needs small boxes to be bounded at all. They hold for `f64` and for `f32` on any device that keeps to the precision of `pavo_shade::interval::Single`.

use super::{QUANTITY, inputs, on_all_cores, reflectances};
use crate::points::columns;
use crate::shading::Shading;
use pavo_shade::interval::{Interval, Single};
use pavo_shade::{Input, bounds_over};
use serde::Serialize;

/// Bounds over a grid of boxes that cover the ranges of the inputs.
#[derive(Clone, Debug)]
pub struct ReflectanceBounds {
    /// Where each number that the reflectance depends on stands in a point.
    columns: Vec<usize>,
    /// The ends of the boxes along each of these numbers, ascending.
    ends: Vec<Vec<f64>>,
    /// The bounds of the channels, by box; the first number changes fastest.
    boxes: Vec<[Interval<Single>; 3]>,
}

/// Bounds in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// How many boxes the ranges were divided into.
    pub boxes: usize,
    /// The lower bound of each channel over all boxes that are bounded; infinite, in JSON `null`, where none is.
    pub low: [f64; 3],
    /// The upper bound of each channel over all boxes that are bounded; infinite, in JSON `null`, where none is.
    pub high: [f64; 3],
    /// The mean distance between the bounds of a box.
    pub mean_width: f64,
    /// How many boxes have a channel without finite bounds.
    pub unbounded: usize,
}

/// What a comparison of samples with bounds gives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Enclosure {
    /// How many samples were compared, each of three channels.
    pub samples: usize,
    /// How many of them have a channel outside of its bounds, or that is no number where the bounds exclude it.
    pub outside: usize,
    /// How many of them are in a box with a channel without finite bounds: there nothing is said.
    pub unbounded: usize,
}

impl ReflectanceBounds {
    /// The bounds over up to this many boxes, with cosines from 0.05.
    pub fn of(shading: &Shading, most: usize) -> Self {
        let program = shading.program(QUANTITY);
        let inputs = inputs(shading);
        let columns = columns(&inputs, program.inputs());
        let range = |input: &Input| std::iter::repeat_n([input.low, input.high], input.components());
        let ranges: Vec<[f64; 2]> = inputs.iter().flat_map(range).collect();
        let parts = parts(columns.len(), most);
        let ends: Vec<Vec<f64>> =
            columns.iter().zip(parts).map(|(&column, parts)| ends(ranges[column], parts)).collect();
        let count = ends.iter().map(|ends| ends.len() - 1).product();
        let numbers: Vec<usize> = (0..count).collect();
        let boxes = on_all_cores(&numbers, |numbers| {
            let boxes: Vec<Vec<[f64; 2]>> = numbers.iter().map(|&number| ranges_of(&ends, number)).collect();
            reflectances(bounds_over::<Single>(&program, &boxes))
        });
        Self { columns, ends, boxes }
    }

    /// The bounds of the channels at a point, which has a number for each component of each input of the surface.
    /// Nothing outside of the ranges of the inputs.
    pub fn at(&self, point: &[f64]) -> Option<[Interval<Single>; 3]> {
        let (mut number, mut stride) = (0, 1);
        for (&column, ends) in self.columns.iter().zip(&self.ends) {
            let value = point[column];
            if !(ends[0] <= value && value <= ends[ends.len() - 1]) {
                return None;
            }
            let index = ends.partition_point(|&end| end <= value).clamp(1, ends.len() - 1) - 1;
            number += stride * index;
            stride *= ends.len() - 1;
        }
        Some(self.boxes[number])
    }

    /// Compares colours with the bounds at their points. Points outside of the ranges are not counted.
    pub fn enclose(&self, points: &[Vec<f32>], colors: &[[f32; 3]]) -> Enclosure {
        let mut enclosure = Enclosure::default();
        for (point, color) in points.iter().zip(colors) {
            let point: Vec<f64> = point.iter().copied().map(f64::from).collect();
            let Some(bounds) = self.at(&point) else { continue };
            enclosure.samples += 1;
            let contains = |(bounds, &channel): (&Interval<Single>, &f32)| bounds.contains(f64::from(channel));
            enclosure.outside += usize::from(!bounds.iter().zip(color).all(contains));
            enclosure.unbounded += usize::from(!bounds.iter().all(is_finite));
        }
        enclosure
    }

    /// The bounds in short.
    pub fn summary(&self) -> Summary {
        let bounded: Vec<_> = self.boxes.iter().filter(|channels| channels.iter().all(is_finite)).collect();
        let over = |from: f64, choose: fn(f64, f64) -> f64, end: fn(Interval<Single>) -> f64| {
            [0, 1, 2].map(|channel| bounded.iter().fold(from, |all, channels| choose(all, end(channels[channel]))))
        };
        let widths = bounded.iter().flat_map(|channels| channels.iter().map(|bounds| bounds.high() - bounds.low()));
        Summary {
            boxes: self.boxes.len(),
            low: over(f64::INFINITY, f64::min, Interval::low),
            high: over(f64::NEG_INFINITY, f64::max, Interval::high),
            mean_width: widths.sum::<f64>() / (3 * bounded.len()).max(1) as f64,
            unbounded: self.boxes.len() - bounded.len(),
        }
    }
}

fn is_finite(bounds: &Interval<Single>) -> bool {
    bounds.is_defined() && bounds.low().is_finite() && bounds.high().is_finite()
}

/// Into how many parts each number is divided: doubled by turns as long as there are no more than so many boxes.
fn parts(numbers: usize, most: usize) -> Vec<usize> {
    let mut parts = vec![1; numbers];
    let mut boxes = 1;
    for turn in 0.. {
        if numbers == 0 || boxes * 2 > most {
            break;
        }
        parts[turn % numbers] *= 2;
        boxes *= 2;
    }
    parts
}

/// The ends of equal parts of a range. Points are numbers of `f32`, so its own ends are the nearest of these outwards.
fn ends([low, high]: [f64; 2], parts: usize) -> Vec<f64> {
    let end = |index: usize| low + (high - low) * index as f64 / parts as f64;
    let mut ends: Vec<f64> = (0..=parts).map(end).collect();
    ends[0] = low.min(f64::from(low as f32));
    ends[parts] = high.max(f64::from(high as f32));
    ends
}

/// The ranges of a box.
fn ranges_of(ends: &[Vec<f64>], mut number: usize) -> Vec<[f64; 2]> {
    let range = |ends: &Vec<f64>| {
        let index = number % (ends.len() - 1);
        number /= ends.len() - 1;
        [ends[index], ends[index + 1]]
    };
    ends.iter().map(range).collect()
}
