//! Maps of where the error lives, over the angle and the thickness.

use crate::cli::plot::{FONT, Picture, heat, shown};
use crate::stability::ErrorMap;
use plotters::coord::Shift;
use plotters::prelude::*;

/// The decimal logarithms of the errors that are drawn black and white.
const LEVELS: [f64; 2] = [-8.0, -2.0];

/// The maps of a variant, a panel for each surface.
pub struct Maps<'a> {
    pub variant: &'a str,
    pub maps: Vec<&'a ErrorMap>,
}

impl Picture for Maps<'_> {
    const SIZE: (u32, u32) = (1500, 420);

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), String> {
        let title =
            format!("{}: largest difference of f32 from f64, black 1e-8, white 1e-2, grey no point", self.variant);
        let area = area.titled(&title, (FONT, 20)).map_err(shown)?;
        for (map, area) in self.maps.iter().zip(area.split_evenly((1, self.maps.len()))) {
            panel(&area, map)?;
        }
        Ok(())
    }
}

fn panel<B: DrawingBackend>(area: &DrawingArea<B, Shift>, map: &ErrorMap) -> Result<(), String> {
    let ([left, right], [thin, thick]) = (ErrorMap::COSINES, ErrorMap::THICKNESSES);
    let largest = map.cells.iter().flatten().copied().fold(0.0, f64::max);
    let mut chart = ChartBuilder::on(area)
        .caption(format!("{}, at most {largest:.1e}", map.surface), (FONT, 14))
        .margin(8)
        .x_label_area_size(40)
        .y_label_area_size(46)
        .build_cartesian_2d(left..right, thin..thick)
        .map_err(shown)?;
    let [width, height] = [(right - left) / ErrorMap::COLUMNS as f64, (thick - thin) / ErrorMap::ROWS as f64];
    let cells = map.cells.iter().enumerate().map(|(index, error)| {
        let (column, row) = ((index % ErrorMap::COLUMNS) as f64, (index / ErrorMap::COLUMNS) as f64);
        let (x, y) = (left + column * width, thin + row * height);
        let colour = error.map_or(RGBColor(128, 128, 128), |error| {
            heat((error.max(1e-30).log10() - LEVELS[0]) / (LEVELS[1] - LEVELS[0]))
        });
        Rectangle::new([(x, y), (x + width, y + height)], colour.filled())
    });
    chart.draw_series(cells).map_err(shown)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_desc("log10 of cos θ₁")
        .y_desc("log10 of the thickness (nm)")
        .x_labels(6)
        .y_labels(8)
        .axis_desc_style((FONT, 13))
        .label_style((FONT, 12))
        .draw()
        .map_err(shown)
}
