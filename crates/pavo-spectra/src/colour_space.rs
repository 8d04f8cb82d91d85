//! Linear RGB colour spaces: primaries, white, and the matrix from CIE XYZ; the sRGB transfer function.

use crate::matrix3::{IDENTITY, Matrix3, inverse, transform};
use crate::names::UnknownName;

/// The space of an output colour, always linear in light.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ColourSpace {
    /// sRGB before its transfer function (IEC 61966-2-1, primaries of ITU-R BT.709).
    LinearSrgb,
    /// Display P3, linear (primaries of SMPTE EG 432-1, white D65).
    DisplayP3,
    /// ITU-R BT.2020, linear.
    Rec2020,
    /// ACEScg (Academy S-2014-004, primaries AP1), with the white of ACES, near D60.
    AcesCg,
    /// CIE XYZ itself; white is (1, 1, 1) there too, since every channel is normalised.
    Xyz,
}

impl ColourSpace {
    /// Every colour space.
    pub const ALL: [ColourSpace; 5] =
        [ColourSpace::LinearSrgb, ColourSpace::DisplayP3, ColourSpace::Rec2020, ColourSpace::AcesCg, ColourSpace::Xyz];

    /// The names that [`ColourSpace::from_name`] knows, in the order of [`ColourSpace::ALL`].
    pub const NAMES: [&'static str; 5] = ["linear-srgb", "display-p3", "rec2020", "acescg", "xyz"];

    /// The colour space of that name.
    ///
    /// # Errors
    /// An unknown name, with the known ones.
    pub fn from_name(name: &str) -> Result<Self, UnknownName> {
        Self::ALL
            .into_iter()
            .find(|space| space.name() == name)
            .ok_or_else(|| UnknownName::new("colour space", name, &Self::NAMES))
    }

    /// The name that [`ColourSpace::from_name`] reads.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// Names of the three channels, for messages.
    pub fn channels(self) -> [&'static str; 3] {
        match self {
            ColourSpace::Xyz => ["X", "Y", "Z"],
            _ => ["R", "G", "B"],
        }
    }

    /// Chromaticities (x, y) of the red, green and blue primaries; `None` for XYZ.
    pub fn primaries(self) -> Option<[[f64; 2]; 3]> {
        match self {
            ColourSpace::LinearSrgb => Some([[0.640, 0.330], [0.300, 0.600], [0.150, 0.060]]),
            ColourSpace::DisplayP3 => Some([[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]]),
            ColourSpace::Rec2020 => Some([[0.708, 0.292], [0.170, 0.797], [0.131, 0.046]]),
            ColourSpace::AcesCg => Some([[0.713, 0.293], [0.165, 0.830], [0.128, 0.044]]),
            ColourSpace::Xyz => None,
        }
    }

    /// Chromaticity (x, y) of the white, as the standard prints it: D65 (0.3127, 0.3290), the white of ACES
    /// (0.32168, 0.33767), or equal energy for XYZ.
    pub fn white_chromaticity(self) -> [f64; 2] {
        match self {
            ColourSpace::LinearSrgb | ColourSpace::DisplayP3 | ColourSpace::Rec2020 => [0.3127, 0.3290],
            ColourSpace::AcesCg => [0.32168, 0.33767],
            ColourSpace::Xyz => [1.0 / 3.0, 1.0 / 3.0],
        }
    }

    /// The matrix, by rows, from linear RGB to CIE XYZ, with Y = 1 for white: the columns are the primaries' XYZ, scaled
    /// to sum to the white's (SMPTE RP 177).
    pub fn rgb_to_xyz(self) -> Matrix3 {
        let Some(primaries) = self.primaries() else { return IDENTITY };
        let [red, green, blue] = primaries.map(xyz_of_chromaticity);
        let unscaled: Matrix3 = std::array::from_fn(|row| [red[row], green[row], blue[row]]);
        let scales = transform(&inverse(&unscaled), xyz_of_chromaticity(self.white_chromaticity()));
        crate::matrix3::scale_columns(&unscaled, scales)
    }

    /// The matrix, by rows, from CIE XYZ to linear RGB: the inverse of [`ColourSpace::rgb_to_xyz`].
    pub fn xyz_to_rgb(self) -> Matrix3 {
        inverse(&self.rgb_to_xyz())
    }
}

/// The XYZ of a chromaticity (x, y) at Y = 1; y must not be 0.
pub fn xyz_of_chromaticity([x, y]: [f64; 2]) -> [f64; 3] {
    [x / y, 1.0, (1.0 - x - y) / y]
}

/// The sRGB transfer function (IEC 61966-2-1): a linear value to an encoded one, both from 0 to 1. Values outside are
/// clamped first, as a picture must.
pub fn srgb_encode(linear: f64) -> f64 {
    let linear = linear.clamp(0.0, 1.0);
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}
