//! A film whose indices are fixed: the colour over angle and thickness as a table, read between its rows.

use pavo_shade::{Real, Scalar, Table, Vector, shade};

/// The colours of a film over angle and thickness.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmTable {
    /// How many angles: the roots of the cosines are equally spaced from 0 to 1. At least 2.
    pub angles: usize,
    /// How many thicknesses, equally spaced. At least 2; or 1 for a film of one thickness.
    pub thicknesses: usize,
    /// The smallest and the largest thickness, nm.
    pub thickness_nm: [f64; 2],
    /// The colours: all angles of the first thickness, then those of the next.
    pub colors: Table,
}

impl FilmTable {
    /// The cosines and thicknesses of the rows, in their order.
    pub fn points(angles: usize, thicknesses: usize, [thinnest, thickest]: [f64; 2]) -> Vec<[f64; 2]> {
        let fraction = |index: usize, count: usize| index as f64 / (count.max(2) - 1) as f64;
        let angle = |index: usize| fraction(index, angles).powi(2);
        let thickness = |index: usize| thinnest + (thickest - thinnest) * fraction(index, thicknesses);
        (0..thicknesses).flat_map(|t| (0..angles).map(move |a| [angle(a), thickness(t)])).collect()
    }
}

/// Reflectance of this film as a linear colour, between the entries of a table of the exact spectral reflectance over
/// angle and thickness. It holds for the fixed indices and the range of thickness of the scene only.
#[shade]
pub fn table_reflectance<S: Scalar>(
    /// The table.
    #[constant]
    table: &FilmTable,
    /// Cosine of the angle between half vector and light, [0, 1].
    cos_theta1: S,
    /// Thickness of the film, nm, within the range of the table.
    thickness_nm: S,
) -> S::Vec3 {
    let last_angle = table.angles as f64 - 1.0_f64;
    let angle = cos_theta1.max(0.0).sqrt() * S::lit(last_angle);
    let column = angle.floor().clamp(S::lit(0.0), S::lit(last_angle - 1.0));
    let angle_fraction = S::Vec3::splat(angle - column);
    let between_angles = |index: S| {
        S::Vec3::mix(S::fetch(&table.colors, index), S::fetch(&table.colors, index + S::lit(1.0)), angle_fraction)
    };
    if table.thicknesses == 1 {
        return between_angles(column);
    }
    let [thinnest, thickest] = table.thickness_nm;
    let last_thickness = table.thicknesses as f64 - 1.0_f64;
    let rows_per_nm = last_thickness / (thickest - thinnest);
    let place = ((thickness_nm - S::lit(thinnest)) * S::lit(rows_per_nm)).clamp(S::lit(0.0), S::lit(last_thickness));
    let row = place.floor().min(S::lit(last_thickness - 1.0));
    let index = row * S::lit(table.angles as f64) + column;
    let thinner = between_angles(index);
    let thicker = between_angles(index + S::lit(table.angles as f64));
    S::Vec3::mix(thinner, thicker, S::Vec3::splat(place - row))
}
