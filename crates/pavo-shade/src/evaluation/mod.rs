//! Fast evaluation of a program, on anything that takes the place of a number.

mod evaluator;
mod inexact;
mod layout;
mod numbers;

pub(crate) use evaluator::{Evaluator, Origin};
pub use inexact::{FunctionErrors, evaluate_inexact};
pub(crate) use layout::{Frame, Layout, Slots, width};
pub use numbers::evaluate;
