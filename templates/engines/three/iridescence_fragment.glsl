{{ header }}

#ifdef USE_IRIDESCENCE

{{ functions }}

// Reflectance of the film on its base, linear. Takes the place of three.js's function of this name.
{{ signature }} {
{{ body }}
    return {{ result }};
}

#endif
