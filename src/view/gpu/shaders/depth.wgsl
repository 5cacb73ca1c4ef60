// Depths in the textures of the occlusion passes, as two bytes: from 0 at the near depth of the
// scene to 1 at the far depth, where there is nothing.

// The result of the previous pass, smaller than the picture.
@group(1) @binding(0) var previous: texture_2d<f32>;

fn depth_part(at: vec3f) -> f32 {
    let depth = dot(at - scene.eye.xyz, scene.forward.xyz);
    return clamp((depth - scene.nearby.x) / scene.nearby.y, 0.0, 1.0);
}

fn packed(depth: f32) -> vec2f {
    let steps = round(clamp(depth, 0.0, 1.0) * 65535.0);
    let high = floor(steps / 256.0);
    return vec2f(high, steps - 256.0 * high) / 255.0;
}

fn unpacked(bytes: vec2f) -> f32 {
    return dot(round(bytes * 255.0), vec2f(256.0, 1.0)) / 65535.0;
}
