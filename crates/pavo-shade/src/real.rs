//! The number types that a shading function is generic over.

use crate::function::FunctionInfo;
use crate::table::Table;
use crate::value::{Arguments, Value};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A truth value, or one per component: the result of a comparison, the condition of [`Real::select`].
pub trait Mask: Copy {
    /// True where both are true.
    fn and(self, other: Self) -> Self;
    /// True where one or both are true.
    fn or(self, other: Self) -> Self;
    /// True where this one is false.
    fn not(self) -> Self;
    /// The mask, with this name carried into emitted code. Plain truth values have none.
    #[inline(always)]
    fn named(self, name: &str) -> Self {
        let _ = name;
        self
    }
}

/// A real number, or several that are computed alike (the components of a vector).
///
/// Instances: `f32`, `f64`, `glam::Vec3`, `glam::DVec3` (each component by itself) and [`crate::Expr`] (the graph). To
/// judge a function by: [`crate::interval::Interval`], [`crate::Dual`], [`crate::Emulated`] and [`crate::Half`].
pub trait Real:
    Copy + Value + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// What a comparison of two numbers gives.
    type Mask: Mask;

    /// A constant. On vectors: the same in each component.
    fn lit(value: f64) -> Self;
    /// Square root; the argument must not be negative.
    fn sqrt(self) -> Self;
    /// `1 / sqrt(x)`; the argument must be positive.
    fn inverse_sqrt(self) -> Self;
    /// Sine of an angle in radians.
    fn sin(self) -> Self;
    /// Cosine of an angle in radians.
    fn cos(self) -> Self;
    /// `e^x`.
    fn exp(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The largest whole number that is not larger.
    fn floor(self) -> Self;
    /// The number held in half precision: rounded to the nearest number of IEEE 754 binary16, infinite beyond 65504.
    ///
    /// An operation on numbers held so whose result is held so again is one of half precision in emitted code, where
    /// the language has it; elsewhere nothing is rounded.
    fn half(self) -> Self;
    /// The smaller of two numbers.
    fn min(self, other: Self) -> Self;
    /// The larger of two numbers.
    fn max(self, other: Self) -> Self;
    /// Whether this number is smaller than the other.
    fn less_than(self, other: Self) -> Self::Mask;
    /// `if_true` where the mask holds, `if_false` elsewhere. Both are evaluated.
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self;

    /// The number kept within `[low, high]`.
    fn clamp(self, low: Self, high: Self) -> Self {
        self.max(low).min(high)
    }

    /// `a (1 - t) + b t`.
    fn mix(a: Self, b: Self, t: Self) -> Self {
        a * (Self::lit(1.0) - t) + b * t
    }

    /// The part after the point, `x - floor(x)`.
    fn fract(self) -> Self {
        self - self.floor()
    }

    /// A whole power by repeated squaring, as products (never the target's `pow`, which is inexact on GPUs).
    #[track_caller]
    fn powi(self, exponent: u32) -> Self {
        match exponent {
            0 => Self::lit(1.0),
            1 => self,
            even if even % 2 == 0 => (self * self).powi(even / 2),
            odd => self * self.powi(odd - 1),
        }
    }

    /// Runs a function: `#[shade]` routes each call through here. Plain numbers just run the body; the graph records
    /// a call of the function, specialised on `key` and on the arguments that are literal.
    #[inline(always)]
    fn call<A, O>(
        info: &'static FunctionInfo,
        key: impl FnOnce() -> String,
        arguments: A,
        body: impl FnOnce(A) -> O,
    ) -> O
    where
        A: Arguments<Leaf = Self::Leaf>,
        O: Value<Leaf = Self::Leaf>,
    {
        let _ = (info, key);
        body(arguments)
    }
}

/// What a per-channel computation runs on: a single number where the channels are alike, a vector where each has its
/// own. Arithmetic is the same; this converts at the edges.
pub trait Lanes<S: Scalar>: Real {
    /// The same number for each channel.
    fn from_scalar(value: S) -> Self;
    /// A number for each channel.
    fn into_vec3(self) -> S::Vec3;
}

/// A single real number, with the vector type that belongs to it.
pub trait Scalar: Real + Lanes<Self> {
    /// Three numbers: a linear colour, or a direction.
    type Vec3: Vector<Self> + Lanes<Self> + Value<Leaf = <Self as Value>::Leaf>;

    /// The row of a table at an index, which is a whole number from 0 to the last row's. On the CPU and in the graph an
    /// index outside of that is held at the ends; a GPU promises nothing there, so keep it within by `clamp`.
    fn fetch(table: &Table, index: Self) -> Self::Vec3;
}

/// Three numbers of type `S`; arithmetic is by component.
pub trait Vector<S: Real>: Real + Mul<S, Output = Self> + Div<S, Output = Self> {
    /// A vector of its components.
    fn new(x: S, y: S, z: S) -> Self;
    /// The same number in each component.
    fn splat(value: S) -> Self;
    /// A constant vector.
    fn lit3(value: [f64; 3]) -> Self;
    /// The first component.
    fn x(self) -> S;
    /// The second component.
    fn y(self) -> S;
    /// The third component.
    fn z(self) -> S;
    /// The scalar product.
    fn dot(self, other: Self) -> S;
    /// The vector scaled to length 1; it must not be zero.
    fn normalize(self) -> Self;
    /// One of two vectors, by a single truth value.
    fn choose(mask: S::Mask, if_true: Self, if_false: Self) -> Self;
}
