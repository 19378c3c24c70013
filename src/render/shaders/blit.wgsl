// Lays a finished picture over its background into the window's pass.

struct Blit {
    // sRGB with opacity.
    background: vec4<f32>,
    // x: 1 if the window's format encodes sRGB itself.
    options: vec4<f32>,
}

@group(0) @binding(0) var<uniform> blit: Blit;
@group(0) @binding(1) var picture: texture_2d<f32>;
@group(0) @binding(2) var nearest: sampler;

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) uv: vec2<f32>,
}

@vertex
fn vs_whole(@builtin(vertex_index) i: u32) -> Varying {
    let uv = vec2<f32>(f32(i32(i & 1u) * 2), f32(i32(i >> 1u) * 2));
    return Varying(vec4<f32>(uv.x * 2.0 - 1.0, 1.0 - uv.y * 2.0, 0.0, 1.0), uv);
}

fn light_of(srgb: vec3<f32>) -> vec3<f32> {
    let high = pow((srgb + 0.055) / 1.055, vec3<f32>(2.4));
    return select(high, srgb / 12.92, srgb <= vec3<f32>(0.04045));
}

@fragment
fn fs_over(in: Varying) -> @location(0) vec4<f32> {
    let front = textureSample(picture, nearest, in.uv);
    let back = vec4<f32>(blit.background.rgb, 1.0) * blit.background.a;
    let over = front + back * (1.0 - front.a);
    let plain = over.rgb / max(over.a, 1e-6);
    let decoded = vec4<f32>(light_of(plain) * over.a, over.a);
    return select(decoded, over, blit.options.x < 0.5);
}
