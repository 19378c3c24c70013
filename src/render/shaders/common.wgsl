// What every pass shares: the view, clip positions, sRGB, and the light.
//
// No shader branches on uniforms alone: it selects, or asks a varying too. Mesa's drivers for the processor write the
// values of such uniforms into the shader and compile it anew for every draw, and keep what they compiled: 4 MB a
// picture.

struct View {
    // Rotation from world to camera axes (x right, y up, z towards the viewer).
    rotation: mat4x4<f32>,
    // xyz: the target in the world; w: distance from the eye to the target.
    target_point: vec4<f32>,
    // x, y: scale of camera coordinates; z: near distance (perspective) or depth range (parallel); w: 1 if parallel.
    projection: vec4<f32>,
    // The part of the whole picture that this target holds: clip.xy * xy + zw * clip.w.
    crop: vec4<f32>,
    // x, y: size of the whole picture in pixels; z, w: this tile's first pixel in it.
    size: vec4<f32>,
    // x: physical pixels per logical pixel; y: reach of occlusion in world lengths; z: 1 if occlusion is there; w: 1 over a dark background, 0 over a light one.
    options: vec4<f32>,
    // x, y: occlusion texels per pixel of the whole picture; z, w: the pixel where its first texel lies.
    occlusion: vec4<f32>,
}

@group(0) @binding(0) var<uniform> view: View;

// Position relative to the target, in camera axes.
fn in_camera(world: vec3<f32>) -> vec3<f32> {
    return (view.rotation * vec4<f32>(world - view.target_point.xyz, 0.0)).xyz;
}

// Distance from the eye plane.
fn eye_distance(q: vec3<f32>) -> f32 {
    return view.target_point.w - q.z;
}

// Unit vector from a place towards the eye.
fn towards_eye(q: vec3<f32>) -> vec3<f32> {
    let to_eye = normalize(vec3<f32>(0.0, 0.0, view.target_point.w) - q);
    return select(to_eye, vec3<f32>(0.0, 0.0, 1.0), view.projection.w > 0.5);
}

fn clip_of(q: vec3<f32>) -> vec4<f32> {
    let d = eye_distance(q);
    let scaled = q.xy * view.projection.xy;
    let parallel = vec2<f32>(1.0 - d / view.projection.z, 1.0);
    let perspective = vec2<f32>(view.projection.z, d);
    let clip = vec4<f32>(scaled, select(perspective, parallel, view.projection.w > 0.5));
    return vec4<f32>(clip.xy * view.crop.xy + view.crop.zw * clip.w, clip.zw);
}

// Length of one pixel in world lengths at a distance from the eye plane.
fn pixel_length(d: f32) -> f32 {
    let at_one = 2.0 / (view.projection.y * view.size.y);
    return select(at_one * d, at_one, view.projection.w > 0.5);
}

// Moves a place towards the eye along its own ray, so that it stays at its pixel.
fn nearer(q: vec3<f32>, by: f32) -> vec3<f32> {
    let eye = vec3<f32>(0.0, 0.0, view.target_point.w);
    let d = max(eye_distance(q), 1e-20);
    let along_ray = eye + (q - eye) * (1.0 - min(by / d, 0.5));
    return select(along_ray, q + vec3<f32>(0.0, 0.0, by), view.projection.w > 0.5);
}

// Cuts the end `b` of a segment off where it comes too close to the eye.
fn before_eye(a: vec3<f32>, b: vec3<f32>) -> vec3<f32> {
    let least = 2.0 * view.projection.z;
    let da = eye_distance(a);
    let db = eye_distance(b);
    let whole = view.projection.w > 0.5 || db >= least || da <= db;
    let cut = mix(b, a, (least - db) / max(da - db, 1e-20));
    return select(cut, b, whole);
}

// Pixels from the middle of the picture, y up.
fn on_screen(q: vec3<f32>) -> vec2<f32> {
    let spread = select(max(eye_distance(q), 1e-20), 1.0, view.projection.w > 0.5);
    return q.xy * view.projection.xy / spread * 0.5 * view.size.xy;
}

// Distance from the eye plane of a stored depth.
fn distance_of_depth(depth: f32) -> f32 {
    let perspective = view.projection.z / max(depth, 1e-12);
    return select(perspective, (1.0 - depth) * view.projection.z, view.projection.w > 0.5);
}

fn linear_of(srgb: vec3<f32>) -> vec3<f32> {
    let low = srgb / 12.92;
    let high = pow((max(srgb, vec3<f32>(0.0)) + 0.055) / 1.055, vec3<f32>(2.4));
    return select(high, low, srgb <= vec3<f32>(0.04045));
}

fn srgb_of(light: vec3<f32>) -> vec3<f32> {
    let c = clamp(light, vec3<f32>(0.0), vec3<f32>(1.0));
    let low = c * 12.92;
    let high = 1.055 * pow(c, vec3<f32>(1.0 / 2.4)) - 0.055;
    return select(high, low, c <= vec3<f32>(0.0031308));
}

// Matte light fixed to the camera: a soft key from the upper left, a headlight, and a sky that is
// brighter above. `scatter` widens the red end of the shadow's edge as light under skin does.
fn matte(base: vec3<f32>, n: vec3<f32>, v: vec3<f32>, occlusion: f32, scatter: f32) -> vec3<f32> {
    let key = normalize(vec3<f32>(-0.50, 0.68, 0.62));
    let wrap = vec3<f32>(0.28) + scatter * vec3<f32>(0.16, 0.02, 0.0);
    let wrapped = max((dot(n, key) + wrap) / (1.0 + wrap), vec3<f32>(0.0));
    let head = max(dot(n, v), 0.0);
    let sky = mix(vec3<f32>(0.15, 0.125, 0.12), vec3<f32>(0.36, 0.37, 0.39), 0.5 + 0.5 * n.y);
    // Light that bounced between folds of the same colour keeps occluded places warm instead of grey.
    let bounced = vec3<f32>(occlusion) / (vec3<f32>(1.0) - base * 0.55 * (1.0 - occlusion));
    let direct = mix(1.0, occlusion, 0.75);
    let h = normalize(key + v);
    let gloss = 0.045 * pow(max(dot(n, h), 0.0), 14.0) + 0.02 * pow(1.0 - head, 3.0);
    return base * (sky * bounced + (0.74 * wrapped + 0.26 * head) * direct) + vec3<f32>(gloss * direct);
}
