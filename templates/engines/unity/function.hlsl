{{ header }}

#ifndef PAVO_THIN_FILM
#define PAVO_THIN_FILM

{{ functions }}

// Reflectance of the film on its base, linear.
{{ signature }} {
{{ body }}
    Reflectance = {{ result }};
}

#endif
