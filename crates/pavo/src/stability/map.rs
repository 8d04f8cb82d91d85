//! Where an error lives: its largest in each cell over the angle and the thickness.

use serde::Serialize;

/// The largest difference of `f32` from `f64` over the sweep, in cells over the logarithms of the cosine and of the
/// thickness.
#[derive(Clone, Debug, Serialize)]
pub struct ErrorMap {
    /// The surface.
    pub surface: String,
    /// The variant.
    pub variant: String,
    /// The largest difference of each cell, row by row from thin to thick; nothing where no point fell.
    pub cells: Vec<Option<f64>>,
}

impl ErrorMap {
    /// Cells over the cosine.
    pub const COLUMNS: usize = 48;
    /// Cells over the thickness.
    pub const ROWS: usize = 32;
    /// The decimal logarithms of the cosine at both ends.
    pub const COSINES: [f64; 2] = [-6.0, 0.0];
    /// The decimal logarithms of the thickness at both ends, nm.
    pub const THICKNESSES: [f64; 2] = [-3.0, 5.0];

    /// A map without points.
    pub(super) fn new(surface: &str, variant: &str) -> Self {
        let cells = vec![None; Self::COLUMNS * Self::ROWS];
        Self { surface: surface.to_owned(), variant: variant.to_owned(), cells }
    }

    /// Takes a point in; what lies beyond an end is taken for the end.
    pub(super) fn take(&mut self, cos_theta1: f64, thickness_nm: f64, error: f64) {
        let place = |value: f64, [low, high]: [f64; 2], count: usize| {
            let fraction = (value.max(1e-30).log10() - low) / (high - low);
            ((fraction * count as f64).max(0.0) as usize).min(count - 1)
        };
        let row = place(thickness_nm, Self::THICKNESSES, Self::ROWS);
        let cell = &mut self.cells[row * Self::COLUMNS + place(cos_theta1, Self::COSINES, Self::COLUMNS)];
        *cell = Some(cell.map_or(error, |largest| largest.max(error)));
    }
}

#[cfg(test)]
mod tests {
    use super::ErrorMap;

    #[test]
    fn a_cell_keeps_its_largest_error() {
        let mut map = ErrorMap::new("dielectric", "poles:k=5");
        for (cosine, thickness, error) in [(1.0, 1e5, 0.25), (1.0, 1e5, 0.5), (1.0, 1e9, 0.125), (0.0, 0.0, 1.0)] {
            map.take(cosine, thickness, error);
        }
        assert_eq!((map.cells[0], map.cells.last().copied().flatten()), (Some(1.0), Some(0.5)));
        assert_eq!(map.cells.iter().flatten().count(), 2);
    }
}
