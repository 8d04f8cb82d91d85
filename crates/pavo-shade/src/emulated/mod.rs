//! Single precision as devices compute it: `f32`, with what a driver may do to it.
//!
//! A [`Policy`] says what is done. The errors of an operation are a function of the bits of its operands, so that the
//! same program gives the same bits each time, and spread evenly over what the policy allows. What is no number and
//! what is infinite pass through as on the CPU.
//!
//! A product that is added is contracted wherever it can be, also when it was computed in another function, and of two
//! products that are added the first one. A device is free to contract some and round others, and without `precise` it
//! may also rearrange sums and products, which is not emulated.
//!
//! ```
//! use pavo_shade::{Emulated, emulated::{Contracting, Exact}};
//!
//! let a = 1.0 + f32::EPSILON;
//! let exact = Emulated::<Exact>::new(a);
//! assert_eq!((exact * exact - exact).value(), a * a - a);
//! let contracting = Emulated::<Contracting>::new(a);
//! assert_eq!((contracting * contracting - contracting).value(), a.mul_add(a, -a));
//! ```

pub(crate) mod noise;
mod policy;

pub use policy::{Contracting, Exact, Flushing, Loose, Policy, SwiftShader, Vulkan};

use crate::real::Real;
use crate::triple::scalar_of_triples;
use core::f64::consts::TAU;
use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};
use noise::{noise, ulp};

/// A number of single precision on a device.
#[derive(Clone, Copy, Debug)]
pub struct Emulated<P = Exact> {
    value: f32,
    /// The factors, where it is a product that has not been used yet.
    factors: Option<[f32; 2]>,
    policy: PhantomData<P>,
}

impl<P: Policy> Emulated<P> {
    /// The number as the device has it.
    pub fn new(value: f32) -> Self {
        let value = if P::FLUSHES && value.is_subnormal() { 0.0_f32.copysign(value) } else { value };
        Self { value, factors: None, policy: PhantomData }
    }

    /// The number, rounded.
    pub fn value(self) -> f32 {
        self.value
    }

    /// The result of an operation: that of the CPU if the policy asks for no error, else the exact one with an error
    /// of up to this many ulp, which depends on the operands.
    fn result(native: f32, exact: f64, error_ulp: f64, [a, b]: [f32; 2]) -> Self {
        if error_ulp == 0.0 {
            return Self::new(native);
        }
        // Rounding adds up to half an ulp.
        Self::new((exact + (error_ulp - 0.5) * noise([a, b, native]) * ulp(exact)) as f32)
    }

    /// `a b + c` without rounding in between.
    fn fused([a, b]: [f32; 2], c: f32) -> Self {
        let exact = f64::from(a) * f64::from(b) + f64::from(c);
        Self::result(a.mul_add(b, c), exact, P::ARITHMETIC_ULP, [a, b])
    }

    /// The angle as the device reduces it.
    fn angle(self) -> f64 {
        if P::TURNS { f64::from(self.value * (1.0 / TAU) as f32) * TAU } else { f64::from(self.value) }
    }

    /// A sine or cosine. Its error may lead beyond [-1, 1].
    fn wave(self, native: f32, exact: fn(f64) -> f64) -> Self {
        if P::SINE_ERROR == 0.0 && !P::TURNS {
            return Self::new(native);
        }
        // Rounding adds up to half the distance between numbers above 1.
        let error = (P::SINE_ERROR - 0.5 * f64::from(f32::EPSILON)).max(0.0);
        Self::new((exact(self.angle()) + error * noise([self.value, 0.0, native])) as f32)
    }
}

/// A number is what it is rounded to.
impl<P: Policy> PartialEq for Emulated<P> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<P: Policy> From<Emulated<P>> for f64 {
    fn from(number: Emulated<P>) -> f64 {
        f64::from(number.value)
    }
}

impl<P: Policy> Add for Emulated<P> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (a, b) = (self.value, other.value);
        match (self.factors, other.factors) {
            (Some(factors), _) => Self::fused(factors, b),
            (None, Some(factors)) => Self::fused(factors, a),
            (None, None) => Self::result(a + b, f64::from(a) + f64::from(b), P::ARITHMETIC_ULP, [a, b]),
        }
    }
}

impl<P: Policy> Sub for Emulated<P> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<P: Policy> Mul for Emulated<P> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.value, other.value);
        let product = Self::result(a * b, f64::from(a) * f64::from(b), P::ARITHMETIC_ULP, [a, b]);
        Self { factors: P::CONTRACTS.then_some([a, b]), ..product }
    }
}

impl<P: Policy> Div for Emulated<P> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let (a, b) = (self.value, other.value);
        Self::result(a / b, f64::from(a) / f64::from(b), P::QUOTIENT_ULP, [a, b])
    }
}

impl<P: Policy> Neg for Emulated<P> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, factors: self.factors.map(|[a, b]| [-a, b]), ..self }
    }
}

impl<P: Policy> Real for Emulated<P> {
    type Mask = bool;

    fn lit(value: f64) -> Self {
        Self::new(value as f32)
    }
    fn sqrt(self) -> Self {
        if P::INVERSE_ROOT_ULP == 0.0 { Self::new(self.value.sqrt()) } else { Self::new(1.0) / self.inverse_sqrt() }
    }
    fn inverse_sqrt(self) -> Self {
        let (native, exact) = (1.0 / self.value.sqrt(), 1.0 / f64::from(self.value).sqrt());
        Self::result(native, exact, P::INVERSE_ROOT_ULP, [self.value, 0.0])
    }
    fn sin(self) -> Self {
        self.wave(self.value.sin(), f64::sin)
    }
    fn cos(self) -> Self {
        self.wave(self.value.cos(), f64::cos)
    }
    fn exp(self) -> Self {
        let [constant, linear] = P::EXPONENTIAL_ULP;
        // Beyond these the value is 0 or infinite with any error.
        let error_ulp = constant + linear * f64::from(self.value.abs().min(1e3));
        Self::result(self.value.exp(), f64::from(self.value).exp(), error_ulp, [self.value, 0.0])
    }
    fn abs(self) -> Self {
        Self::new(self.value.abs())
    }
    fn floor(self) -> Self {
        Self::new(self.value.floor())
    }
    fn half(self) -> Self {
        Self::new(self.value.half())
    }
    fn min(self, other: Self) -> Self {
        Self::new(self.value.min(other.value))
    }
    fn max(self, other: Self) -> Self {
        Self::new(self.value.max(other.value))
    }
    fn less_than(self, other: Self) -> bool {
        self.value < other.value
    }
    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        Self::new(if mask { if_true.value } else { if_false.value })
    }
}

scalar_of_triples!([P: Policy] Emulated<P>);
