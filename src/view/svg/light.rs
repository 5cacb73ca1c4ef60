//! The colour of a face without a GPU, as `shaders/faces.wgsl` computes it for the centre of the
//! face. A page test compares the still picture, which uses these colours, with the view.

use crate::view::appearance::{Colour, FaceColour, Palette, row_colours};
use crate::view::camera::Eye;
use crate::view::state::ViewState;
use glam::Vec3;

/// Returns the sRGB colour at the centre of a face, components from 0 to 1, without marks.
pub fn face_colour(state: &ViewState, face: u32, palette: &Palette) -> Vec3 {
    let (light, is_front) = light_on(state, face);
    let modelled = 0.68 + (1.05 - 0.68) * light;
    let side = if is_front { Vec3::ONE } else { rgb(palette.back) };
    let plain = rgb(palette.shade).lerp(rgb(palette.material), light) * side;
    let colour = match state.appearance().colour_of(face as usize) {
        FaceColour::Plain => plain,
        FaceColour::Row(colour) => {
            let row = Vec3::from(state.appearance().rows.palette[usize::from(colour) - 1]);
            plain.lerp(row * modelled, row_colours::STRENGTH)
        }
        FaceColour::NoValue => rgb(palette.no_value) * modelled,
        FaceColour::Value(texel) | FaceColour::Beyond(texel) => {
            state.appearance().map().colour(texel) * modelled
        }
    };
    colour.min(Vec3::ONE)
}

fn rgb([r, g, b, _]: Colour) -> Vec3 {
    Vec3::new(r, g, b)
}

/// How far the light wraps around beyond the terminator.
const WRAP: f32 = 0.3;

/// Returns the light on a face, from 0 (shade) to 1 (full light), and whether its front is seen.
fn light_on(state: &ViewState, face: u32) -> (f32, bool) {
    let mesh = state.mesh();
    let corners = mesh.faces.row(face as usize);
    let mean = |values: &[Vec3]| {
        corners.iter().map(|&v| values[v as usize]).sum::<Vec3>() / corners.len().max(1) as f32
    };
    let Eye { at: eye, right, up, forward, .. } = state.camera().eye();
    let to_eye = (eye - mean(&mesh.positions)).normalize();
    let flat = mesh.normals.faces[face as usize];
    let outwards = if flat.length_squared() < 0.5 { to_eye } else { flat };
    let normal = towards(outwards, to_eye);
    let soft = towards(mean(&mesh.normals.vertices), normal);
    let bent = (normal + 0.4 * soft).normalize();
    let key = (up * 0.78 - right * 0.58 - forward * 0.40).normalize();
    let [_, _, sky] = state.camera().up.axes();
    let wrapped = ((bent.dot(key) + WRAP) / (1.0 + WRAP)).max(0.0);
    let from_sky = 0.5 + 0.5 * bent.dot(sky);
    let from_eye = bent.dot(to_eye).max(0.0);
    let light = (0.62 * wrapped + 0.22 * from_sky + 0.24 * from_eye).clamp(0.0, 1.0);
    (light, outwards.dot(to_eye) >= 0.0)
}

/// Returns the vector or its opposite, whichever is on the side of `side`.
fn towards(vector: Vec3, side: Vec3) -> Vec3 {
    if vector.dot(side) >= 0.0 { vector } else { -vector }
}
