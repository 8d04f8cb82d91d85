//! The lit sphere of the fragment entry as a picture: rendered on lavapipe, or evaluated on the CPU.

mod display;
mod evaluated;
mod rendered;

pub use display::{Display, bytes};
pub use evaluated::{Evaluation, evaluate};
pub use rendered::{is_renderable, render};
