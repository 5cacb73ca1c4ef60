//! A still picture of a stage as SVG: what a page shows before it can draw. Faces, edges, handles
//! and the lines that pull them, as the view draws them in its first picture, in the colours of
//! both themes.
//!
//! Faces are painted from the farthest to the nearest, each in one colour with its own edges. So it
//! is a picture for meshes of a few hundred faces that do not cut through each other.

use super::camera::Eye;
use super::light::face_colour;
use super::palette::{Colour, DARK, Dot, DotKind, LIGHT, LineKind, Palette, Stroke};
use super::ray::hidden;
use super::stage::Stage;
use glam::{Vec2, Vec3};
use std::fmt::Write;

/// Colours of faces are rounded to so many steps per part, places to whole CSS pixels: nobody sees it
/// in a picture that is replaced at once, and it is half of the size.
const STEPS: f32 = 64.0;
/// Opacity of what the surface hides, as in the shaders of lines and dots.
const BEHIND: f32 = 0.38;
/// What hides a mark by less than this part of its distance from the eye does not hide it.
const NEAR: f32 = 0.02;

/// The stage as an `svg` element of the size of its canvas, with the classes `still` and `class`.
/// [`style`] has the rest of its looks.
pub fn svg(stage: &Stage, class: &str) -> String {
    let [width, height] = stage.camera.canvas.round().to_array();
    let mut svg = format!(r#"<svg class="still {class}" viewBox="0 0 {width} {height}">"#);
    let eye = stage.camera.eye();
    let place = |point: Vec3| eye.project(point).0.round();
    let places: Vec<Vec2> = stage.subject.positions.iter().map(|&point| place(point)).collect();
    let rim = rim_of(stage);
    for face in from_far_to_near(stage, &eye) {
        let corners = stage.subject.faces.row(face as usize);
        let [light, dark] = [LIGHT, DARK]
            .map(|palette| (face_colour(stage, face, &palette) * STEPS).round() / STEPS);
        let colour = themed(light.extend(1.0).to_array(), dark.extend(1.0).to_array());
        let outline = line(corners.iter().map(|&v| places[v as usize]));
        // Writing to a string cannot fail.
        let _ = write!(svg, r#"<path color="{colour}" d="{outline}z"/>"#);
        let rim: String = sides(corners)
            .filter(|side| rim.binary_search(side).is_ok())
            .map(|side| line(side.map(|v| places[v as usize])))
            .collect();
        if !rim.is_empty() {
            let _ = write!(svg, r#"<path class="rim" d="{rim}"/>"#);
        }
    }
    svg + &handles(stage, &eye) + "</svg>"
}

/// The edges on the boundary, in lexicographic order of their ends.
pub(super) fn rim_of(stage: &Stage) -> Vec<[u32; 2]> {
    let boundary = stage.subject.edges.iter().filter(|edge| edge.boundary);
    boundary.map(|edge| edge.ends).collect()
}

/// Handles, their targets, and the lines between them.
fn handles(stage: &Stage, eye: &Eye) -> String {
    let place = |point: Vec3| eye.project(point).0.round();
    let (mut pulls, mut targets, mut dots) = (String::new(), String::new(), String::new());
    for (handle, target) in stage.handles.iter().zip(stage.targets()) {
        let at = place(stage.subject.positions[handle.vertex as usize]);
        let opacity = if is_hidden(stage, eye, handle.vertex) { BEHIND } else { 1.0 };
        if handle.kind != DotKind::Fixed {
            let pull = line([at, place(target)]);
            let _ = write!(pulls, r#"<path class="pull" opacity="{opacity}" d="{pull}"/>"#);
            targets += &dot(DotKind::Target, 1.0, place(target));
        }
        dots += &dot(handle.kind, opacity, at);
    }
    pulls + &targets + &dots
}

/// The style sheet of still pictures: the colours and widths of the view's palette. Faces with
/// values have lighter edges than plain ones.
pub fn style(has_values: bool) -> String {
    let edge = |palette: &Palette| {
        let mut stroke = palette.strokes[LineKind::Edge as usize];
        if has_values {
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

/// The faces, those whose corners are on average the farthest first.
pub(super) fn from_far_to_near(stage: &Stage, eye: &Eye) -> Vec<u32> {
    let subject = &stage.subject;
    let depth = |corners: &[u32]| {
        let sum: f32 = corners.iter().map(|&v| eye.project(subject.positions[v as usize]).1).sum();
        sum / corners.len().max(1) as f32
    };
    let mut faces: Vec<(f32, u32)> = subject.faces.iter().map(depth).zip(0..).collect();
    faces.sort_by(|a, b| b.0.total_cmp(&a.0));
    faces.into_iter().map(|(_, face)| face).collect()
}

/// The sides of a face, the smaller vertex first.
pub(super) fn sides(corners: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)])
}

/// Whether the surface hides the mark on a vertex. The view draws marks in front of what is near.
pub(super) fn is_hidden(stage: &Stage, eye: &Eye, vertex: u32) -> bool {
    let distance = (stage.subject.positions[vertex as usize] - eye.at).length();
    hidden(&stage.subject, eye.at, vertex, distance * NEAR)
}

/// A line through places, as the data of a path: the first as it is, the others by their steps.
pub(super) fn line(places: impl IntoIterator<Item = Vec2>) -> String {
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

/// A CSS colour for both themes.
pub(super) fn themed(light: Colour, dark: Colour) -> String {
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
