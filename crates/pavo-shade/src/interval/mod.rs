//! Intervals: numbers of which only bounds are known.
//!
//! Each operation gives bounds of all results that its operands may lead to, widened by the error that the arithmetic
//! may make ([`Precision`]). What an operation is not defined for (a root of what may be negative, a division by what
//! may be 0) leaves an interval that is not [`Interval::is_defined`]: the bounds hold where it is a number at all.
//!
//! `max`, `min` and `clamp` of a number and what is none give the number, as they do on the CPU. A device that gives
//! what is none had no guard to lose.

mod arithmetic;
mod functions;
mod precision;
mod real;
mod truth;

pub use precision::{Double, Precision, Single};
pub use real::IntervalVec3;
pub use truth::{Truth, Truth3};

use core::marker::PhantomData;

/// The bounds of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<P = Double> {
    low: f64,
    high: f64,
    defined: bool,
    precision: PhantomData<P>,
}

impl<P: Precision> Interval<P> {
    /// The numbers from `low` to `high`, and the nearest numbers of the arithmetic.
    pub fn new(low: f64, high: f64) -> Self {
        let (low, high) = (low.min(P::nearest(low)), high.max(P::nearest(high)));
        Self { low, high, defined: true, precision: PhantomData }
    }

    /// One number, and the nearest of the arithmetic.
    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// Anything, also what is no number.
    pub fn anything() -> Self {
        Self { low: f64::NEG_INFINITY, high: f64::INFINITY, defined: false, precision: PhantomData }
    }

    /// The lower bound.
    pub fn low(self) -> f64 {
        self.low
    }

    /// The upper bound.
    pub fn high(self) -> f64 {
        self.high
    }

    /// Whether it is a number in any case.
    pub fn is_defined(self) -> bool {
        self.defined
    }

    /// Whether a value lies within; what is no number lies within where that may be.
    pub fn contains(self, value: f64) -> bool {
        if value.is_nan() { !self.defined } else { self.low <= value && value <= self.high }
    }

    /// Whether all that it may be is at least all that the other may be, both being numbers.
    pub fn is_at_least(self, other: Self) -> bool {
        self.defined && other.defined && self.low >= other.high
    }

    /// Whether all that it may be is below all that the other may be, both being numbers.
    pub fn is_below(self, other: Self) -> bool {
        self.defined && other.defined && self.high < other.low
    }

    /// The smallest interval around both.
    pub fn hull(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            defined: self.defined && other.defined,
            ..self
        }
    }

    /// The lower and the upper half.
    pub(crate) fn halves(self) -> [Self; 2] {
        let middle = f64::midpoint(self.low, self.high);
        [Self { high: middle, ..self }, Self { low: middle, ..self }]
    }

    /// The number at a fraction of the way from the lower to the upper bound, or all where there is none.
    pub(crate) fn point_within(self, fraction: f64) -> Self {
        let value = (self.low + (self.high - self.low) * fraction).clamp(self.low, self.high);
        if value.is_finite() { Self { defined: self.defined, ..Self::point(value) } } else { self }
    }

    /// Bounds that were computed to the nearest `f64`, widened by an error relative to them. What was not below 0 or
    /// not above stays so: no rounding changes a sign.
    fn widened(low: f64, high: f64, relative: f64, defined: bool) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::anything();
        }
        let mut wide_low = low - (low.abs() * relative + P::SMALLEST);
        let mut wide_high = high + (high.abs() * relative + P::SMALLEST);
        if low >= 0.0 {
            wide_low = wide_low.max(0.0);
        }
        if high <= 0.0 {
            wide_high = wide_high.min(0.0);
        }
        Self {
            low: if wide_low < -P::LARGEST { f64::NEG_INFINITY } else { wide_low },
            high: if wide_high > P::LARGEST { f64::INFINITY } else { wide_high },
            defined,
            precision: PhantomData,
        }
    }

    /// Bounds that need no rounding.
    fn exact(low: f64, high: f64, defined: bool) -> Self {
        Self { low, high, defined, precision: PhantomData }
    }

    /// The largest absolute value.
    fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }
}
