//! Which parts of a film's reflectance are held in half precision.

use crate::film::Method;
use pavo_shade::{Real, Scalar, Vector};

/// The parts that are held in half precision; the rest takes the number type as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Precision {
    /// The colour: what each node, pole, Gaussian or wavelength adds to it, the weights and the sum.
    pub sums: bool,
    /// Of nodes under a window, also the reciprocals of both polarisations that make a node.
    pub nodes: bool,
}

impl Precision {
    /// Nothing is in half precision.
    pub const FULL: Self = Self { sums: false, nodes: false };

    /// What of a method stands half precision: the sums, where they are short. Measured over dielectrics and conductors
    /// they add an RMS of 1e-4 to 5e-4 then; the nodes add up to 2.6e-3, and a sum over 81 wavelengths 1.3e-3.
    pub fn half(method: &Method) -> Self {
        const LONGEST_SUM: usize = 32;
        let stands_it = match method {
            Method::TabulatedSeries { .. } => false,
            Method::Spectral { nodes } => nodes.len() <= LONGEST_SUM,
            _ => true,
        };
        Self { sums: stands_it, nodes: false }
    }

    /// The names of the parts in half precision.
    pub fn parts(self) -> Vec<&'static str> {
        let parts = [(self.sums, "weights and sums"), (self.nodes, "nodes")];
        parts.into_iter().filter(|(is_half, _)| *is_half).map(|(_, name)| name).collect()
    }

    /// A number of the sums.
    pub(crate) fn sum<R: Real>(self, value: R) -> R {
        if self.sums { value.half() } else { value }
    }

    /// A number of the nodes.
    pub(crate) fn node<R: Real>(self, value: R) -> R {
        if self.nodes { value.half() } else { value }
    }

    /// A weight times what it is the weight of.
    pub(crate) fn weighted<S: Scalar>(self, weight: [f64; 3], value: S::Vec3) -> S::Vec3 {
        self.sum(self.sum(S::Vec3::lit3(weight)) * self.sum(value))
    }
}
