// Depth peeling: keeps what lies behind the layer taken before and in front of what is opaque.

// Depths are read as plain numbers: wgpu cannot say `textureLoad` of depth textures in OpenGL's language.
@group(2) @binding(0) var depth_taken: texture_multisampled_2d<f32>;
@group(2) @binding(1) var depth_opaque: texture_multisampled_2d<f32>;

// Depths are compared with this relative slack: 16 units in the last place of f32, so that the layer
// taken before is not met again. At 400 mm that is 0.8 µm.
const DEPTH_SLACK: f32 = 2e-6;

const SAMPLES_AT = array<vec2<f32>, 4>(
    vec2<f32>(-0.125, -0.375), vec2<f32>(0.375, -0.125), vec2<f32>(-0.375, 0.125), vec2<f32>(0.125, 0.375));

// Which of a pixel's four samples are still to be taken. Depth is linear over a triangle's pixels, so
// its value at a sample follows from the value in the middle and the slopes; this costs a quarter of
// running the shader for every sample. Sample places are those that WebGPU prescribes.
fn samples_left(place: vec4<f32>) -> u32 {
    var offsets = SAMPLES_AT;
    let slope = vec2<f32>(dpdx(place.z), dpdy(place.z));
    let slack = DEPTH_SLACK * place.z + 1e-4 * (abs(slope.x) + abs(slope.y));
    let pixel = vec2<i32>(place.xy);
    var left = 0u;
    for (var i = 0; i < 4; i++) {
        let z = place.z + dot(slope, offsets[i]);
        let taken = textureLoad(depth_taken, pixel, i).x;
        let hidden = textureLoad(depth_opaque, pixel, i).x;
        if z < taken - slack && z > hidden {
            left |= 1u << u32(i);
        }
    }
    return left;
}

// The same before the first layer, when nothing is taken yet: half the reads.
fn samples_before(place: vec4<f32>) -> u32 {
    var offsets = SAMPLES_AT;
    let slope = vec2<f32>(dpdx(place.z), dpdy(place.z));
    let pixel = vec2<i32>(place.xy);
    var left = 0u;
    for (var i = 0; i < 4; i++) {
        if place.z + dot(slope, offsets[i]) > textureLoad(depth_opaque, pixel, i).x {
            left |= 1u << u32(i);
        }
    }
    return left;
}
