//! The figures of single points.

use crate::inputs::ShadingQuantity;
use crate::shading::Shading;
use pavo_spectra::ColourSpace;

/// The largest of some figures with its place; what is not a number counts as infinite.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Largest {
    pub value: f64,
    pub index: Option<usize>,
}

impl Largest {
    /// Takes a figure in.
    pub fn take(&mut self, index: usize, value: f64) {
        let value = if value.is_nan() { f64::INFINITY } else { value };
        if value > self.value || self.index.is_none() {
            *self = Self { value, index: Some(index) };
        }
    }

    /// Adds a count, and keeps the first place that has any.
    pub fn add(&mut self, index: usize, count: f64) {
        if count > 0.0 {
            self.value += count;
            self.index = self.index.or(Some(index));
        }
    }

    /// The sum of two counts.
    pub fn and(self, other: Self) -> Self {
        Self { value: self.value + other.value, index: self.index.or(other.index) }
    }

    /// The larger of two.
    pub fn or(self, other: Self) -> Self {
        if other.index.is_some() && (self.index.is_none() || other.value > self.value) { other } else { self }
    }

    /// The largest over a list.
    pub fn of(values: impl IntoIterator<Item = (usize, f64)>) -> Self {
        let mut largest = Self::default();
        values.into_iter().for_each(|(index, value)| largest.take(index, value));
        largest
    }
}

/// From a linear colour to CIE XYZ over that of white.
#[derive(Clone, Copy, Debug)]
pub(super) struct OverWhite([[f64; 3]; 3]);

impl OverWhite {
    pub fn of(space: ColourSpace) -> Self {
        Self(space.rgb_to_xyz().map(|row| {
            let white: f64 = row.iter().sum();
            row.map(|factor| factor / white)
        }))
    }

    pub fn xyz(self, color: [f64; 3]) -> [f64; 3] {
        self.0.map(|row| row[0] * color[0] + row[1] * color[1] + row[2] * color[2])
    }

    /// How far a colour leaves [0, 1] in any of X, Y and Z over those of white.
    pub fn excess(self, color: [f64; 3]) -> f64 {
        outside(self.xyz(color))
    }
}

/// How far a colour leaves [0, 1] in any channel.
pub(super) fn outside(color: [f64; 3]) -> f64 {
    color.into_iter().map(beyond).fold(0.0, f64::max)
}

/// How far a number leaves [0, 1].
fn beyond(value: f64) -> f64 {
    if value.is_nan() { f64::INFINITY } else { (value - 1.0).max(-value).max(0.0) }
}

/// How many numbers of a colour are not finite.
pub(super) fn not_finite(color: [f64; 3]) -> f64 {
    color.into_iter().filter(|value| !value.is_finite()).count() as f64
}

/// The largest difference of two colours in a channel.
pub(super) fn difference(found: [f64; 3], expected: [f64; 3]) -> f64 {
    let pairs = found.into_iter().zip(expected);
    pairs.map(|(found, expected)| (found - expected).abs()).fold(0.0, |a, b| if b.is_nan() { b } else { b.max(a) })
}

/// How far the channels of a colour are apart.
pub(super) fn colouring([r, g, b]: [f64; 3]) -> f64 {
    r.max(g).max(b) - r.min(g).min(b)
}

/// How far the colour jumps from a point to the next number of `f32` in each of its inputs, beyond three times what the
/// derivatives at both ends allow.
pub(super) fn jump(shading: &Shading, quantity: ShadingQuantity, point: &[f32], highs: &[f64]) -> f64 {
    const SLACK: f64 = 3.0;
    let start: Vec<f64> = point.iter().copied().map(f64::from).collect();
    let mut largest = 0.0_f64;
    for column in 0..point.len() {
        let next = f64::from(point[column].next_up());
        if next > highs[column] {
            continue;
        }
        let mut end = start.clone();
        end[column] = next;
        let [(from, slope), (to, slope_there)] =
            [&start, &end].map(|point| shading.evaluate_with_derivative(quantity, point, column));
        for channel in 0..3 {
            let allowed = SLACK * slope[channel].abs().max(slope_there[channel].abs()) * (next - start[column]);
            // An infinite derivative, as that of a root at 0, allows any step.
            let excess = if allowed.is_finite() { (to[channel] - from[channel]).abs() - allowed } else { 0.0 };
            largest = largest.max(excess);
        }
    }
    largest
}

/// The difference of the BRDFs that two radiances speak of, relative to the larger of them and 1.
pub(super) fn exchange(radiance: [f64; 3], n_dot_l: f64, exchanged: [f64; 3], n_dot_v: f64) -> f64 {
    let [brdf, other] =
        [(radiance, n_dot_l), (exchanged, n_dot_v)].map(|(color, cosine)| color.map(|value| value / cosine));
    let relative = |channel: usize| {
        (brdf[channel] - other[channel]).abs() / brdf[channel].abs().max(other[channel].abs()).max(1.0)
    };
    relative(0).max(relative(1)).max(relative(2))
}
