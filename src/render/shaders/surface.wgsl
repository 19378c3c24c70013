// Surfaces: two poses blended in the vertex stage, matte light, colours from numbers, edges, open rims.

struct Surface {
    // rgb: sRGB; a: opacity.
    colour: vec4<f32>,
    below: vec4<f32>,
    above: vec4<f32>,
    // rgb: sRGB; a: opacity of edges.
    wire: vec4<f32>,
    // x: low; y: high; z: 1 if logarithmic; w: 1 if coloured by numbers.
    limits: vec4<f32>,
    // x: edge width in logical pixels; y: silhouette and rim; z: 1 if flat; w: blend of poses.
    options: vec4<f32>,
    // x, y: first texel of the poses from and to; z: width of the texture; w: colours in the map.
    texels: vec4<u32>,
    // x, y: first texel of the numbers from and to; z: width of the texture.
    scalar_texels: vec4<u32>,
}

@group(1) @binding(0) var<uniform> surface: Surface;
@group(1) @binding(1) var shape: texture_2d<u32>;
@group(1) @binding(2) var scalars: texture_2d<u32>;
@group(1) @binding(3) var colour_map: texture_2d<f32>;

struct Varying {
    @invariant @builtin(position) clip: vec4<f32>,
    @location(0) q: vec3<f32>,
    @location(1) normal: vec3<f32>,
    // x: number times y; y: 1 where there is a number.
    @location(2) number: vec2<f32>,
    @location(3) corner: vec3<f32>,
}

fn texel(index: u32, width: u32) -> vec2<i32> {
    let columns = max(width, 1u);
    return vec2<i32>(i32(index % columns), i32(index / columns));
}

// Undoes the octahedral packing of a unit normal into two 16-bit numbers.
fn unpacked_normal(packed: u32) -> vec3<f32> {
    let e = unpack2x16snorm(packed);
    let z = 1.0 - abs(e.x) - abs(e.y);
    let fold = max(-z, 0.0);
    let xy = e + select(vec2<f32>(fold), vec2<f32>(-fold), e >= vec2<f32>(0.0));
    return normalize(vec3<f32>(xy, z));
}

fn number_at(index: u32) -> vec2<f32> {
    let bits = textureLoad(scalars, texel(index, surface.scalar_texels.z), 0).x;
    let is_nan = (bits & 0x7fffffffu) > 0x7f800000u;
    return select(vec2<f32>(bitcast<f32>(bits), 1.0), vec2<f32>(0.0), is_nan);
}

fn placed(vertex: u32) -> Varying {
    let blend = surface.options.w;
    let a = textureLoad(shape, texel(surface.texels.x + vertex, surface.texels.z), 0);
    let b = textureLoad(shape, texel(surface.texels.y + vertex, surface.texels.z), 0);
    let world = mix(bitcast<vec3<f32>>(a.xyz), bitcast<vec3<f32>>(b.xyz), blend);
    let normal = mix(unpacked_normal(a.w), unpacked_normal(b.w), blend);
    var out: Varying;
    out.q = in_camera(world);
    out.clip = clip_of(out.q);
    out.normal = (view.rotation * vec4<f32>(normal, 0.0)).xyz;
    // Without numbers a stand-in of one texel is read.
    let by_numbers = surface.limits.w > 0.5;
    let from_number = number_at(select(0u, surface.scalar_texels.x + vertex, by_numbers));
    let to_number = number_at(select(0u, surface.scalar_texels.y + vertex, by_numbers));
    let known = from_number.y * to_number.y;
    let number = vec2<f32>(mix(from_number.x, to_number.x, blend) * known, known);
    out.number = select(vec2<f32>(0.0), number, by_numbers);
    out.corner = vec3<f32>(1.0);
    return out;
}

@vertex
fn vs_indexed(@builtin(vertex_index) vertex: u32) -> Varying {
    return placed(vertex);
}

// Without an index buffer: every corner knows its number, so edges need no geometry shader.
@vertex
fn vs_corners(@builtin(vertex_index) corner: u32, @location(0) vertex: u32) -> Varying {
    var out = placed(vertex);
    let k = corner % 3u;
    out.corner = vec3<f32>(f32(k == 0u), f32(k == 1u), f32(k == 2u));
    return out;
}

fn mapped(number: vec2<f32>) -> vec3<f32> {
    if number.y < 0.5 {
        return vec3<f32>(0.54, 0.56, 0.58);
    }
    let value = number.x / number.y;
    let low = surface.limits.x;
    let high = surface.limits.y;
    if value < low {
        return surface.below.rgb;
    }
    if value > high {
        return surface.above.rgb;
    }
    let even = (value - low) / max(high - low, 1e-30);
    let logarithmic = log(max(value, 1e-30) / low) / max(log(high / low), 1e-30);
    let share = select(even, logarithmic, surface.limits.z > 0.5);
    let last = f32(surface.texels.w) - 1.0;
    let place = clamp(share, 0.0, 1.0) * last;
    let first = min(floor(place), max(last - 1.0, 0.0));
    let a = textureLoad(colour_map, vec2<i32>(i32(first), 0), 0).rgb;
    let b = textureLoad(colour_map, vec2<i32>(i32(min(first + 1.0, last)), 0), 0).rgb;
    return mix(a, b, place - first);
}

fn base_of(number: vec2<f32>) -> vec3<f32> {
    return select(surface.colour.rgb, mapped(number), surface.limits.w > 0.5);
}

// Colour that the light meets; a surface of one colour is darker inside.
fn light_base_of(number: vec2<f32>, from_inside: bool) -> vec3<f32> {
    let darker = select(vec3<f32>(1.0), vec3<f32>(0.60, 0.46, 0.46), from_inside && surface.limits.w <= 0.5);
    return linear_of(base_of(number)) * darker;
}

// Share of the pixel that a line of `width` pixels covers, `d` pixels from its middle.
fn covered(d: f32, width: f32) -> f32 {
    return clamp(0.5 * width + 0.5 - d, 0.0, 1.0) * min(width, 1.0);
}

// The edge of a translucent surface stands off the background, as the edge of glass does.
fn translucent_edge(colour: vec3<f32>) -> vec3<f32> {
    return mix(colour * 0.45, mix(colour, vec3<f32>(1.0), 0.45), view.options.w);
}

// Half the width of a rim in logical pixels.
const RIM_HALF_WIDTH: f32 = 0.7;

// Where a surface ends, a thin line shows its cut edge.
@vertex
fn vs_rim(@builtin(vertex_index) i: u32, @location(0) from_vertex: u32, @location(1) to_vertex: u32) -> Varying {
    let from_end = placed(from_vertex);
    let to_end = placed(to_vertex);
    let a = before_eye(to_end.q, from_end.q);
    let b = before_eye(from_end.q, to_end.q);
    let along = on_screen(b) - on_screen(a);
    let dir = select(vec2<f32>(1.0, 0.0), along / max(length(along), 1e-9), length(along) > 1e-6);
    // Corners 0 1 2, 2 1 3, a little longer than the edge so that neighbours leave no notch.
    let corner = select(i, 5u - i, i >= 3u) + select(0u, 1u, i >= 3u);
    let at_end = corner >= 2u;
    let half_width = RIM_HALF_WIDTH * view.options.x;
    let side = select(-1.0, 1.0, (corner & 1u) == 1u);
    let offset = (vec2<f32>(-dir.y, dir.x) * side + dir * select(-0.5, 0.5, at_end)) * half_width;
    var out = from_end;
    if at_end {
        out = to_end;
    }
    let middle = select(a, b, at_end);
    out.q = nearer(middle, half_width * pixel_length(eye_distance(middle)));
    let clip = clip_of(out.q);
    out.clip = vec4<f32>(clip.xy + offset * 2.0 / view.size.xy * view.crop.xy * clip.w, clip.zw);
    return out;
}

@fragment
fn fs_rim(in: Varying) -> @location(0) vec4<f32> {
    let base = base_of(in.number);
    let strength = surface.options.y;
    let opacity = mix(surface.colour.a, 1.0, 0.5 * strength);
    let translucent = vec4<f32>(translucent_edge(base * 0.8), 1.0) * opacity;
    let opaque = vec4<f32>(mix(base, mix(base, vec3<f32>(1.0), 0.30), strength), 1.0);
    return select(opaque, translucent, surface.colour.a < 1.0);
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
    let v = towards_eye(in.q);
    let across = cross(dpdx(in.q), dpdy(in.q));
    let face = normalize(across) * select(-1.0, 1.0, dot(across, v) >= 0.0);
    let smooth_normal = in.normal / max(length(in.normal), 1e-20);
    let from_inside = dot(smooth_normal, face) < 0.0;
    let turned = select(smooth_normal, -smooth_normal, from_inside);
    let flat_shaded = surface.options.z > 0.5 || length(in.normal) < 1e-6;
    let n = select(turned, face, flat_shaded);
    let facing = clamp(dot(n, v), 0.0, 1.0);

    // The silhouette is a line of constant width: how far off, in pixels, the surface turns away.
    let slope = dot(turned, v);
    let turn = max(length(vec2<f32>(dpdx(slope), dpdy(slope))), 1e-6);
    let rim_pixels = max(slope, 0.0) / turn;

    let corner_turn = vec3<f32>(
        length(vec2<f32>(dpdx(in.corner.x), dpdy(in.corner.x))),
        length(vec2<f32>(dpdx(in.corner.y), dpdy(in.corner.y))),
        length(vec2<f32>(dpdx(in.corner.z), dpdy(in.corner.z))));
    let corner_pixels = in.corner / max(corner_turn, vec3<f32>(1e-9));

    let by_numbers = surface.limits.w > 0.5;
    let light_base = light_base_of(in.number, from_inside);
    let translucent = surface.colour.a < 1.0;
    let open_to_light = select(occlusion_at(in.clip.xy, eye_distance(in.q)), 1.0, translucent);
    let lit = matte(light_base, n, v, open_to_light, select(1.0, 0.3, by_numbers));

    // A translucent surface lets some of its light through to what is behind it.
    var colour = srgb_of(lit * select(1.0, 0.82, translucent));
    // A thin surface seen aslant is longer to pass: Beer and Lambert give 1 - (1 - a)^(1 / cos).
    let aslant = 1.0 - pow(max(1.0 - surface.colour.a, 0.0), 1.0 / max(facing, 0.14));
    var opacity = select(surface.colour.a, aslant, translucent);
    let ppp = view.options.x;
    let rim_line = covered(rim_pixels, 2.6 * ppp) * surface.options.y;
    // Dark on opaque surfaces.
    let rim_colour = select(colour * 0.25, translucent_edge(colour), translucent);
    colour = mix(colour, rim_colour, rim_line);
    opacity = mix(opacity, 1.0, select(0.0, 0.5 * rim_line, translucent));
    // Without edges their width is 0, which covers nothing.
    let d = min(corner_pixels.x, min(corner_pixels.y, corner_pixels.z));
    let edge = covered(d, surface.options.x * ppp) * surface.wire.a;
    colour = mix(colour, surface.wire.rgb, edge);
    opacity = mix(opacity, 1.0, edge);
    return vec4<f32>(colour * opacity, opacity);
}

// For pictures that another follows: light is found at vertices, without occlusion and silhouettes.

struct Lit {
    @builtin(position) clip: vec4<f32>,
    // Premultiplied.
    @location(0) light: vec4<f32>,
}

struct EdgedLit {
    @builtin(position) clip: vec4<f32>,
    @location(0) light: vec4<f32>,
    @location(1) corner: vec3<f32>,
}

fn light_at(at: Varying) -> vec4<f32> {
    let v = towards_eye(at.q);
    let normal = at.normal / max(length(at.normal), 1e-20);
    let from_inside = dot(normal, v) < 0.0;
    let n = select(normal, -normal, from_inside);
    let light_base = light_base_of(at.number, from_inside);
    let lit = matte(light_base, n, v, 1.0, select(1.0, 0.3, surface.limits.w > 0.5));
    let opacity = 1.0 - pow(max(1.0 - surface.colour.a, 0.0), 1.0 / max(dot(n, v), 0.14));
    let film = vec4<f32>(srgb_of(lit * 0.82) * opacity, opacity);
    return select(vec4<f32>(srgb_of(lit), 1.0), film, surface.colour.a < 1.0);
}

@vertex
fn vs_moving(@builtin(vertex_index) vertex: u32) -> Lit {
    let at = placed(vertex);
    return Lit(at.clip, light_at(at));
}

@vertex
fn vs_moving_corners(@builtin(vertex_index) corner: u32, @location(0) vertex: u32) -> EdgedLit {
    let at = placed(vertex);
    let k = corner % 3u;
    return EdgedLit(at.clip, light_at(at), vec3<f32>(f32(k == 0u), f32(k == 1u), f32(k == 2u)));
}

@fragment
fn fs_moving(in: Lit) -> @location(0) vec4<f32> {
    return in.light;
}

@fragment
fn fs_moving_edged(in: EdgedLit) -> @location(0) vec4<f32> {
    let turn = vec3<f32>(
        length(vec2<f32>(dpdx(in.corner.x), dpdy(in.corner.x))),
        length(vec2<f32>(dpdx(in.corner.y), dpdy(in.corner.y))),
        length(vec2<f32>(dpdx(in.corner.z), dpdy(in.corner.z))));
    let pixels = in.corner / max(turn, vec3<f32>(1e-9));
    let nearest = min(pixels.x, min(pixels.y, pixels.z));
    let edge = covered(nearest, surface.options.x * view.options.x) * surface.wire.a;
    return mix(in.light, vec4<f32>(surface.wire.rgb, 1.0), edge);
}
