// Fitted spheres, as tinted glass balls with their outline and three great circles. The ray through
// each pixel is intersected with the ball, which is therefore round at every size and from inside.

struct Corner {
    @builtin(position) position: vec4f,
    // Direction of the ray through the pixel, of any length; it starts at `begins`.
    @location(0) sight: vec3f,
    @location(1) @interpolate(flat) ball: vec4f,
    @location(2) begins: vec3f,
}

struct Pixel {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
}

@vertex
fn corner_of_sphere(
    @builtin(vertex_index) corner: u32,
    @location(0) centre: vec3f,
    @location(1) radius: f32,
) -> Corner {
    let right = select(-1.0, 1.0, corner == 1u || corner == 2u || corner == 4u);
    let high = select(-1.0, 1.0, corner == 2u || corner == 4u || corner == 5u);
    let to_centre = centre - scene.eye.xyz;
    let depth = dot(to_centre, scene.forward.xyz);
    let away = length(to_centre);
    var out: Corner;
    out.ball = vec4f(centre, radius);
    // Radius, at the centre and across the ray to it, of the cone that touches the ball. Near the
    // ball or inside, the whole canvas is covered instead.
    let reach = 1.02 * radius * away / sqrt(max(away * away - radius * radius, 1e-12));
    out.begins = scene.eye.xyz;
    if is_parallel() {
        let corner_at =
            centre + (scene.right.xyz * right + scene.up.xyz * high) * (1.02 * radius);
        out.begins = corner_at - scene.forward.xyz * depth;
        out.sight = scene.forward.xyz;
        let clip = scene.clip_from_scene * vec4f(corner_at, 1.0);
        out.position = vec4f(clip.xy, 0.5 * clip.w, clip.w);
    } else if away > 1.2 * radius && depth > 1.2 * radius {
        let forward = to_centre / away;
        let u = normalize(cross(forward, scene.up.xyz));
        let corner_at = centre + (u * right + cross(u, forward) * high) * reach;
        out.sight = corner_at - scene.eye.xyz;
        let clip = scene.clip_from_scene * vec4f(corner_at, 1.0);
        out.position = vec4f(clip.xy, 0.5 * clip.w, clip.w);
    } else {
        let half_size = 0.5 * scene.canvas.xy * scene.placement.xy * scene.canvas.w;
        let place = on_picture(vec2f(right, high)) * half_size;
        out.sight = scene.forward.xyz + scene.right.xyz * place.x + scene.up.xyz * place.y;
        out.position = vec4f(right, high, 0.5, 1.0);
    }
    return out;
}

@fragment
fn glass(in: Corner) -> Pixel {
    let sight = normalize(in.sight);
    let radius = in.ball.w;
    let from_centre = in.begins - in.ball.xyz;
    let middle = -dot(from_centre, sight);
    // Smallest distance of the ray from the centre.
    let miss = length(from_centre + sight * middle);
    let half_chord = sqrt(max(radius * radius - miss * miss, 0.0));
    let front = middle - half_chord;
    let along = select(middle + half_chord, front, front > 0.0);
    let point = in.begins + sight * along;
    let normal = (point - in.ball.xyz) / radius;
    let edge_on = 1.0 - abs(dot(normal, sight));

    let ratio = scene.canvas.z;
    let pixel = scale_depth(point) * scene.canvas.w;
    let inward = (radius - miss) / max(pixel, 1e-12);
    let outline = clamp(1.6 * ratio + 0.5 - inward, 0.0, 1.0);
    let steepness = max(fwidth(normal), vec3f(1e-6));
    let great_circles = clamp(0.6 * ratio + 0.5 - abs(normal) / steepness, vec3f(0.0), vec3f(1.0));
    let great_circle = max(great_circles.x, max(great_circles.y, great_circles.z));

    if miss > radius || along <= 0.0 || within_section(point) < 0.0 {
        discard;
    }
    var opacity = 0.035 + 0.28 * edge_on * edge_on * edge_on;
    opacity = max(opacity, 0.5 * great_circle * (1.0 - edge_on));
    opacity = max(opacity, 0.85 * outline) * clamp(inward, 0.0, 1.0);
    let clip = scene.clip_from_scene * vec4f(point, 1.0);
    var out: Pixel;
    out.colour = vec4f(scene.sphere.rgb, opacity * scene.sphere.a);
    out.depth = clamp(clip.z / clip.w, 0.0, 0.999999);
    return out;
}
