#import pavo::thin_film::thin_film_reflectance

// Six numbers for each point: cosine, thickness, index of the film, colour of the base.
@group(0) @binding(0) var<storage, read> given: array<f32>;
@group(0) @binding(1) var<storage, read_write> results: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let first = 6u * id.x;
    if first >= arrayLength(&given) {
        return;
    }
    let color = vec3f(given[first + 3u], given[first + 4u], given[first + 5u]);
    let reflectance =
        thin_film_reflectance(given[first], given[first + 1u], given[first + 2u], 1.0, 1.0, 0.0, color, 1.0);
    results[3u * id.x] = reflectance.x;
    results[3u * id.x + 1u] = reflectance.y;
    results[3u * id.x + 2u] = reflectance.z;
}
