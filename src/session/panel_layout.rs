//! New panels along the lines of curvature of the surface: laid out on a copy, shown, and taken in
//! place of the mesh.

use super::Session;
use super::edit::check_lock;
use crate::mesh::{Edited, Mesh, Point, Surface, Topology};
use crate::quads::{
    Boundary, MapOptions, PanelSize, RemeshError, RemeshObserver, Remeshed, Remesher,
    direction_weight, follow_weight,
};
use crate::scene::{Forecast, HowFar, Lock, SceneError};
use crate::session::Error;
use crate::words;
use serde::{Deserialize, Serialize};

/// The number of panels of a mesh of triangles without a wish: half its triangles, within these.
const PANELS: [usize; 2] = [60, 500];
/// The same of other meshes, whose faces are panels.
const FACES: [usize; 2] = [60, 2000];
/// Panels are cut at the boundary without a wish if they then move at most this fraction as far.
const CUT_MOVES: f64 = 0.5;
/// Points of the surface along the line of an edge.
const LINE_POINTS: usize = 5;

/// What is wished of new panels.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(deny_unknown_fields)]
pub struct LayoutSettings {
    /// Their number;
    #[serde(default)]
    pub count: Option<usize>,
    /// or the length of their sides, in the unit of the mesh. Without either, a number that suits the
    /// mesh.
    #[serde(default)]
    pub size: Option<f64>,
    /// From 0, few irregular points, to 1, a small move to circular panels.
    pub follow: f64,
    /// From 0, a small move, to 1, panels of even size.
    pub even: f64,
    /// Whether the boundary is followed or cuts panels; without a wish, what moves less.
    #[serde(default)]
    pub boundary: Option<Boundary>,
}

/// New panels on the surface.
#[derive(Clone, Debug)]
pub struct PanelLayout {
    /// Their mesh.
    pub mesh: Mesh,
    /// What they do at the boundary; none if the surface is closed.
    pub boundary: Option<Boundary>,
    /// The mean length of their sides, in the unit of the mesh.
    pub size: f64,
    /// What is to be said of them, and what they cannot follow.
    pub words: Vec<String>,
    /// Lines over the surface along their edges, those at irregular vertices first.
    pub lines: Vec<Vec<Point>>,
    /// The number of lines at irregular vertices.
    pub irregular_lines: usize,
}

impl Session {
    /// Lays out panels along the lines of curvature of the current shape.
    ///
    /// # Errors
    /// If panels of this size cannot cover the surface, or if `observer` cancels.
    pub fn lay_out_panels(
        &self,
        settings: &LayoutSettings,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<PanelLayout, Error> {
        if !self.mesh().tets.is_empty() {
            let message = "the mesh has tetrahedra, expected a surface".to_owned();
            return Err(SceneError { path: String::new(), message }.into());
        }
        let refused =
            |error: RemeshError| SceneError { path: String::new(), message: error.to_string() };
        let shape = self.current_mesh();
        let followed = settings.boundary.unwrap_or(Boundary::Followed);
        let mut remesher = Remesher::new(&shape).map_err(refused)?;
        let mut layout =
            self.layout(&mut remesher, settings, followed, observer).map_err(refused)?;
        let has_boundary = !self.topology().boundary_loops().is_empty();
        if settings.boundary.is_none() && has_boundary && layout.moves_a_lot() {
            // Panels that are cut may move less. What cannot be cut stays followed.
            match self.layout(&mut remesher, settings, Boundary::Cut, observer) {
                Err(RemeshError::Cancelled) => return Err(refused(RemeshError::Cancelled).into()),
                Ok(cut) if cut.move_length() <= CUT_MOVES * layout.move_length() => layout = cut,
                _ => {}
            }
        }
        Ok(layout.shown(&shape, &self.document().units))
    }

    /// Puts panels in place of the mesh, as one step of undo, if the session still has this
    /// generation; returns whether it has. The scene is carried over.
    ///
    /// # Errors
    /// If the lesson locks the mesh, or the system would be singular; nothing has changed then.
    pub fn take_panels(&mut self, generation: u32, panels: &Mesh) -> Result<bool, Error> {
        if self.is_dragging() || generation != self.generation() {
            return Ok(false);
        }
        check_lock(Lock::Mesh, self.document())?;
        self.end_transaction();
        let edited = Edited::covering(&self.current_mesh(), panels);
        let change = self.replace_mesh(&edited)?;
        let count = words::count(panels.faces.len(), "panel", "panels");
        self.history.push(format!("Lay out {count}"), change);
        Ok(true)
    }

    /// The mesh at its current positions.
    fn current_mesh(&self) -> Mesh {
        Mesh { positions: self.positions(), ..self.mesh().clone() }
    }

    fn layout(
        &self,
        remesher: &mut Remesher,
        settings: &LayoutSettings,
        boundary: Boundary,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Layout, RemeshError> {
        let size = match (settings.size, settings.count) {
            (Some(length), _) => PanelSize::Length(length),
            (None, Some(count)) => PanelSize::Count(count),
            (None, None) => PanelSize::Count(usual_count(self.mesh())),
        };
        let options = MapOptions {
            follow: follow_weight(settings.follow),
            direction: direction_weight(settings.even),
            boundary,
            ..MapOptions::of_size(size)
        };
        let remeshed = remesher.remesh(&options, &self.document().units, observer)?;
        let topology = Topology::new(&remeshed.mesh);
        let forecast = Forecast::of(&remeshed.mesh, &topology);
        Ok(Layout { remeshed, topology, forecast, boundary })
    }
}

/// The number of panels that suits a mesh.
fn usual_count(mesh: &Mesh) -> usize {
    let faces = mesh.faces.len();
    match mesh.faces.iter().all(|face| face.len() == 3) {
        true => (faces / 2).clamp(PANELS[0], PANELS[1]),
        false => faces.clamp(FACES[0], FACES[1]),
    }
}

/// A layout with its forecast.
struct Layout {
    remeshed: Remeshed,
    topology: Topology,
    forecast: Option<Forecast>,
    boundary: Boundary,
}

impl Layout {
    /// Whether some panels will move a lot to become circular or flat.
    fn moves_a_lot(&self) -> bool {
        let kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.into_iter().any(|kind| kind.how_far == HowFar::Lot)
    }

    /// The largest mean move of the kinds of panels, in the unit of the mesh.
    fn move_length(&self) -> f64 {
        let kinds = self.forecast.iter().flat_map(|forecast| &forecast.kinds);
        kinds.map(|kind| kind.least_move).fold(0.0, f64::max) * self.remeshed.measures.edge.mean
    }

    fn shown(self, shape: &Mesh, units: &str) -> PanelLayout {
        let words = self.words(units);
        let (lines, irregular_lines) = self.lines(shape);
        PanelLayout {
            boundary: (!self.topology.boundary_loops().is_empty()).then_some(self.boundary),
            size: self.remeshed.measures.edge.mean,
            mesh: self.remeshed.mesh,
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
            count: self.mesh.faces.len(),
            size: words::rounded(self.size, 2),
        }
    }
}
