//! Lambert's diffuse reflection and Phong's highlight, in the DSL: generic over what a number is.

use pavo_shade::{Graph, Input, Program, Rate, Real, Scalar, Vector, shade};

/// Lambert's diffuse reflection under Phong's highlight, by colour channel.
///
/// Source: Phong 1975, with the highlight left unnormalised as in the paper.
#[shade]
pub fn lambert_phong<S: Scalar>(
    /// Cosine of the angle between normal and light, [0, 1].
    n_dot_l: S,
    /// Cosine of the angle between mirror direction and view, [-1, 1].
    r_dot_v: S,
    /// Diffuse colour, linear, [0, 1].
    diffuse_color: S::Vec3,
) -> S::Vec3 {
    let highlight = specular_highlight(r_dot_v, 0.04);
    let diffuse = diffuse_color * (1.0 / core::f64::consts::PI);
    (diffuse + S::Vec3::splat(highlight)) * n_dot_l
}

/// Phong's highlight with exponent 16.
#[shade]
pub fn specular_highlight<R: Real>(
    /// Cosine of the angle between mirror direction and view, [-1, 1].
    r_dot_v: R,
    /// Strength of the highlight, [0, 1].
    strength: R,
) -> R {
    strength * r_dot_v.max(0.0).powi(16)
}

/// The graph of the BRDF, with its inputs by name, range and rate.
pub fn program() -> Program {
    let graph = Graph::new();
    let n_dot_l = graph.input(Input::scalar("n_dot_l", "", 0.0, 1.0, Rate::Pixel));
    let r_dot_v = graph.input(Input::scalar("r_dot_v", "", -1.0, 1.0, Rate::Pixel));
    let diffuse_color = graph.input(Input::colour("diffuse_color", Rate::Material));
    graph.output("radiance", lambert_phong(n_dot_l, r_dot_v, diffuse_color));
    graph.program()
}
