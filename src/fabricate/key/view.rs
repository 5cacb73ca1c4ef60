//! The shape seen in one direction: where its panels, edges and vertices are in the picture, and which
//! of them no panel hides.

use crate::fabricate::boxes::Boxes;
use crate::fabricate::panel::{direction_of, roomiest_point};
use crate::fabricate::sheet::{text_width, upright};
use crate::fabricate::surface::{Edge, PanelSurface};
use crate::fabricate::view_axes::{Seen, ViewAxes};
use crate::math::Vec3;
use crate::math::plane::{Point2, bounds, distance, is_inside};

/// Something that has a name.
#[derive(Clone, Debug)]
pub(super) enum Element {
    Panel(u32),
    /// A piece of a panel, with its outline about the centre of the surface.
    Piece(u32, Vec<Vec3<f64>>),
    Edge(u32),
    Vertex(u32),
}

/// A name and what it is written on.
pub(super) struct Mark {
    pub(super) name: String,
    pub(super) element: Element,
}

/// Where a name is written in a picture, in the unit of the mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) at: Point2,
    pub(super) along: Point2,
    /// The largest height of the name.
    pub(super) height: f64,
}

/// Sine of the angle between a panel and the direction of view below which it is seen edge-on.
const EDGE_ON: f64 = 1e-3;
/// What is nearer by less than this fraction of the size of the picture hides nothing.
const NEARER: f64 = 1e-5;
/// Largest length of the name of a beam, and height, relative to its edge.
const OF_EDGE: [f64; 2] = [0.7, 0.2];
/// Height of the name of a node relative to its shortest edge.
const OF_NODE: f64 = 0.15;

pub(super) struct View<'a> {
    surface: &'a PanelSurface,
    pub(super) axes: ViewAxes,
    pub(super) seen: Seen,
    /// The box of each panel in the picture.
    panels: Boxes,
}

/// Where there is most room for a name on a polygon; `wide` is its width where it is one high.
pub(super) fn on_polygon(corners: &[Point2], wide: f64) -> Option<Spot> {
    let (at, radius) = roomiest_point(corners);
    let height = radius / (0.25 * (wide * wide + 1.0)).sqrt();
    (radius > 0.0).then_some(Spot { at, along: [1.0, 0.0], height })
}

impl View<'_> {
    pub(super) fn new(surface: &PanelSurface, axes: ViewAxes) -> View<'_> {
        let seen = Seen::new(surface, axes);
        let around = |row: &[u32]| bounds(row.iter().map(|&v| seen.points[v as usize]));
        let panels = Boxes::of(surface.faces.iter().map(around));
        View { surface, axes, seen, panels }
    }

    fn corners(&self, face: u32) -> Vec<Point2> {
        let row = self.surface.faces.row(face as usize).iter();
        row.map(|&v| self.seen.points[v as usize]).collect()
    }

    /// How far away a panel is at a point; none if it is seen edge-on.
    fn depth(&self, face: u32, [x, y]: Point2) -> Option<f64> {
        let [right, up, away] = self.axes;
        let normal = self.surface.normal(face);
        let across = normal.dot(away);
        let row = self.surface.faces.row(face as usize);
        let level =
            row.iter().map(|&v| normal.dot(self.surface.positions[v as usize])).sum::<f64>()
                / row.len() as f64;
        let depth = (level - normal.dot(right) * x - normal.dot(up) * y) / across;
        (across.abs() > EDGE_ON).then_some(depth)
    }

    /// Whether a panel other than these hides a point at a depth.
    fn is_hidden(&self, point: Point2, depth: f64, own: &[u32]) -> bool {
        let least = depth - NEARER * self.seen.size[0].max(self.seen.size[1]);
        self.panels.meeting([point; 2]).any(|face| {
            !own.contains(&face)
                && is_inside(&self.corners(face), point)
                && self.depth(face, point).is_some_and(|depth| depth < least)
        })
    }

    /// Whether the middle of an edge is seen, and where it is.
    fn edge(&self, edge: u32) -> Option<[Point2; 2]> {
        let own = &self.surface.edges[edge as usize];
        if own.is_bridge() {
            return None;
        }
        let ends = own.ends.map(|v| v as usize);
        let [a, b] = ends.map(|v| self.seen.points[v]);
        let depth = 0.5 * (self.seen.depths[ends[0]] + self.seen.depths[ends[1]]);
        let own = self.surface.panels.row(edge as usize);
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        (!self.is_hidden(middle, depth, own)).then_some([a, b])
    }

    fn projected(&self, points: &[Vec3<f64>]) -> Vec<Point2> {
        let [right, up, _] = self.axes;
        points.iter().map(|point| [point.dot(right), point.dot(up)]).collect()
    }

    /// The ends of a seam of a panel, if its middle is seen.
    fn seam(&self, panel: u32, ends: &[Vec3<f64>]) -> Option<[Point2; 2]> {
        let [a, b] = self.projected(ends)[..] else { return None };
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let depth = self.depth(panel, middle)?;
        (!self.is_hidden(middle, depth, &[panel])).then_some([a, b])
    }

    /// The edges and the seams of panels that are seen.
    pub(super) fn lines(&self, seams: &[(u32, Vec<Vec3<f64>>)]) -> Vec<Vec<Point2>> {
        let edges = (0..self.surface.edges.len() as u32).filter_map(|edge| self.edge(edge));
        let seams = seams.iter().filter_map(|(panel, ends)| self.seam(*panel, ends));
        edges.chain(seams).map(|ends| ends.to_vec()).collect()
    }

    /// Where the names of some marks are written; none if what they name is not seen.
    pub(super) fn spots(&self, marks: &[Mark]) -> Vec<Option<Spot>> {
        let (mut shortest, mut around) = (Vec::new(), Vec::new());
        if marks.iter().any(|mark| matches!(mark.element, Element::Vertex(_))) {
            (shortest, around) = self.around_vertices();
        }
        let spot = |Mark { name, element }: &Mark| {
            // The width of the name where it is one high.
            let wide = text_width(name, 1.0);
            match element {
                Element::Panel(face) => self.on_panel(*face, &self.corners(*face), wide),
                Element::Piece(face, outline) => {
                    self.on_panel(*face, &self.projected(outline), wide)
                }
                Element::Edge(edge) => self.on_edge(*edge, wide),
                Element::Vertex(v) => {
                    let v = *v;
                    let (at, depth) = (self.seen.points[v as usize], self.seen.depths[v as usize]);
                    let height = OF_NODE * shortest[v as usize];
                    let is_seen = height > 0.0 && !self.is_hidden(at, depth, &around[v as usize]);
                    is_seen.then_some(Spot { at, along: [1.0, 0.0], height })
                }
            }
        };
        marks.iter().map(spot).collect()
    }

    /// The name of a panel, or of a piece of it with these corners in the picture.
    fn on_panel(&self, face: u32, corners: &[Point2], wide: f64) -> Option<Spot> {
        let spot = on_polygon(corners, wide)?;
        let depth = self.depth(face, spot.at)?;
        (!self.is_hidden(spot.at, depth, &[face])).then_some(spot)
    }

    fn on_edge(&self, edge: u32, wide: f64) -> Option<Spot> {
        let [a, b] = self.edge(edge)?;
        let long = distance(a, b);
        let height = (OF_EDGE[0] * long / wide).min(OF_EDGE[1] * long);
        let along = upright(direction_of(a, b), [1.0, 0.0]);
        let at = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        (long > 0.0).then_some(Spot { at, along, height })
    }

    /// For each vertex the length of its shortest edge in the picture, and its panels. An edge without
    /// length in space leaves room for a name.
    fn around_vertices(&self) -> (Vec<f64>, Vec<Vec<u32>>) {
        let mut shortest = vec![f64::INFINITY; self.seen.points.len()];
        let has_length = |edge: &&Edge| self.surface.length(edge) > 0.0;
        for edge in self.surface.real_edges().filter(has_length) {
            let [a, b] = edge.ends.map(|v| v as usize);
            let long = distance(self.seen.points[a], self.seen.points[b]);
            [a, b].into_iter().for_each(|v| shortest[v] = shortest[v].min(long));
        }
        (shortest, self.surface.panels_around())
    }
}
