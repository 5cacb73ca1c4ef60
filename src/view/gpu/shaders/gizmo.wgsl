// The gizmo: triangles in CSS pixels, over everything.

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) colour: vec4f,
}

@vertex
fn corner_of_gizmo(@location(0) at: vec2f, @location(1) colour: vec4f) -> Corner {
    let on_canvas = at * scene.canvas.z / (0.5 * scene.canvas.xy) - vec2f(1.0);
    var out: Corner;
    out.position = vec4f(on_canvas.x, -on_canvas.y, 0.0, 1.0);
    out.colour = colour;
    return out;
}

@fragment
fn drawn(in: Corner) -> @location(0) vec4f {
    return in.colour;
}
