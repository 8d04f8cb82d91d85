//! Intervals as numbers of the DSL: a shading function that runs on them gives bounds of its results.
//!
//! They know nothing of where a number comes from: `x * x` may be negative here where it may not be in a program, in
//! which the two operands are one node (`powi` knows that they are one).

use super::{Interval, Precision, Truth, Truth3};
use crate::real::{Lanes, Real, Scalar, Vector};
use crate::table::Table;
use crate::value::{LeafInfo, Value, join};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The bounds of a vector, by component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntervalVec3<P>(pub [Interval<P>; 3]);

impl<P: Precision> Value for Interval<P> {
    type Leaf = Self;
    fn flatten(self, leaves: &mut Vec<Self>) {
        leaves.push(self);
    }
    fn unflatten(leaves: &mut dyn Iterator<Item = Self>) -> Self {
        leaves.next().expect("one leaf per number")
    }
    fn describe(path: &str, doc: &str, leaves: &mut Vec<LeafInfo>) {
        leaves.push(LeafInfo::new(path, doc));
    }
}

impl<P: Precision> Value for IntervalVec3<P> {
    type Leaf = Interval<P>;
    fn flatten(self, leaves: &mut Vec<Interval<P>>) {
        leaves.extend(self.0);
    }
    fn unflatten(leaves: &mut dyn Iterator<Item = Interval<P>>) -> Self {
        Self(core::array::from_fn(|_| leaves.next().expect("three leaves per vector")))
    }
    fn describe(path: &str, doc: &str, leaves: &mut Vec<LeafInfo>) {
        leaves.extend(["x", "y", "z"].map(|component| LeafInfo::new(&join(path, component), doc)));
    }
}

impl<P: Precision> Real for Interval<P> {
    type Mask = Truth;

    fn lit(value: f64) -> Self {
        Self::point(value)
    }
    fn sqrt(self) -> Self {
        self.root()
    }
    fn inverse_sqrt(self) -> Self {
        self.inverse_root()
    }
    fn sin(self) -> Self {
        self.sine()
    }
    fn cos(self) -> Self {
        self.cosine()
    }
    fn exp(self) -> Self {
        self.exponential()
    }
    fn abs(self) -> Self {
        self.absolute()
    }
    fn floor(self) -> Self {
        self.whole()
    }
    fn half(self) -> Self {
        self.held_in_half()
    }
    fn min(self, other: Self) -> Self {
        self.smaller(other)
    }
    fn max(self, other: Self) -> Self {
        self.larger(other)
    }
    fn less_than(self, other: Self) -> Truth {
        self.is_less(other)
    }
    fn select(mask: Truth, if_true: Self, if_false: Self) -> Self {
        Self::chosen(mask, if_true, if_false)
    }
    fn mix(a: Self, b: Self, t: Self) -> Self {
        Self::mixed(a, b, t)
    }
    fn fract(self) -> Self {
        self.fraction()
    }
    fn powi(self, exponent: u32) -> Self {
        match exponent {
            0 => Self::lit(1.0),
            1 => self,
            even if even % 2 == 0 => self.square().powi(even / 2),
            odd => self * self.powi(odd - 1),
        }
    }
}

impl<P: Precision> Scalar for Interval<P> {
    type Vec3 = IntervalVec3<P>;
    /// Any row may be read.
    fn fetch(table: &Table, _: Self) -> IntervalVec3<P> {
        let [low, high] = table.extremes();
        IntervalVec3(core::array::from_fn(|column| Self::new(low[column], high[column])))
    }
}

impl<P: Precision> Lanes<Interval<P>> for Interval<P> {
    fn from_scalar(value: Self) -> Self {
        value
    }
    fn into_vec3(self) -> IntervalVec3<P> {
        IntervalVec3([self; 3])
    }
}

impl<P: Precision> Lanes<Interval<P>> for IntervalVec3<P> {
    fn from_scalar(value: Interval<P>) -> Self {
        Self([value; 3])
    }
    fn into_vec3(self) -> Self {
        self
    }
}

impl<P: Precision> IntervalVec3<P> {
    fn each(self, function: impl Fn(Interval<P>) -> Interval<P>) -> Self {
        Self(self.0.map(function))
    }
    fn zip(self, other: Self, function: impl Fn(Interval<P>, Interval<P>) -> Interval<P>) -> Self {
        Self(core::array::from_fn(|index| function(self.0[index], other.0[index])))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<P: Precision> $trait for IntervalVec3<P> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.zip(other, $trait::$method)
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<P: Precision> Mul<Interval<P>> for IntervalVec3<P> {
    type Output = Self;
    fn mul(self, other: Interval<P>) -> Self {
        self.each(|component| component * other)
    }
}

impl<P: Precision> Div<Interval<P>> for IntervalVec3<P> {
    type Output = Self;
    fn div(self, other: Interval<P>) -> Self {
        self.each(|component| component / other)
    }
}

impl<P: Precision> Neg for IntervalVec3<P> {
    type Output = Self;
    fn neg(self) -> Self {
        self.each(Neg::neg)
    }
}

impl<P: Precision> Real for IntervalVec3<P> {
    type Mask = Truth3;

    fn lit(value: f64) -> Self {
        Self([Interval::point(value); 3])
    }
    fn sqrt(self) -> Self {
        self.each(Interval::root)
    }
    fn inverse_sqrt(self) -> Self {
        self.each(Interval::inverse_root)
    }
    fn sin(self) -> Self {
        self.each(Interval::sine)
    }
    fn cos(self) -> Self {
        self.each(Interval::cosine)
    }
    fn exp(self) -> Self {
        self.each(Interval::exponential)
    }
    fn abs(self) -> Self {
        self.each(Interval::absolute)
    }
    fn floor(self) -> Self {
        self.each(Interval::whole)
    }
    fn half(self) -> Self {
        self.each(Interval::held_in_half)
    }
    fn min(self, other: Self) -> Self {
        self.zip(other, Interval::smaller)
    }
    fn max(self, other: Self) -> Self {
        self.zip(other, Interval::larger)
    }
    fn less_than(self, other: Self) -> Truth3 {
        Truth3(core::array::from_fn(|index| self.0[index].is_less(other.0[index])))
    }
    fn select(mask: Truth3, if_true: Self, if_false: Self) -> Self {
        Self(core::array::from_fn(|index| Interval::chosen(mask.0[index], if_true.0[index], if_false.0[index])))
    }
    fn mix(a: Self, b: Self, t: Self) -> Self {
        Self(core::array::from_fn(|index| Interval::mixed(a.0[index], b.0[index], t.0[index])))
    }
    fn fract(self) -> Self {
        self.each(Interval::fraction)
    }
    fn powi(self, exponent: u32) -> Self {
        self.each(|component| component.powi(exponent))
    }
}

impl<P: Precision> Vector<Interval<P>> for IntervalVec3<P> {
    fn new(x: Interval<P>, y: Interval<P>, z: Interval<P>) -> Self {
        Self([x, y, z])
    }
    fn splat(value: Interval<P>) -> Self {
        Self([value; 3])
    }
    fn lit3(value: [f64; 3]) -> Self {
        Self(value.map(Interval::point))
    }
    fn x(self) -> Interval<P> {
        self.0[0]
    }
    fn y(self) -> Interval<P> {
        self.0[1]
    }
    fn z(self) -> Interval<P> {
        self.0[2]
    }
    fn dot(self, other: Self) -> Interval<P> {
        Interval::dot(self.0, other.0, false)
    }
    fn normalize(self) -> Self {
        let [x, y, z] = self.0;
        Self([[x, y, z], [y, z, x], [z, x, y]].map(Interval::normalized_component))
    }
    fn choose(mask: Truth, if_true: Self, if_false: Self) -> Self {
        if_true.zip(if_false, |if_true, if_false| Interval::chosen(mask, if_true, if_false))
    }
}
