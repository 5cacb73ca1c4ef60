//! Thumbnails for the gallery: a small picture of the model as an SVG file of its own. Faces are
//! painted from the farthest to the nearest, as in [`super::picture`], but with fewer colours and
//! coarser positions, to keep the file small.
//!
//! One file serves both themes: it follows the colour scheme of the page that shows it.

use super::light::face_colour;
use super::picture::{from_far_to_near, is_hidden, line, rim_of, themed};
use crate::view::appearance::{DARK, DotKind, LIGHT, LineKind, Palette};
use crate::view::camera::Eye;
use crate::view::model::polygon_edges::undirected_sides;
use crate::view::state::ViewState;
use glam::{Vec2, Vec3};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Meshes of more faces are drawn more coarsely and with thinner lines.
const CROWD: usize = 1200;
/// Handles are scaled by this factor relative to the view.
const DOTS: f32 = 0.62;

/// Returns the thumbnail as an SVG file of the size of the canvas.
pub fn svg(state: &ViewState) -> String {
    let mut drawing = Drawing::new(state);
    let body = drawing.faces() + &drawing.curves() + &drawing.dots();
    let [width, height] = (state.camera().canvas * drawing.scale).round().to_array();
    let style = drawing.style();
    let colours = &drawing.colours;
    let colours: String =
        colours.iter().map(|(colour, class)| format!(".{class}{{color:{colour}}}")).collect();
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}"><style>{style}{colours}</style>{body}</svg>"#
    )
}

struct Drawing<'a> {
    state: &'a ViewState,
    eye: Eye,
    /// Position units per CSS pixel.
    scale: f32,
    /// Brightness steps from black to white.
    steps: f32,
    /// The class of each colour used.
    colours: BTreeMap<String, String>,
}

/// Returns the name with this number: `a`, `b`, ..., `z`, `aa`, ...
fn letters(number: usize) -> String {
    let last = char::from(b'a' + (number % 26) as u8);
    if number < 26 { last.to_string() } else { letters(number / 26 - 1) + &last.to_string() }
}

impl<'a> Drawing<'a> {
    fn new(state: &'a ViewState) -> Self {
        let is_crowd = state.mesh().faces.len() > CROWD;
        let (scale, steps) = if is_crowd { (1.0, 20.0) } else { (2.0, 32.0) };
        Drawing { state, eye: state.camera().eye(), scale, steps, colours: BTreeMap::new() }
    }

    /// Returns the class of a colour, which is new if necessary.
    fn class(&mut self, colour: String) -> String {
        let number = self.colours.len();
        self.colours.entry(colour).or_insert_with(|| letters(number)).clone()
    }

    fn style(&self) -> String {
        let appearance = self.state.appearance();
        let edge = |palette: &Palette| match appearance.has_full_map() {
            true => palette.edge_of_values,
            false => palette.strokes[LineKind::Edge as usize].colour,
        };
        // Lines as wide as in the view would cover thousands of small faces.
        let crowd = (self.state.mesh().faces.len() as f32 / 450.0).sqrt().max(1.0);
        let stroke = |kind: LineKind| {
            let colour = |palette: &Palette| palette.strokes[kind as usize].colour;
            let width = LIGHT.strokes[kind as usize].width * self.scale * DOTS;
            format!("stroke:{};stroke-width:{width:.2}", themed(colour(&LIGHT), colour(&DARK)))
        };
        format!(
            ":root{{color-scheme:light dark}}path,circle{{fill:currentColor}}\
             path{{stroke:{};stroke-width:{:.2};stroke-linejoin:round}}\
             .R,.P{{fill:none;stroke-linecap:round}}.R{{{}}}.P{{{}}}\
             .D{{stroke:currentColor;stroke-linecap:round;stroke-width:{:.2}}}.S{{stroke-width:{:.2}}}\
             .H{{stroke:#fff;stroke-width:{:.2}}}",
            themed(edge(&LIGHT), edge(&DARK)),
            self.scale / crowd,
            stroke(LineKind::Boundary),
            stroke(LineKind::Pull),
            2.0 * LIGHT.dots[DotKind::Vertex as usize].radius * self.scale,
            LIGHT.dots[DotKind::Vertex as usize].radius * self.scale,
            LIGHT.dots[DotKind::Handle as usize].rim_width * self.scale * DOTS,
        )
    }

    fn faces(&mut self) -> String {
        let mut svg = String::new();
        let rim = rim_of(self.state);
        // The class of the path that contains the last face.
        let mut open = String::new();
        for face in from_far_to_near(self.state) {
            // On a closed surface no back face is visible.
            if rim.is_empty() && self.is_turned_away(face) {
                continue;
            }
            let [light, dark] = [LIGHT, DARK].map(|palette| {
                self.coarse(face_colour(self.state, face, &palette)).extend(1.0).to_array()
            });
            let class = self.class(themed(light, dark));
            let corners = self.state.mesh().faces.row(face as usize);
            let outline = line(corners.iter().map(|&v| self.place(v)));
            // Writing to a string cannot fail.
            if class == open {
                svg.truncate(svg.len() - r#""/>"#.len());
                let _ = write!(svg, r#"{outline}z"/>"#);
            } else {
                let _ = write!(svg, r#"<path class="{class}" d="{outline}z"/>"#);
                open = class;
            }
            let border: String = undirected_sides(corners)
                .filter(|side| rim.contains(side))
                .map(|side| line(side.map(|v| self.place(v))))
                .collect();
            if !border.is_empty() {
                let _ = write!(svg, r#"<path class="R" d="{border}"/>"#);
                open.clear();
            }
        }
        svg
    }

    /// Quantises each component of a value colour, but only the brightness of shaded material.
    fn coarse(&self, colour: Vec3) -> Vec3 {
        let coarse = |part: f32| (part * self.steps).round() / self.steps;
        let most = colour.max_element();
        if self.state.appearance().has_full_map() || most == 0.0 {
            Vec3::from(colour.to_array().map(coarse))
        } else {
            (colour * (coarse(most) / most)).min(Vec3::ONE)
        }
    }

    fn is_turned_away(&self, face: u32) -> bool {
        let mesh = self.state.mesh();
        let corner = mesh.faces.row(face as usize)[0];
        let sight = mesh.positions[corner as usize] - self.eye.at;
        mesh.normals.faces[face as usize].dot(sight) > 0.0
    }

    /// Draws polylines if there are no faces; polylines on a surface appear as its edges.
    fn curves(&self) -> String {
        let mesh = self.state.mesh();
        if !mesh.faces.is_empty() || mesh.curves.is_empty() {
            return String::new();
        }
        let curves = mesh.curves.iter();
        let lines: String =
            curves.map(|curve| line(curve.iter().map(|&v| self.place(v)))).collect();
        format!(r#"<path class="R" d="{lines}"/>"#)
    }

    /// Draws vertices in the colours of constraints (all if there is nothing else), then handles
    /// and pull lines.
    fn dots(&mut self) -> String {
        let mut svg = self.points();
        let mut marks = String::new();
        for handle in self.state.handles() {
            let from = self.place(handle.vertex);
            let to = self.at(self.state.mesh().relative(handle.target));
            if from.distance(to) > self.scale {
                let _ = write!(svg, r#"<path class="P" d="{}"/>"#, line([from, to]));
            }
            if !is_hidden(self.state, &self.eye, handle.vertex) {
                let [light, dark] = [LIGHT, DARK].map(|palette| palette.dots[handle.kind as usize]);
                let class = self.class(themed(light.fill, dark.fill)) + " H";
                marks += &self.dot(&class, from, light.radius * DOTS);
            }
        }
        svg + &marks
    }

    fn points(&mut self) -> String {
        let state = self.state;
        let rows = &state.appearance().rows;
        let is_only_points = state.mesh().is_only_points();
        let mut paths: BTreeMap<String, String> = BTreeMap::new();
        for v in 0..state.mesh().positions.len() as u32 {
            let row = rows.vertices.get(v as usize).copied().unwrap_or(0);
            let is_seen = is_only_points || row > 0 && !is_hidden(state, &self.eye, v);
            if !is_seen || state.appearance().has_values() {
                continue;
            }
            let [light, dark] = [LIGHT, DARK].map(|palette| match row {
                0 => palette.dots[DotKind::Vertex as usize].fill,
                row => Vec3::from(rows.palette[usize::from(row) - 1]).extend(1.0).to_array(),
            });
            let Vec2 { x, y } = self.place(v);
            let _ = write!(paths.entry(themed(light, dark)).or_default(), "M{x} {y}h0");
        }
        let size = if is_only_points { "D" } else { "D S" };
        let dots = paths.into_iter().map(|(colour, dots)| {
            let class = self.class(colour);
            format!(r#"<path class="{class} {size}" d="{dots}"/>"#)
        });
        dots.collect()
    }

    fn dot(&self, class: &str, Vec2 { x, y }: Vec2, radius: f32) -> String {
        let radius = (radius * self.scale).round();
        format!(r#"<circle class="{class}" cx="{x}" cy="{y}" r="{radius}"/>"#)
    }

    fn place(&self, vertex: u32) -> Vec2 {
        self.at(self.state.mesh().positions[vertex as usize])
    }

    fn at(&self, point: Vec3) -> Vec2 {
        (self.eye.project(point).0 * self.scale).round()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube, closed or without its lid.
    fn state(faces: usize) -> ViewState {
        let corners = (0..8u8).flat_map(|k| [k & 1, k >> 1 & 1, k >> 2].map(f64::from));
        let quads =
            [[0, 2, 3, 1], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6], [4, 5, 7, 6]];
        let indices: Vec<u32> = quads[..faces].concat();
        let offsets = (0..=faces as u32).map(|k| 4 * k).collect();
        let mut state = ViewState::default();
        let positions: Vec<f64> = corners.collect();
        state.set_mesh((offsets, indices), (vec![0], vec![]), &positions).unwrap();
        state.resize(Vec2::new(200.0, 100.0));
        state
    }

    fn outlines(svg: &str) -> usize {
        svg.matches('z').count()
    }

    #[test]
    fn a_closed_surface_shows_no_backs_and_an_open_one_shows_all() {
        let closed = svg(&state(6));
        assert_eq!(outlines(&closed), 3, "{closed}");
        assert!(closed.contains(r#"viewBox="0 0 400 200""#));
        let open = svg(&state(5));
        assert_eq!(outlines(&open), 5, "{open}");
        assert!(open.contains(r#"class="R""#));
    }

    #[test]
    fn points_without_faces_are_dots() {
        let mut state = ViewState::default();
        state
            .set_mesh((vec![0], vec![]), (vec![0], vec![]), &[0.0, 0.0, 0.0, 1.0, 2.0, 3.0])
            .unwrap();
        state.resize(Vec2::new(200.0, 100.0));
        assert_eq!(svg(&state).matches("h0").count(), 2);
    }

    #[test]
    fn classes_are_letters() {
        assert_eq!([0, 25, 26, 51, 52].map(letters), ["a", "z", "aa", "az", "ba"]);
    }
}
