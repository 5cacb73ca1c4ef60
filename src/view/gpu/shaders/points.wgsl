// Dots: vertices, selected vertices, handles, targets. Round or square, always facing the eye, with
// a rim; parts behind the surface are drawn dim.

struct Corner {
    @builtin(position) position: vec4f,
    // Offset from the centre of the dot in pixels.
    @location(0) at: vec2f,
    @location(1) @interpolate(flat) kind: u32,
    @location(2) @interpolate(flat) fill: vec4f,
}

@vertex
fn corner_of_dot(
    @builtin(vertex_index) corner: u32,
    // Index in the table of positions, kind, index of the colour among those of the rows.
    @location(0) ids: vec3u,
) -> Corner {
    let size = scene.dots[ids.y].size;
    let reach = (size.x + select(0.0, GLOW, ids.y == ACTIVE)) * scene.canvas.z + 1.0;
    let right = corner == 1u || corner == 2u || corner == 4u;
    let high = corner == 2u || corner == 4u || corner == 5u;
    let middle = position_of(ids.x);
    let depth = scale_depth(middle);
    // Lifted in front of the surface around the vertex, even a steep one. Marks are lifted further,
    // so that no part of a handle is hidden.
    let steepness = select(1.6, 4.0, ids.y > 0u);
    let forward = reach * scene.canvas.w * steepness + 0.0012;
    let clip = scene.clip_from_scene * vec4f(nearer(middle, min(forward, 0.5)), 1.0);
    var out: Corner;
    out.at = vec2f(select(-reach, reach, right), select(-reach, reach, high));
    out.kind = ids.y;
    out.fill = scene.dots[ids.y].fill;
    if ids.z > 0u {
        out.fill = vec4f(colour_of_row(ids.z).rgb, 1.0);
    }
    let offset = out.at / (0.5 * scene.canvas.xy);
    out.position = vec4f(clip.xy + offset * clip.w, clip.z, clip.w);
    // Handles can be picked wherever they are, so the section does not cut them.
    let is_cut = within_section(middle) < 0.0 && ids.y <= SELECTED;
    if depth <= 0.0 || is_cut {
        out.position = vec4f(0.0, 0.0, -1.0, 1.0);
    }
    return out;
}

fn dot_colour(in: Corner) -> vec4f {
    let style = scene.dots[in.kind];
    let ratio = scene.canvas.z;
    let corner = max(abs(in.at) - vec2f(style.size.x * ratio - 2.0 * ratio), vec2f(0.0));
    let to_square = length(corner) + (style.size.x - 2.0) * ratio;
    let away = select(length(in.at), to_square, style.size.z > 0.5);
    let coverage = clamp(style.size.x * ratio + 0.5 - away, 0.0, 1.0);
    let inside = clamp((style.size.x - style.size.y) * ratio + 0.5 - away, 0.0, 1.0);
    let colour = mix(style.rim, in.fill, inside);
    // The handle under the pointer glows.
    let beyond = clamp((away / ratio - style.size.x) / GLOW, 0.0, 1.0);
    let glow = select(0.0, 0.5 * (1.0 - beyond) * (1.0 - beyond), in.kind == ACTIVE);
    let opacity = max(colour.a * coverage, glow);
    return vec4f(mix(in.fill.rgb, colour.rgb, coverage), opacity);
}

@fragment
fn in_front(in: Corner) -> @location(0) vec4f {
    return dot_colour(in);
}

@fragment
fn behind(in: Corner) -> @location(0) vec4f {
    let colour = dot_colour(in);
    return vec4f(colour.rgb, colour.a * 0.38);
}

// The handle under the pointer, and the extent of its glow in CSS pixels.
const ACTIVE: u32 = 7u;
const GLOW: f32 = 9.0;

// Kinds up to this one mark vertices; the later ones are handles and the tape.
const SELECTED: u32 = 3u;
