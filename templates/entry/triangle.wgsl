// One triangle over the whole target; the position runs from -1 to 1 from corner to corner, y upwards.
struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) position: vec2f,
}

@vertex
fn main(@builtin(vertex_index) index: u32) -> Corner {
    let position = vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - vec2f(1.0);
    return Corner(vec4f(position, 0.0, 1.0), position);
}
