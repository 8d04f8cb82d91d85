//! `pavo plot`: pictures of the sensitivities and of what a variant makes of a scene.

mod reflectance;
mod sensitivities;

pub(super) use reflectance::heat;

use super::arguments::PlotCommand;
use super::failure::Failure;
use super::output;
use super::picture::png;
use plotters::coord::Shift;
use plotters::prelude::{BitMapBackend, DrawingArea, DrawingBackend, IntoDrawingArea, SVGBackend, WHITE};
use plotters::style::{FontStyle, register_font};
use std::fmt::Display;
use std::path::Path;

/// The font family of every text; in a PNG it is DejaVu Sans, in an SVG what the viewer has.
pub(super) const FONT: &str = "sans-serif";

/// Draws what was asked for.
pub fn run(command: &PlotCommand) -> Result<(), Failure> {
    match command {
        PlotCommand::Sensitivities(arguments) => sensitivities::run(arguments),
        PlotCommand::Reflectance(arguments) => reflectance::run(arguments),
    }
}

/// What can be drawn on any backend.
pub(super) trait Picture {
    /// Width and height in pixels.
    const SIZE: (u32, u32);

    /// Draws onto a white area of [`Picture::SIZE`].
    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Result<(), String>;
}

/// The format of a picture.
#[derive(Clone, Copy, Debug)]
enum Format {
    Svg,
    Png,
}

impl Format {
    /// The format that the extension of a file names.
    fn of(path: &Path) -> Result<Self, Failure> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            Some("svg") => Ok(Format::Svg),
            Some("png") => Ok(Format::Png),
            _ => Err(Failure::input(
                format!("{}: the extension names no format of plots", pavo_files::shown(path)),
                "name a file that ends in .svg or .png",
            )),
        }
    }

    /// Draws a picture, writes it to a file, and prints the file's name.
    fn write(self, picture: &impl Picture, path: &Path) -> Result<(), Failure> {
        let bytes = self.encode(picture);
        let bytes = bytes.map_err(|error| Failure::check(format!("the plot cannot be drawn: {error}")))?;
        output::write(path, &bytes)?;
        output::print(&format!("{}\n", path.display()))
    }

    fn encode<P: Picture>(self, picture: &P) -> Result<Vec<u8>, String> {
        match self {
            Format::Svg => svg(picture).map(String::into_bytes),
            Format::Png => {
                register_font(FONT, FontStyle::Normal, dejavu::sans::regular())
                    .map_err(|_| "its font cannot be read")?;
                let (width, height) = P::SIZE;
                let mut pixels = vec![0; width as usize * height as usize * 3];
                on_white(picture, BitMapBackend::with_buffer(&mut pixels, P::SIZE))?;
                png(&pixels, P::SIZE).map_err(shown)
            }
        }
    }
}

/// A picture as a PNG.
pub(super) fn png_of(picture: &impl Picture) -> Result<Vec<u8>, Failure> {
    Format::Png.encode(picture).map_err(|error| Failure::check(format!("the plot cannot be drawn: {error}")))
}

/// A picture as the text of an SVG.
pub(super) fn svg<P: Picture>(picture: &P) -> Result<String, String> {
    register_font(FONT, FontStyle::Normal, dejavu::sans::regular()).map_err(|_| "its font cannot be read")?;
    let mut text = String::new();
    on_white(picture, SVGBackend::with_string(&mut text, P::SIZE))?;
    Ok(text)
}

fn on_white<B: DrawingBackend>(picture: &impl Picture, backend: B) -> Result<(), String> {
    let area = backend.into_drawing_area();
    area.fill(&WHITE).map_err(shown)?;
    picture.draw(&area.margin(12, 0, 0, 0))?;
    area.present().map_err(shown)
}

/// A tick of an axis, without idle decimals.
fn tick(value: &f64) -> String {
    ((value * 1e3).round() / 1e3).to_string()
}

pub(super) fn shown(error: impl Display) -> String {
    error.to_string()
}
