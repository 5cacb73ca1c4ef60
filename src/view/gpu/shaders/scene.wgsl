// Shared by all primitives: the uniform block, and the tables from which vertices are pulled.
// WebGL2 has no storage buffers, so the tables are textures, 1024 texels wide.

struct Stroke {
    colour: vec4f,
    // Width in CSS pixels; for circles the number of segments; width of the casing; factor of the
    // opacity where the surface hides the line.
    size: vec4f,
}

struct Dot {
    fill: vec4f,
    rim: vec4f,
    // Radius and rim width in CSS pixels, 1 for a square, unused.
    size: vec4f,
}

struct Scene {
    clip_from_scene: mat4x4f,
    // w: the depth that sets the scale everywhere in parallel projection, else 0.
    eye: vec4f,
    right: vec4f,
    up: vec4f,
    forward: vec4f,
    // Up direction; w: height of the ground along it.
    sky: vec4f,
    // Width and height in pixels, pixels per CSS pixel, length of a pixel at depth 1.
    canvas: vec4f,
    // From clip coordinates of the picture to those of the canvas: factors, then offsets.
    placement: vec4f,
    // Near depth, far minus near depth, reach of the occlusion, strength of the occlusion.
    nearby: vec4f,
    // Section: points with dot(point, xyz) <= w are kept.
    section: vec4f,
    material: vec4f,
    shade: vec4f,
    no_value: vec4f,
    selected: vec4f,
    tint: vec4f,
    sphere: vec4f,
    // The surface of the ghost or of the layer.
    ghost: vec4f,
    // Dark squares of the checkerboard; the opacity is the fraction mixed into a face.
    check: vec4f,
    // Squares of the checkerboard per unit of length, 0 for none. Then, if vertices have values, in
    // steps from a band limit: start and end of the range, and the tolerance; else 0.
    checks: vec4f,
    // Background, at the top and the bottom of the picture.
    behind_top: vec4f,
    behind_bottom: vec4f,
    // Shadow on the ground; its opacity applies where all light is blocked.
    shadow: vec4f,
    // Factor of the light on back faces.
    back: vec4f,
    circle: Stroke,
    strokes: array<Stroke, 17>,
    dots: array<Dot, 10>,
}

@group(0) @binding(0) var<uniform> scene: Scene;
@group(0) @binding(1) var positions: texture_2d<f32>;
@group(0) @binding(2) var vertex_normals: texture_2d<f32>;
@group(0) @binding(3) var face_normals: texture_2d<f32>;
@group(0) @binding(4) var face_looks: texture_2d<f32>;
// Row 0: the full map of values. Row 1: the colours of the rows of constraints. Row 2: the same,
// for projections. Row 3: the map of values beyond a tolerance.
@group(0) @binding(5) var colour_map: texture_2d<f32>;
// Positions of the vertices on the checkerboard.
@group(0) @binding(6) var uv: texture_2d<f32>;

fn texel(index: u32) -> vec2u {
    return vec2u(index & 1023u, index >> 10u);
}

// Colour of a row of constraints; its opacity is the fraction mixed into a face.
fn colour_of_row(index: u32) -> vec4f {
    return textureLoad(colour_map, vec2u(index, 1u), 0);
}

fn position_of(vertex: u32) -> vec3f {
    return textureLoad(positions, texel(vertex), 0).xyz;
}

fn is_parallel() -> bool {
    return scene.eye.w > 0.0;
}

// Depth that determines the size on the screen at a point.
fn scale_depth(point: vec3f) -> f32 {
    if is_parallel() {
        return scene.eye.w;
    }
    return dot(point - scene.eye.xyz, scene.forward.xyz);
}

// Unit vector from a point towards the eye.
fn to_eye_from(point: vec3f) -> vec3f {
    if is_parallel() {
        return -scene.forward.xyz;
    }
    return normalize(scene.eye.xyz - point);
}

// Moves a point towards the eye by a fraction of its distance; its screen position stays.
fn nearer(point: vec3f, part: f32) -> vec3f {
    if is_parallel() {
        return point - scene.forward.xyz * (part * scene.eye.w);
    }
    return mix(point, scene.eye.xyz, part);
}

// Distance from the section plane, negative where the section cuts off.
fn within_section(point: vec3f) -> f32 {
    return scene.section.w - dot(point, scene.section.xyz);
}

// Converts clip coordinates of the canvas to those of the picture.
fn on_picture(at: vec2f) -> vec2f {
    return (at - scene.placement.zw) / scene.placement.xy;
}
