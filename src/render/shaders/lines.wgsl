// Lines with a width in pixels: each segment becomes a quad with round ends.

struct Lines {
    // rgb: sRGB; a: opacity.
    colour: vec4<f32>,
    // x: width in logical pixels; y: triangles in a round end, 0 for none.
    options: vec4<f32>,
}

@group(1) @binding(0) var<uniform> lines: Lines;

struct Varying {
    @invariant @builtin(position) clip: vec4<f32>,
    // From the middle line, -1 to 1.
    @location(0) across: f32,
}

@vertex
fn vs_segment(@builtin(vertex_index) i: u32, @location(0) from_point: vec3<f32>, @location(1) to_point: vec3<f32>) -> Varying {
    let whole_a = in_camera(from_point);
    let whole_b = in_camera(to_point);
    let a = before_eye(whole_b, whole_a);
    let b = before_eye(whole_a, whole_b);
    let along = on_screen(b) - on_screen(a);
    let dir = select(vec2<f32>(1.0, 0.0), along / max(length(along), 1e-9), length(along) > 1e-6);
    let side = vec2<f32>(-dir.y, dir.x);
    let radius = 0.5 * lines.options.x * view.options.x;
    var at_end: bool;
    var offset: vec2<f32>;
    if i < 6u {
        // Two triangles: corners 0 1 2, 2 1 3.
        var corners = array<u32, 6>(0u, 1u, 2u, 2u, 1u, 3u);
        let corner = corners[i];
        at_end = corner >= 2u;
        offset = side * select(-1.0, 1.0, (corner & 1u) == 1u);
    } else {
        let fan = i - 6u;
        let triangles = u32(lines.options.y);
        let t = fan / 3u;
        at_end = t >= triangles;
        let step = f32(t % triangles) + f32(fan % 3u == 2u);
        let angle = 3.14159265 * step / f32(triangles);
        let outwards = select(-1.0, 1.0, at_end);
        offset = (side * cos(angle) + dir * sin(angle) * outwards) * select(1.0, 0.0, fan % 3u == 0u);
    }
    let middle = select(a, b, at_end);
    let length_here = pixel_length(eye_distance(middle)) * radius;
    var out: Varying;
    let lifted = nearer(middle, length_here);
    let clip = clip_of(lifted);
    let shift = offset * radius * 2.0 / view.size.xy * view.crop.xy;
    out.clip = vec4<f32>(clip.xy + shift * clip.w, clip.zw);
    out.across = dot(offset, side);
    return out;
}

@fragment
fn fs_first(in: Varying) -> @builtin(sample_mask) u32 {
    return samples_before(in.clip);
}

@fragment
fn fs_peel(in: Varying) -> @builtin(sample_mask) u32 {
    return samples_left(in.clip);
}

@fragment
fn fs_colour(in: Varying) -> @location(0) vec4<f32> {
    // Wide lines are round like a thread, so that they read as lying on the surface.
    let round_share = clamp(lines.options.x - 2.5, 0.0, 1.0);
    let height = sqrt(max(1.0 - in.across * in.across, 0.0));
    let shade = mix(1.0, 0.62 + 0.38 * height, round_share);
    let colour = srgb_of(linear_of(lines.colour.rgb) * shade);
    return vec4<f32>(colour, 1.0) * lines.colour.a;
}
