// The background: a gradient over the whole picture, and the shadow on the ground.

struct Behind {
    @builtin(position) position: vec4f,
    // 0 at the bottom of the picture, 1 at its top.
    @location(0) height: f32,
}

@vertex
fn corner_of_picture(@location(0) at: vec2f) -> Behind {
    var out: Behind;
    out.position = vec4f(at, 0.5, 1.0);
    out.height = 0.5 + 0.5 * on_picture(at).y;
    return out;
}

@fragment
fn gradient(in: Behind) -> @location(0) vec4f {
    let colour = mix(scene.behind_bottom.rgb, scene.behind_top.rgb, in.height);
    // Dithering by less than one step of eight bits, so that the gradient has no visible stripes.
    let noise = fract(52.9829189 * fract(dot(in.position.xy, vec2f(0.06711056, 0.00583715))));
    return vec4f(colour + (noise - 0.5) / 255.0, 1.0);
}

struct Ground {
    @builtin(position) position: vec4f,
    // Fraction of the light that is blocked.
    @location(0) dark: f32,
}

// A cell of the ground: its corner and side length, and the darkness at its corners.
@vertex
fn corner_of_cell(
    @builtin(vertex_index) corner: u32,
    @location(0) cell: vec4f,
    @location(1) dark: vec4f,
) -> Ground {
    let right = corner == 1u || corner == 3u || corner == 4u;
    let away = corner == 2u || corner == 4u || corner == 5u;
    let along = select(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0), scene.sky.y > 0.5);
    let at = cell.xyz + cell.w * (vec3f(select(0.0, 1.0, right), 0.0, 0.0) + select(0.0, 1.0, away) * along);
    var out: Ground;
    out.position = scene.clip_from_scene * vec4f(at, 1.0);
    // Always behind the model, and not clipped at its far depth.
    out.position.z = 0.5 * out.position.w;
    out.dark = mix(mix(dark.x, dark.y, f32(right)), mix(dark.z, dark.w, f32(right)), f32(away));
    // The ground is not drawn from below.
    if dot(to_eye_from(at), scene.sky.xyz) <= 0.0 {
        out.dark = 0.0;
    }
    return out;
}

@fragment
fn shadow(in: Ground) -> @location(0) vec4f {
    return vec4f(scene.shadow.rgb, scene.shadow.a * in.dark);
}
