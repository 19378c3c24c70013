// Ambient occlusion at half size from the depth of opaque surfaces: how much of the sky a place sees.

@group(1) @binding(0) var depth_map: texture_multisampled_2d<f32>;
@group(1) @binding(1) var before: texture_2d<u32>;

const SAMPLES: i32 = 14;
// Where the first of four samples lies in the first pixel of a texel, in texels.
const SAMPLE_AT = vec2<f32>(0.1875, 0.0625);

@vertex
fn vs_whole(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(f32(i32(i & 1u) * 4 - 1), f32(i32(i >> 1u) * 4 - 1), 0.0, 1.0);
}

// Distance of the surface at a half-size texel, or FAR.
@fragment
fn fs_distance(@builtin(position) place: vec4<f32>) -> @location(0) u32 {
    let size = vec2<i32>(textureDimensions(depth_map));
    let pixel = min(vec2<i32>(place.xy) * 2, size - 1);
    let depth = textureLoad(depth_map, pixel, 0).x;
    // Openness is not known yet, so that the distance keeps all its bits.
    return select(OPEN_AND_FAR, bitcast<u32>(distance_of_depth(depth)), depth > 0.0);
}

fn distance_at(texel: vec2<i32>) -> f32 {
    let size = vec2<i32>(textureDimensions(before));
    return distance_of(textureLoad(before, clamp(texel, vec2<i32>(0), size - 1), 0).x);
}

// Where a half-size texel at a distance lies, in camera axes.
fn camera_place(texel: vec2<f32>, distance: f32) -> vec3<f32> {
    let pixel = texel * 2.0 + view.size.zw;
    let ndc = vec2<f32>(pixel.x / view.size.x * 2.0 - 1.0, 1.0 - pixel.y / view.size.y * 2.0);
    let spread = select(distance, 1.0, view.projection.w > 0.5);
    return vec3<f32>(ndc * spread / view.projection.xy, view.target_point.w - distance);
}

// The neighbour on the side where depth changes less, so that normals do not bend at edges.
fn step_along(texel: vec2<i32>, here: vec3<f32>, distance: f32, dir: vec2<i32>) -> vec3<f32> {
    let ahead = distance_at(texel + dir);
    let behind = distance_at(texel - dir);
    let centre = vec2<f32>(texel) + SAMPLE_AT;
    if abs(ahead - distance) < abs(behind - distance) {
        return camera_place(centre + vec2<f32>(dir), ahead) - here;
    }
    return here - camera_place(centre - vec2<f32>(dir), behind);
}

@fragment
fn fs_gather(@builtin(position) place: vec4<f32>) -> @location(0) u32 {
    let texel = vec2<i32>(place.xy);
    let distance = distance_at(texel);
    if distance >= FAR {
        return OPEN_AND_FAR;
    }
    let here = camera_place(vec2<f32>(texel) + SAMPLE_AT, distance);
    let along_x = step_along(texel, here, distance, vec2<i32>(1, 0));
    let along_y = step_along(texel, here, distance, vec2<i32>(0, -1));
    let normal = normalize(cross(along_x, along_y));
    let reach = view.options.y;
    // Half-size texels; at most 12 % of the picture's height, which keeps neighbours' reads close together.
    let reach_texels = min(0.5 * reach / pixel_length(distance), 0.06 * view.size.y);
    // A pattern of 4 x 4 turns, removed by the 4 x 4 blur.
    let global = texel + vec2<i32>(view.size.zw * 0.5);
    let turn = f32(((global.x & 3) * 4 + ((global.y & 3) * 5 & 3) + ((global.x >> 1) & 1)) & 15) / 16.0;
    var sum = 0.0;
    for (var i = 0; i < SAMPLES; i++) {
        let share = (f32(i) + 0.5 + 0.5 * turn) / (f32(SAMPLES) + 0.5);
        let angle = 6.2831853 * (turn + f32(i) * 0.381966);
        let offset = vec2<f32>(cos(angle), sin(angle)) * share * reach_texels;
        let there = texel + vec2<i32>(round(offset));
        let d = distance_at(there);
        if d >= FAR {
            continue;
        }
        let away = camera_place(vec2<f32>(there) + SAMPLE_AT, d) - here;
        let apart = dot(away, away);
        let rise = max(dot(away, normal) - 0.012 * reach, 0.0);
        let fade = max(1.0 - apart / (reach * reach), 0.0);
        sum += fade * rise / sqrt(apart + 1e-4 * reach * reach);
    }
    let open = clamp(1.0 - 3.0 * sum / f32(SAMPLES), 0.0, 1.0);
    return occlusion_texel(open, distance);
}

@fragment
fn fs_blur(@builtin(position) place: vec4<f32>) -> @location(0) u32 {
    let texel = vec2<i32>(place.xy);
    let size = vec2<i32>(textureDimensions(before));
    let here = textureLoad(before, texel, 0).x;
    let distance = distance_of(here);
    if distance >= FAR {
        return OPEN_AND_FAR;
    }
    var sum = 0.0;
    var weights = 0.0;
    for (var y = -2; y < 2; y++) {
        for (var x = -2; x < 2; x++) {
            let at = texel + vec2<i32>(x, y);
            if any(at < vec2<i32>(0)) || any(at >= size) {
                continue;
            }
            let near = textureLoad(before, at, 0).x;
            let apart = abs(distance_of(near) - distance) / max(view.options.y, 1e-20);
            let weight = exp2(-6.0 * apart);
            sum += openness_of(near) * weight;
            weights += weight;
        }
    }
    return occlusion_texel(sum / weights, distance);
}
