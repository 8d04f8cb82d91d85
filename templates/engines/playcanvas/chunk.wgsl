{{ header }}
{% if inputs | selectattr("name", "equalto", "film_ior") | list %}
uniform material_iridescenceRefractionIndex: f32;
{% endif %}
{{ functions }}

// Reflectance of the film on its base, linear, with the signature of the engine's own function.
{{ signature }} {
{%- for input in inputs %}
    {{ input.declared }} = {{ input.value }};
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
    return {{ result }};
}
