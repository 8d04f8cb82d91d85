//! How `#[shade]` gives a `let` its name: values and masks are named, anything else passes through.
//!
//! The three traits have a method `bind`, for `&&&Binding<T>`, `&&Binding<T>` and `&Binding<T>`. On `(&&&binding).bind(..)`
//! the compiler looks at them in this order and takes the first whose bound on `T` holds.

use crate::real::Mask;
use crate::value::Value;
use core::cell::Cell;

/// The right-hand side of a `let`.
pub struct Binding<T>(Cell<Option<T>>);

impl<T> Binding<T> {
    /// Wraps the right-hand side.
    #[inline(always)]
    pub fn new(value: T) -> Self {
        Self(Cell::new(Some(value)))
    }

    #[inline(always)]
    fn take(&self) -> T {
        self.0.take().expect("a binding is used once")
    }
}

/// Names a value.
pub trait BindValue {
    /// The type of the value.
    type Output;
    /// Gives the value back, named.
    fn bind(self, name: &str) -> Self::Output;
}

impl<T: Value> BindValue for &&&Binding<T> {
    type Output = T;
    #[inline(always)]
    fn bind(self, name: &str) -> T {
        self.take().named(name)
    }
}

/// Names a mask.
pub trait BindMask {
    /// The type of the mask.
    type Output;
    /// Gives the mask back, named.
    fn bind(self, name: &str) -> Self::Output;
}

impl<T: Mask> BindMask for &&Binding<T> {
    type Output = T;
    #[inline(always)]
    fn bind(self, name: &str) -> T {
        self.take().named(name)
    }
}

/// Passes anything else through.
pub trait BindOther {
    /// The type of the thing.
    type Output;
    /// Gives it back as it is.
    fn bind(self, name: &str) -> Self::Output;
}

impl<T> BindOther for &Binding<T> {
    type Output = T;
    #[inline(always)]
    fn bind(self, _name: &str) -> T {
        self.take()
    }
}
