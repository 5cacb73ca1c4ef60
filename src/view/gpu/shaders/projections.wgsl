// Projected shapes, as outlines with a faint inside, and arrows from vertices to their projections, in
// the colours of the rows of constraints, with a light casing that parts them from whatever is below.

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,
    @location(1) @interpolate(flat) ends: vec4f,
    @location(2) @interpolate(flat) colour: vec4f,
    // Half widths of the line and of the arrow's head, length of the head, width of the casing.
    @location(3) @interpolate(flat) sizes: vec4f,
}

// A head, in CSS pixels; of a shorter arrow it is the whole.
const HEAD: f32 = 8.0;
const HEAD_SLOPE: f32 = 0.42;
// An arrow that is no longer than this on the screen, in CSS pixels, says nothing.
const SHORTEST: f32 = 1.5;

@vertex
fn corner_of_projection(
    @builtin(vertex_index) corner: u32,
    @location(0) ends: vec2u,
    // Which stroke, and the place of the colour.
    @location(1) kind: vec2u,
) -> Corner {
    let stroke = scene.strokes[kind.x];
    let ratio = scene.canvas.z;
    let is_arrow = kind.x == ARROW;
    let from_point = textureLoad(positions, texel(ends.x), 0);
    let to_point = textureLoad(positions, texel(ends.y), 0);
    // A projected point lies beside the surface, by the fourth number: so much nearer to the eye,
    // nothing that it belongs to hides it.
    let depth = max(scale_depth(to_point.xyz), 1e-12);
    let lift = 2.5 * LIFT + min(max(from_point.w, to_point.w) / depth, 0.1);
    let head = select(0.0, HEAD * ratio, is_arrow);
    let half_width = 0.5 * stroke.size.x * ratio;
    let casing = stroke.size.z * ratio;
    let reach = max(half_width, head * HEAD_SLOPE) + casing;
    let quad = cut_stroke_corner(from_point.xyz, to_point.xyz, corner, reach, lift);
    let length_on_screen = distance(quad.start, quad.end);
    var out: Corner;
    out.position = quad.position;
    if is_arrow && length_on_screen < SHORTEST * ratio {
        out.position = vec4f(0.0, 0.0, -1.0, 1.0);
    }
    out.at = quad.at;
    out.ends = vec4f(quad.start, quad.end);
    let head_length = min(head, length_on_screen);
    out.sizes = vec4f(half_width, head_length * HEAD_SLOPE, head_length, casing);
    // Outlines that are only a few pixels long fade instead of filling everything, as edges do.
    let fineness = clamp(length_on_screen / (24.0 * ratio), 0.2, 1.0);
    let colour = textureLoad(colour_map, vec2u(kind.y, 2u), 0).rgb;
    out.colour = vec4f(colour, select(fineness, 1.0, is_arrow));
    return out;
}

@fragment
fn drawn(in: Corner) -> @location(0) vec4f {
    let span = in.ends.zw - in.ends.xy;
    let total = max(length(span), 1e-4);
    let along = span / total;
    let from_tip = dot(in.ends.zw - in.at, along);
    let aside = abs(dot(in.at - in.ends.xy, vec2f(-along.y, along.x)));
    // The line ends inside the head, or its round end would blunt the tip.
    let shaft = clamp(dot(in.at - in.ends.xy, along), 0.0, max(total - in.sizes.z, 0.0));
    var away = distance(in.at, in.ends.xy + along * shaft) - in.sizes.x;
    if in.sizes.z > 0.0 {
        let side = (aside - from_tip * HEAD_SLOPE) / sqrt(1.0 + HEAD_SLOPE * HEAD_SLOPE);
        away = min(away, max(side, from_tip - in.sizes.z));
    }
    let inside = clamp(0.5 - away, 0.0, 1.0);
    let casing = scene.strokes[OUTLINE].colour;
    let coverage = clamp(0.5 + in.sizes.w - away, 0.0, 1.0) * casing.a;
    let opacity = max(inside, coverage) * in.colour.a;
    return vec4f(mix(casing.rgb, in.colour.rgb, inside), opacity);
}

struct InsideCorner {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) colour: vec4f,
    @location(1) within: f32,
}

// How much of its colour is on a shape that lies clear of the surface.
const INSIDE: f32 = 0.45;
// It does where it is so many CSS pixels beside it. What lies on its face says nothing, and the colour
// of the face is seen.
const CLEAR: f32 = 9.0;
// A paper of the colour of its row, which is seen on a face of that colour too.
const PAPER: f32 = 0.72;

@vertex
fn corner_of_inside(
    // The point, and the place of the colour.
    @location(0) ids: vec2u,
    @location(1) beside: f32,
) -> InsideCorner {
    let at = position_of(ids.x);
    // As near to the eye as the outlines are, but for a little: they lie on it.
    let depth = max(scale_depth(at), 1e-12);
    let lift = 2.0 * LIFT + min(beside / depth, 0.1);
    let beside_on_screen = beside / (depth * scene.canvas.w * scene.canvas.z);
    var out: InsideCorner;
    out.position = scene.clip_from_scene * vec4f(nearer(at, lift), 1.0);
    let colour = textureLoad(colour_map, vec2u(ids.y, 2u), 0).rgb;
    let opacity = INSIDE * clamp(beside_on_screen / CLEAR, 0.0, 1.0);
    out.colour = vec4f(mix(colour, vec3f(1.0), PAPER), opacity);
    out.within = within_section(at);
    return out;
}

@fragment
fn inside(in: InsideCorner) -> @location(0) vec4f {
    if in.within < 0.0 {
        discard;
    }
    return in.colour;
}

const OUTLINE: u32 = 4u;
const ARROW: u32 = 5u;
