//! What the emitted code saves where a scene fixes something: operations, and cycles on a graphics card.
//!
//! The pairs of scenes stand in `templates/savings/savings.toml`. `cargo xtask savings` prints them as a table.

mod cases;
mod failure;
mod measure;
mod report;

pub use cases::{Case, Errors, Quantity, cases};
pub use failure::Failure;
pub use measure::{FAMILY, Pair, Saving};
pub use report::table;
