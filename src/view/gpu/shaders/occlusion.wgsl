// Ambient occlusion at half the size of the picture, in three passes: the depths and normals of the
// faces; for each pixel the ambient light that nearby surfaces block, estimated from the horizon of
// its neighbours on the screen (Mara, McGuire, Bukowski and Ritter 2016 compare such estimates);
// and the mean over sixteen neighbours, each of which sampled other directions.

struct Seen {
    @builtin(position) position: vec4f,
    @location(0) at: vec3f,
    @location(1) @interpolate(flat) normal: vec3f,
}

@vertex
fn corner_of_depth(@location(0) ids: vec2u) -> Seen {
    let at = position_of(ids.x);
    var out: Seen;
    // The whole picture, even if the canvas shows only a part of it.
    let clip = scene.clip_from_scene * vec4f(at, 1.0);
    let xy = (clip.xy - scene.placement.zw * clip.w) / scene.placement.xy;
    out.position = vec4f(xy, clip.z, clip.w);
    out.at = at;
    out.normal = textureLoad(face_normals, texel(ids.y), 0).xyz;
    return out;
}

// Depth, and the normal's components to the right and up on the screen, turned towards the eye.
@fragment
fn depth_and_normal(in: Seen) -> @location(0) vec4f {
    let towards = select(-1.0, 1.0, dot(in.normal, to_eye_from(in.at)) >= 0.0);
    let normal = in.normal * towards;
    let tilt = vec2f(dot(normal, scene.right.xyz), dot(normal, scene.up.xyz));
    if within_section(in.at) < 0.0 {
        discard;
    }
    return vec4f(packed(depth_part(in.at)), tilt * 0.5 + 0.5);
}

@vertex
fn corner_of_screen(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4f {
    let at = vec2f(select(-1.0, 3.0, corner == 1u), select(-1.0, 3.0, corner == 2u));
    return vec4f(at, 0.5, 1.0);
}

// Half the width and height of the picture at depth 1.
fn half_extent() -> vec2f {
    return 0.5 * scene.canvas.xy * scene.placement.xy * scene.canvas.w;
}

fn depth_of(part: f32) -> f32 {
    return scene.nearby.x + part * scene.nearby.y;
}

// The surface point at a pixel, in screen axes: right, up, and away from the eye.
fn seen_at(pixel: vec2f, part: f32, size: vec2f) -> vec3f {
    let depth = depth_of(part);
    let across = select(depth, scene.eye.w, is_parallel());
    let place = vec2f(2.0 * pixel.x / size.x - 1.0, 1.0 - 2.0 * pixel.y / size.y);
    return vec3f(place * half_extent() * across, depth);
}

// Number of samples per pixel.
const SAMPLES: i32 = 8;
// Maximum distance of a sample in pixels.
const FARTHEST: f32 = 72.0;
// Samples that rise less than this above the surface, as a sine, block no light: faces are flat.
const RISE: f32 = 0.12;
const STRENGTH: f32 = 2.7;
// Height above the ground, relative to the reach, from which the ground blocks no light.
const GROUND_REACH: f32 = 1.0;
const GROUND_STRENGTH: f32 = 0.38;

@fragment
fn gathered(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let here = textureLoad(previous, vec2i(position.xy), 0);
    let part = unpacked(here.xy);
    if part >= 1.0 {
        return vec4f(1.0, here.xy, 1.0);
    }
    let extent = vec2i(textureDimensions(previous));
    let size = vec2f(extent);
    let point = seen_at(position.xy, part, size);
    let tilt = here.zw * 2.0 - 1.0;
    let normal = vec3f(tilt, -sqrt(max(1.0 - dot(tilt, tilt), 0.0)));
    let reach = scene.nearby.z;
    let across = select(point.z, scene.eye.w, is_parallel());
    let radius = min(0.5 * reach / (across * half_extent().x) * size.x, FARTHEST);

    // Each pixel of a block of four by four starts in another direction.
    let cell = vec2u(position.xy) & vec2u(3u);
    let crossed = cell.x ^ cell.y;
    let turned = f32((crossed & 1u) * 8u + (cell.y & 1u) * 4u + (crossed & 2u) + (cell.y >> 1u));
    var blocked = 0.0;
    for (var i = 0; i < SAMPLES; i++) {
        let angle = 2.39996323 * f32(i) + turned * 0.39269908;
        let away = radius * (f32(i) + 0.35 + turned * 0.04) / f32(SAMPLES) + 1.0;
        let there = position.xy + away * vec2f(cos(angle), sin(angle));
        let pixel = clamp(vec2i(there), vec2i(0), extent - 1);
        let other = unpacked(textureLoad(previous, pixel, 0).xy);
        let way = seen_at(vec2f(pixel) + 0.5, other, size) - point;
        let length_squared = max(dot(way, way), 1e-20);
        let rise = dot(way, normal) * inverseSqrt(length_squared);
        let nearness = max(1.0 - length_squared / (reach * reach), 0.0);
        blocked += max(rise - RISE, 0.0) * nearness;
    }
    var open = 1.0 - STRENGTH * blocked / f32(SAMPLES);

    // The ground is not a face, but blocks light from low surfaces that face down.
    let sky = vec3f(
        dot(scene.sky.xyz, scene.right.xyz),
        dot(scene.sky.xyz, scene.up.xyz),
        dot(scene.sky.xyz, scene.forward.xyz),
    );
    let height = dot(point, sky) + dot(scene.eye.xyz, scene.sky.xyz) - scene.sky.w;
    let near_ground = max(1.0 - height / (GROUND_REACH * reach), 0.0);
    let looks_down = 0.5 - 0.5 * dot(normal, sky);
    open *= 1.0 - GROUND_STRENGTH * looks_down * near_ground * near_ground;
    return vec4f(clamp(open, 0.0, 1.0), here.xy, 1.0);
}

@fragment
fn smoothed(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let middle = vec2i(position.xy);
    let here = textureLoad(previous, middle, 0);
    let part = unpacked(here.yz);
    if part >= 1.0 {
        return here;
    }
    let last = vec2i(textureDimensions(previous)) - 1;
    // The depth of a steep surface changes much per pixel; beyond this it is another surface.
    let allowed = 0.3 * scene.nearby.z / scene.nearby.y;
    var sum = 0.0;
    var weights = 0.0;
    for (var i = 0; i < 16; i++) {
        let pixel = clamp(middle + vec2i(i & 3, i >> 2u) - 2, vec2i(0), last);
        let other = textureLoad(previous, pixel, 0);
        let weight = max(1.0 - abs(unpacked(other.yz) - part) / allowed, 0.0);
        sum += weight * other.x;
        weights += weight;
    }
    return vec4f(select(here.x, sum / weights, weights > 0.0), here.yz, 1.0);
}
