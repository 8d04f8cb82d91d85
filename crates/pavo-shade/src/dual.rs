//! Numbers that carry their derivatives: forward-mode differentiation of a shading function.

use crate::real::Real;
use crate::triple::scalar_of_triples;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number with its partial derivatives by `N` variables: each operation applies the chain rule. The values are those of
/// `f64`, bit for bit.
///
/// Source: Wengert 1964, "A simple automatic derivative evaluation program"; Griewank and Walther 2008, "Evaluating
/// Derivatives", chapter 3.
///
/// Where an operation has no derivative, one side is taken:
///
/// | operation | derivative |
/// |---|---|
/// | `abs(x)` at 0 | that for larger `x`, 1 |
/// | `floor(x)` | 0 everywhere, so that `fract(x)` has 1 |
/// | `min(a, b)`, `max(a, b)` at `a = b` | that of `a`; `clamp` at its bounds has that of within |
/// | `select` | that of the value selected; the condition has none |
/// | `sqrt(x)` at 0 | infinite; 0 by what `x` does not depend on |
/// | a row of a table | 0: rows are constant between whole indices |
///
/// ```
/// use pavo_shade::{Dual, Real};
///
/// let [x, y] = Dual::variables([3.0, 2.0]);
/// let product = x * y.sqrt();
/// assert_eq!(product.derivatives, [2.0_f64.sqrt(), 3.0 / (2.0 * 2.0_f64.sqrt())]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const N: usize> {
    /// The number.
    pub value: f64,
    /// Its derivative by each variable.
    pub derivatives: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// The variables at these values: the derivative of each by itself is 1.
    pub fn variables(values: [f64; N]) -> [Self; N] {
        core::array::from_fn(|index| Self {
            value: values[index],
            derivatives: core::array::from_fn(|other| if other == index { 1.0 } else { 0.0 }),
        })
    }

    /// A function of this number, by its value and its slope there.
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, derivatives: self.derivatives.map(|derivative| along(slope, derivative)) }
    }

    /// A function of two numbers, by its value and its slopes along each.
    fn chain2(self, other: Self, value: f64, [slope, other_slope]: [f64; 2]) -> Self {
        let derivatives = core::array::from_fn(|index| {
            along(slope, self.derivatives[index]) + along(other_slope, other.derivatives[index])
        });
        Self { value, derivatives }
    }
}

/// The change of a function of this slope. What does not change its argument does not change it, however steep it is.
fn along(slope: f64, derivative: f64) -> f64 {
    if derivative == 0.0 { 0.0 } else { slope * derivative }
}

impl<const N: usize> From<Dual<N>> for f64 {
    fn from(number: Dual<N>) -> f64 {
        number.value
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.chain2(other, self.value + other.value, [1.0, 1.0])
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.chain2(other, self.value - other.value, [1.0, -1.0])
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.chain2(other, self.value * other.value, [other.value, self.value])
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        self.chain2(other, quotient, [1.0 / other.value, -quotient / other.value])
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl<const N: usize> Real for Dual<N> {
    type Mask = bool;

    fn lit(value: f64) -> Self {
        Self { value, derivatives: [0.0; N] }
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    fn inverse_sqrt(self) -> Self {
        let inverse = 1.0 / self.value.sqrt();
        self.chain(inverse, -0.5 * inverse / self.value)
    }
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }
    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }
    fn abs(self) -> Self {
        self.chain(self.value.abs(), if self.value < 0.0 { -1.0 } else { 1.0 })
    }
    fn floor(self) -> Self {
        Self::lit(self.value.floor())
    }
    fn half(self) -> Self {
        // The derivative is that of what is rounded.
        self.chain(self.value.half(), 1.0)
    }
    fn min(self, other: Self) -> Self {
        // Of a number and none it is the number, as for f64.
        if other.value < self.value || self.value.is_nan() { other } else { self }
    }
    fn max(self, other: Self) -> Self {
        if other.value > self.value || self.value.is_nan() { other } else { self }
    }
    fn less_than(self, other: Self) -> bool {
        self.value < other.value
    }
    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }
}

scalar_of_triples!([const N: usize] Dual<N>);
