{%- set radiance = outputs | selectattr("name", "equalto", "radiance") | list %}
{%- set mirrored = outputs | selectattr("name", "equalto", "mirrored") | first -%}
// A room to look at the surface in: a soft box above, one to the side, and a dim floor.
fn studio(direction: vec3f) -> vec3f {
    let ceiling = smoothstep(0.15, 0.95, direction.y) * 1.1;
    let window = smoothstep(0.55, 0.75, dot(direction, vec3f(-0.696, 0.298, 0.653))) * 1.6;
    let floor_light = (1.0 - smoothstep(-1.0, 0.0, direction.y)) * 0.12;
    return vec3f(0.06 + ceiling + window + floor_light);
}

// Shades a sphere that fills the target; the position runs from -1 to 1, y upwards. Linear colour.
@fragment
fn main(@location(0) position: vec2f) -> @location(0) vec4f {
    let radius_squared = dot(position, position) * 1.1;
    if (radius_squared > 1.0) {
        return vec4f(0.0, 0.0, 0.0, 1.0);
    }
    let normal = vec3f(position * 1.0488, sqrt(1.0 - radius_squared));
    let view_direction = vec3f(0.0, 0.0, 1.0);
    let n_dot_v = normal.z;
    // What varies over the surface: 0 at the top to 1 at the bottom, with a swirl.
    let swirl = sin(4.0 * normal.x + 2.0 * sin(3.0 * normal.y + normal.x)) * 0.05;
    let pattern = clamp(0.5 - 0.5 * normal.y + swirl, 0.0, 1.0);
{%- for input in inputs if not input.geometry %}
    let {{ input.name }} = {{ input.value }};
{%- endfor %}

    var color = {{ mirrored.value }} * studio(reflect(-view_direction, normal));
{%- for output in radiance %}
    var lights = array<vec3f, 2>(vec3f(-0.452, 0.603, 0.657), vec3f(0.762, 0.127, 0.635));
    for (var light = 0; light < 2; light++) {
        let light_direction = lights[light];
        color += {{ output.value }};
    }
{%- endfor %}
    return vec4f(color, 1.0);
}
