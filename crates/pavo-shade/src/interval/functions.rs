//! Functions of one number, and what chooses among numbers.

use super::{Interval, Precision, Truth};
use core::f64::consts::{FRAC_PI_2, PI, TAU};

impl<P: Precision> Interval<P> {
    /// Square root; not defined where the number may be negative.
    pub fn root(self) -> Self {
        let defined = self.defined && self.low >= 0.0;
        Self::widened(self.low.max(0.0).sqrt(), self.high.max(0.0).sqrt(), P::ROOT, defined)
    }

    /// 1 over the square root; not defined where the number may be 0 or negative.
    pub fn inverse_root(self) -> Self {
        if self.low <= 0.0 {
            let low = if self.high > 0.0 { 1.0 / self.high.sqrt() } else { 0.0 };
            return Self { high: f64::INFINITY, ..Self::widened(low, low, P::ROOT, false) };
        }
        Self::widened(1.0 / self.high.sqrt(), 1.0 / self.low.sqrt(), P::ROOT, self.defined)
    }

    /// Cosine, by the extrema that lie within.
    pub fn cosine(self) -> Self {
        self.shifted_cosine(0.0, self.low.cos(), self.high.cos())
    }

    /// Sine: a cosine that is a quarter turn late.
    pub fn sine(self) -> Self {
        self.shifted_cosine(FRAC_PI_2, self.low.sin(), self.high.sin())
    }

    /// A cosine with its maximum at `shift`, given its values at both ends.
    fn shifted_cosine(self, shift: f64, at_low: f64, at_high: f64) -> Self {
        // Beyond this angle the nearest multiple of a half turn is not certain.
        let is_certain = self.magnitude() < 1e9;
        let (mut low, mut high) = (-1.0, 1.0);
        if is_certain && self.high - self.low < TAU {
            let slack = 1e-14 * (self.magnitude() + 1.0);
            let reaches = |extremum: f64| {
                let next = extremum + ((self.low - slack - extremum) / TAU).ceil() * TAU;
                next <= self.high + slack
            };
            high = if reaches(shift) { 1.0 } else { at_low.max(at_high) };
            low = if reaches(shift + PI) { -1.0 } else { at_low.min(at_high) };
        }
        let is_finite = self.low.is_finite() && self.high.is_finite();
        // A device reduces a large angle with the error that a product has.
        let reduction = (self.magnitude() * P::ARITHMETIC).min(2.0);
        let (low, high) = ((low - reduction).max(-1.0), (high + reduction).min(1.0));
        Self::exact(low - P::SINE, high + P::SINE, self.defined && is_finite)
    }

    /// `e^x`.
    pub fn exponential(self) -> Self {
        let [constant, linear] = P::EXPONENTIAL;
        // Beyond these the value is 0 or infinite in any arithmetic.
        let relative = constant + linear * self.magnitude().min(1e3);
        Self::widened(self.low.exp(), self.high.exp(), relative, self.defined)
    }

    /// Absolute value.
    pub fn absolute(self) -> Self {
        let low = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { self.low.abs().min(self.high.abs()) };
        Self::exact(low, self.magnitude(), self.defined)
    }

    /// The largest whole number that is not larger.
    pub fn whole(self) -> Self {
        Self::exact(self.low.floor(), self.high.floor(), self.defined)
    }

    /// The number in half precision or better: rounded either way, below 2^-14 to 0 or not, infinite beyond 65504.
    pub fn held_in_half(self) -> Self {
        const SPACING: f64 = 1.0 / 1024.0;
        const LEAST: f64 = 1.0 / 16384.0;
        const LARGEST: f64 = 65504.0;
        let margin = |end: f64| end.abs() * SPACING + LEAST;
        let (mut low, mut high) = (self.low - margin(self.low), self.high + margin(self.high));
        if self.low >= 0.0 {
            low = low.max(0.0);
        }
        if self.high <= 0.0 {
            high = high.min(0.0);
        }
        if low < -LARGEST {
            low = f64::NEG_INFINITY;
        }
        if high > LARGEST {
            high = f64::INFINITY;
        }
        Self::exact(low, high, self.defined)
    }

    /// The part after the point; 1 where it was rounded up.
    pub fn fraction(self) -> Self {
        let defined = self.defined && self.low.is_finite() && self.high.is_finite();
        let whole = self.low.floor();
        if defined && whole == self.high.floor() {
            let fraction = Self::widened(self.low - whole, self.high - whole, P::ARITHMETIC, true);
            return Self::exact(fraction.low, fraction.high.min(1.0), true);
        }
        Self::exact(0.0, 1.0, defined)
    }

    /// The larger of two; the other where one is no number.
    pub fn larger(self, other: Self) -> Self {
        let both = Self::exact(self.low.max(other.low), self.high.max(other.high), true);
        self.or_other(other, both)
    }

    /// The smaller of two; the other where one is no number.
    pub fn smaller(self, other: Self) -> Self {
        let both = Self::exact(self.low.min(other.low), self.high.min(other.high), true);
        self.or_other(other, both)
    }

    fn or_other(self, other: Self, both: Self) -> Self {
        let mut result = both;
        if !self.defined {
            result = result.hull(other);
        }
        if !other.defined {
            result = result.hull(self);
        }
        Self { defined: self.defined || other.defined, ..result }
    }

    /// `a (1 - t) + b t`; between `a` and `b` where `t` is within 0 and 1, whichever way it is computed.
    pub fn mixed(a: Self, b: Self, t: Self) -> Self {
        let computed = a * (Self::point(1.0) - t) + b * t;
        if !(computed.defined && t.low >= 0.0 && t.high <= 1.0) {
            return computed;
        }
        let between = a.hull(b);
        let error = 4.0 * P::ARITHMETIC * between.magnitude() + P::SMALLEST;
        let low = if between.low >= 0.0 { (between.low - error).max(0.0) } else { between.low - error };
        let high = if between.high <= 0.0 { (between.high + error).min(0.0) } else { between.high + error };
        Self::exact(computed.low.max(low), computed.high.min(high), true)
    }

    /// Whether this number is smaller than the other, as far as the bounds tell.
    pub fn is_less(self, other: Self) -> Truth {
        let defined = self.defined && other.defined;
        Truth::new(!defined || self.low < other.high, !defined || self.high >= other.low)
    }

    /// One of two by a condition; their hull where it is not decided.
    pub fn chosen(condition: Truth, if_true: Self, if_false: Self) -> Self {
        match condition.decided() {
            Some(true) => if_true,
            Some(false) => if_false,
            None => if_true.hull(if_false),
        }
    }
}
