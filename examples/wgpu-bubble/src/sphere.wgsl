// The bubble: a sphere that fills the target. What stands above comes from pavo.
@group(0) @binding(0) var<uniform> surface: SurfaceUniforms;

const LIGHT_DIRECTION = vec3f(-0.48, 0.6, 0.64);
const VIEW_DIRECTION = vec3f(0.0, 0.0, 1.0);

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    // One triangle over the whole target.
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    return vec4f(corner * 4.0 - 1.0, 0.0, 1.0);
}

// The radiance towards the viewer at a position from -1 to 1, y upwards; linear sRGB.
fn bubble(position: vec2f) -> vec3f {
    let radius_squared = dot(position, position) * 1.1;
    if (radius_squared >= 1.0) {
        return vec3f(0.0);
    }
    let normal = vec3f(position * sqrt(1.1), sqrt(1.0 - radius_squared));
    // The film is thin at the top and thick at the bottom.
    let thickness_nm = (0.5 - 0.5 * normal.y) * 900.0 + 60.0 * (normal.x * normal.x);
    let lit = shade_surface(
        normal,
        LIGHT_DIRECTION,
        VIEW_DIRECTION,
        thickness_nm,
        surface.roughness,
        surface.light_color,
        surface.light_intensity,
    );
    // A bright sky above, a dim floor below.
    let mirrored_y = 2.0 * normal.z * normal.y;
    let sky = 1.6 + 1.2 * mirrored_y;
    return lit + surface_reflectance(normal.z, thickness_nm) * sky;
}

@fragment
fn fragment(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let position = vec2f(pixel.x - HALF_SIZE, HALF_SIZE - pixel.y) / HALF_SIZE;
    return vec4f(bubble(position), 1.0);
}
