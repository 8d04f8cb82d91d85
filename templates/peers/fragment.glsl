#version 450

{{ text }}

{% for location in range(locations) -%}
layout(location = {{ location }}) in vec4 varying_{{ location }};
{% endfor -%}
layout(location = 0) out vec4 fragment_color;

// Evaluates one point, from interpolated inputs and nothing else.
void main() {
{%- for input in inputs %}
    {{ "vec3" if input.vector else "float" }} {{ input.name }} = {{ input.value }};
{%- endfor %}
    fragment_color = vec4({{ expression }}, 1.0);
}
