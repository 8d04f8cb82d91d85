{{ header }}

#ifndef PAVO_THIN_FILM
#define PAVO_THIN_FILM

{{ functions }}

// Reflectance of the film on its base, linear.
{{ signature }} {
{%- for input in inputs %}
    {{ input.declared }} = {{ input.value }};
{%- endfor %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
    Reflectance = {{ result }};
}

#endif
