// Depth peeling: keeps what lies behind the layer taken before and in front of what is opaque.

@group(2) @binding(0) var depth_taken: texture_depth_multisampled_2d;
@group(2) @binding(1) var depth_opaque: texture_depth_multisampled_2d;

// Depths are compared with this relative slack: 8 units in the last place of f32, so that the layer
// taken before is not met again. At 400 mm that is 0.4 µm.
const DEPTH_SLACK: f32 = 1e-6;

fn taken_or_hidden(place: vec4<f32>, sample: u32) -> bool {
    let pixel = vec2<i32>(place.xy);
    let taken = textureLoad(depth_taken, pixel, i32(sample));
    let opaque_depth = textureLoad(depth_opaque, pixel, i32(sample));
    return place.z >= taken * (1.0 - DEPTH_SLACK) || place.z <= opaque_depth;
}
