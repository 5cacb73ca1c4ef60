//! One layout of new panels: its forecast, what is said of it, and the lines that show it.

use super::places::MarkedPlace;
use crate::math::marked;
use crate::mesh::{Mesh, Point, Surface, Topology};
use crate::quads::{Boundary, Remeshed};
use crate::scene::{Forecast, HowFar};
use crate::words;
use serde::Serialize;
use std::cmp::Ordering;

/// Panels are cut at the boundary without a wish if they then move less than this fraction as far: a
/// forecast is within a third of the move, and whole panels are easier to build.
const CUT_MOVES: f64 = 2.0 / 3.0;
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
    pub(super) remeshed: Remeshed,
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

    /// What the panels do at the boundary; none if they have none.
    pub(super) fn at_boundary(&self) -> Option<Boundary> {
        (self.remeshed.measures.loops > 0).then_some(self.boundary)
    }

    /// Whether no other choice at the boundary moves clearly less: there is none, or panels will hardly
    /// move to become circular or flat.
    pub(super) fn is_enough(&self) -> bool {
        self.at_boundary().is_none() || self.hardly_moves()
    }

    fn hardly_moves(&self) -> bool {
        let kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.into_iter().all(|kind| matches!(kind.how_far, HowFar::Nothing | HowFar::Hardly))
    }

    /// Whether the panels do not have the shape of every kind already.
    fn is_moved(&self) -> bool {
        let mut kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.any(|kind| kind.how_far != HowFar::Nothing)
    }

    /// Whether these panels, cut at the boundary, are better than those that follow it: they leave fewer
    /// faces as they are, or as many and move much less.
    pub(super) fn is_better_than(&self, followed: &Layout) -> bool {
        match self.remeshed.staying.cmp(&followed.remeshed.staying) {
            Ordering::Less => true,
            Ordering::Equal => self.move_length() < CUT_MOVES * followed.move_length(),
            Ordering::Greater => false,
        }
    }

    /// Whether these panels leave fewer faces as they are than others.
    pub(super) fn covers_more_than(&self, other: &Layout) -> bool {
        self.remeshed.staying < other.remeshed.staying
    }

    /// The largest mean move of the kinds of panels, in the unit of the mesh.
    pub(super) fn move_length(&self) -> f64 {
        let kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.map(|kind| kind.least_move).fold(0.0, f64::max) * self.remeshed.measures.edge.mean
    }

    /// The layout as hosts see it, on its shape without faces that are left out, and the surface of this;
    /// `units` is the symbol of the unit, `kept` the number of faces that were to stay, and `said` what is
    /// said of the choice at the boundary.
    pub(super) fn shown(
        &self,
        (shape, surface): &(Mesh, Surface),
        units: &str,
        (kept, said): (usize, Option<String>),
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
        notes.extend(said.map(|said| LayoutNote { words: format!("{said}."), places: Vec::new() }));
        if kept > 0 {
            let faces = words::count(kept, "selected face stays", "selected faces stay");
            let words = format!("{faces}, and the panels share no corners with what stays.");
            notes.push(LayoutNote { words, places: Vec::new() });
        }
        let (lines, irregular) = self.lines(surface);
        PanelLayout {
            boundary: self.at_boundary(),
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

    /// What this choice at the boundary comes to: "483 panels, will move about 20 mm off the surface".
    pub(super) fn forecast(&self, units: &str) -> BoundaryForecast {
        let count = words::count(self.count(), "panel", "panels");
        let words = format!("{count}, will {}", self.moves(units));
        BoundaryForecast { boundary: self.boundary, words }
    }

    /// "move about 20 mm off the surface", or "not move" if the panels have the shape of every kind already.
    pub(super) fn moves(&self, units: &str) -> String {
        match self.is_moved() {
            true => {
                let far = words::rough_length(self.move_length(), units);
                format!("move about {far} off the surface")
            }
            false => "not move".to_owned(),
        }
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
            // The panels will be kept close to the surface, along which they glide for nothing: how far
            // they leave it is as forecast, and their whole way two or three times that.
            let besides = if self.is_moved() { ", besides gliding along the surface" } else { "" };
            said += &format!(" The mesh will then {}{besides}.", forecast.moves(units));
        }
        said
    }

    /// Lines over the surface along the edges, those at irregular vertices first, and their number.
    fn lines(&self, surface: &Surface) -> (Vec<Vec<Point>>, usize) {
        let Layout { topology, remeshed, .. } = self;
        let is_irregular =
            marked(remeshed.mesh.positions.len(), remeshed.irregular.iter().copied());
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
