//! Truth values that may be undecided: comparisons of intervals.

use crate::real::Mask;

/// Whether a condition may hold, and whether it may fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Truth {
    may_hold: bool,
    may_fail: bool,
}

/// A condition for each component of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Truth3(pub [Truth; 3]);

impl Truth {
    /// A condition that may hold, may fail, or both.
    pub fn new(may_hold: bool, may_fail: bool) -> Self {
        Self { may_hold, may_fail }
    }

    /// Whether it holds, where that is certain.
    pub fn decided(self) -> Option<bool> {
        (self.may_hold != self.may_fail).then_some(self.may_hold)
    }
}

impl Mask for Truth {
    fn and(self, other: Self) -> Self {
        Self { may_hold: self.may_hold && other.may_hold, may_fail: self.may_fail || other.may_fail }
    }
    fn or(self, other: Self) -> Self {
        Self { may_hold: self.may_hold || other.may_hold, may_fail: self.may_fail && other.may_fail }
    }
    fn not(self) -> Self {
        Self { may_hold: self.may_fail, may_fail: self.may_hold }
    }
}

impl Mask for Truth3 {
    fn and(self, other: Self) -> Self {
        Self(core::array::from_fn(|index| self.0[index].and(other.0[index])))
    }
    fn or(self, other: Self) -> Self {
        Self(core::array::from_fn(|index| self.0[index].or(other.0[index])))
    }
    fn not(self) -> Self {
        Self(self.0.map(Truth::not))
    }
}
