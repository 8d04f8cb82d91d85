//! What a device does to single precision, as data.

use core::fmt::Debug;

/// How an arithmetic departs from that of `f32` on the CPU. A type gives what it departs in; the rest is exact.
///
/// An error in ulp is in units of the distance between neighbouring numbers of `f32` at the exact result, and includes
/// the rounding. 0 means the result of the CPU, which for sums, products, quotients and roots is the nearest number.
///
/// Sources: the Vulkan specification, appendix "Vulkan Environment for SPIR-V", "Precision of Individual Operations";
/// SPIR-V specification, decoration `NoContraction`.
pub trait Policy: Copy + Debug + PartialEq + 'static {
    /// Whether a product that is added to a number, or subtracted, is not rounded before: `a * b + c` in one step.
    const CONTRACTS: bool = false;
    /// Whether numbers below 2^-126 become 0, as operands and as results.
    const FLUSHES: bool = false;
    /// Error of a sum, a difference or a product, ulp, 0 or within [0.5, 1]. At 1 it is either of the neighbours of
    /// the exact result, and the exact result where that is a number: what Vulkan calls correctly rounded.
    const ARITHMETIC_ULP: f64 = 0.0;
    /// Error of a quotient, ulp, 0 or at least 0.5.
    const QUOTIENT_ULP: f64 = 0.0;
    /// Error of 1 over a square root, ulp, 0 or at least 0.5. Unless it is 0, a square root is 1 over it, as in Vulkan.
    const INVERSE_ROOT_ULP: f64 = 0.0;
    /// Error of an exponential, ulp, 0 or at least 0.5: a constant, and what each unit of the exponent adds to it.
    const EXPONENTIAL_ULP: [f64; 2] = [0.0, 0.0];
    /// Error of a sine or a cosine, absolute and with its rounding, for any angle.
    const SINE_ERROR: f64 = 0.0;
    /// Whether an angle is taken in turns first, times `1 / (2 pi)` in `f32`: large angles lose what that rounds.
    const TURNS: bool = false;
}

/// `f32` as the CPU computes it, bit for bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exact;
impl Policy for Exact {}

/// Products are added without rounding, as compilers of shaders do where the text does not say `precise`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contracting;
impl Policy for Contracting {
    const CONTRACTS: bool = true;
}

/// Numbers below 2^-126 become 0: the default of many devices, as Vulkan leaves it open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flushing;
impl Policy for Flushing {
    const FLUSHES: bool = true;
}

/// The sines of SwiftShader: turns in `f32`, then a polynomial of fifth order. It is off by up to 1.9e-4, at 80 degrees
/// and its mirror angles. The polynomial is smooth; the error here is not, which is harder on recurrences.
///
/// Source: SwiftShader, `src/Pipeline/ShaderCore.cpp`, `Sin5`, exact at 0, 30, 60 and 90 degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwiftShader;
impl Policy for SwiftShader {
    const SINE_ERROR: f64 = 2e-4;
    const TURNS: bool = true;
}

/// What Vulkan allows of each operation, but for sines, which are as good as most devices have them: turns in `f32`, and
/// 4e-7 from there. It is what [`crate::interval::Single`] encloses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loose;
impl Policy for Loose {
    const CONTRACTS: bool = true;
    const FLUSHES: bool = true;
    const ARITHMETIC_ULP: f64 = 1.0;
    const QUOTIENT_ULP: f64 = 2.5;
    const INVERSE_ROOT_ULP: f64 = 2.0;
    const EXPONENTIAL_ULP: [f64; 2] = [3.0, 2.0];
    const SINE_ERROR: f64 = 4e-7;
    const TURNS: bool = true;
}

/// What Vulkan allows of each operation: for sines 2^-11, which it promises within [-pi, pi] and which is taken for any
/// angle here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vulkan;
impl Policy for Vulkan {
    const CONTRACTS: bool = Loose::CONTRACTS;
    const FLUSHES: bool = Loose::FLUSHES;
    const ARITHMETIC_ULP: f64 = Loose::ARITHMETIC_ULP;
    const QUOTIENT_ULP: f64 = Loose::QUOTIENT_ULP;
    const INVERSE_ROOT_ULP: f64 = Loose::INVERSE_ROOT_ULP;
    const EXPONENTIAL_ULP: [f64; 2] = Loose::EXPONENTIAL_ULP;
    const SINE_ERROR: f64 = 1.0 / 2048.0;
    const TURNS: bool = Loose::TURNS;
}
