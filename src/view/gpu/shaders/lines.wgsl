// Edges of polygons, polylines, and lines from handles to their targets; the part of the latter
// lines behind the surface is drawn dim.

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,
    @location(1) @interpolate(flat) ends: vec4f,
    @location(2) @interpolate(flat) colour: vec4f,
    // Half the width, and the factor of the opacity behind the surface.
    @location(3) @interpolate(flat) style: vec2f,
}

@vertex
fn corner_of_line(
    @builtin(vertex_index) corner: u32,
    @location(0) ends: vec2u,
    @location(1) kind: u32,
) -> Corner {
    let stroke = scene.strokes[kind];
    let ratio = scene.canvas.z;
    let half_width = 0.5 * stroke.size.x * ratio;
    // Lines over the surface cross the flat triangles of faces, so they are lifted further.
    let lift = select(LIFT, 4.0 * LIFT, kind >= OVER);
    let from_point = position_of(ends.x);
    let to_point = position_of(ends.y);
    var quad: StrokeCorner;
    if kind == GROUND || kind == PULL {
        // The section does not cut what lies outside the model.
        quad = stroke_corner(from_point, to_point, corner, half_width, lift);
    } else {
        quad = cut_stroke_corner(from_point, to_point, corner, half_width, lift);
    }
    var out: Corner;
    out.position = quad.position;
    out.at = quad.at;
    out.ends = vec4f(quad.start, quad.end);
    out.colour = stroke.colour;
    out.style = vec2f(half_width, stroke.size.w);
    if kind == 0u || kind == GHOST || kind == LAYER {
        // Short edges are fainter: panels of a few pixels would otherwise be nothing but edges.
        let length_on_screen = distance(quad.start, quad.end) / ratio;
        out.colour.a *= clamp(0.16 + length_on_screen / 26.0, 0.16, 1.0);
    }
    return out;
}

fn line_colour(in: Corner) -> vec4f {
    let coverage = stroke_coverage(in.at, in.ends.xy, in.ends.zw, in.style.x);
    return vec4f(in.colour.rgb, in.colour.a * coverage);
}

const PULL: u32 = 3u;
const GHOST: u32 = 7u;
const GROUND: u32 = 8u;
const LAYER: u32 = 12u;
const OVER: u32 = 14u;

@fragment
fn in_front(in: Corner) -> @location(0) vec4f {
    return line_colour(in);
}

@fragment
fn behind(in: Corner) -> @location(0) vec4f {
    let colour = line_colour(in);
    return vec4f(colour.rgb, colour.a * in.style.y);
}
