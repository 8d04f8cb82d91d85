//! A base that is known by its reflectance at normal incidence alone, the F0 of engines: the index that has it.
//!
//! F0 is meant under air, as engines mean it, so that the index is the medium's own and an ambient medium, or a film,
//! that is not air changes what is reflected. Without an edge tint the base is the dielectric of this F0
//! ([`ior_from_reflectance`]), with one it is a conductor.

use crate::film::BaseKind;
use crate::fresnel::{LARGEST_AMPLITUDE, ior_from_reflectance};
use pavo_shade::{Real, Scalar, shade};

/// A complex refractive index.
#[shade]
pub struct ComplexIndex<R: Real> {
    /// Refractive index.
    pub ior: R,
    /// Extinction coefficient.
    pub kappa: R,
}

/// Complex refractive index of the conductor that reflects this much at normal incidence under air, with an edge tint:
/// at 0 it does not absorb, at 1 it has the smallest index that this reflectance allows.
///
/// The index is `g n_min + (1 - g) n_max` with `n_min = (1 - r) / (1 + r)`, `n_max = (1 + s) / (1 - s)` and
/// `s = sqrt(r)`. Of `k^2 = (r (n + 1)^2 - (n - 1)^2) / (1 - r)` the two factors `n_max - n` and `n - 1 / n_max` are
/// sums of positive terms here, so that nothing cancels. `s` is held below 0.9999, as for a dielectric: what reflects
/// more reflects 0.9998.
///
/// Source: Gulbrandsen 2014, "Artist Friendly Metallic Fresnel", JCGT 3(4): the index by reflectivity r and edge tint g.
#[shade]
pub fn index_from_f0<R: Real>(
    /// Reflectance at normal incidence, [0, 1].
    f0: R,
    /// Edge tint, [0, 1].
    edge_tint: R,
) -> ComplexIndex<R> {
    let amplitude = f0.max(R::lit(0.0)).sqrt().min(R::lit(LARGEST_AMPLITUDE));
    let missing = 1.0 - amplitude;
    let present = 1.0 + amplitude;
    let reciprocal = 1.0 / (1.0 + amplitude * amplitude);
    let smallest = missing * present * reciprocal;
    let twice = 2.0 * amplitude * reciprocal;
    let span = twice * present / missing;
    let above_smallest = (1.0 - edge_tint) * span;
    let below_largest = edge_tint * span;
    let ior = smallest + above_smallest;
    let kappa = (below_largest * (above_smallest + twice * missing / present)).sqrt();
    ComplexIndex { ior, kappa }
}

/// The index of a base of this kind by channel: of a conductor with its edge tint, or of a dielectric without.
pub fn base_index<S: Scalar>(kind: BaseKind, f0: S::Vec3, edge_tint: S::Vec3) -> ComplexIndex<S::Vec3> {
    match kind {
        BaseKind::Conductor => index_from_f0(f0, edge_tint),
        BaseKind::Dielectric { .. } => {
            ComplexIndex { ior: ior_from_reflectance(f0, S::Vec3::lit(1.0)), kappa: S::Vec3::lit(0.0) }
        }
    }
}
