//! The page of a scene.

use super::page;
use super::plots::PlotFile;
use super::survey::Survey;
use super::worst;
use crate::cli::failure::Failure;
use minijinja::value::Serde;
use minijinja::{Value, context};
use pavo_spectra::ColourSpace;
use pavo_spectra::colour_space::srgb_encode;

/// The page as HTML, on its own or as one of a gallery.
pub fn page(survey: &Survey<'_>, in_gallery: bool) -> Result<String, Failure> {
    let Survey { figures, description, pictures, plots, worst_points } = survey;
    let plots: Vec<Value> = plots
        .iter()
        .map(|plot| context! { caption => &plot.caption, svg => inline(plot), file => plot.file })
        .collect();
    let space = ColourSpace::from_name(&figures.scene.colour.space).unwrap_or(ColourSpace::LinearSrgb);
    // Weak reflectances are brightened alike, the strongest channel to 1.
    let strongest = figures.worst_points.iter().flat_map(|point| point.exact).fold(0.0, f64::max);
    let gain = if strongest > 1e-6 { (1.0 / strongest).max(1.0) } else { 1.0 };
    let swatch = |color: [f64; 3]| css_colour(color.map(|value| value * gain), space);
    let swatches: Vec<[String; 2]> =
        figures.worst_points.iter().map(|point| [swatch(point.exact), swatch(point.found)]).collect();
    let values = context! {
        title => &figures.scene.name,
        figures => Serde(figures),
        description => Serde(description),
        in_gallery,
        plots,
        pictures => Serde(pictures),
        swatches,
        gain,
        worst_file => worst::FILE,
        worst_table => worst_points,
    };
    page::render("scene.html", values)
}

/// A plot as a part of a page: without its white ground, and with its black as the colour of the page's text.
fn inline(plot: &PlotFile) -> String {
    let mut svg = plot.svg.replace("#000000", "currentColor");
    if let Some(start) = svg.find("<rect")
        && let Some(length) = svg[start..].find("/>")
        && svg[start..start + length].contains("#FFFFFF")
    {
        svg.replace_range(start..start + length + 2, "");
    }
    svg
}

/// A linear colour of a space as CSS; what lies outside of sRGB is clipped.
fn css_colour(color: [f64; 3], space: ColourSpace) -> String {
    let through = |matrix: [[f64; 3]; 3], color: [f64; 3]| {
        matrix.map(|row| row.iter().zip(color).map(|(factor, value)| factor * value).sum::<f64>())
    };
    let linear = through(ColourSpace::LinearSrgb.xyz_to_rgb(), through(space.rgb_to_xyz(), color));
    let [red, green, blue] = linear.map(|value| (srgb_encode(value.clamp(0.0, 1.0)) * 255.0).round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}
