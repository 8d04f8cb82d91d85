//! The pavo command.
fn main() {}
