{{ header }}

{{ functions }}

// Reflectance of the film on its base, linear.
{{ signature }} {
{{ body }}
    Reflectance = {{ result }};
}
