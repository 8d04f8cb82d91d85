//! The colours of a scene over angle and thickness: by the variant, by the exact reference, and how they differ.

use super::{FONT, Format, Picture, shown, tick};
use crate::cli::arguments;
use crate::cli::failure::Failure;
use crate::cli::progress::Progress;
use crate::cli::sources::Source;
use crate::inputs::ShadingQuantity;
use pavo_spectra::ColourSpace;
use pavo_spectra::colour_space::srgb_encode;
use pavo_spectra::delta_e::delta_e_of_linear;
use plotters::coord::Shift;
use plotters::prelude::*;

/// Cells over the cosine of the angle.
const COLUMNS: usize = 128;
/// Cells over a range of thicknesses.
const ROWS: usize = 96;

/// Evaluates the scene and draws the three panels.
pub fn run(arguments: &arguments::PlotReflectance) -> Result<(), Failure> {
    let format = Format::of(&arguments.output)?;
    let source = Source::load(&arguments.scene, arguments.variant.as_deref())?;
    let shading = &source.shading;
    let quantity = ShadingQuantity::Reflectance;
    let inputs = shading.inputs(quantity);
    let varies = inputs.iter().any(|input| input.name == "thickness_nm");
    let rows = if varies { ROWS } else { 1 };
    let thicknesses = shading.scene().film.as_ref().map(|film| [film.thickness_nm.low(), film.thickness_nm.high()]);
    let point = |cell: usize| -> Vec<f64> {
        let fractions = [(cell % COLUMNS) as f64 + 0.5, (cell / COLUMNS) as f64 + 0.5];
        let numbers = inputs.iter().flat_map(|input| {
            let value = match input.name.as_str() {
                "cos_theta1" => fractions[0] / COLUMNS as f64,
                "thickness_nm" => input.low + (input.high - input.low) * fractions[1] / rows as f64,
                _ => f64::midpoint(input.low, input.high),
            };
            std::iter::repeat_n(value, input.components())
        });
        numbers.collect()
    };
    let points: Vec<Vec<f64>> = (0..rows * COLUMNS).map(point).collect();
    let progress = Progress::start();
    progress.step(format!("evaluating {} points", points.len()));
    let by_variant = shading.evaluate_each(quantity, &points);
    let exact = shading.reference_each(quantity, &points)?;
    drop(progress);
    let space = ColourSpace::from_name(&shading.scene().colour.space)
        .map_err(|error| Failure::input(error, "see colour.space of the scene"))?;
    let differences = by_variant.iter().zip(&exact).map(|(a, b)| delta_e_of_linear(*a, *b, space)).collect();
    let title = format!("Reflectance of {} by {}", shading.scene().name, shading.variant());
    let maps = Maps { title, space, rows, thicknesses, by_variant, exact, differences };
    format.write(&maps, &arguments.output)
}

struct Maps {
    title: String,
    space: ColourSpace,
    rows: usize,
    /// The ends of the range of thicknesses, nm.
    thicknesses: Option<[f64; 2]>,
    by_variant: Vec<[f64; 3]>,
    exact: Vec<[f64; 3]>,
    differences: Vec<f64>,
}

impl Picture for Maps {
    const SIZE: (u32, u32) = (1350, 480);

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), String> {
        let area = area.titled(&self.title, (FONT, 22)).map_err(shown)?;
        // Weak reflectances are brightened alike in both pictures, the strongest channel to 1.
        let strongest = self.exact.iter().flatten().copied().fold(0.0, f64::max);
        let gain = if strongest > 1e-6 { (1.0 / strongest).max(1.0) } else { 1.0 };
        let brightened = if gain >= 1.05 { format!(", shown × {gain:.1}") } else { String::new() };
        let picture = |colors: &[[f64; 3]]| colors.iter().map(|color| to_srgb(*color, self.space, gain)).collect();
        let worst = self.differences.iter().copied().fold(0.0, f64::max);
        let heat = self.differences.iter().map(|difference| heat(difference / worst.max(1e-12))).collect();
        let maps: [(String, Vec<RGBColor>); 3] = [
            (format!("the variant{brightened}"), picture(&self.by_variant)),
            (format!("the exact reference{brightened}"), picture(&self.exact)),
            (format!("CIEDE2000: black 0, white the maximum, {worst:.2}"), heat),
        ];
        for ((title, colors), area) in maps.iter().zip(area.split_evenly((1, 3))) {
            self.map(&area, title, colors)?;
        }
        Ok(())
    }
}

impl Maps {
    fn map<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        title: &str,
        colors: &[RGBColor],
    ) -> Result<(), String> {
        let strip = self.rows == 1;
        let ([low, high], axis) = match self.thicknesses {
            Some(range) if !strip => (range, "thickness (nm)".to_owned()),
            Some([thickness, _]) => ([0.0, 1.0], format!("thickness {thickness} nm")),
            None => ([0.0, 1.0], "no film".to_owned()),
        };
        let mut chart = ChartBuilder::on(area)
            .caption(title, (FONT, 15))
            .margin(12)
            .x_label_area_size(44)
            .y_label_area_size(60)
            .build_cartesian_2d(0.0..1.0, low..high)
            .map_err(shown)?;
        let step = (high - low) / self.rows as f64;
        let cells = colors.iter().enumerate().map(|(cell, color)| {
            let (column, row) = ((cell % COLUMNS) as f64, (cell / COLUMNS) as f64);
            let corner = (column / COLUMNS as f64, low + row * step);
            let opposite = ((column + 1.0) / COLUMNS as f64, low + (row + 1.0) * step);
            Rectangle::new([corner, opposite], color.filled())
        });
        chart.draw_series(cells).map_err(shown)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc("cos θ₁, the angle of incidence")
            .y_desc(axis)
            .y_labels(if strip { 0 } else { 8 })
            .x_labels(6)
            .axis_desc_style((FONT, 15))
            .label_style((FONT, 13))
            .x_label_formatter(&tick)
            .y_label_formatter(&tick)
            .draw()
            .map_err(shown)
    }
}

/// A linear colour of a space as sRGB; what lies outside of it is clipped.
fn to_srgb(color: [f64; 3], space: ColourSpace, gain: f64) -> RGBColor {
    let through = |matrix: [[f64; 3]; 3], color: [f64; 3]| {
        matrix.map(|row| row.iter().zip(color).map(|(factor, value)| factor * value).sum::<f64>())
    };
    let linear = through(ColourSpace::LinearSrgb.xyz_to_rgb(), through(space.rgb_to_xyz(), color));
    let [red, green, blue] = linear.map(|value| (srgb_encode((value * gain).clamp(0.0, 1.0)) * 255.0).round() as u8);
    RGBColor(red, green, blue)
}

/// Black over red and yellow to white, for 0 to 1.
pub(in crate::cli) fn heat(level: f64) -> RGBColor {
    let [red, green, blue] = [0.0, 1.0, 2.0].map(|start| ((3.0 * level - start).clamp(0.0, 1.0) * 255.0).round() as u8);
    RGBColor(red, green, blue)
}
