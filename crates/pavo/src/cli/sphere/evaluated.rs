//! The sphere on the CPU, by the exact reference or by the variant: what `templates/entry/sphere.wgsl` does around the
//! surface, so that two pictures differ by the film's reflectance alone.

use super::OVERSAMPLING;
use crate::emission::over_sphere;
use crate::inputs::ShadingQuantity;
use crate::media::MediaError;
use crate::shading::Shading;
use glam::DVec3;
use pavo_emit::Sphere;
use pavo_shade::Input;

/// By what the surface is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluation {
    /// The exact spectral reference.
    Reference,
    /// The variant in `f64`.
    Variant,
}

/// The directions to the two punctual lights.
const LIGHTS: [DVec3; 2] = [DVec3::new(-0.452, 0.603, 0.657), DVec3::new(0.762, 0.127, 0.635)];
const VIEW: DVec3 = DVec3::new(0.0, 0.0, 1.0);

/// The radiance of the samples of a square picture, row by row from the top.
///
/// # Errors
/// If an index of a point is no index.
pub fn evaluate(shading: &Shading, by: Evaluation, size: u32) -> Result<Vec<[f64; 3]>, MediaError> {
    let side = (size * OVERSAMPLING) as usize;
    let places: Vec<Place> = (0..side * side).filter_map(|index| Place::of(index, side)).collect();
    let mut colors = vec![DVec3::ZERO; places.len()];
    let mut add = |quantity: ShadingQuantity, lit: &[(usize, Cosines, f64)]| -> Result<(), MediaError> {
        let inputs = shading.inputs(quantity);
        let sphere = over_sphere(&inputs);
        let points: Vec<Vec<f64>> =
            lit.iter().map(|(place, cosines, _)| point(&inputs, &sphere, cosines, places[*place].pattern)).collect();
        let found = match by {
            Evaluation::Reference => shading.reference_each(quantity, &points)?,
            Evaluation::Variant => shading.evaluate_each(quantity, &points),
        };
        for ((place, _, factor), color) in lit.iter().zip(found) {
            colors[*place] += DVec3::from(color) * *factor;
        }
        Ok(())
    };
    let mirrored = |(index, place): (usize, &Place)| {
        let cosine = place.normal.z;
        let direction = 2.0 * cosine * place.normal - VIEW;
        (index, Cosines { cos_theta1: cosine, ..Cosines::default() }, studio(direction))
    };
    add(ShadingQuantity::Reflectance, &places.iter().enumerate().map(mirrored).collect::<Vec<_>>())?;
    if shading.scene().lights.punctual {
        for light in LIGHTS {
            let lit = |(index, place): (usize, &Place)| Some((index, Cosines::under(place.normal, light)?, 1.0));
            add(ShadingQuantity::Radiance, &places.iter().enumerate().filter_map(lit).collect::<Vec<_>>())?;
        }
    }
    let mut samples = vec![[0.0; 3]; side * side];
    for (place, color) in places.iter().zip(colors) {
        samples[place.index] = color.to_array();
    }
    Ok(samples)
}

/// A sample on the sphere.
struct Place {
    index: usize,
    normal: DVec3,
    /// How far along its range stands what varies over the surface.
    pattern: f64,
}

impl Place {
    /// The place of a sample of a square picture, unless it lies beside the sphere.
    fn of(index: usize, side: usize) -> Option<Self> {
        let centre = |place: usize| (place as f64 + 0.5) / side as f64 * 2.0 - 1.0;
        let (x, y) = (centre(index % side), -centre(index / side));
        let radius_squared = (x * x + y * y) * 1.1;
        if radius_squared > 1.0 {
            return None;
        }
        let normal = DVec3::new(x * 1.0488, y * 1.0488, (1.0 - radius_squared).sqrt());
        let swirl = (4.0 * normal.x + 2.0 * (3.0 * normal.y + normal.x).sin()).sin() * 0.05;
        Some(Self { index, normal, pattern: (0.5 - 0.5 * normal.y + swirl).clamp(0.0, 1.0) })
    }
}

/// Cosines between the directions at a place.
#[derive(Clone, Copy, Default)]
struct Cosines {
    n_dot_l: f64,
    n_dot_v: f64,
    n_dot_h: f64,
    cos_theta1: f64,
}

impl Cosines {
    /// The cosines under a light; nothing where light or view are below the horizon.
    fn under(normal: DVec3, light: DVec3) -> Option<Self> {
        let half_vector = (light + VIEW).normalize();
        let cosine = |a: DVec3, b: DVec3| a.dot(b).clamp(0.0, 1.0);
        let cosines = Self {
            n_dot_l: cosine(normal, light),
            n_dot_v: cosine(normal, VIEW),
            n_dot_h: cosine(normal, half_vector),
            cos_theta1: cosine(half_vector, light),
        };
        (cosines.n_dot_l.min(cosines.n_dot_v) >= 1e-6).then_some(cosines)
    }
}

/// The numbers of a point: the cosines, and what the sphere gives to all else.
fn point(inputs: &[Input], sphere: &Sphere, cosines: &Cosines, pattern: f64) -> Vec<f64> {
    let numbers = inputs.iter().zip(&sphere.inputs).flat_map(|(input, over_sphere)| match input.name.as_str() {
        "n_dot_l" => vec![cosines.n_dot_l],
        "n_dot_v" => vec![cosines.n_dot_v],
        "n_dot_h" => vec![cosines.n_dot_h],
        "cos_theta1" => vec![cosines.cos_theta1],
        _ => {
            let ends = over_sphere.low.iter().zip(&over_sphere.high);
            ends.map(|(low, high)| low + (high - low) * pattern).collect()
        }
    });
    numbers.collect()
}

/// The light of the room from a direction.
fn studio(direction: DVec3) -> f64 {
    let ceiling = smoothstep(0.15, 0.95, direction.y) * 1.1;
    let window = smoothstep(0.55, 0.75, direction.dot(DVec3::new(-0.696, 0.298, 0.653))) * 1.6;
    let floor = (1.0 - smoothstep(-1.0, 0.0, direction.y)) * 0.12;
    0.06 + ceiling + window + floor
}

fn smoothstep(low: f64, high: f64, value: f64) -> f64 {
    let part = ((value - low) / (high - low)).clamp(0.0, 1.0);
    part * part * (3.0 - 2.0 * part)
}
