{{ header }}
{% if "film_ior" in inputs %}
uniform float material_iridescenceRefractionIndex;
{% endif %}
{{ functions }}

// Reflectance of the film on its base, linear, with the signature of the engine's own function.
{{ signature }} {
{{ body }}
    return {{ result }};
}
