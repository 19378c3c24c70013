// Reads the smaller occlusion at a full-size pixel, from the four nearest texels of like depth.

@group(2) @binding(2) var occlusion_map: texture_2d<u32>;

fn occlusion_at(pixel: vec2<f32>, distance: f32) -> f32 {
    // The distance is positive: it is asked along so that this is no branch on a uniform alone.
    if view.options.z * distance <= 0.0 {
        return 1.0;
    }
    let size = vec2<i32>(textureDimensions(occlusion_map));
    let place = (pixel + view.size.zw - view.occlusion.zw) * view.occlusion.xy;
    let first = floor(place);
    let share = place - first;
    var sum = 0.0;
    var weights = 0.0;
    for (var i = 0; i < 4; i++) {
        let step = vec2<i32>(i & 1, i >> 1);
        let at = clamp(vec2<i32>(first) + step, vec2<i32>(0), size - 1);
        let texel = textureLoad(occlusion_map, at, 0).x;
        let bilinear = mix(1.0 - share, share, vec2<f32>(step));
        let apart = abs(distance_of(texel) - distance) / max(view.options.y, 1e-20);
        let weight = (bilinear.x * bilinear.y + 1e-3) * exp2(-8.0 * apart) + 1e-8;
        sum += openness_of(texel) * weight;
        weights += weight;
    }
    return sum / weights;
}
