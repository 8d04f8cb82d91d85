//! Plain numbers as instances of [`Real`]: `f32`, `f64`, and glam's vectors of them.

use crate::half::Half;
use crate::real::{Lanes, Mask, Real, Scalar, Vector};
use crate::table::Table;
use crate::value::{LeafInfo, Value, join};
use glam::{BVec3, DVec3, Vec3};

impl Mask for bool {
    fn and(self, other: Self) -> Self {
        self & other
    }
    fn or(self, other: Self) -> Self {
        self | other
    }
    fn not(self) -> Self {
        !self
    }
}

impl Mask for BVec3 {
    fn and(self, other: Self) -> Self {
        self & other
    }
    fn or(self, other: Self) -> Self {
        self | other
    }
    fn not(self) -> Self {
        !self
    }
}

macro_rules! native_scalar {
    ($scalar:ty, $vector:ty) => {
        impl Value for $scalar {
            type Leaf = $scalar;
            fn flatten(self, leaves: &mut Vec<$scalar>) {
                leaves.push(self);
            }
            fn unflatten(leaves: &mut dyn Iterator<Item = $scalar>) -> Self {
                leaves.next().expect("one leaf per number")
            }
            fn describe(path: &str, doc: &str, leaves: &mut Vec<LeafInfo>) {
                leaves.push(LeafInfo::new(path, doc));
            }
        }

        impl Real for $scalar {
            type Mask = bool;
            #[inline(always)]
            fn lit(value: f64) -> Self {
                value as $scalar
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                <$scalar>::sqrt(self)
            }
            #[inline(always)]
            fn inverse_sqrt(self) -> Self {
                1.0 / <$scalar>::sqrt(self)
            }
            #[inline(always)]
            fn sin(self) -> Self {
                <$scalar>::sin(self)
            }
            #[inline(always)]
            fn cos(self) -> Self {
                <$scalar>::cos(self)
            }
            #[inline(always)]
            fn exp(self) -> Self {
                <$scalar>::exp(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                <$scalar>::abs(self)
            }
            #[inline(always)]
            fn floor(self) -> Self {
                <$scalar>::floor(self)
            }
            #[inline(always)]
            fn half(self) -> Self {
                f64::from(Half::new(f64::from(self))) as $scalar
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                <$scalar>::min(self, other)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                <$scalar>::max(self, other)
            }
            #[inline(always)]
            fn less_than(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
                if mask { if_true } else { if_false }
            }
        }

        impl Scalar for $scalar {
            type Vec3 = $vector;
            #[inline(always)]
            fn fetch(table: &Table, index: Self) -> $vector {
                Vector::<$scalar>::lit3(table.row(f64::from(index)))
            }
        }

        impl Lanes<$scalar> for $scalar {
            #[inline(always)]
            fn from_scalar(value: $scalar) -> Self {
                value
            }
            #[inline(always)]
            fn into_vec3(self) -> $vector {
                <$vector>::splat(self)
            }
        }

        impl Lanes<$scalar> for $vector {
            #[inline(always)]
            fn from_scalar(value: $scalar) -> Self {
                <$vector>::splat(value)
            }
            #[inline(always)]
            fn into_vec3(self) -> $vector {
                self
            }
        }

        impl Value for $vector {
            type Leaf = $scalar;
            fn flatten(self, leaves: &mut Vec<$scalar>) {
                leaves.extend(self.to_array());
            }
            fn unflatten(leaves: &mut dyn Iterator<Item = $scalar>) -> Self {
                <$vector>::from_array(core::array::from_fn(|_| leaves.next().expect("three leaves per vector")))
            }
            fn describe(path: &str, doc: &str, leaves: &mut Vec<LeafInfo>) {
                leaves.extend(["x", "y", "z"].map(|component| LeafInfo::new(&join(path, component), doc)));
            }
        }

        impl Real for $vector {
            type Mask = BVec3;
            #[inline(always)]
            fn lit(value: f64) -> Self {
                <$vector>::splat(value as $scalar)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                each(self, <$scalar>::sqrt)
            }
            #[inline(always)]
            fn inverse_sqrt(self) -> Self {
                each(self, Real::inverse_sqrt)
            }
            #[inline(always)]
            fn sin(self) -> Self {
                each(self, <$scalar>::sin)
            }
            #[inline(always)]
            fn cos(self) -> Self {
                each(self, <$scalar>::cos)
            }
            #[inline(always)]
            fn exp(self) -> Self {
                each(self, <$scalar>::exp)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                <$vector>::abs(self)
            }
            #[inline(always)]
            fn floor(self) -> Self {
                <$vector>::floor(self)
            }
            #[inline(always)]
            fn half(self) -> Self {
                each(self, Real::half)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                <$vector>::min(self, other)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                <$vector>::max(self, other)
            }
            #[inline(always)]
            fn less_than(self, other: Self) -> BVec3 {
                self.cmplt(other)
            }
            #[inline(always)]
            fn select(mask: BVec3, if_true: Self, if_false: Self) -> Self {
                <$vector>::select(mask, if_true, if_false)
            }
        }

        impl Vector<$scalar> for $vector {
            #[inline(always)]
            fn new(x: $scalar, y: $scalar, z: $scalar) -> Self {
                <$vector>::new(x, y, z)
            }
            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                <$vector>::splat(value)
            }
            #[inline(always)]
            fn lit3(value: [f64; 3]) -> Self {
                <$vector>::from_array(value.map(|component| component as $scalar))
            }
            #[inline(always)]
            fn x(self) -> $scalar {
                self.x
            }
            #[inline(always)]
            fn y(self) -> $scalar {
                self.y
            }
            #[inline(always)]
            fn z(self) -> $scalar {
                self.z
            }
            #[inline(always)]
            fn dot(self, other: Self) -> $scalar {
                <$vector>::dot(self, other)
            }
            #[inline(always)]
            fn normalize(self) -> Self {
                <$vector>::normalize(self)
            }
            #[inline(always)]
            fn choose(mask: bool, if_true: Self, if_false: Self) -> Self {
                if mask { if_true } else { if_false }
            }
        }
    };
}

native_scalar!(f32, Vec3);
native_scalar!(f64, DVec3);

/// Applies a scalar function to each component.
#[inline(always)]
fn each<S: Copy, V: Copy + Into<[S; 3]> + From<[S; 3]>>(vector: V, function: impl Fn(S) -> S) -> V {
    let components: [S; 3] = vector.into();
    V::from(components.map(function))
}
