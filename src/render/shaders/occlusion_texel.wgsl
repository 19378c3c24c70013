// One texel of occlusion: the distance from the eye plane, whose lowest eight bits give way to openness (0 to 255).
// The distance keeps 15 bits after the point: 400 mm to 12 µm.

// Distances beyond this stand for nothing.
const FAR: f32 = 1e29;
const OPEN_AND_FAR: u32 = 0x7149f2ffu;

fn distance_of(texel: u32) -> f32 {
    return bitcast<f32>(texel);
}

fn openness_of(texel: u32) -> f32 {
    return f32(texel & 0xffu) / 255.0;
}

fn occlusion_texel(open: f32, distance: f32) -> u32 {
    return (bitcast<u32>(distance) & 0xffffff00u) | u32(round(clamp(open, 0.0, 1.0) * 255.0));
}
