//! The white furnace: what a surface returns under light of 1 from all directions.

use super::checks::{Largest, OverWhite};
use crate::inputs::ShadingQuantity;
use crate::shading::Shading;
use pavo_shade::Input;
use std::f64::consts::{PI, TAU};

const QUANTITY: ShadingQuantity = ShadingQuantity::Brdf;
/// Samples along each of the two dimensions, for each of the two ways of sampling.
const SAMPLES: usize = 24;
const ROUGHNESSES: [f64; 3] = [0.2, 0.5, 1.0];
const COSINES: [f64; 4] = [0.05, 0.3, 0.7, 1.0];

/// How much more than it gets a surface returns at worst, with the settings: a point of the BRDF without its directions.
pub(super) fn furnace(shading: &Shading, white: OverWhite) -> (Largest, Vec<Vec<f32>>) {
    let inputs = shading.inputs(QUANTITY);
    let mut settings = Vec::new();
    for metalness in [0.0, 1.0] {
        for thickness_nm in [0.0, 250.0] {
            for roughness in ROUGHNESSES {
                for n_dot_v in COSINES {
                    settings.push(point(&inputs, &[n_dot_v, thickness_nm, roughness, metalness]));
                }
            }
        }
    }
    settings.dedup();
    let excess = settings.iter().enumerate().map(|(index, point)| {
        let returned = white.xyz(returned(shading, &inputs, point));
        (index, returned.into_iter().map(|value| value - 1.0).fold(0.0, f64::max))
    });
    let largest = Largest::of(excess);
    let single = |point: &Vec<f64>| point.iter().map(|&value| value as f32).collect();
    (largest, settings.iter().map(single).collect())
}

/// A point of the BRDF over a base that reflects all it can.
fn point(inputs: &[Input], [n_dot_v, thickness_nm, roughness, metalness]: &[f64; 4]) -> Vec<f64> {
    let value = |input: &Input| {
        let wanted = match input.name.as_str() {
            "n_dot_l" | "n_dot_v" => *n_dot_v,
            "n_dot_h" | "cos_theta1" | "base_color" | "ambient_ior" => 1.0,
            "thickness_nm" => *thickness_nm,
            "film_ior" => 1.5,
            "base_ior" => 1.3,
            "base_kappa" => 3.0,
            "roughness" => *roughness,
            "metalness" => *metalness,
            _ => f64::midpoint(input.low, input.high),
        };
        wanted.clamp(input.low, input.high)
    };
    inputs.iter().flat_map(|input| std::iter::repeat_n(value(input), input.components())).collect()
}

/// The integral of the BRDF times the cosine over the hemisphere. Half of the samples follow the distribution of the
/// normals, half the cosine; each is weighed by the mean of both densities.
fn returned(shading: &Shading, inputs: &[Input], setting: &[f64]) -> [f64; 3] {
    let column = |name: &str| {
        let before = inputs.iter().take_while(|input| input.name != name);
        before.map(Input::components).sum::<usize>()
    };
    let [light, view, half, incidence] = ["n_dot_l", "n_dot_v", "n_dot_h", "cos_theta1"].map(column);
    let roughness = inputs.iter().position(|input| input.name == "roughness").map(|_| setting[column("roughness")]);
    let roughness = roughness.unwrap_or(shading.scene().surface.roughness.low());
    let alpha_squared = roughness.powi(4);
    let cosine_v = setting[view];
    let v = [(1.0 - cosine_v * cosine_v).max(0.0).sqrt(), 0.0, cosine_v];
    let mut sum = [0.0; 3];
    let mut add = |l: [f64; 3]| {
        let h = unit([l[0] + v[0], l[1] + v[1], l[2] + v[2]]);
        let v_dot_h = dot(v, h);
        if l[2] <= 0.0 || v_dot_h <= 0.0 {
            return;
        }
        let spread = 1.0 - h[2] * h[2] * (1.0 - alpha_squared);
        let density_of_normals = alpha_squared / (PI * spread * spread) * h[2] / (4.0 * v_dot_h);
        let density = 0.5 * (density_of_normals + l[2] / PI);
        let mut point = setting.to_vec();
        (point[light], point[half], point[incidence]) = (l[2], h[2].min(1.0), v_dot_h.min(1.0));
        let brdf = shading.evaluate(QUANTITY, &point);
        for channel in 0..3 {
            sum[channel] += brdf[channel] * l[2] / density / (2 * SAMPLES * SAMPLES) as f64;
        }
    };
    for row in 0..SAMPLES {
        for column in 0..SAMPLES {
            let [x, y] = [row, column].map(|index| (index as f64 + 0.5) / SAMPLES as f64);
            let cosine = ((1.0 - x) / (1.0 + (alpha_squared - 1.0) * x)).sqrt();
            let h = direction(cosine, TAU * y);
            let v_dot_h = dot(v, h);
            add([0, 1, 2].map(|axis| 2.0 * v_dot_h * h[axis] - v[axis]));
            add(direction((1.0 - x).sqrt(), TAU * y));
        }
    }
    sum
}

fn direction(cosine: f64, azimuth: f64) -> [f64; 3] {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    [sine * azimuth.cos(), sine * azimuth.sin(), cosine]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt().max(1e-30);
    a.map(|component| component / length)
}
