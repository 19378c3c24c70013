// Copies the kept picture into the window, pixel by pixel.

@group(0) @binding(0) var picture: texture_2d<f32>;

@vertex
fn vs_whole(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(f32(i32(i & 1u) * 4 - 1), f32(i32(i >> 1u) * 4 - 1), 0.0, 1.0);
}

@fragment
fn fs_copy(@builtin(position) place: vec4<f32>) -> @location(0) vec4<f32> {
    return textureLoad(picture, vec2<i32>(place.xy), 0);
}
