uniform highp sampler2D inputs;
layout(location = 0) out vec4 {{ target }};

// Evaluates one point, the one of this pixel: {{ texels }} texels of inputs ({{ columns }}), a colour out.
void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
{%- for location in locations %}
    vec4 {{ location }} = texelFetch(inputs, ivec2(place.x * {{ texels }} + {{ loop.index0 }}, place.y), 0);
{%- endfor %}
{%- for input in inputs %}
    {{ input.ty }} {{ input.name }} = {{ input.value }};
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
    {{ target }} = vec4({{ color }}, 1.0);
}
