// What all primitives share: the scene's numbers, and tables from which vertices are pulled.
// WebGL2 has no storage buffers, so the tables are textures, 1024 texels wide.

struct Stroke {
    colour: vec4f,
    // Width in CSS pixels; for circles the number of pieces; width of the casing; what is left of the
    // opacity where the surface hides it.
    size: vec4f,
}

struct Dot {
    fill: vec4f,
    rim: vec4f,
    // Radius and rim width in CSS pixels, 1 for a square, then nothing.
    size: vec4f,
}

struct Scene {
    clip_from_scene: mat4x4f,
    // Then in parallel projection the depth whose scale everything has, else 0.
    eye: vec4f,
    right: vec4f,
    up: vec4f,
    forward: vec4f,
    // To the sky, then how high the lowest point of the model is along it.
    sky: vec4f,
    // Width and height in pixels, pixels per CSS pixel, length of a pixel at depth 1.
    canvas: vec4f,
    // From clip coordinates of the picture to those of the canvas: factors, then what is added.
    placement: vec4f,
    // Near depth, from there to the far depth, and how far away things keep light off each other.
    nearby: vec4f,
    // The half space that is kept: its points times the first three are at most the fourth.
    section: vec4f,
    material: vec4f,
    shade: vec4f,
    no_value: vec4f,
    selected: vec4f,
    tint: vec4f,
    sphere: vec4f,
    // The surface of the ghost, or of the layer.
    ghost: vec4f,
    // Colour of the dark squares of the checkerboard; its opacity is how much is mixed into a face.
    check: vec4f,
    // Squares of the checkerboard along a unit of length, 0 for none; then, where vertices have values
    // in steps, how many steps from a limit the range begins and ends, and where the tolerance is, else 0.
    checks: vec4f,
    // Behind everything, from the top of the picture to its bottom.
    behind_top: vec4f,
    behind_bottom: vec4f,
    // On the ground; its opacity is that where all light is kept off.
    shadow: vec4f,
    // The light of faces that are seen from behind is multiplied by this.
    back: vec4f,
    circle: Stroke,
    strokes: array<Stroke, 16>,
    dots: array<Dot, 10>,
}

@group(0) @binding(0) var<uniform> scene: Scene;
@group(0) @binding(1) var positions: texture_2d<f32>;
@group(0) @binding(2) var vertex_normals: texture_2d<f32>;
@group(0) @binding(3) var face_normals: texture_2d<f32>;
@group(0) @binding(4) var face_looks: texture_2d<f32>;
// Row 0: the full map of values. Row 1: the colours of the rows of constraints. Row 2: the same, for
// projections. Row 3: the map of values beyond a tolerance.
@group(0) @binding(5) var colour_map: texture_2d<f32>;
// Where the vertices are on the checkerboard.
@group(0) @binding(6) var places: texture_2d<f32>;

fn texel(index: u32) -> vec2u {
    return vec2u(index & 1023u, index >> 10u);
}

// Its opacity is how much of it is mixed into a face.
fn colour_of_row(place: u32) -> vec4f {
    return textureLoad(colour_map, vec2u(place, 1u), 0);
}

fn position_of(vertex: u32) -> vec3f {
    return textureLoad(positions, texel(vertex), 0).xyz;
}

fn is_parallel() -> bool {
    return scene.eye.w > 0.0;
}

// The depth that decides how large things are at a point.
fn scale_depth(point: vec3f) -> f32 {
    if is_parallel() {
        return scene.eye.w;
    }
    return dot(point - scene.eye.xyz, scene.forward.xyz);
}

// From a point towards the eye.
fn to_eye_from(point: vec3f) -> vec3f {
    if is_parallel() {
        return -scene.forward.xyz;
    }
    return normalize(scene.eye.xyz - point);
}

// A point that comes towards the eye by a part of its distance: its place on the screen stays.
fn nearer(point: vec3f, part: f32) -> vec3f {
    if is_parallel() {
        return point - scene.forward.xyz * (part * scene.eye.w);
    }
    return mix(point, scene.eye.xyz, part);
}

// How far a point is on the side of the section plane that is kept; less than nothing where it is cut off.
fn within_section(point: vec3f) -> f32 {
    return scene.section.w - dot(point, scene.section.xyz);
}

// Where a place in clip coordinates of the canvas is in those of the picture.
fn on_picture(at: vec2f) -> vec2f {
    return (at - scene.placement.zw) / scene.placement.xy;
}
