// Points as shaded discs that face the viewer, with a diameter in pixels.

struct Points {
    // x: diameter in logical pixels; y: triangles of the disc; z: 1 if every point has its own colour.
    options: vec4<f32>,
    // sRGB with opacity of all points that have none of their own.
    colour: vec4<f32>,
}

@group(1) @binding(0) var<uniform> points: Points;

struct Varying {
    @invariant @builtin(position) clip: vec4<f32>,
    @location(0) place: vec2<f32>,
    @location(1) colour: vec4<f32>,
}

@vertex
fn vs_disc(@builtin(vertex_index) i: u32, @location(0) centre: vec3<f32>, @location(1) colour: vec4<f32>) -> Varying {
    let q = in_camera(centre);
    let triangles = points.options.y;
    let step = f32(i / 3u) + f32(i % 3u == 2u);
    let angle = 6.28318531 * (step + 0.5) / triangles;
    // A polygon with the area of the circle, so that the mean diameter is right.
    let third = 6.28318531 / triangles;
    let reach = sqrt(third / sin(third)) * select(1.0, 0.0, i % 3u == 0u);
    let offset = vec2<f32>(cos(angle), sin(angle)) * reach;
    let radius = 0.5 * points.options.x * view.options.x;
    // Half a radius nearer, so that a disc is not cut by the surface that its centre lies on.
    let lifted = nearer(q, 0.5 * radius * pixel_length(eye_distance(q)));
    let clip = clip_of(lifted);
    var out: Varying;
    out.clip = vec4<f32>(clip.xy + offset * radius * 2.0 / view.size.xy * view.crop.xy * clip.w, clip.zw);
    out.place = offset;
    out.colour = select(points.colour, colour, points.options.z > 0.5);
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
    let r2 = min(dot(in.place, in.place), 1.0);
    // A low dome: calm in the middle, darker at the rim.
    let n = normalize(vec3<f32>(in.place * 0.75, sqrt(1.0 - 0.5 * r2)));
    let light = matte(linear_of(in.colour.rgb), n, vec3<f32>(0.0, 0.0, 1.0), 1.0, 0.0);
    let rim = mix(1.0, 0.55, smoothstep(0.72, 1.0, r2));
    return vec4<f32>(srgb_of(light * rim), 1.0) * in.colour.a;
}
