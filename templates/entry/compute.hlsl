StructuredBuffer<float> inputs : register(t0);
RWStructuredBuffer<float> outputs : register(u1);

// Evaluates one point: {{ stride }} numbers in ({{ columns }}), {{ outputs | length * 3 }} numbers out.
[numthreads({{ workgroup_size }}, 1, 1)]
void main(uint3 invocation : SV_DispatchThreadID) {
    uint index = invocation.x;
    uint count;
    uint stride;
    outputs.GetDimensions(count, stride);
    if (index >= count / {{ outputs | length * 3 }}) {
        return;
    }
{%- for input in inputs %}
{%- if input.vector %}
    float3 {{ input.name }} = float3(inputs[index * {{ stride }} + {{ input.offset }}], inputs[index * {{ stride }} + {{ input.offset + 1 }}], inputs[index * {{ stride }} + {{ input.offset + 2 }}]);
{%- else %}
    float {{ input.name }} = inputs[index * {{ stride }} + {{ input.offset }}];
{%- endif %}
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
{%- for output in outputs %}
    float3 {{ output.name }} = {{ output.value }};
    outputs[index * {{ outputs | length * 3 }} + {{ loop.index0 * 3 }}] = {{ output.name }}.x;
    outputs[index * {{ outputs | length * 3 }} + {{ loop.index0 * 3 + 1 }}] = {{ output.name }}.y;
    outputs[index * {{ outputs | length * 3 }} + {{ loop.index0 * 3 + 2 }}] = {{ output.name }}.z;
{%- endfor %}
}
