{% for location in locations -%}
layout(location = {{ loop.index0 }}) in vec4 {{ location }};
{% endfor -%}
layout(location = 0) out vec4 {{ target }};

// {{ comment }}
void main() {
{%- for input in inputs %}
    {{ input.ty }} {{ input.name }} = {{ input.value }};
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
    {{ target }} = vec4({{ color }}, 1.0);
}
