//! A still picture of the model as SVG, for a page that cannot draw yet: faces, edges, fitted
//! circles, handles and their pull lines, as in the first picture of the view, in the colours of
//! both themes.
//!
//! Faces are painted from the farthest to the nearest, each in one colour with its own edges. This
//! suits meshes of a few hundred faces that do not intersect.
//!
//! Attributes hold the data with which a script (`www/viewport/placeholder/placeholder-scene.js`)
//! animates the picture until the view draws: the eye, to draw the faces at other positions, and
//! the displacement of a dragged handle.

use super::circles::circles;
use super::light::face_colour;
use crate::view::appearance::{Colour, DARK, Dot, DotKind, LIGHT, LineKind, Palette, Stroke};
use crate::view::camera::Eye;
use crate::view::model::polygon_edges::undirected_sides;
use crate::view::picking::hidden;
use crate::view::state::ViewState;
use glam::{Vec2, Vec3, Vec4};
use std::collections::BTreeSet;
use std::fmt::{Display, Write};

/// Steps per colour component; positions are rounded to whole CSS pixels. The picture is replaced
/// so soon that the rounding is not noticed, and it halves the size.
const STEPS: f32 = 64.0;
/// Opacity of marks that the surface hides, as in the shaders of lines and dots.
const BEHIND: f32 = 0.38;
/// A surface hides a handle if it is in front by more than this fraction of the distance.
const NEAR: f32 = 0.02;

/// Returns the picture as an `svg` element of the size of the canvas, with the classes `still` and
/// `class`. [`style`] has the rest of its styling.
pub fn svg(state: &ViewState, class: &str) -> String {
    let [width, height] = state.camera().canvas.round().to_array();
    let eye = state.camera().eye();
    let mut svg = format!(
        r#"<svg class="still {class}" viewBox="0 0 {width} {height}" data-eye="{}">"#,
        spaced(rows_for_file(state, &eye).iter().flat_map(|row| row.to_array())),
    );
    let place = |point: Vec3| eye.project(point).0.round();
    let places: Vec<Vec2> = state.mesh().positions.iter().map(|&point| place(point)).collect();
    let rim = rim_of(state);
    for face in from_far_to_near(state) {
        let corners = state.mesh().faces.row(face as usize);
        let [light, dark] = [LIGHT, DARK]
            .map(|palette| (face_colour(state, face, &palette) * STEPS).round() / STEPS);
        let colour = themed(light.extend(1.0).to_array(), dark.extend(1.0).to_array());
        let outline = line(corners.iter().map(|&v| places[v as usize]));
        // Writing to a string cannot fail.
        let _ = write!(svg, r#"<path color="{colour}" d="{outline}z"/>"#);
        let on_rim: Vec<(usize, [u32; 2])> =
            undirected_sides(corners).enumerate().filter(|(_, ends)| rim.contains(ends)).collect();
        if !on_rim.is_empty() {
            let sides = spaced(on_rim.iter().map(|(side, _)| side));
            let ends = on_rim.iter().map(|(_, ends)| line(ends.map(|v| places[v as usize])));
            let rim: String = ends.collect();
            let _ = write!(svg, r#"<path class="rim" data-sides="{sides}" d="{rim}"/>"#);
        }
    }
    svg + &circles(state, &eye) + &handles(state, &eye) + "</svg>"
}

/// Returns the boundary edges.
pub(crate) fn rim_of(state: &ViewState) -> BTreeSet<[u32; 2]> {
    let boundary = state.mesh().edges.iter().filter(|edge| edge.boundary);
    boundary.map(|edge| edge.ends).collect()
}

/// Draws each handle with its target and the line between them.
fn handles(state: &ViewState, eye: &Eye) -> String {
    let mut svg = String::new();
    for (handle, target) in state.handles().iter().zip(state.targets()) {
        let point = state.mesh().positions[handle.vertex as usize];
        let (at, depth) = eye.project(point);
        let [right, down] = [Vec2::X, Vec2::Y].map(|pixel| eye.across(pixel, depth));
        let _ = write!(
            svg,
            r#"<g data-vertex="{}" data-right="{}" data-down="{}">"#,
            handle.vertex,
            spaced(right.to_array()),
            spaced(down.to_array()),
        );
        let opacity = if is_hidden(state, eye, handle.vertex) { BEHIND } else { 1.0 };
        if handle.kind != DotKind::Fixed {
            let to = eye.project(target).0.round();
            let Vec2 { x, y } = at.round();
            let pull = format!("M{x} {y}L{} {}", to.x, to.y);
            let _ = write!(svg, r#"<path class="pull" opacity="{opacity}" d="{pull}"/>"#);
            svg += &dot(DotKind::Target, 1.0, to);
        }
        svg += &dot(handle.kind, opacity, at.round());
        svg += "</g>";
    }
    svg
}

/// Returns the rows of the eye's projection for points in file coordinates.
fn rows_for_file(state: &ViewState, eye: &Eye) -> [Vec4; 3] {
    let centre = state.mesh().centre.as_vec3();
    eye.rows().map(|row| row.truncate().extend(row.w - row.truncate().dot(centre)))
}

/// Formats numbers as the text of an attribute.
pub fn spaced(values: impl IntoIterator<Item = impl Display>) -> String {
    values.into_iter().map(|value| value.to_string()).collect::<Vec<_>>().join(" ")
}

/// Returns the style sheet of still pictures, with the colours and widths of the view's palette.
/// Edges are lighter if all faces have colours of values.
pub fn style(has_full_map: bool) -> String {
    let edge = |palette: &Palette| {
        let mut stroke = palette.strokes[LineKind::Edge as usize];
        if has_full_map {
            stroke.colour = palette.edge_of_values;
        }
        let [r, g, b, a] = stroke.colour;
        let face = (100.0 * (1.0 - a)).round();
        format!("color-mix(in srgb,currentColor {face}%,{})", hex([r, g, b, 1.0]))
    };
    let mut style = format!(
        ".still path{{fill:currentColor;stroke:light-dark({},{});stroke-width:{};stroke-linejoin:round}}",
        edge(&LIGHT),
        edge(&DARK),
        LIGHT.strokes[LineKind::Edge as usize].width,
    );
    for (kind, class) in [(LineKind::Boundary, "rim"), (LineKind::Pull, "pull")] {
        let [Stroke { colour: light, width, .. }, Stroke { colour: dark, .. }] =
            [LIGHT, DARK].map(|palette| palette.strokes[kind as usize]);
        let _ = write!(
            style,
            ".still .{class}{{fill:none;stroke:{};stroke-width:{};stroke-linecap:round}}",
            themed(light, dark),
            width,
        );
    }
    let [light, dark] = [LIGHT, DARK].map(|palette| {
        let [r, g, b, _] = palette.circle.colour;
        [r, g, b, 1.0]
    });
    let Stroke { width, .. } = LIGHT.circle;
    let stroke = themed(light, dark);
    let _ = write!(style, ".still .circles{{fill:none;stroke:{stroke};stroke-width:{width}}}");
    for kind in [DotKind::Target, DotKind::Handle, DotKind::Fixed] {
        let [light, dark] = [LIGHT, DARK].map(|palette| palette.dots[kind as usize]);
        let _ = write!(
            style,
            ".still .{}{{fill:{};stroke:{};stroke-width:{}}}",
            dot_class(kind),
            themed(light.fill, dark.fill),
            themed(light.rim, dark.rim),
            light.rim_width,
        );
    }
    style
}

/// Returns the faces in painting order: the greatest mean depth of the corners first. The order
/// depends on the direction of view, not on the position of the eye.
pub fn from_far_to_near(state: &ViewState) -> Vec<u32> {
    let mesh = state.mesh();
    let forward = state.camera().eye().forward;
    let depth = |corners: &[u32]| {
        let sum: f32 = corners.iter().map(|&v| mesh.positions[v as usize].dot(forward)).sum();
        sum / corners.len().max(1) as f32
    };
    let mut faces: Vec<(f32, u32)> = mesh.faces.iter().map(depth).zip(0..).collect();
    faces.sort_by(|a, b| b.0.total_cmp(&a.0));
    faces.into_iter().map(|(_, face)| face).collect()
}

/// Returns whether the surface hides a mark. Marks are drawn in front of near surfaces.
pub(crate) fn is_hidden(state: &ViewState, eye: &Eye, vertex: u32) -> bool {
    let point = state.mesh().positions[vertex as usize];
    let from = eye.seen_from(point);
    hidden(state.mesh(), from, vertex, eye.scale_depth((point - from).length()) * NEAR, |_| true)
}

/// Returns the path data of a polyline: the first point absolute, the others relative.
pub(crate) fn line(places: impl IntoIterator<Item = Vec2>) -> String {
    let mut data = String::new();
    let mut last = None;
    for place in places {
        let Vec2 { x, y } = place - last.unwrap_or_default();
        let letter = if last.is_none() {
            "M"
        } else if data.contains('l') {
            " "
        } else {
            "l"
        };
        let between = if y < 0.0 { "" } else { " " };
        let letter = if letter == " " && x < 0.0 { "" } else { letter };
        let _ = write!(data, "{letter}{x}{between}{y}");
        last = Some(place);
    }
    data
}

fn dot(kind: DotKind, opacity: f32, at: Vec2) -> String {
    let Dot { radius, rim_width, square, .. } = LIGHT.dots[kind as usize];
    let radius = radius - 0.5 * rim_width;
    let (class, Vec2 { x, y }) = (dot_class(kind), at);
    if square > 0.0 {
        let (left, top, side) = (x - radius, y - radius, 2.0 * radius);
        return format!(
            r#"<rect class="{class}" opacity="{opacity}" x="{left}" y="{top}" width="{side}" height="{side}" rx="2"/>"#
        );
    }
    format!(r#"<circle class="{class}" opacity="{opacity}" cx="{x}" cy="{y}" r="{radius}"/>"#)
}

fn dot_class(kind: DotKind) -> &'static str {
    match kind {
        DotKind::Target => "target",
        DotKind::Fixed => "fixed",
        _ => "handle",
    }
}

pub(crate) fn themed(light: Colour, dark: Colour) -> String {
    let [light, dark] = [light, dark].map(hex);
    if light == dark { light } else { format!("light-dark({light},{dark})") }
}

fn hex(colour: Colour) -> String {
    let [r, g, b, a] = colour.map(|part| (part * 255.0).round() as u8);
    if a == 255 {
        format!("#{r:02x}{g:02x}{b:02x}")
    } else {
        format!("#{r:02x}{g:02x}{b:02x}{a:02x}")
    }
}
