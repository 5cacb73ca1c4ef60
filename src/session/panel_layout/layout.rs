//! One layout of new panels: its forecast, what is said of it, and the lines that show it.

use super::places::MarkedPlace;
use crate::mesh::{Mesh, Point, Surface, Topology};
use crate::quads::{Boundary, Remeshed};
use crate::scene::{Forecast, HowFar};
use crate::words;
use serde::Serialize;

/// Points of the surface along the line of an edge.
const LINE_POINTS: usize = 5;
/// Radius of the ring around a place, in panels.
const RING: f64 = 1.2;

/// New panels on the surface.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct PanelLayout {
    /// Their mesh.
    #[serde(skip)]
    pub mesh: Mesh,
    /// What they do at the boundary; none if the surface is closed.
    pub boundary: Option<Boundary>,
    /// Their number, without the faces that stay as they are.
    pub count: usize,
    /// The mean length of their sides, in the unit of the mesh, to two digits.
    pub size: f64,
    /// What is to be said of them.
    pub words: String,
    /// What they cannot follow, and what stays as it is.
    pub notes: Vec<LayoutNote>,
    /// Lines over the surface: rings around the places of the notes, then along the edges of the
    /// panels, those at irregular vertices first.
    #[serde(skip)]
    pub lines: Vec<Vec<Point>>,
    /// The number of rings and of lines at irregular vertices.
    #[serde(rename = "marked")]
    pub marked_lines: usize,
}

/// A sentence about new panels.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct LayoutNote {
    /// The sentence.
    pub words: String,
    /// For each place that it names, the vertices of the mesh around it.
    pub places: Vec<Vec<u32>>,
}

/// What panels come to with one choice at the boundary.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BoundaryForecast {
    /// The choice.
    pub boundary: Boundary,
    /// Their number and their move, or why there are none.
    pub words: String,
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

    /// Whether panels will hardly move to become circular or flat.
    pub(super) fn hardly_moves(&self) -> bool {
        let kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.into_iter().all(|kind| matches!(kind.how_far, HowFar::Nothing | HowFar::Hardly))
    }

    /// The largest mean move of the kinds of panels, in the unit of the mesh.
    pub(super) fn move_length(&self) -> f64 {
        let kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.map(|kind| kind.least_move).fold(0.0, f64::max) * self.remeshed.measures.edge.mean
    }

    /// The layout as hosts see it, on its shape without faces that are left out, and the surface of this;
    /// `units` is the symbol of the unit, and `kept` the number of faces that were to stay.
    pub(super) fn shown(
        &self,
        (shape, surface): &(Mesh, Surface),
        units: &str,
        kept: usize,
    ) -> PanelLayout {
        let size = self.remeshed.measures.edge.mean;
        let mut rings = Vec::new();
        let mut notes = Vec::new();
        for note in &self.remeshed.notes {
            let of = |&at: &Point| MarkedPlace::new(at.into(), RING * size, surface, shape);
            let places: Vec<MarkedPlace> = note.places.iter().map(of).collect();
            rings.extend(places.iter().map(|place| place.ring.clone()));
            let places = places.into_iter().map(|place| place.around).collect();
            notes.push(LayoutNote { words: format!("{}.", note.words), places });
        }
        if kept > 0 {
            let faces = words::count(kept, "selected face stays", "selected faces stay");
            let words = format!("{faces}, and the panels share no corners with what stays.");
            notes.push(LayoutNote { words, places: Vec::new() });
        }
        let (lines, irregular) = self.lines(surface);
        PanelLayout {
            boundary: (!self.topology.boundary_loops().is_empty()).then_some(self.boundary),
            count: self.count(),
            size: words::rounded(size, 2),
            mesh: self.remeshed.mesh.clone(),
            words: self.words(units),
            notes,
            marked_lines: rings.len() + irregular,
            lines: [rings, lines].concat(),
        }
    }

    /// The number of panels.
    fn count(&self) -> usize {
        self.remeshed.measures.quads + self.remeshed.measures.other_faces
    }

    /// What this choice at the boundary comes to: "483 panels, will move about 20 mm", or "will not
    /// move" if they have the shape of every kind already.
    pub(super) fn forecast(&self, units: &str) -> BoundaryForecast {
        let count = words::count(self.count(), "panel", "panels");
        let mut kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        let moves = match kinds.any(|kind| kind.how_far != HowFar::Nothing) {
            true => format!("move about {}", words::rough_length(self.move_length(), units)),
            false => "not move".to_owned(),
        };
        let words = format!("{count}, will {moves}");
        BoundaryForecast { boundary: self.boundary, words }
    }

    /// "490 panels, 12 irregular points, edges 6° off the lines of curvature." and the forecast.
    fn words(&self, units: &str) -> String {
        let measures = &self.remeshed.measures;
        let irregular = measures.irregular.inside + measures.irregular.boundary;
        let mut parts = vec![
            words::count(self.count(), "panel", "panels"),
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
        said
    }

    /// Lines over the surface along the edges, those at irregular vertices first, and their number.
    fn lines(&self, surface: &Surface) -> (Vec<Vec<Point>>, usize) {
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
