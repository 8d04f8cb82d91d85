{{ header }}
{% if "film_ior" in inputs %}
uniform material_iridescenceRefractionIndex: f32;
{% endif %}
{{ functions }}

// Reflectance of the film on its base, linear, with the signature of the engine's own function.
{{ signature }} {
{{ body }}
    return {{ result }};
}
