//! Half precision: each operation rounded to the nearest number of IEEE 754 binary16.

use crate::real::Real;
use crate::triple::scalar_of_triples;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number of IEEE 754 binary16, to which each operation is rounded.
///
/// It has 11 significant bits; the largest number is 65504, the smallest 2^-24 and the smallest with all its bits 2^-14.
/// What is smaller loses bits and is not flushed. A length of 300 nm squared is beyond its range, and a guard like
/// `max(x, 1e-12)` is one against 0 only in name: the literal itself becomes 0.
///
/// Sums, products, quotients and roots are the nearest number to the exact result; sines, exponentials and
/// [`Real::inverse_sqrt`] to that of `f64`. A device may be less exact: Vulkan allows 2^-7 for a sine in half precision.
///
/// Source: IEEE 754-2019, table 3.5; the Vulkan specification, "Precision of Individual Operations".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Half(f64);

/// Bits after the first one.
const FRACTION_BITS: i32 = 10;
/// Exponent of the smallest number that has all of its bits.
const LEAST_EXPONENT: i32 = -14;
/// The largest number.
const LARGEST: f64 = 65504.0;

impl Half {
    /// The nearest number, the one with an even last bit where two are; infinite beyond the largest.
    pub fn new(value: f64) -> Self {
        if value == 0.0 || !value.is_finite() {
            return Self(value);
        }
        // The exponent of an f64 that is itself below its normal range comes out too small, which is below the least.
        let exponent = ((value.to_bits() >> 52) & 0x7ff) as i32 - 1023;
        let spacing = 2.0_f64.powi(exponent.max(LEAST_EXPONENT) - FRACTION_BITS);
        let rounded = (value / spacing).round_ties_even() * spacing;
        Self(if rounded.abs() > LARGEST { f64::INFINITY.copysign(value) } else { rounded })
    }
}

impl From<Half> for f64 {
    fn from(number: Half) -> f64 {
        number.0
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Half {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self::new($trait::$method(self.0, other.0))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Half {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Half {
    type Mask = bool;

    fn lit(value: f64) -> Self {
        Self::new(value)
    }
    fn sqrt(self) -> Self {
        Self::new(self.0.sqrt())
    }
    fn inverse_sqrt(self) -> Self {
        Self::new(1.0 / self.0.sqrt())
    }
    fn sin(self) -> Self {
        Self::new(self.0.sin())
    }
    fn cos(self) -> Self {
        Self::new(self.0.cos())
    }
    fn exp(self) -> Self {
        Self::new(self.0.exp())
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn floor(self) -> Self {
        Self(self.0.floor())
    }
    fn half(self) -> Self {
        self
    }
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
    fn less_than(self, other: Self) -> bool {
        self.0 < other.0
    }
    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }
}

scalar_of_triples!([] Half);
