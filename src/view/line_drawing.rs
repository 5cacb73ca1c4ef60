//! A line drawing of a model for print: visible parts of edges, outlines, curves and fitted circles, and
//! the section.
//!
//! Visibility is sampled along each line against a depth buffer whose pixels are about a tenth of a
//! millimetre on paper. The sides of the frontmost face at a sample count as visible whatever their
//! depth, so that lines on slanted surfaces stay whole.

use super::model::ViewError;
use crate::view::camera::{Eye, Section};
use crate::view::picking::DepthMap;
use crate::view::state::{FittedShape, ViewState};
use glam::{Vec2, Vec3};
use std::fmt::Write;

/// Size of the drawing: A4 landscape with a margin, in hundredths of a millimetre.
const SHEET: Vec2 = Vec2::new(27_700.0, 19_000.0);
/// Pixels of the depth buffer along the longer side.
const PIXELS: f32 = 2560.0;
/// Lines are sampled once per pixel, at most this many times.
const MOST_SAMPLES: f32 = 4000.0;
/// Shorter visible runs of longer lines are dropped: specks where a hidden edge meets an outline.
const SPECK: usize = 8;
/// Number of chords of a drawn circle.
const CHORDS: usize = 48;

/// Margin around the model as a fraction of its size, because circles extend beyond it.
const MARGIN: f32 = 0.03;

/// Line widths in hundredths of a millimetre (ISO 128: thick for outlines, thin on the surface).
const OUTLINE: u32 = 35;
const EDGE: u32 = 18;
const CIRCLE: u32 = 13;

/// Draws the visible lines as SVG in millimetres, with groups for circles, edges and outlines.
///
/// # Errors
/// If no line of the model is in the picture.
pub fn line_drawing(state: &ViewState) -> Result<String, ViewError> {
    let camera = state.camera();
    let [low, high] = frame(state).ok_or(ViewError::NoLine)?;
    let scale = (SHEET / (high - low).max(Vec2::ONE)).min_element();
    let size = ((high - low) * scale).round();
    let sight = Sight {
        map: DepthMap::new(state.mesh(), &camera, PIXELS),
        eye: camera.eye(),
        near: camera.distance * 1e-3,
        section: camera.section,
        samples: PIXELS / camera.canvas.max_element().max(1.0),
        frame: [low, high],
        scale,
    };
    let mut edges = Lines::default();
    let mut circles = Lines::default();
    let mesh = state.mesh();
    let at = |v: u32| mesh.positions[v as usize];
    let display = state.display();
    for sides in mesh.sides.chunk_by(|a, b| a.0 == b.0) {
        let faces: Vec<u32> = sides.iter().map(|side| side.1).collect();
        let from_eye = |face: u32| {
            let corner = at(mesh.faces.row(face as usize)[0]);
            mesh.normals.faces[face as usize].dot(corner - sight.eye.seen_from(corner))
        };
        let is_outline = match faces[..] {
            // Inconsistent orientations invert this test; `sees` then finds outlines by depth.
            [one, other] => from_eye(one) * from_eye(other) < 0.0,
            _ => true,
        };
        sight.draw(sides[0].0.map(at), &faces, is_outline, &mut edges);
    }
    // The section ends the surface, so that it is an outline.
    if let Some(section) = camera.section {
        for (&triangle, &face) in mesh.triangles.iter().zip(&mesh.triangle_face) {
            let corners = triangle.map(at);
            if let Some(ends) = section.through(corners) {
                sight.draw(ends, &[face], true, &mut edges);
            }
        }
    }
    // Outlines are drawn even if edges are switched off.
    if !display.edges {
        edges.on_surface.clear();
    }
    for curve in mesh.curves.iter() {
        curve
            .windows(2)
            .for_each(|ends| sight.draw([at(ends[0]), at(ends[1])], &[], false, &mut edges));
    }
    if display.shapes {
        for (centre, radii) in state.shapes().iter().filter_map(FittedShape::radii) {
            let point = |k: usize| {
                let (sin, cos) = (std::f32::consts::TAU * k as f32 / CHORDS as f32).sin_cos();
                centre + radii[0] * cos + radii[1] * sin
            };
            (0..CHORDS)
                .for_each(|k| sight.draw([point(k), point(k + 1)], &[], false, &mut circles));
        }
    }
    let [width, height] = size.to_array();
    let mut svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}mm" height="{}mm" viewBox="0 0 {width} {height}"><g fill="none" stroke-linecap="round" stroke-linejoin="round">"#,
        width / 100.0,
        height / 100.0,
    );
    let pens = [
        ("circles", "#123d87", CIRCLE, circles.on_surface),
        ("edges", "#1d2123", EDGE, edges.on_surface),
        ("outlines", "#000", OUTLINE, edges.outlines),
    ];
    if pens.iter().all(|(.., data)| data.is_empty()) {
        return Err(ViewError::NoLine);
    }
    for (id, ink, pen, data) in pens {
        if !data.is_empty() {
            // Writing to a string cannot fail.
            let _ = write!(
                svg,
                r#"<g id="{id}" stroke="{ink}" stroke-width="{pen}"><path d="{data}"/></g>"#
            );
        }
    }
    Ok(svg + "</g></svg>\n")
}

/// Returns two corners of the part of the canvas that shows what the section leaves of the model, with
/// a margin; none if nothing of it is there.
fn frame(state: &ViewState) -> Option<[Vec2; 2]> {
    let (canvas, eye) = (state.camera().canvas, state.camera().eye());
    let (mesh, section) = (state.mesh(), state.camera().section);
    let is_kept = |point: &Vec3| section.is_none_or(|section| section.within(*point) >= 0.0);
    let segments = mesh.curves.iter().flat_map(|curve| curve.windows(2).map(|w| [w[0], w[1]]));
    let lines = mesh.sides.iter().map(|side| side.0).chain(segments);
    let lines = lines.map(|ends| ends.map(|vertex| mesh.positions[vertex as usize]));
    let cut = lines.filter_map(|ends| section?.cut(ends)).flatten();
    let places = mesh.used_positions().filter(is_kept).chain(cut);
    let places = places.map(|point| eye.project(point));
    let seen = places.filter(|(_, depth)| *depth > 0.0).map(|(place, _)| place);
    let (low, high) = (seen.clone().reduce(Vec2::min)?, seen.reduce(Vec2::max)?);
    if high.cmple(Vec2::ZERO).any() || low.cmpge(canvas).any() {
        return None;
    }
    let margin = Vec2::splat(MARGIN * (high - low).max_element());
    Some([(low - margin).max(Vec2::ZERO), (high + margin).min(canvas)])
}

/// Path data of outlines, where the surface ends as seen from the eye, and of other lines.
#[derive(Default)]
struct Lines {
    outlines: String,
    on_surface: String,
}

/// The visibility of a part of a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Visibility {
    Hidden,
    OnSurface,
    Outline,
}

/// The depth buffer and the eye, against which lines are drawn.
struct Sight {
    map: DepthMap,
    eye: Eye,
    /// The depth in front of which nothing is drawn.
    near: f32,
    section: Option<Section>,
    /// Samples per CSS pixel.
    samples: f32,
    frame: [Vec2; 2],
    /// Units of the drawing per CSS pixel.
    scale: f32,
}

impl Sight {
    /// Draws the visible parts of the line between two points, a side of `faces`. Even if
    /// `is_outline` is false, a part is drawn as an outline if there is nothing close behind it.
    fn draw(&self, ends: [Vec3; 2], faces: &[u32], is_outline: bool, to: &mut Lines) {
        let kept = self.section.map_or(Some(ends), |section| section.cut(ends));
        let Some(ends) = kept.and_then(|ends| self.in_front(ends)) else { return };
        let [a, b] = ends.map(|point| self.eye.project(point));
        let count = ((b.0 - a.0).length() * self.samples).ceil().clamp(1.0, MOST_SAMPLES) as usize;
        let part = |k: usize, to_middle: f32| (k as f32 + to_middle) / count as f32;
        let mut seen: Vec<Visibility> = (0..count)
            .map(|k| match self.sees([a, b], part(k, 0.5), faces) {
                Visibility::OnSurface if is_outline => Visibility::Outline,
                seen => seen,
            })
            .collect();
        let speck = SPECK.min(count);
        forget_specks(&mut seen, speck);
        let mut first = 0;
        for run in seen.chunk_by(|a, b| a == b) {
            let last = first + run.len();
            let path = match run[0] {
                Visibility::OnSurface => Some(&mut to.on_surface),
                Visibility::Outline => Some(&mut to.outlines),
                Visibility::Hidden => None,
            };
            let joins = [first.checked_sub(1), Some(last)].map(|k| {
                k.and_then(|k| seen.get(k)).is_some_and(|&beside| beside != Visibility::Hidden)
            });
            if let Some(path) = path.filter(|_| run.len() >= speck || joins.contains(&true)) {
                let places = [first, last].map(|k| a.0.lerp(b.0, part(k, 0.0)));
                *path += &line(places.map(|at| ((at - self.frame[0]) * self.scale).round()));
            }
            first = last;
        }
    }

    /// Returns the part of a line beyond the near depth.
    fn in_front(&self, [a, b]: [Vec3; 2]) -> Option<[Vec3; 2]> {
        let [da, db] = [a, b].map(|point| (point - self.eye.at).dot(self.eye.forward) - self.near);
        let cut = || a.lerp(b, da / (da - db));
        match [da >= 0.0, db >= 0.0] {
            [true, true] => Some([a, b]),
            [true, false] => Some([a, cut()]),
            [false, true] => Some([cut(), b]),
            [false, false] => None,
        }
    }

    /// Returns the visibility at fraction `part` of a line with these end positions and depths.
    fn sees(
        &self,
        [(a, depth_a), (b, depth_b)]: [(Vec2, f32); 2],
        part: f32,
        faces: &[u32],
    ) -> Visibility {
        let place = a.lerp(b, part);
        let depth = match self.eye.parallel {
            // 1 / depth is linear on the screen.
            None => 1.0 / ((1.0 - part) / depth_a + part / depth_b),
            Some(_) => depth_a + (depth_b - depth_a) * part,
        };
        let [low, high] = self.frame;
        let is_inside = place.cmpge(low).all() && place.cmple(high).all();
        if !is_inside || !self.map.shows_line(place, depth, faces) {
            Visibility::Hidden
        } else if !faces.is_empty() && self.map.ends_at(place, depth, faces) {
            Visibility::Outline
        } else {
            Visibility::OnSurface
        }
    }
}

/// Turns short runs of outline, which appear beside a vertex of an outline, into plain line.
fn forget_specks(seen: &mut [Visibility], speck: usize) {
    for run in seen.chunk_by_mut(|a, b| a == b) {
        if run[0] == Visibility::Outline && run.len() < speck {
            run.fill(Visibility::OnSurface);
        }
    }
}

/// Returns the path data of a line: its start, and its end relative to that.
fn line([start, end]: [Vec2; 2]) -> String {
    let pair = |Vec2 { x, y }: Vec2| format!("{x}{}{y}", if y < 0.0 { "" } else { " " });
    format!("M{}l{}", pair(start), pair(end - start))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Draws quads in parallel projection.
    fn seen(positions: &[[f64; 3]], quads: &[[u32; 4]], from: &str) -> String {
        let mut state = ViewState::default();
        let offsets = (0..=quads.len() as u32).map(|k| 4 * k).collect();
        let positions = positions.as_flattened();
        state.set_mesh((offsets, quads.concat()), (vec![0], vec![]), positions).unwrap();
        state.resize(Vec2::new(800.0, 600.0));
        state.set_parallel(true);
        state.move_camera(|camera| camera.look_from(from)).unwrap();
        line_drawing(&state).unwrap()
    }

    #[test]
    fn a_model_beside_the_picture_is_no_drawing_of_negative_size() {
        let mut state = ViewState::default();
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let faces = (vec![0, 4], vec![0, 1, 2, 3]);
        state.set_mesh(faces, (vec![0], vec![]), square.as_flattened()).unwrap();
        state.resize(Vec2::new(800.0, 600.0));
        state.move_camera(|camera| camera.look_from("top")).unwrap();
        assert!(line_drawing(&state).is_ok());
        state.move_camera(|camera| camera.pan(4000.0, 0.0));
        assert_eq!(line_drawing(&state), Err(ViewError::NoLine));
    }

    #[test]
    fn what_is_cut_off_takes_no_part_of_the_sheet() {
        // A tower of which a tenth was kept stood at the foot of an empty sheet.
        let corner = |k: u8| [f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2) * 10.0];
        let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
        let offsets = (0..=4).map(|k| 4 * k).collect();
        let sides = vec![0, 1, 5, 4, 1, 3, 7, 5, 3, 2, 6, 7, 2, 0, 4, 6];
        let mut state = ViewState::default();
        state.set_mesh((offsets, sides), (vec![0], vec![]), corners.as_flattened()).unwrap();
        state.resize(Vec2::new(800.0, 600.0));
        state.set_parallel(true);
        state.preset("front").unwrap();
        state.set_section(Some((2, 0.1, false))).unwrap();
        let svg = line_drawing(&state).unwrap();
        let size = |name: &str| -> f32 {
            let (_, rest) = svg.split_once(&format!("{name}=\"")).unwrap();
            rest.split_once("mm").unwrap().0.parse().unwrap()
        };
        assert!((size("width") / size("height") - 1.0).abs() < 0.05, "{svg}");
        state.zoom(5.0, Vec2::new(400.0, 300.0));
        assert_eq!(line_drawing(&state), Err(ViewError::NoLine));
    }

    #[test]
    fn points_have_no_lines() {
        let mut state = ViewState::default();
        state
            .set_mesh((vec![0], vec![]), (vec![0], vec![]), &[0.0, 0.0, 0.0, 1.0, 2.0, 3.0])
            .unwrap();
        state.resize(Vec2::new(800.0, 600.0));
        assert_eq!(line_drawing(&state), Err(ViewError::NoLine));
    }

    /// Returns the lengths of the lines of a pen, in hundredths of a millimetre.
    fn lengths(svg: &str, pen: &str) -> Vec<f32> {
        let Some((_, group)) = svg.split_once(&format!("id=\"{pen}\"")) else { return vec![] };
        let data = group.split('"').find(|text| text.starts_with('M')).unwrap();
        let length = |piece: &str| {
            let step = piece.split_once('l').unwrap().1.replace('-', " -");
            let parts: Vec<f32> =
                step.split_whitespace().map(|part| part.parse().unwrap()).collect();
            parts[0].hypot(parts[1])
        };
        data.split('M').skip(1).map(length).collect()
    }

    #[test]
    fn of_a_cube_nine_edges_are_seen_and_six_are_its_outline() {
        let corner = |k: u8| [k & 1, k >> 1 & 1, k >> 2].map(f64::from);
        let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
        let quads =
            [[0, 2, 3, 1], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6], [4, 5, 7, 6]];
        let svg = seen(&corners, &quads, "isometric");
        let [outlines, edges] = ["outlines", "edges"].map(|pen| lengths(&svg, pen));
        assert_eq!([outlines.len(), edges.len()], [6, 3], "{svg}");
        // All edges have the same length in this view.
        for length in outlines.iter().chain(&edges) {
            assert!((length / edges[0] - 1.0).abs() < 0.01, "{svg}");
        }
        // Without the lid and the two front sides nothing is hidden.
        let svg = seen(&corners, &[quads[0], quads[3], quads[4]], "isometric");
        assert_eq!(lengths(&svg, "outlines").len() + lengths(&svg, "edges").len(), 9);
    }

    #[test]
    fn a_line_ends_where_the_surface_begins_to_hide_it() {
        let square = |at: f64, height: f64| {
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| [x + at, y + at, height])
        };
        let both = [square(0.5, 0.0), square(0.0, 1.0)].concat();
        let svg = seen(&both, &[[0, 1, 2, 3], [4, 5, 6, 7]], "top");
        let found = lengths(&svg, "outlines");
        let side = found.iter().copied().fold(0.0, f32::max);
        let sum: f32 = found.iter().sum();
        // Two half sides of the lower square are hidden.
        assert_eq!(found.len(), 8);
        assert!((sum / side - 7.0).abs() < 0.02, "{}", sum / side);
        assert!(lengths(&svg, "edges").is_empty());
    }
}
