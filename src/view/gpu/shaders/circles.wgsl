// Fitted circles, as thin lines of many segments. They are lifted in front of the faces to which
// they are fitted, which are not flat yet.

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,
    @location(1) @interpolate(flat) ends: vec4f,
    @location(2) @interpolate(flat) half_width: f32,
    @location(3) @interpolate(flat) opacity: f32,
}

@vertex
fn corner_of_circle(
    @builtin(vertex_index) index: u32,
    @location(0) centre: vec3f,
    @location(1) normal: vec3f,
    @location(2) radius: f32,
) -> Corner {
    let across = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), abs(normal.x) > 0.6);
    let u = normalize(cross(normal, across)) * radius;
    let v = cross(normal, u);
    let pieces = scene.circle.size.y;
    let piece = f32(index / 6u);
    let start = piece / pieces * 6.283185307;
    // The last segment ends exactly where the first began.
    let end = select((piece + 1.0) / pieces * 6.283185307, 0.0, piece + 1.5 > pieces);
    let a = centre + u * cos(start) + v * sin(start);
    let b = centre + u * cos(end) + v * sin(end);
    // Circles of a few pixels are thinner and fainter, down to nothing, as many would be one patch.
    let depth = max(scale_depth(centre), 1e-12);
    // So are circles seen nearly edge-on, whose rows are as close as they are narrow.
    let facing = abs(dot(normal, to_eye_from(centre)));
    let radius_on_screen =
        radius * mix(0.15, 1.0, facing) / (depth * scene.canvas.w * scene.canvas.z);
    let fineness = clamp(radius_on_screen / 14.0, 0.5, 1.0);
    let half_width = 0.5 * scene.circle.size.x * scene.canvas.z * fineness;
    let lift = LIFT + min(0.12 * radius / depth, 0.1);
    let quad = cut_stroke_corner(a, b, index % 6u, half_width, lift);
    var out: Corner;
    out.position = quad.position;
    out.at = quad.at;
    out.ends = vec4f(quad.start, quad.end);
    out.half_width = half_width;
    out.opacity = scene.circle.colour.a * clamp((radius_on_screen - 2.0) / 18.0, 0.0, 1.0);
    return out;
}

@fragment
fn drawn(in: Corner) -> @location(0) vec4f {
    // Where two segments meet, each fades out: overlaps would look like beads.
    let span = in.ends.zw - in.ends.xy;
    let total = max(length(span), 1e-4);
    let along = dot(in.at - in.ends.xy, span) / total;
    let own = min(clamp(along + 0.5, 0.0, 1.0), clamp(total - along + 0.5, 0.0, 1.0));
    let coverage = own * stroke_coverage(in.at, in.ends.xy, in.ends.zw, in.half_width);
    return vec4f(scene.circle.colour.rgb, in.opacity * coverage);
}
