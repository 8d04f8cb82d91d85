//! From the radiance of the samples to what a display shows.

use pavo_spectra::ColourSpace;
use pavo_spectra::colour_space::srgb_encode;

/// How radiance is shown: its exposure, and the way from its colour space to sRGB.
pub struct Display {
    exposure: f64,
    to_srgb: [[f64; 3]; 3],
}

impl Display {
    /// The exposure that suits these samples of a colour space.
    pub fn of(samples: &[[f64; 3]], space: ColourSpace) -> Self {
        Self { exposure: exposure(samples), to_srgb: matrix_to_srgb(space) }
    }

    /// The pixels of a square picture as linear sRGB: the mean of the tone-mapped samples of each, `oversampling` a side,
    /// not yet clipped.
    pub fn pixels(&self, samples: &[[f64; 3]], size: u32, oversampling: u32) -> Vec<[f64; 3]> {
        let (size, oversampling) = (size as usize, oversampling as usize);
        let pixel = |index: usize| {
            let (row, column) = (index / size, index % size);
            let mut sum = [0.0_f64; 3];
            for sample in 0..oversampling * oversampling {
                let y = row * oversampling + sample / oversampling;
                let x = column * oversampling + sample % oversampling;
                let color = samples[y * size * oversampling + x];
                let linear =
                    self.to_srgb.map(|row| row.iter().zip(color).map(|(factor, value)| factor * value).sum::<f64>());
                let shown = tone_mapped(linear.map(|value| value * self.exposure));
                sum = std::array::from_fn(|channel| sum[channel] + shown[channel]);
            }
            sum.map(|value| value / (oversampling * oversampling) as f64)
        };
        (0..size * size).map(pixel).collect()
    }
}

/// Pixels of linear sRGB as bytes.
pub fn bytes(pixels: &[[f64; 3]]) -> Vec<u8> {
    pixels.iter().flatten().map(|value| (srgb_encode(*value) * 255.0).round() as u8).collect()
}

/// What brings the brighter parts of the picture to one level, whether a surface mirrors 4 % or all of the light: a
/// factor that puts the ninetieth percentile of the sphere at 0.8.
fn exposure(samples: &[[f64; 3]]) -> f64 {
    let brightness = samples.iter().map(|color| color.iter().copied().fold(0.0, f64::max));
    let mut lit: Vec<f64> = brightness.filter(|value| value.is_finite() && *value > 0.0).collect();
    lit.sort_by(f64::total_cmp);
    lit.get(lit.len() * 9 / 10).map_or(1.0, |level| 0.8 / level)
}

/// Highlights are compressed by the brightest channel, so that hues stay.
///
/// Source: Reinhard et al. 2002, equation 4, with white at 4.
fn tone_mapped(linear: [f64; 3]) -> [f64; 3] {
    const WHITE: f64 = 4.0;
    let brightest = linear.iter().copied().fold(0.0, f64::max);
    let scale = (1.0 + brightest / (WHITE * WHITE)) / (1.0 + brightest) * 1.3;
    linear.map(|value| value * scale)
}

fn matrix_to_srgb(space: ColourSpace) -> [[f64; 3]; 3] {
    let (from, to) = (space.rgb_to_xyz(), ColourSpace::LinearSrgb.xyz_to_rgb());
    std::array::from_fn(|row| std::array::from_fn(|column| (0..3).map(|k| to[row][k] * from[k][column]).sum()))
}
