//! The sphere on the CPU, by the exact reference or by the variant: what `templates/entry/sphere.wgsl` does around the
//! surface, so that two pictures differ by the film's reflectance alone.

use crate::entries::over_sphere;
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

/// In how many steps the reflectance under a light is evaluated over the pattern.
const STEPS: usize = 1024;

/// The radiance of the samples of a square picture, row by row from the top.
///
/// # Errors
/// If an index of a point is no index.
pub fn evaluate(shading: &Shading, by: Evaluation, side: u32) -> Result<Vec<[f64; 3]>, MediaError> {
    let side = side as usize;
    let places: Vec<Place> = (0..side * side).filter_map(|index| Place::of(index, side)).collect();
    let reflectances = |cosines: &[(f64, f64)]| {
        let quantity = ShadingQuantity::Reflectance;
        let inputs = shading.inputs(quantity);
        let sphere = over_sphere(&inputs);
        let at = |&(cos_theta1, pattern): &(f64, f64)| {
            point(&inputs, &sphere, &Cosines { cos_theta1, ..Cosines::default() }, pattern)
        };
        let points: Vec<Vec<f64>> = cosines.iter().map(at).collect();
        match by {
            Evaluation::Reference => shading.reference_each(quantity, &points),
            Evaluation::Variant => Ok(shading.evaluate_each(quantity, &points)),
        }
    };
    let mirrored = reflectances(&places.iter().map(|place| (place.normal.z, place.pattern)).collect::<Vec<_>>())?;
    let mut samples = vec![DVec3::ZERO; side * side];
    for (place, reflectance) in places.iter().zip(mirrored) {
        let direction = 2.0 * place.normal.z * place.normal - VIEW;
        samples[place.index] = DVec3::from(reflectance) * studio(direction);
    }
    if shading.scene().lights.punctual {
        let quantity = ShadingQuantity::Radiance;
        let inputs = shading.inputs(quantity);
        let sphere = over_sphere(&inputs);
        for light in LIGHTS {
            // Light and view are far away: the angle at the half vector is the same all over the sphere.
            let cos_theta1 = light.dot((light + VIEW).normalize());
            let steps: Vec<(f64, f64)> = (0..=STEPS).map(|step| (cos_theta1, step as f64 / STEPS as f64)).collect();
            let steps = reflectances(&steps)?;
            let lit: Vec<(&Place, Cosines)> =
                places.iter().filter_map(|place| Some((place, Cosines::under(place.normal, light)?))).collect();
            let points: Vec<Vec<f64>> =
                lit.iter().map(|(place, cosines)| point(&inputs, &sphere, cosines, place.pattern)).collect();
            let under_light: Vec<[f64; 3]> = lit.iter().map(|(place, _)| interpolate(&steps, place.pattern)).collect();
            for ((place, _), color) in lit.iter().zip(shading.of_reflectance_each(quantity, &points, &under_light)) {
                samples[place.index] += DVec3::from(color);
            }
        }
    }
    Ok(samples.into_iter().map(|color| color.to_array()).collect())
}

/// A value between equally spaced ones over 0 to 1, by the cubic through the four nearest.
fn interpolate(values: &[[f64; 3]], part: f64) -> [f64; 3] {
    let place = part * (values.len() - 1) as f64;
    let first = (place.floor() as usize).saturating_sub(1).min(values.len() - 4);
    let t = place - first as f64;
    let weights = [
        -(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0,
        t * (t - 2.0) * (t - 3.0) / 2.0,
        -t * (t - 1.0) * (t - 3.0) / 2.0,
        t * (t - 1.0) * (t - 2.0) / 6.0,
    ];
    std::array::from_fn(|channel| {
        weights.iter().zip(&values[first..]).map(|(weight, value)| weight * value[channel]).sum()
    })
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

#[cfg(test)]
mod tests {
    use super::{STEPS, interpolate};

    #[test]
    fn interpolation_loses_nothing_that_can_be_seen() {
        // A film whose path is 20 wavelengths longer at the thick end.
        let wave = |part: f64| [(40.0 * std::f64::consts::PI * part).cos(); 3];
        let values: Vec<[f64; 3]> = (0..=STEPS).map(|step| wave(step as f64 / STEPS as f64)).collect();
        for index in 0..=1000 {
            let part = f64::from(index) / 1000.0;
            let [found, ..] = interpolate(&values, part);
            assert!((found - wave(part)[0]).abs() < 3e-5, "{part}: {found}");
        }
    }
}
