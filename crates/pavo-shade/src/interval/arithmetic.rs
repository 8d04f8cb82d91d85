//! Sums, products, quotients, and scalar products.

use super::{Interval, Precision};
use core::ops::{Add, Div, Mul, Neg, Sub};

impl<P: Precision> Add for Interval<P> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let defined = self.defined && other.defined;
        Self::widened(self.low + other.low, self.high + other.high, P::ARITHMETIC, defined)
    }
}

impl<P: Precision> Sub for Interval<P> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<P: Precision> Neg for Interval<P> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low, ..self }
    }
}

impl<P: Precision> Mul for Interval<P> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let ends = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        spanned(ends, P::ARITHMETIC, self.defined && other.defined)
    }
}

impl<P: Precision> Div for Interval<P> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let is_safe = (other.low > 0.0 || other.high < 0.0) && other.magnitude() <= P::LARGEST_DIVISOR;
        if !is_safe {
            return Self::anything();
        }
        let ends = [self.low / other.low, self.low / other.high, self.high / other.low, self.high / other.high];
        spanned(ends, P::QUOTIENT, self.defined && other.defined)
    }
}

/// The interval between the smallest and the largest of four ends.
fn spanned<P: Precision>([a, b, c, d]: [f64; 4], relative: f64, defined: bool) -> Interval<P> {
    // One that is no number, or infinities of both signs: neither is bounded.
    if (a + b + c + d).is_nan() {
        return Interval::anything();
    }
    Interval::widened(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)), relative, defined)
}

impl<P: Precision> Interval<P> {
    /// The product of a number with itself.
    pub fn square(self) -> Self {
        let (a, b) = (self.low * self.low, self.high * self.high);
        let low = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { a.min(b) };
        Self::widened(low, a.max(b), P::ARITHMETIC, self.defined)
    }

    /// The sum of three products or squares, in any order of adding.
    pub(crate) fn sum([a, b, c]: [Self; 3]) -> Self {
        let sum = a + b + c;
        let error = 2.0 * P::ARITHMETIC * (a.magnitude() + b.magnitude() + c.magnitude());
        let keeps_sign = |bound: f64, terms: [f64; 3]| {
            if terms.iter().all(|&term| term >= 0.0) { bound.max(0.0) } else { bound }
        };
        let low = keeps_sign(sum.low - error, [a.low, b.low, c.low]);
        let high = -keeps_sign(-(sum.high + error), [-a.high, -b.high, -c.high]);
        if low.is_nan() || high.is_nan() { Self::anything() } else { Self::exact(low, high, sum.defined) }
    }

    /// The scalar product of two vectors; of a vector with itself if `is_square`.
    pub(crate) fn dot(a: [Self; 3], b: [Self; 3], is_square: bool) -> Self {
        let product = |index: usize| if is_square { a[index].square() } else { a[index] * b[index] };
        Self::sum([product(0), product(1), product(2)])
    }

    /// The first component of a vector that is scaled to length 1.
    pub(crate) fn normalized_component(vector: [Self; 3]) -> Self {
        let length = Self::sum(vector.map(Self::square)).root();
        let component = vector[0] / length;
        let limit = 1.0 + 8.0 * P::ARITHMETIC;
        Self::exact(component.low.max(-limit), component.high.min(limit), component.defined)
    }
}
