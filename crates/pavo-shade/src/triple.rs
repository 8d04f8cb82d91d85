//! The vector of a number type that has none of its own: three numbers, each computed by itself.

use crate::real::{Lanes, Real, Scalar, Vector};
use crate::value::{LeafInfo, Value, join};
use core::ops::{Add, Div, Mul, Neg, Sub};
use glam::BVec3;

/// Three numbers of a type. Operations on vectors are those on its numbers, in the order in which glam computes them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triple<S>(pub [S; 3]);

/// What a number type needs besides [`Real`] to be a [`Scalar`] with [`Triple`] as its vector. The type converts into
/// `f64`.
macro_rules! scalar_of_triples {
    ([$($generics:tt)*] $number:ty) => {
        impl<$($generics)*> $crate::value::Value for $number {
            type Leaf = Self;
            fn flatten(self, leaves: &mut Vec<Self>) {
                leaves.push(self);
            }
            fn unflatten(leaves: &mut dyn Iterator<Item = Self>) -> Self {
                leaves.next().expect("one leaf per number")
            }
            fn describe(path: &str, doc: &str, leaves: &mut Vec<$crate::value::LeafInfo>) {
                leaves.push($crate::value::LeafInfo::new(path, doc));
            }
        }

        impl<$($generics)*> $crate::real::Lanes<$number> for $number {
            fn from_scalar(value: Self) -> Self {
                value
            }
            fn into_vec3(self) -> $crate::triple::Triple<Self> {
                $crate::triple::Triple([self; 3])
            }
        }

        impl<$($generics)*> $crate::real::Scalar for $number {
            type Vec3 = $crate::triple::Triple<Self>;
            fn fetch(table: &$crate::table::Table, index: Self) -> Self::Vec3 {
                $crate::real::Vector::lit3(table.row(f64::from(index)))
            }
        }
    };
}

pub(crate) use scalar_of_triples;

impl<S: Copy> Triple<S> {
    fn each(self, function: impl Fn(S) -> S) -> Self {
        Self(self.0.map(function))
    }
    fn zip<T>(self, other: Self, function: impl Fn(S, S) -> T) -> [T; 3] {
        core::array::from_fn(|index| function(self.0[index], other.0[index]))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<S: Real> $trait for Triple<S> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.zip(other, $trait::$method))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<S: Real> Mul<S> for Triple<S> {
    type Output = Self;
    fn mul(self, other: S) -> Self {
        self.each(|component| component * other)
    }
}

impl<S: Real> Div<S> for Triple<S> {
    type Output = Self;
    fn div(self, other: S) -> Self {
        self.each(|component| component / other)
    }
}

impl<S: Real> Neg for Triple<S> {
    type Output = Self;
    fn neg(self) -> Self {
        self.each(Neg::neg)
    }
}

impl<S: Value<Leaf = S> + Copy> Value for Triple<S> {
    type Leaf = S;
    fn flatten(self, leaves: &mut Vec<S>) {
        leaves.extend(self.0);
    }
    fn unflatten(leaves: &mut dyn Iterator<Item = S>) -> Self {
        Self(core::array::from_fn(|_| leaves.next().expect("three leaves per vector")))
    }
    fn describe(path: &str, doc: &str, leaves: &mut Vec<LeafInfo>) {
        leaves.extend(["x", "y", "z"].map(|component| LeafInfo::new(&join(path, component), doc)));
    }
}

impl<S: Real<Mask = bool> + Value<Leaf = S>> Real for Triple<S> {
    type Mask = BVec3;

    fn lit(value: f64) -> Self {
        Self([S::lit(value); 3])
    }
    fn sqrt(self) -> Self {
        self.each(S::sqrt)
    }
    fn inverse_sqrt(self) -> Self {
        self.each(S::inverse_sqrt)
    }
    fn sin(self) -> Self {
        self.each(S::sin)
    }
    fn cos(self) -> Self {
        self.each(S::cos)
    }
    fn exp(self) -> Self {
        self.each(S::exp)
    }
    fn abs(self) -> Self {
        self.each(S::abs)
    }
    fn floor(self) -> Self {
        self.each(S::floor)
    }
    fn half(self) -> Self {
        self.each(S::half)
    }
    fn min(self, other: Self) -> Self {
        Self(self.zip(other, S::min))
    }
    fn max(self, other: Self) -> Self {
        Self(self.zip(other, S::max))
    }
    fn less_than(self, other: Self) -> BVec3 {
        BVec3::from_array(self.zip(other, S::less_than))
    }
    fn select(mask: BVec3, if_true: Self, if_false: Self) -> Self {
        let mask: [bool; 3] = mask.into();
        Self(core::array::from_fn(|index| S::select(mask[index], if_true.0[index], if_false.0[index])))
    }
}

impl<S: Real<Mask = bool> + Value<Leaf = S>> Vector<S> for Triple<S> {
    fn new(x: S, y: S, z: S) -> Self {
        Self([x, y, z])
    }
    fn splat(value: S) -> Self {
        Self([value; 3])
    }
    fn lit3(value: [f64; 3]) -> Self {
        Self(value.map(S::lit))
    }
    fn x(self) -> S {
        self.0[0]
    }
    fn y(self) -> S {
        self.0[1]
    }
    fn z(self) -> S {
        self.0[2]
    }
    fn dot(self, other: Self) -> S {
        let [x, y, z] = self.zip(other, Mul::mul);
        x + y + z
    }
    fn normalize(self) -> Self {
        self * self.dot(self).inverse_sqrt()
    }
    fn choose(mask: bool, if_true: Self, if_false: Self) -> Self {
        Self(if_true.zip(if_false, |if_true, if_false| S::select(mask, if_true, if_false)))
    }
}

impl<S: Scalar<Vec3 = Self> + Real<Mask = bool> + Value<Leaf = S>> Lanes<S> for Triple<S> {
    fn from_scalar(value: S) -> Self {
        Self([value; 3])
    }
    fn into_vec3(self) -> Self {
        self
    }
}
