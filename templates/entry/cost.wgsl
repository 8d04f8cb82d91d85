// {{ comment }}
@fragment
fn main(
{%- for location in locations %}
    @location({{ loop.index0 }}) {{ location }}: vec4f,
{%- endfor %}
) -> @location(0) vec4f {
{%- for input in inputs %}
    let {{ input.name }} = {{ input.value }};
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
    return vec4f({{ color }}, 1.0);
}
