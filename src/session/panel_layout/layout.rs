//! One layout of new panels: its forecast, what is said of it, and the lines that show it.

use crate::mesh::{Mesh, Point, Surface, Topology};
use crate::quads::{Boundary, Remeshed};
use crate::scene::{Forecast, HowFar};
use crate::words;
use serde::Serialize;

/// Points of the surface along the line of an edge.
const LINE_POINTS: usize = 5;

/// New panels on the surface.
#[derive(Clone, Debug)]
pub struct PanelLayout {
    /// Their mesh.
    pub mesh: Mesh,
    /// What they do at the boundary; none if the surface is closed.
    pub boundary: Option<Boundary>,
    /// Their number, without the faces that stay as they are.
    pub count: usize,
    /// The mean length of their sides, in the unit of the mesh.
    pub size: f64,
    /// What is to be said of them, and what they cannot follow.
    pub words: Vec<String>,
    /// Lines over the surface along their edges, those at irregular vertices first.
    pub lines: Vec<Vec<Point>>,
    /// The number of lines at irregular vertices.
    pub irregular_lines: usize,
}

/// A layout with its forecast.
pub(super) struct Layout {
    remeshed: Remeshed,
    topology: Topology,
    forecast: Option<Forecast>,
    boundary: Boundary,
}

impl Layout {
    /// A layout of `remeshed`, with its forecast.
    pub(super) fn new(remeshed: Remeshed, boundary: Boundary) -> Layout {
        let topology = Topology::new(&remeshed.mesh);
        let forecast = Forecast::of(&remeshed.mesh, &topology);
        Layout { remeshed, topology, forecast, boundary }
    }

    /// Whether some panels will move a lot to become circular or flat.
    pub(super) fn moves_a_lot(&self) -> bool {
        let kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.into_iter().any(|kind| kind.how_far == HowFar::Lot)
    }

    /// The largest mean move of the kinds of panels, in the unit of the mesh.
    pub(super) fn move_length(&self) -> f64 {
        let kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.map(|kind| kind.least_move).fold(0.0, f64::max) * self.remeshed.measures.edge.mean
    }

    /// The layout on its `shape` as hosts see it; `units` is the symbol of the unit.
    pub(super) fn shown(&self, shape: &Mesh, units: &str) -> PanelLayout {
        let words = self.words(units);
        let (lines, irregular_lines) = self.lines(shape);
        PanelLayout {
            boundary: (!self.topology.boundary_loops().is_empty()).then_some(self.boundary),
            count: self.remeshed.measures.quads + self.remeshed.measures.other_faces,
            size: self.remeshed.measures.edge.mean,
            mesh: self.remeshed.mesh.clone(),
            words,
            lines,
            irregular_lines,
        }
    }

    /// "490 panels, 12 irregular points, edges 6° off the lines of curvature." and the forecast, then
    /// what the panels cannot follow.
    fn words(&self, units: &str) -> Vec<String> {
        let measures = &self.remeshed.measures;
        let irregular = measures.irregular.inside + measures.irregular.boundary;
        let mut parts = vec![
            words::count(measures.quads + measures.other_faces, "panel", "panels"),
            match irregular {
                0 => "no irregular points".to_owned(),
                some => words::count(some, "irregular point", "irregular points"),
            },
        ];
        parts.extend(measures.angle.map(|angle| {
            format!("edges {} off the lines of curvature", words::rough_degrees(angle.mean))
        }));
        let mut said = format!("{}.", parts.join(", "));
        if let Some(forecast) = &self.forecast {
            said += &format!(" The mesh will then {}.", forecast.moves(units));
        }
        let notes = self.remeshed.notes.iter().map(|note| format!("{}.", note.words));
        std::iter::once(said).chain(notes).collect()
    }

    /// Lines over `shape` along the edges, those at irregular vertices first, and their number.
    fn lines(&self, shape: &Mesh) -> (Vec<Vec<Point>>, usize) {
        let Layout { topology, remeshed, .. } = self;
        let mut is_irregular: Vec<bool> =
            topology.neighbours().iter().map(|near| near.len() != 4).collect();
        for &v in topology.boundary_loops().indices() {
            is_irregular[v as usize] = false;
        }
        // What stays as it is has no irregular points.
        let faces = &remeshed.mesh.faces;
        for face in faces.iter().skip(faces.len() - remeshed.staying) {
            face.iter().for_each(|&v| is_irregular[v as usize] = false);
        }
        let surface = Surface::new(&shape.positions, shape);
        let at = |v: u32| remeshed.mesh.positions[v as usize];
        let line = |&[a, b]: &[u32; 2]| {
            let mut hint = Surface::NO_HINT;
            let point = |k: usize| {
                let part = k as f64 / (LINE_POINTS - 1) as f64;
                let (from, to) = (at(a), at(b));
                let on_edge = std::array::from_fn(|i| from[i] + part * (to[i] - from[i]));
                surface.closest(on_edge, &mut hint)
            };
            (0..LINE_POINTS).map(point).collect::<Vec<Point>>()
        };
        let at_irregular = |ends: &&[u32; 2]| ends.iter().any(|&v| is_irregular[v as usize]);
        let (first, others): (Vec<_>, Vec<_>) = topology.edges().iter().partition(at_irregular);
        let lines = first.iter().chain(&others).map(line).collect();
        (lines, first.len())
    }
}

/// New panels as they are sent to a page.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct LayoutWords {
    /// What is to be said of them, and what they cannot follow.
    pub words: Vec<String>,
    /// What they do at the boundary; none if the surface is closed.
    pub boundary: Option<Boundary>,
    /// Their number.
    pub count: usize,
    /// The mean length of their sides, in the unit of the mesh, to two digits.
    pub size: f64,
}

impl PanelLayout {
    /// What a page says of it.
    pub fn in_words(&self) -> LayoutWords {
        LayoutWords {
            words: self.words.clone(),
            boundary: self.boundary,
            count: self.count,
            size: words::rounded(self.size, 2),
        }
    }
}
