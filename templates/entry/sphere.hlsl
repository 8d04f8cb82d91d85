{%- set radiance = outputs | selectattr("name", "equalto", "radiance") | list %}
{%- set mirrored = outputs | selectattr("name", "equalto", "mirrored") | first -%}
// A room to look at the surface in: a soft box above, one to the side, and a dim floor.
float3 studio(float3 direction) {
    float ceiling = smoothstep(0.15, 0.95, direction.y) * 1.1;
    float window = smoothstep(0.55, 0.75, dot(direction, float3(-0.696, 0.298, 0.653))) * 1.6;
    float floor_light = (1.0 - smoothstep(-1.0, 0.0, direction.y)) * 0.12;
    return (float3)(0.06 + ceiling + window + floor_light);
}

// Shades a sphere that fills the target; the position runs from -1 to 1, y upwards. Linear colour.
float4 main(float2 position : TEXCOORD0) : SV_Target0 {
    float radius_squared = dot(position, position) * 1.1;
    if (radius_squared > 1.0) {
        return float4(0.0, 0.0, 0.0, 1.0);
    }
    float3 normal = float3(position * 1.0488, sqrt(1.0 - radius_squared));
    float3 view_direction = float3(0.0, 0.0, 1.0);
    float n_dot_v = normal.z;
    // What varies over the surface: 0 at the top to 1 at the bottom, with a swirl.
    float swirl = sin(4.0 * normal.x + 2.0 * sin(3.0 * normal.y + normal.x)) * 0.05;
    float pattern = clamp(0.5 - 0.5 * normal.y + swirl, 0.0, 1.0);
{%- for input in inputs if not input.geometry %}
    {{ input.ty }} {{ input.name }} = {{ input.value }};
{%- endfor %}

    float3 color = {{ mirrored.value }} * studio(reflect(-view_direction, normal));
{%- for output in radiance %}
    for (int light = 0; light < 2; light++) {
        float3 light_direction = light == 0 ? float3(-0.452, 0.603, 0.657) : float3(0.762, 0.127, 0.635);
        color += {{ output.value }};
    }
{%- endfor %}
    return float4(color, 1.0);
}
