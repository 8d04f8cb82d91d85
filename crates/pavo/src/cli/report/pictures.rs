//! The sphere by the exact reference and by the variant, and how they differ.

use super::figures::SphereFigures;
use crate::cli::failure::Failure;
use crate::cli::picture::png;
use crate::cli::plot::heat;
use crate::cli::progress::Progress;
use crate::cli::sources::Source;
use crate::cli::sphere::{Display, Evaluation, bytes, evaluate, is_renderable, render};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use pavo_check::Device;
use pavo_spectra::ColourSpace;
use pavo_spectra::delta_e::delta_e_of_linear;
use plotters::style::RGBColor;
use serde::Serialize;

/// The width and height of the pictures in pixels. Each has one sample: the reference takes a tenth of a millisecond.
const SIZE: u32 = 288;

/// The pictures of a page as `data:` URIs, with their figures.
#[derive(Serialize)]
pub struct Pictures {
    /// The sphere by the exact reference.
    pub exact: String,
    /// The sphere by the variant.
    pub variant: String,
    /// The map of dE2000 between them.
    pub difference: String,
    /// The colours of the map from 0 to the end of its scale.
    pub scale: Vec<String>,
    /// The figures.
    pub figures: SphereFigures,
}

/// Makes the pictures: the variant by its emitted shader where there is a device.
pub fn pictures(source: &Source, device: Option<&Device>, progress: &Progress) -> Result<Pictures, Failure> {
    let shading = &source.shading;
    progress.step(format!("the sphere of {} by the exact reference", shading.scene().name));
    let exact = evaluate(shading, Evaluation::Reference, SIZE)?;
    let on_cpu = evaluate(shading, Evaluation::Variant, SIZE)?;
    progress.step(format!("the sphere of {} by {}", shading.scene().name, shading.variant()));
    let device = match device {
        None => Err("as asked by --no-run".to_owned()),
        Some(_) if !is_renderable(shading) => {
            Err("lavapipe takes minutes to compile the tables of a fragment shader".to_owned())
        }
        Some(device) => Ok(device),
    };
    let rendered = device.as_ref().ok().map(|device| render(source, device, SIZE)).transpose()?;

    // One exposure for all, so that the pictures differ by the reflectance alone.
    let display = Display::of(&exact, shading.sensitivities().space());
    let [exact, on_cpu] = [exact, on_cpu].map(|samples| clipped(&display.pixels(&samples, SIZE, 1)));
    let rendered = rendered.map(|samples| clipped(&display.pixels(&samples, SIZE, 1)));
    let shader_against_cpu = rendered.as_ref().map(|rendered| {
        let pairs = bytes(rendered).into_iter().zip(bytes(&on_cpu));
        pairs.map(|(a, b)| f64::from(a.abs_diff(b))).fold(0.0, f64::max)
    });
    let variant = rendered.unwrap_or(on_cpu);
    let differences: Vec<f64> =
        exact.iter().zip(&variant).map(|(a, b)| delta_e_of_linear(*a, *b, ColourSpace::LinearSrgb)).collect();
    let lit: Vec<f64> =
        (0..exact.len()).filter(|&index| exact[index] != [0.0; 3]).map(|index| differences[index]).collect();
    let max_delta_e = differences.iter().copied().fold(0.0, f64::max);
    let scale_delta_e = round_up(max_delta_e);
    let map: Vec<u8> = differences
        .iter()
        .map(|difference| heat(difference / scale_delta_e))
        .flat_map(|RGBColor(r, g, b)| [r, g, b])
        .collect();
    Ok(Pictures {
        exact: data_uri(&bytes(&exact))?,
        variant: data_uri(&bytes(&variant))?,
        difference: data_uri(&map)?,
        scale: (0..=12)
            .map(|step| heat(f64::from(step) / 12.0))
            .map(|RGBColor(r, g, b)| format!("#{r:02x}{g:02x}{b:02x}"))
            .collect(),
        figures: SphereFigures {
            size: SIZE,
            device: device.as_ref().ok().map(|device| device.description().clone()),
            not_run: device.err(),
            shader_against_cpu,
            mean_delta_e: lit.iter().sum::<f64>() / lit.len().max(1) as f64,
            max_delta_e,
            scale_delta_e,
        },
    })
}

/// What a display can show of linear sRGB.
fn clipped(pixels: &[[f64; 3]]) -> Vec<[f64; 3]> {
    pixels.iter().map(|pixel| pixel.map(|value| if value > 0.0 { value.min(1.0) } else { 0.0 })).collect()
}

/// The next of 1, 2, 3 and 5 times a power of ten, from 0.1 on.
fn round_up(value: f64) -> f64 {
    let mut step = 0.1;
    loop {
        for factor in [1.0, 2.0, 3.0, 5.0] {
            if step * factor >= value || step > 1e3 {
                return step * factor;
            }
        }
        step *= 10.0;
    }
}

fn data_uri(bytes: &[u8]) -> Result<String, Failure> {
    let picture = png(bytes, (SIZE, SIZE));
    let picture = picture.map_err(|error| Failure::check(format!("a picture cannot be encoded: {error}")))?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(picture)))
}

#[cfg(test)]
mod tests {
    use super::round_up;

    #[test]
    fn scales_end_at_round_numbers() {
        for (value, end) in [(0.0, 0.1), (0.11, 0.2), (0.73, 1.0), (3.2, 5.0), (61.0, 100.0), (f64::NAN, 1000.0)] {
            assert!((round_up(value) / end - 1.0).abs() < 1e-9 || value.is_nan(), "{value}: {}", round_up(value));
        }
    }
}
