// Lines of constant width on the screen: quads around segments, with round, antialiased ends.

struct StrokeCorner {
    position: vec4f,
    // Screen positions in pixels.
    at: vec2f,
    start: vec2f,
    end: vec2f,
}

// Lines on a face are moved towards the eye by this fraction of their distance: their screen
// position stays, and they lie in front of the face.
const LIFT: f32 = 0.0006;

fn pixels(clip: vec4f) -> vec2f {
    return clip.xy / clip.w * 0.5 * scene.canvas.xy;
}

// Like `stroke_corner`, for the part of the segment that the section plane keeps.
fn cut_stroke_corner(a: vec3f, b: vec3f, corner: u32, half_width: f32, lift: f32) -> StrokeCorner {
    let inside = vec2f(within_section(a), within_section(b));
    if max(inside.x, inside.y) < 0.0 {
        var out: StrokeCorner;
        out.position = vec4f(0.0, 0.0, -1.0, 1.0);
        return out;
    }
    let middle = mix(a, b, inside.x / max(abs(inside.x - inside.y), 1e-20) * sign(inside.x - inside.y));
    let start = select(a, middle, inside.x < 0.0);
    let end = select(b, middle, inside.y < 0.0);
    return stroke_corner(start, end, corner, half_width, lift);
}

// Corner 0 to 5 of the two triangles around the segment from a to b, lifted towards the eye.
fn stroke_corner(a: vec3f, b: vec3f, corner: u32, half_width: f32, lift: f32) -> StrokeCorner {
    var from_clip = scene.clip_from_scene * vec4f(nearer(a, lift), 1.0);
    var to_clip = scene.clip_from_scene * vec4f(nearer(b, lift), 1.0);
    var out: StrokeCorner;
    if from_clip.z < 0.0 && to_clip.z < 0.0 {
        out.position = vec4f(0.0, 0.0, -1.0, 1.0);
        return out;
    }
    // Clipped at the near plane before the perspective division.
    let part = from_clip.z / (from_clip.z - to_clip.z);
    if from_clip.z < 0.0 {
        from_clip = mix(from_clip, to_clip, part);
    } else if to_clip.z < 0.0 {
        to_clip = mix(from_clip, to_clip, part);
    }
    out.start = pixels(from_clip);
    out.end = pixels(to_clip);
    let span = out.end - out.start;
    var along = vec2f(1.0, 0.0);
    if dot(span, span) > 1e-8 {
        along = normalize(span);
    }
    let across = vec2f(-along.y, along.x);
    let reach = half_width + 1.0;
    let ahead = corner == 1u || corner == 2u || corner == 4u;
    let left = corner == 2u || corner == 4u || corner == 5u;
    let origin = select(out.start - along * reach, out.end + along * reach, ahead);
    out.at = origin + across * select(-reach, reach, left);
    let depth = select(from_clip.z / from_clip.w, to_clip.z / to_clip.w, ahead);
    out.position = vec4f(out.at / (0.5 * scene.canvas.xy), depth, 1.0);
    return out;
}

fn stroke_coverage(at: vec2f, start: vec2f, end: vec2f, half_width: f32) -> f32 {
    let span = end - start;
    let part = clamp(dot(at - start, span) / max(dot(span, span), 1e-8), 0.0, 1.0);
    return clamp(half_width + 0.5 - distance(at, start + span * part), 0.0, 1.0);
}
