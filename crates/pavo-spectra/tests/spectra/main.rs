//! Tests of the crate through its public interface, one module per subject.

mod colour_spaces;
mod delta_e;
mod dielectrics;
mod illuminants;
mod limits;
mod metals;
mod observers;
mod optical_constants;
mod random;
mod reference_points;
mod sensitivities;
mod tables;
mod transfer_matrix;

/// Fails unless two numbers agree within an absolute tolerance.
#[track_caller]
fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(error <= tolerance, "{what}: {found}, expected {expected} within {tolerance:e}, off by {error:e}");
}
