// Flat faces, lit from both sides by a large soft key light over the viewer's left shoulder that
// wraps a little around the shape, by a sky, and by a weak light from the eye, so that the shape is
// readable from everywhere. Back faces are cooler.

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) at: vec3f,
    @location(1) soft_normal: vec3f,
    @location(2) @interpolate(flat) normal: vec3f,
    @location(3) @interpolate(flat) look: vec4f,
    // In squares of the checkerboard.
    @location(4) uv: vec2f,
    // If vertices have values: in steps from a band limit.
    @location(5) steps: f32,
}

@vertex
fn corner_of_face(@location(0) ids: vec2u) -> Corner {
    let table = textureLoad(positions, texel(ids.x), 0);
    let at = table.xyz;
    var out: Corner;
    out.steps = -table.w;
    out.position = scene.clip_from_scene * vec4f(at, 1.0);
    out.at = at;
    out.soft_normal = textureLoad(vertex_normals, texel(ids.x), 0).xyz;
    out.normal = textureLoad(face_normals, texel(ids.y), 0).xyz;
    out.look = textureLoad(face_looks, texel(ids.y), 0);
    out.uv = vec2f(0.0);
    if scene.checks.x > 0.0 {
        out.uv = textureLoad(uv, texel(ids.x), 0).xy * scene.checks.x;
    }
    return out;
}

// Fraction of a pixel in dark squares: the checkerboard under a box filter of pixel size (Quilez,
// Filtering procedural textures), crisp when near and grey far away.
fn dark_part(uv: vec2f, pixel: vec2f) -> f32 {
    let size = max(pixel, vec2f(1e-5));
    let from_edge = abs(fract((uv - 0.5 * size) * 0.5) - 0.5);
    let to_edge = abs(fract((uv + 0.5 * size) * 0.5) - 0.5);
    let sides = 2.0 * (from_edge - to_edge) / size;
    return 0.5 - 0.5 * sides.x * sides.y;
}

// Colour of the band of a value, from row `row` of the colour map.
fn band_colour(value: f32, row: u32) -> vec3f {
    let begins = scene.checks.y;
    let ends = scene.checks.z;
    let limit = floor(clamp(value, begins, ends - 1e-4));
    let middle = 0.5 * (max(limit, begins) + min(limit + 1.0, ends));
    let part = (middle - begins) / (ends - begins);
    return textureLoad(colour_map, vec2u(u32(part * 255.0 + 0.5), row), 0).rgb;
}

// Coverage of a pixel by an isoline; `change` is the change of the value per pixel.
fn on_isoline(value: f32, change: f32) -> f32 {
    let limit = round(value);
    let is_inside = limit > scene.checks.y + 1e-3 && limit < scene.checks.z - 1e-3;
    let half_width = 0.5 * scene.strokes[BAND].size.x * scene.canvas.z;
    let away = abs(value - limit) / max(change, 1e-9);
    // Lines that are only a few pixels apart fade, so that they do not fill the face.
    let fading = clamp(0.25 * (1.0 / max(change, 1e-9)) / (half_width + 1.0) - 0.5, 0.0, 1.0);
    return select(0.0, clamp(half_width + 0.5 - away, 0.0, 1.0) * fading, is_inside);
}

// Coverage of a pixel by the diagonal hatching, which is fixed to the canvas.
fn hatched(pixel: vec2f) -> f32 {
    let ratio = scene.canvas.z;
    let across = (pixel.x + pixel.y) * 0.70710678 / ratio;
    let away = abs(fract(across / HATCH_STEP) - 0.5) * HATCH_STEP;
    return clamp((0.5 * HATCH_WIDTH - away) * ratio + 0.5, 0.0, 1.0);
}

// Spacing and width of the hatching in CSS pixels, and its opacity.
const HATCH_STEP: f32 = 7.0;
const HATCH_WIDTH: f32 = 1.5;
const HATCH: f32 = 0.92;
const HATCH_OF_SELECTED: vec3f = vec3f(0.06, 0.08, 0.11);
const HATCH_OF_TINT: vec3f = vec3f(1.0);

const BAND: u32 = 10u;
// The section is drawn in the style of the boundary.
const CUT: u32 = 1u;

// Amount of light, and 1 if the front of the face is seen, else 0.
fn light_on(in: Corner) -> vec2f {
    let to_eye = to_eye_from(in.at);
    var normal = in.normal;
    if dot(normal, normal) < 0.5 {
        normal = to_eye;
    }
    let is_front = dot(normal, to_eye) >= 0.0;
    normal = select(-normal, normal, is_front);
    let soft = select(-in.soft_normal, in.soft_normal, dot(in.soft_normal, normal) >= 0.0);
    let bent = normalize(normal + 0.4 * soft);
    let key = normalize(scene.up.xyz * 0.78 - scene.right.xyz * 0.58 - scene.forward.xyz * 0.40);
    let wrapped = max((dot(bent, key) + WRAP) / (1.0 + WRAP), 0.0);
    let from_sky = 0.5 + 0.5 * dot(bent, scene.sky.xyz);
    let from_eye = max(dot(bent, to_eye), 0.0);
    let light = 0.62 * wrapped + 0.22 * from_sky + 0.24 * from_eye;
    return vec2f(clamp(light, 0.0, 1.0), select(0.0, 1.0, is_front));
}

// Fraction of the ambient light that reaches a point: 1 without occluders. It is computed at a
// lower resolution; of the four nearest samples, those of similar depth count.
fn openness(in: Corner) -> f32 {
    if scene.nearby.w <= 0.0 {
        return 1.0;
    }
    let on_canvas = vec2f(2.0, -2.0) * in.position.xy / scene.canvas.xy + vec2f(-1.0, 1.0);
    let place = vec2f(0.5, -0.5) * on_picture(on_canvas) + 0.5;
    let extent = vec2i(textureDimensions(previous));
    let at = place * vec2f(extent) - 0.5;
    let first = floor(at);
    let part = at - first;
    let own = depth_part(in.at);
    let scale = 12.0 * scene.nearby.y / scene.nearby.z;
    var sum = 0.0;
    var weights = 0.0;
    for (var i = 0; i < 4; i++) {
        let step = vec2i(i & 1, i >> 1u);
        let texel = textureLoad(previous, clamp(vec2i(first) + step, vec2i(0), extent - 1), 0);
        let share = mix(1.0 - part, part, vec2f(step));
        let weight = (share.x * share.y + 1e-3) / (1e-2 + scale * abs(unpacked(texel.yz) - own));
        sum += weight * texel.x;
        weights += weight;
    }
    return mix(1.0, sum / weights, scene.nearby.w);
}

// Factor of the colour where no ambient light arrives.
const CLOSED: vec3f = vec3f(0.47, 0.47, 0.50);

// How far the key light wraps around beyond the terminator.
const WRAP: f32 = 0.3;

@fragment
fn lit(in: Corner) -> @location(0) vec4f {
    let seen = light_on(in);
    let light = seen.x;
    // Derivatives are defined only in uniform control flow, so they are taken here.
    let pixel = fwidth(in.uv);
    let change = length(vec2f(dpdx(in.steps), dpdy(in.steps)));
    let within = within_section(in.at);
    let within_change = fwidth(within);
    let modelled = mix(0.68, 1.05, light);
    let index = u32(in.look.x * 255.0 + 0.5);
    let open = mix(CLOSED, vec3f(1.0), openness(in));
    var colour = mix(scene.shade.rgb, scene.material.rgb, light) * mix(scene.back.rgb, vec3f(1.0), seen.y) * open;
    if in.look.y > 0.875 {
        colour = scene.no_value.rgb * modelled;
    } else if in.look.y > 0.375 {
        let map = select(0u, 3u, in.look.y > 0.625);
        if scene.checks.z > 0.0 {
            let line = scene.strokes[BAND].colour;
            let covered = on_isoline(in.steps, change) * line.a;
            // A face beyond the tolerance may be partly within it.
            let banded = band_colour(in.steps, map) * modelled;
            colour = mix(banded, colour, select(0.0, 1.0, in.steps < scene.checks.w));
            colour = mix(colour, line.rgb, covered);
        } else {
            colour = textureLoad(colour_map, vec2u(index, map), 0).rgb * modelled;
        }
    } else if in.look.y > 0.125 {
        let row = colour_of_row(index);
        colour = mix(colour, row.rgb * modelled * open, row.a);
    }
    if scene.checks.x > 0.0 {
        let dark = dark_part(in.uv, pixel) * scene.check.a;
        colour = mix(colour, scene.check.rgb * modelled, dark);
    }
    // Over values, marks are also hatched, in white or dark ink: one of the two is always visible.
    let hatch = select(0.0, 1.0, in.look.y > 0.375) * hatched(in.position.xy);
    colour = mix(colour, mix(scene.tint.rgb * modelled, HATCH_OF_TINT, hatch * in.look.w), in.look.w * mix(scene.tint.a, HATCH, hatch));
    colour = mix(colour, mix(scene.selected.rgb * modelled, HATCH_OF_SELECTED, hatch), in.look.z * mix(scene.selected.a, HATCH, hatch));
    // At the section the surface ends in a heavy line.
    let cut = scene.strokes[CUT];
    let beside_cut = within / max(within_change, 1e-12);
    colour = mix(colour, cut.colour.rgb, clamp(cut.size.x * scene.canvas.z + 0.5 - beside_cut, 0.0, 1.0));
    if within < 0.0 {
        discard;
    }
    return vec4f(min(colour, vec3f(1.0)), 1.0);
}

// The ghost: the original faces as a veil, which is denser where it is seen edge-on.

struct VeilCorner {
    @builtin(position) position: vec4f,
    @location(0) at: vec3f,
}

// Pushed back by this fraction of the distance, so as not to stain a surface that hardly moved.
const BACK: f32 = 0.0012;

@vertex
fn corner_of_veil(@location(0) ids: vec2u) -> VeilCorner {
    let at = position_of(ids.x);
    var out: VeilCorner;
    out.position = scene.clip_from_scene * vec4f(nearer(at, -BACK), 1.0);
    out.at = at;
    return out;
}

@fragment
fn veil(in: VeilCorner) -> @location(0) vec4f {
    let normal = cross(dpdx(in.at), dpdy(in.at));
    let facing = abs(dot(normal, to_eye_from(in.at))) / max(length(normal), 1e-20);
    let edge_on = 1.0 - min(facing, 1.0);
    if within_section(in.at) < 0.0 {
        discard;
    }
    return vec4f(scene.ghost.rgb, scene.ghost.a * (1.0 + 1.5 * edge_on * edge_on));
}
