{{ header }}

#ifdef USE_IRIDESCENCE

{{ functions }}

// Reflectance of the film on its base, linear. Takes the place of three.js's function of this name.
{{ signature }} {
{%- for input in inputs %}
    {{ input.declared }} = {{ input.value }};
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
    return {{ result }};
}

#endif
