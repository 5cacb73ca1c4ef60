//! The geometry of the gizmo: arrows with the letters of their axes, and squares, as triangles.
//!
//! Each part has a casing below it, so that it is visible on any mesh. The part under the pointer
//! is drawn heavier; while it is held, the others are drawn fainter.

use super::drag_constraint::DragDirection;
use super::{Gizmo, GizmoState, Part};
use crate::view::appearance::{Colour, Palette};
use glam::Vec2;

/// Widths in CSS pixels: shaft of an arrow, outline of a square, strokes of a letter.
const SHAFT: f32 = 2.4;
const OUTLINE: f32 = 1.6;
const LETTER: f32 = 1.7;
/// Width of the casing on each side.
const CASING: f32 = 1.3;
/// Factor of the width of a highlighted part.
const HIGHLIGHT: f32 = 1.6;
/// Opacity of the inside of a square, plain and highlighted.
const FILL: [f32; 2] = [0.32, 0.72];
/// Factor of the opacity of parts that are not dragged.
const FADED: f32 = 0.22;
/// Length and half width of an arrow's head.
const HEAD: Vec2 = Vec2::new(13.0, 5.0);
/// Distance from the tip to the centre of the letter.
const TO_LETTER: f32 = 11.0;
/// Strokes of the letters x, y and z; y points down.
const LETTERS: [&[[f32; 4]]; 3] = [
    &[[-3.0, -4.0, 3.0, 4.0], [-3.0, 4.0, 3.0, -4.0]],
    &[[-3.2, -4.0, 0.0, 0.2], [3.2, -4.0, 0.0, 0.2], [0.0, 0.2, 0.0, 4.0]],
    &[[-3.0, -4.0, 3.0, -4.0], [3.0, -4.0, -3.0, 4.0], [-3.0, 4.0, 3.0, 4.0]],
];

/// A corner of a triangle: x and y in CSS pixels, and a colour.
pub type Corner = [f32; 6];

/// Returns all triangles, in drawing order.
pub fn triangles(gizmo: &Gizmo, wanted: &GizmoState, palette: &Palette) -> Vec<Corner> {
    let mut parts: Vec<&Part> = gizmo.parts.iter().filter(|part| part.strength > 0.0).collect();
    let is_arrow = |part: &Part| matches!(part.direction, DragDirection::Axis(_));
    parts.sort_by(|a, b| is_arrow(a).cmp(&is_arrow(b)).then(b.depth.total_cmp(&a.depth)));
    let mut drawing = Drawing::default();
    for part in parts {
        let highlighted = wanted.highlighted == Some(part.direction);
        let back = if wanted.held && !highlighted { FADED } else { 1.0 };
        drawing.opacity = part.strength * back;
        let width = if highlighted { HIGHLIGHT } else { 1.0 };
        match part.direction {
            DragDirection::Axis(axis) => {
                drawing.arrow(part, axis, width, [palette.axis_casing, palette.axes[axis]]);
            }
            DragDirection::Plane(axis) => {
                let fill = FILL[usize::from(highlighted)];
                drawing.square(part, fill, width, [palette.axis_casing, palette.axes[axis]]);
            }
            DragDirection::Screen => {}
        }
    }
    drawing.corners
}

#[derive(Default)]
struct Drawing {
    corners: Vec<Corner>,
    opacity: f32,
}

impl Drawing {
    fn triangle(&mut self, points: [Vec2; 3], [r, g, b, a]: Colour) {
        let alpha = a * self.opacity;
        self.corners.extend(points.map(|at| [at.x, at.y, r, g, b, alpha]));
    }

    fn line(&mut self, from: Vec2, to: Vec2, width: f32, colour: Colour) {
        let along = (to - from).normalize_or(Vec2::X) * (0.5 * width);
        let aside = along.perp();
        let [a, b] = [from - along, to + along];
        self.triangle([a - aside, b - aside, b + aside], colour);
        self.triangle([a - aside, b + aside, a + aside], colour);
    }

    fn arrow(&mut self, part: &Part, axis: usize, width: f32, [casing, colour]: [Colour; 2]) {
        let [start, tip] = part.corners[..] else { return };
        let span = tip - start;
        let along = span.normalize_or(Vec2::NEG_Y);
        // A head longer than its arrow would cover the handle.
        let scale = (span.length() / HEAD.x).min(1.0) * (0.5 + 0.5 * width);
        let head = HEAD * scale;
        let neck = tip - along * head.x;
        for (extra, colour) in [(CASING, casing), (0.0, colour)] {
            let grown = 1.0 + 2.0 * extra / HEAD.x;
            let aside = along.perp() * (head.y * grown + extra);
            let base = neck - along * extra;
            self.line(start, neck, SHAFT * width + 2.0 * extra, colour);
            self.triangle([base - aside, tip + along * (1.6 * extra), base + aside], colour);
        }
        let middle = tip + along * TO_LETTER;
        for (extra, colour) in [(CASING, casing), (0.0, colour)] {
            for &[x, y, to_x, to_y] in LETTERS[axis] {
                let [from, to] = [Vec2::new(x, y), Vec2::new(to_x, to_y)].map(|at| middle + at);
                self.line(from, to, LETTER * width.min(1.3) + 2.0 * extra, colour);
            }
        }
    }

    fn square(&mut self, part: &Part, fill: f32, width: f32, [casing, colour]: [Colour; 2]) {
        let [a, b, c, d] = part.corners[..] else { return };
        let sides = [[a, b], [b, c], [c, d], [d, a]];
        for [from, to] in sides {
            self.line(from, to, OUTLINE * width + 2.0 * CASING, casing);
        }
        let [red, green, blue, _] = colour;
        self.triangle([a, b, c], [red, green, blue, fill]);
        self.triangle([a, c, d], [red, green, blue, fill]);
        for [from, to] in sides {
            self.line(from, to, OUTLINE * width, colour);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::appearance::{DARK, LIGHT};
    use crate::view::camera::Camera;
    use glam::Vec3;

    #[test]
    fn all_parts_are_drawn_near_the_gizmo_and_what_is_not_held_steps_back() {
        let canvas = Vec2::new(1000.0, 800.0);
        let gizmo = Gizmo::new(&Camera { canvas, ..Camera::default() }, Vec3::ZERO, false).unwrap();
        for palette in [&LIGHT, &DARK] {
            let shown = triangles(&gizmo, &GizmoState::default(), palette);
            assert_eq!(shown.len() % 3, 0);
            for colour in palette.axes {
                let [r, g, b, _] = colour;
                assert!(shown.iter().any(|corner| corner[2..] == [r, g, b, 1.0]), "{colour:?}");
            }
            let limit = gizmo.sizes.length + 30.0;
            let near =
                |corner: &Corner| Vec2::new(corner[0], corner[1]).distance(gizmo.middle) < limit;
            assert!(shown.iter().all(near));
            let held = GizmoState {
                highlighted: Some(DragDirection::Axis(2)),
                held: true,
                ..GizmoState::default()
            };
            let opaque = |wanted| {
                let corners = triangles(&gizmo, wanted, palette);
                corners.iter().filter(|corner| corner[5] == 1.0).count()
            };
            assert!(opaque(&held) > 0);
            assert!(opaque(&held) < opaque(&GizmoState::default()));
        }
    }
}
