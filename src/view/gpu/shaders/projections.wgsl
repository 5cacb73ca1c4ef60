// Projected shapes, as outlines with a faint inside, and arrows from vertices to projections, in
// the colours of the rows of constraints, with a light casing against what is below.

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,
    @location(1) @interpolate(flat) ends: vec4f,
    @location(2) @interpolate(flat) colour: vec4f,
    // Half widths of the line and of the arrow head, length of the head, width of the casing.
    @location(3) @interpolate(flat) sizes: vec4f,
}

// Length of the head in CSS pixels; a shorter arrow is all head.
const HEAD: f32 = 8.0;
const HEAD_SLOPE: f32 = 0.42;
// Arrows that are no longer than this on the screen, in CSS pixels, are not drawn.
const SHORTEST: f32 = 1.5;

@vertex
fn corner_of_projection(
    @builtin(vertex_index) corner: u32,
    @location(0) ends: vec2u,
    // Index of the stroke, and index of the colour.
    @location(1) kind: vec2u,
) -> Corner {
    let stroke = scene.strokes[kind.x];
    let ratio = scene.canvas.z;
    let is_arrow = kind.x == ARROW;
    let from_point = textureLoad(positions, texel(ends.x), 0);
    let to_point = textureLoad(positions, texel(ends.y), 0);
    // The fourth number is the distance of a projected point from its vertex. Lifted by as much,
    // the point is not hidden by its own surface.
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
    // Outlines that are only a few pixels long fade like edges, so that they do not fill the face.
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
    // The shaft ends inside the head; its round end would otherwise blunt the tip.
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

// Opacity of the inside of a shape that lies clear of the surface.
const INSIDE: f32 = 0.45;
// Distance from the surface, in CSS pixels, at which this opacity is reached. A shape on its face
// is transparent, so that the colour of the face is seen.
const CLEAR: f32 = 9.0;
// Fraction of white in the inside, which makes it visible on a face of the colour of its row.
const PAPER: f32 = 0.72;

@vertex
fn corner_of_inside(
    // Index of the point, and index of the colour.
    @location(0) ids: vec2u,
    @location(1) beside: f32,
) -> InsideCorner {
    let at = position_of(ids.x);
    // Lifted slightly less than the outlines, so that those lie on top.
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
