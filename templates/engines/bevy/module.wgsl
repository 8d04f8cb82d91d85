#define_import_path pavo::thin_film

{{ header }}

{{ functions }}

// Reflectance of the film on its base, linear.
{{ signature }} {
{{ body }}
    return {{ result }};
}
