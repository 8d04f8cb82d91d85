layout(local_size_x = {{ workgroup_size }}) in;
layout(std430, set = 0, binding = 0) readonly buffer Inputs {
    float inputs[];
};
layout(std430, set = 0, binding = 1) buffer Outputs {
    float outputs[];
};

// Evaluates one point: {{ stride }} numbers in ({{ columns }}), {{ outputs | length * 3 }} numbers out.
void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= uint(outputs.length()) / {{ outputs | length * 3 }}u) {
        return;
    }
{%- for input in inputs %}
{%- if input.vector %}
    vec3 {{ input.name }} = vec3(inputs[point * {{ stride }}u + {{ input.offset }}u], inputs[point * {{ stride }}u + {{ input.offset + 1 }}u], inputs[point * {{ stride }}u + {{ input.offset + 2 }}u]);
{%- else %}
    float {{ input.name }} = inputs[point * {{ stride }}u + {{ input.offset }}u];
{%- endif %}
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
{%- for output in outputs %}
    vec3 {{ output.name }} = {{ output.value }};
    outputs[point * {{ outputs | length * 3 }}u + {{ loop.index0 * 3 }}u] = {{ output.name }}.x;
    outputs[point * {{ outputs | length * 3 }}u + {{ loop.index0 * 3 + 1 }}u] = {{ output.name }}.y;
    outputs[point * {{ outputs | length * 3 }}u + {{ loop.index0 * 3 + 2 }}u] = {{ output.name }}.z;
{%- endfor %}
}
