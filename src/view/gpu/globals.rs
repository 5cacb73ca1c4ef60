//! The uniform block of all shaders: camera, canvas, colours. The order is that of `Scene` in
//! `shaders/scene.wgsl`, in groups of four numbers.

use super::placement::Placement;
use crate::view::appearance::{Colour, DOT_KINDS, Dot, DotKind, LINE_KINDS, LineKind, Stroke};
use crate::view::state::ViewState;
use glam::{Mat4, Vec3, Vec4};

/// Total number of numbers.
pub const NUMBERS: usize = 16 + 4 * (5 + 1 + 7 + 2 + 4 + 3) + 8 + 8 * LINE_KINDS + 12 * DOT_KINDS;

/// Reach of the occlusion, as a fraction of the size of the model.
const REACH: f32 = 0.26;

/// Returns the numbers for a picture at `placement`, with a veil of this colour.
pub fn numbers(state: &ViewState, veil: Colour, placement: Placement) -> Vec<f32> {
    let camera = state.camera();
    let eye = camera.eye();
    let palette = state.palette();
    let ratio = placement.size.0 as f32 / camera.canvas.x;
    let [x, y, right, up] = placement.transform();
    let (near, far) = state.depth_range();
    let [_, _, sky] = camera.up.axes();
    let [r, g, b] = state.appearance().tint_colour;

    let mut numbers = Vec::with_capacity(NUMBERS);
    let onto_canvas = Mat4::from_cols(
        Vec4::new(x, 0.0, 0.0, 0.0),
        Vec4::new(0.0, y, 0.0, 0.0),
        Vec4::Z,
        Vec4::new(right, up, 0.0, 1.0),
    );
    numbers.extend((onto_canvas * camera.clip_from_scene(near, far)).to_cols_array());
    numbers.extend(eye.at.extend(eye.parallel.unwrap_or(0.0)).to_array());
    for axis in [eye.right, eye.up, eye.forward] {
        numbers.extend(Vec3::extend(axis, 0.0).to_array());
    }
    numbers.extend(sky.extend(state.floor()).to_array());
    let pixel = 1.0 / (eye.focal * ratio);
    let (width, height) = placement.canvas;
    numbers.extend(Vec4::new(width as f32, height as f32, ratio, pixel).to_array());
    numbers.extend([x, y, right, up]);
    numbers.extend([near, far - near, REACH * state.size(), state.occlusion()]);
    numbers.extend(camera.section.map_or(NO_SECTION, |section| section.numbers()).to_array());
    for colour in [palette.material, palette.shade, palette.no_value, palette.selected] {
        numbers.extend(colour);
    }
    numbers.extend([r, g, b, TINT_STRENGTH]);
    numbers.extend(palette.sphere);
    numbers.extend(veil);
    numbers.extend(palette.check);
    let [begins, ends] = state.appearance().corner_steps().unwrap_or_default();
    let tolerance = state.appearance().tolerance_in_steps();
    numbers.extend([state.checks().per_length, begins, ends, tolerance]);
    let behind = state.background();
    let above = if state.has_plain_background() { behind } else { palette.backdrop };
    for colour in [above, behind, palette.shadow, palette.back] {
        numbers.extend(colour);
    }
    extend_stroke(&mut numbers, &palette.circle, state.circle_pieces());
    let mut strokes = palette.strokes;
    if state.checks().per_length > 0.0 {
        strokes[LineKind::Edge as usize].colour = palette.edge_of_checks;
    } else if state.appearance().has_full_map() {
        strokes[LineKind::Edge as usize].colour = palette.edge_of_values;
    }
    for kind in [LineKind::Larger, LineKind::Smaller] {
        strokes[kind as usize].colour = state.colour_over_surface(kind);
    }
    for stroke in &strokes {
        extend_stroke(&mut numbers, stroke, 1);
    }
    let mut dots = palette.dots;
    dots[DotKind::Tinted as usize].fill = [r, g, b, 1.0];
    for Dot { fill, rim, radius, rim_width, square } in dots {
        numbers.extend(fill);
        numbers.extend(rim);
        numbers.extend([radius, rim_width, square, 0.0]);
    }
    numbers
}

/// A half space that contains every point.
const NO_SECTION: Vec4 = Vec4::new(0.0, 0.0, 0.0, 1.0);

/// Fraction of the tint that is mixed into a face.
const TINT_STRENGTH: f32 = 0.55;

fn extend_stroke(numbers: &mut Vec<f32>, stroke: &Stroke, pieces: u32) {
    numbers.extend(stroke.colour);
    numbers.extend([stroke.width, pieces as f32, stroke.casing, stroke.hidden]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::gpu::FACES;

    #[test]
    fn there_are_as_many_numbers_as_the_shaders_read() {
        let numbers = numbers(&ViewState::default(), [0.0; 4], Placement::whole((800, 400)));
        assert_eq!(numbers.len(), NUMBERS);
        let module = naga::front::wgsl::parse_str(&FACES.concat()).unwrap();
        let mut types = module.types.iter().map(|(_, own)| own);
        let scene = types.find(|own| own.name.as_deref() == Some("Scene")).unwrap();
        let naga::TypeInner::Struct { span, .. } = scene.inner else { panic!("{scene:?}") };
        assert_eq!(span as usize, NUMBERS * size_of::<f32>());
    }
}
