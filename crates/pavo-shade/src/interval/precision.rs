//! How far the operations of an arithmetic may be from exact.

use core::fmt::Debug;

/// The errors of an arithmetic's operations, relative to the result unless said otherwise.
pub trait Precision: Copy + Debug + PartialEq + 'static {
    /// Of a sum, a difference or a product.
    const ARITHMETIC: f64;
    /// Of a quotient.
    const QUOTIENT: f64;
    /// Of a square root, and of 1 over one.
    const ROOT: f64;
    /// Of a sine or a cosine, absolute.
    const SINE: f64;
    /// Of an exponential: a constant, and what the size of the exponent adds to it.
    const EXPONENTIAL: [f64; 2];
    /// A result that is smaller may become 0.
    const SMALLEST: f64;
    /// A result that is larger may become infinite.
    const LARGEST: f64;
    /// The largest divisor for which the error of a quotient is known.
    const LARGEST_DIVISOR: f64;

    /// The nearest number of this arithmetic.
    fn nearest(value: f64) -> f64;
}

/// `f64` as the CPU computes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Double;

/// `f32` as any device computes it that keeps to the precision that WGSL and SPIR-V ask for. Sines and cosines are the
/// exception: there the standards ask for 2^-11 only, and what devices give is taken.
///
/// Its bounds enclose what `f64` gives as well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Single;

const UNIT: f64 = f32::EPSILON as f64;

impl Precision for Double {
    const ARITHMETIC: f64 = f64::EPSILON;
    const QUOTIENT: f64 = f64::EPSILON;
    const ROOT: f64 = 2.0 * f64::EPSILON;
    const SINE: f64 = f64::EPSILON;
    const EXPONENTIAL: [f64; 2] = [2.0 * f64::EPSILON, 0.0];
    const SMALLEST: f64 = f64::MIN_POSITIVE;
    const LARGEST: f64 = f64::MAX;
    const LARGEST_DIVISOR: f64 = f64::MAX;

    fn nearest(value: f64) -> f64 {
        value
    }
}

impl Precision for Single {
    const ARITHMETIC: f64 = UNIT;
    const QUOTIENT: f64 = 3.0 * UNIT;
    const ROOT: f64 = 5.0 * UNIT;
    const SINE: f64 = 4e-7;
    const EXPONENTIAL: [f64; 2] = [4.0 * UNIT, 2.0 * UNIT];
    const SMALLEST: f64 = f32::MIN_POSITIVE as f64;
    const LARGEST: f64 = f32::MAX as f64;
    // 2^126.
    const LARGEST_DIVISOR: f64 = f32::MAX as f64 / 4.0;

    fn nearest(value: f64) -> f64 {
        let nearest = value as f32;
        if nearest.is_subnormal() { 0.0 } else { f64::from(nearest) }
    }
}
