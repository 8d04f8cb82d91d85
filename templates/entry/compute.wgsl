@group(0) @binding(0) var<storage, read> inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;

// Evaluates one point: {{ stride }} numbers in ({{ columns }}), {{ outputs | length * 3 }} numbers out.
@compute @workgroup_size({{ workgroup_size }})
fn main(@builtin(global_invocation_id) id: vec3u) {
    let point = id.x;
    if (point >= arrayLength(&outputs) / {{ outputs | length * 3 }}u) {
        return;
    }
{%- for input in inputs %}
{%- if input.vector %}
    let {{ input.name }} = vec3f(inputs[point * {{ stride }}u + {{ input.offset }}u], inputs[point * {{ stride }}u + {{ input.offset + 1 }}u], inputs[point * {{ stride }}u + {{ input.offset + 2 }}u]);
{%- else %}
    let {{ input.name }} = inputs[point * {{ stride }}u + {{ input.offset }}u];
{%- endif %}
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
{%- for output in outputs %}
    let {{ output.name }} = {{ output.value }};
    outputs[point * {{ outputs | length * 3 }}u + {{ loop.index0 * 3 }}u] = {{ output.name }}.x;
    outputs[point * {{ outputs | length * 3 }}u + {{ loop.index0 * 3 + 1 }}u] = {{ output.name }}.y;
    outputs[point * {{ outputs | length * 3 }}u + {{ loop.index0 * 3 + 2 }}u] = {{ output.name }}.z;
{%- endfor %}
}
