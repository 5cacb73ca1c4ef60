//! The result of a run for builders: how many panels have the required shape within a tolerance,
//! and how far the vertices have moved for it.

use super::inspect::{is_usual, panel_row};
use super::measuring::Shape;
use crate::constraint::Info;
use crate::math::nearest_round;
use crate::mesh::{Mesh, Topology};
use crate::session::Session;
use crate::session::run::{Bend, Flaw, Level, SurfaceDistance, Tried};
use crate::solve::{Moved, Require};
use crate::words::{group_digits, is_or_are, limit};
use serde::Serialize;

/// How many panels have the required shape, and what became of the design. Lengths are in the unit of
/// the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Verdict {
    /// The id of the kind that constrains them.
    pub kind: &'static str,
    /// The adjective for panels with the shape: "flat".
    pub adjective: &'static str,
    /// How good the shape is.
    pub level: Level,
    /// Why it is not good, the gravest reason first; for one that lacks panels or has folded faces, only
    /// an open seam.
    pub flaws: Vec<Flaw>,
    /// Number of panels whose worst vertex is within the tolerance.
    pub within: usize,
    /// Number of constrained panels.
    pub of: usize,
    /// The tolerance.
    pub tolerance: f64,
    /// The tolerance that they were made within, if that was one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub required: Option<f64>,
    /// The distance of the worst vertex.
    pub worst: f64,
    /// The face that it belongs to.
    pub worst_face: u32,
    /// Number of faces of the mesh that are folded or dented but were not at rest.
    pub folded: usize,
    /// The panels within a larger tolerance only.
    #[serde(skip)]
    pub eased: Option<EasedPanels>,
    /// Whether the search that found the shape has seen faces fold within the required tolerance; false
    /// where that is not known, as after opening a file.
    #[serde(skip)]
    pub would_fold: bool,
    /// Distances of the vertices from their rest positions.
    pub moved: Moved,
    /// Distances between the surface and the original.
    pub surface: SurfaceDistance,
    /// Whether the original is the surface on which the panels were laid out.
    #[serde(skip)]
    pub is_on_other: bool,
    /// The largest distance of a boundary vertex from the original boundary.
    pub boundary: f64,
    /// The angle between neighbouring faces.
    pub bend: Bend,
    /// The smallest ratio of an edge length to its rest length.
    pub shortest_edge: f64,
    /// The fraction of the area that is lost, after wrinkles are smoothed away.
    pub area_lost: f64,
    /// The largest distance between boundary vertices that lie on each other at rest, without being
    /// joined.
    pub seam: f64,
    /// The attempts of the search that led to the shape; empty if none did.
    pub attempts: Vec<Tried>,
    /// The name of the attempt that found it, by the scene where there was no search; empty if none
    /// did.
    pub chosen: String,
}

/// Panels with a larger tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EasedPanels {
    /// Number of panels.
    pub panels: usize,
    /// Their tolerance, in the unit of the mesh.
    pub within: f64,
}

/// The panels that are asked to have one shape.
struct Panels {
    /// The index of the row that asks for it.
    row: usize,
    kind: &'static Info,
    adjective: &'static str,
    /// The panels, ascending.
    faces: Vec<u32>,
    /// The distance of the worst vertex of each face of the mesh, `#F`.
    distances: Vec<f64>,
}

impl Panels {
    /// Returns those of the row that asks panels for a shape, see [`panel_row`]; none if no row does.
    fn of(session: &mut Session, shape: &Shape) -> Option<Panels> {
        let document = session.document();
        let row = panel_row(document)?;
        let (kind, is_usual) = {
            let kind = &document.constraints[row].kind;
            (kind.info(), is_usual(kind))
        };
        let adjective = kind.panels?;
        let [faces, _] = session.members(row);
        let distances = match is_usual {
            true => session.face_values_of(kind.measure?, shape)?,
            false => session.row_distances(row, shape),
        };
        (!faces.is_empty()).then_some(Panels { row, kind, adjective, faces, distances })
    }

    fn distance(&self, face: u32) -> f64 {
        self.distances[face as usize]
    }

    /// Number of panels whose worst vertex is within `tolerance`.
    fn within(&self, tolerance: f64) -> usize {
        self.faces.iter().filter(|&&face| self.distance(face) <= tolerance).count()
    }
}

impl Verdict {
    /// Whether all panels are within their tolerance, which may be a relaxed one.
    pub(crate) fn is_met(&self) -> bool {
        self.within + self.eased.map_or(0, |eased| eased.panels) == self.of
    }

    /// The relaxed tolerance, if it is that of most panels and none is beyond it: then it is said to be
    /// that of all.
    pub(crate) fn relaxed_for_most(&self) -> Option<f64> {
        let EasedPanels { panels, within } = self.eased?;
        (panels > self.within && self.is_met()).then_some(within)
    }
}

impl Session {
    /// Returns how many panels have the shape that the scene asks of them, with distances up to
    /// `tolerance`. None if no row constrains panels.
    pub fn verdict(&mut self, tolerance: f64) -> Option<Verdict> {
        let panels = Panels::of(self, &Shape::Now)?;
        let Panels { row, kind, adjective, faces, .. } = &panels;
        let distance = |face: u32| panels.distance(face);
        let worst_face =
            faces.iter().copied().max_by(|&a, &b| distance(a).total_cmp(&distance(b)))?;
        let within = panels.within(tolerance);
        let spec = &self.document().constraints[*row];
        let required = match spec.require {
            Require::Within(length) => Some(length),
            Require::Soft | Require::Exact => None,
        };
        let eased = spec.eased.as_ref().and_then(|eased| {
            let is_one = |face: &&u32| faces.binary_search(face).is_ok();
            let beyond = eased.faces.iter().filter(is_one).map(|&face| distance(face));
            let beyond = beyond.filter(|&far| far > tolerance && far <= eased.within).count();
            (beyond > 0).then_some(EasedPanels { panels: beyond, within: eased.within })
        });
        let measure = self.measured.shape_measure(&self.scene, &self.rest);
        let seam = self.rest.seam_at(self.scene.positions());
        let search = self.met_here();
        let mut verdict = Verdict {
            kind: kind.id,
            adjective,
            level: Level::Poor,
            flaws: Vec::new(),
            within,
            of: faces.len(),
            tolerance,
            required,
            worst: distance(worst_face),
            worst_face,
            folded: measure.folded.len(),
            eased,
            would_fold: search.and_then(|met| met.report.eased).is_some_and(|it| it.folded > 0),
            moved: measure.moved,
            surface: measure.surface,
            is_on_other: measure.is_on_other,
            boundary: measure.boundary,
            bend: measure.bend,
            shortest_edge: measure.shortest_edge,
            area_lost: measure.area_lost,
            seam,
            attempts: search.map_or_else(Vec::new, |met| met.tried.clone()),
            chosen: String::new(),
        };
        if verdict.is_met() {
            (verdict.level, verdict.flaws) = measure.level(eased.is_some(), self.edge_of_design());
        }
        if seam > tolerance {
            verdict.flaws.insert(0, Flaw::SeamOpened);
            verdict.level = verdict.level.max(Level::Fair);
        }
        // Without the search itself, as after opening a file, the scene names the attempt.
        if let Some(tried) = search.and_then(|met| met.tried.get(met.chosen?)) {
            verdict.chosen.clone_from(&tried.name);
        } else if required.is_some() && verdict.is_met() {
            verdict.chosen = self.document().attempt.name();
        }
        Some(verdict)
    }

    /// Returns the number of panels of a shape beyond `tolerance`, and of all panels; none if no row
    /// constrains panels.
    pub(crate) fn panels_beyond(&mut self, tolerance: f64, shape: &Shape) -> Option<[usize; 2]> {
        let panels = Panels::of(self, shape)?;
        let all = panels.faces.len();
        Some([all - panels.within(tolerance), all])
    }

    /// Says how many panels are within `tolerance` so far; none if no row constrains panels. It takes no
    /// longer than an iteration, unlike the whole verdict.
    pub fn panel_progress(&mut self, tolerance: f64) -> Option<String> {
        let panels = Panels::of(self, &Shape::Now)?;
        let (within, of) = (panels.within(tolerance), panels.faces.len());
        let tolerance = limit(tolerance, &self.document().units);
        Some(count_in_words(panels.adjective, within, of, &tolerance))
    }
}

/// Says that `within` of all panels have their shape within a tolerance, given in words.
pub(super) fn count_in_words(adjective: &str, within: usize, of: usize, tolerance: &str) -> String {
    let shape = format!("{adjective} within {tolerance}");
    let all = group_digits(of);
    match of {
        _ if within < of => {
            format!("{} of {all} panels {} {shape}.", group_digits(within), is_or_are(within))
        }
        1 => format!("The panel is {shape}."),
        _ => format!("All {all} panels are {shape}."),
    }
}

/// Returns a tolerance for distances on a mesh: about a thousandth of the mean edge, rounded to 1,
/// 2 or 5 times a power of ten, in the unit of the mesh; 1 for a mesh of no size.
pub fn tolerance_of(mesh: &Mesh) -> f64 {
    tolerance(Topology::new(mesh).mean_edge(&mesh.positions), mesh.size())
}

/// The same for a mesh of this mean `edge` and this `size`.
pub(crate) fn tolerance(edge: f64, size: f64) -> f64 {
    nearest_round(1e-3 * if edge > 0.0 { edge } else { size }).unwrap_or(1.0)
}
