//! The families of graphics cards whose compiler can be asked.

use serde::Serialize;

/// A family of graphics cards with one instruction set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Family {
    /// The name, as on the command line.
    pub name: &'static str,
    /// What instruction set it is, and a card that has it.
    pub description: &'static str,
    /// The names that releases of RADV have for it; the first that is known is taken.
    #[serde(skip)]
    pub(super) driver_names: &'static [&'static str],
}

const fn family(name: &'static str, description: &'static str, driver_names: &'static [&'static str]) -> Family {
    Family { name, description, driver_names }
}

/// The families, from the oldest to the newest. RDNA 1 is left out, as its figures are those of RDNA 2.
pub const FAMILIES: &[Family] = &[
    family("tahiti", "GCN 1, such as the Radeon HD 7970", &["TAHITI"]),
    family("polaris10", "GCN 4, such as the Radeon RX 480", &["POLARIS10"]),
    family("vega10", "GCN 5, such as the Radeon RX Vega 64", &["VEGA10"]),
    family("navi21", "RDNA 2, such as the Radeon RX 6800", &["NAVI21"]),
    family("gfx1100", "RDNA 3, such as the Radeon RX 7900", &["NAVI31", "GFX1100"]),
];
