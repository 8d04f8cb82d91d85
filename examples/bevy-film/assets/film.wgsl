// A Bevy material whose colour is that of a thin film under a bright sky. Its functions come from pavo.
#import bevy_pbr::forward_io::VertexOutput
#import bevy_pbr::mesh_view_bindings::view
#import pavo::thin_film::surface_reflectance

// The thinnest and the thickest film, in nanometres; the rest is unused.
@group(#{MATERIAL_BIND_GROUP}) @binding(0) var<uniform> thickness_range_nm: vec4f;

@fragment
fn fragment(mesh: VertexOutput) -> @location(0) vec4f {
    let normal = normalize(mesh.world_normal);
    let view_direction = normalize(view.world_position - mesh.world_position.xyz);
    let n_dot_v = clamp(dot(normal, view_direction), 0.0, 1.0);
    let thickness_nm = mix(thickness_range_nm.x, thickness_range_nm.y, 0.5 - 0.5 * normal.y);
    let sky = 1.6 + 1.2 * reflect(-view_direction, normal).y;
    return vec4f(surface_reflectance(n_dot_v, thickness_nm) * sky, 1.0);
}
