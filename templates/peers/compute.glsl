#version 450

{{ text }}

layout(local_size_x = {{ workgroup_size }}) in;
layout(std430, set = 0, binding = 0) readonly buffer Inputs {
    float inputs[];
};
layout(std430, set = 0, binding = 1) buffer Outputs {
    float outputs[];
};

// Evaluates one point: {{ stride }} numbers in, 3 numbers out.
void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= uint(outputs.length()) / 3u) {
        return;
    }
{%- for input in inputs %}
{%- if input.vector %}
    vec3 {{ input.name }} = vec3(inputs[point * {{ stride }}u + {{ input.offset }}u], inputs[point * {{ stride }}u + {{ input.offset + 1 }}u], inputs[point * {{ stride }}u + {{ input.offset + 2 }}u]);
{%- else %}
    float {{ input.name }} = inputs[point * {{ stride }}u + {{ input.offset }}u];
{%- endif %}
{%- endfor %}
    vec3 reflectance = {{ expression }};
    outputs[point * 3u] = reflectance.x;
    outputs[point * 3u + 1u] = reflectance.y;
    outputs[point * 3u + 2u] = reflectance.z;
}
