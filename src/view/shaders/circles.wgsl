// Fitted circles, as thin lines of 48 pieces.

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,
    @location(1) @interpolate(flat) ends: vec4f,
}

fn half_width() -> f32 {
    return 0.5 * scene.circle.size.x * scene.canvas.z;
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
    let step = 6.283185307 / 48.0;
    let start = f32(index / 6u) * step;
    let end = f32((index / 6u + 1u) % 48u) * step;
    let a = centre + u * cos(start) + v * sin(start);
    let b = centre + u * cos(end) + v * sin(end);
    let quad = stroke_corner(a, b, index % 6u, half_width());
    var out: Corner;
    out.position = quad.position;
    out.at = quad.at;
    out.ends = vec4f(quad.start, quad.end);
    return out;
}

@fragment
fn drawn(in: Corner) -> @location(0) vec4f {
    let coverage = stroke_coverage(in.at, in.ends.xy, in.ends.zw, half_width());
    return vec4f(scene.circle.colour.rgb, scene.circle.colour.a * coverage);
}
