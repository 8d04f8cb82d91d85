//! Under construction.

pub mod scene;
