//! How `#[shade]` gives a `let` its name: values are named, anything else passes through.
//!
//! Both traits have a method `bind`. On `Binding<T>` with `T: Value` the one that takes it by value is found first;
//! for any other type the compiler goes on to the one that takes a reference.

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
}

/// Names a value.
pub trait BindValue {
    /// The type of the value.
    type Output;
    /// Gives the value back, named.
    fn bind(self, name: &str) -> Self::Output;
}

impl<T: Value> BindValue for Binding<T> {
    type Output = T;
    #[inline(always)]
    fn bind(self, name: &str) -> T {
        self.0.into_inner().expect("a binding is used once").named(name)
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
        self.0.take().expect("a binding is used once")
    }
}
