//! The same bubble on the CPU, by the Rust functions of the same variant.

use crate::bubble::{SurfaceUniforms, shade_surface, surface_reflectance};
use glam::{Vec2, Vec3};

const LIGHT_DIRECTION: Vec3 = Vec3::new(-0.48, 0.6, 0.64);

/// The radiance towards the viewer at a position from -1 to 1, y upwards; linear sRGB.
pub fn bubble(position: Vec2, surface: &SurfaceUniforms) -> Vec3 {
    let radius_squared = position.dot(position) * 1.1;
    if radius_squared >= 1.0 {
        return Vec3::ZERO;
    }
    let normal = (position * 1.1_f32.sqrt()).extend((1.0 - radius_squared).sqrt());
    let thickness_nm = (0.5 - 0.5 * normal.y) * 900.0 + 60.0 * (normal.x * normal.x);
    let lit = shade_surface(
        normal,
        LIGHT_DIRECTION,
        Vec3::Z,
        thickness_nm,
        surface.roughness,
        surface.light_color.into(),
        surface.light_intensity,
    );
    let mirrored_y = 2.0 * normal.z * normal.y;
    let sky = 1.6 + 1.2 * mirrored_y;
    lit + surface_reflectance(normal.z, thickness_nm) * sky
}
