//! The shapes offered for all panels of a mesh, and the request for one of them.

use crate::constraint::{Centring, Element, Info, KINDS, Kind, KindError, Selector};
use crate::mesh::{
    MESH_OPERATIONS, Mesh, ProblemKind, Topology, mean_dihedral_angle, orientation, untouched_words,
};
use crate::scene::{ClosenessTo, ConstraintSpec, RowNumber, Scene, SceneError};
use crate::solve::Require;
use serde::Serialize;

/// A kind offered for all panels, and whether it applies to a mesh.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct PanelOffer {
    /// The id of a kind with [`Info::panels`].
    pub kind: &'static str,
    /// Reason why the kind does not apply to the mesh, if so.
    pub reason: Option<String>,
}

/// Returns the kinds offered for all panels, and whether each applies to `mesh`.
pub fn panel_offers(mesh: &Mesh) -> Vec<PanelOffer> {
    let offered = KINDS.iter().filter_map(|info| Some((info, info.panels?)));
    offered
        .map(|(info, adjective)| PanelOffer {
            kind: info.id,
            reason: against(info, adjective, mesh),
        })
        .collect()
}

/// Returns the adjective for panels of the kind with this id; none if it is not offered for panels.
pub fn panel_adjective(kind: &str) -> Option<&'static str> {
    KINDS.iter().find(|info| info.id == kind)?.panels
}

pub(super) fn is_of_triangles(mesh: &Mesh) -> bool {
    mesh.faces.iter().all(|face| face.len() <= 3)
}

/// Whether more than half of the faces are triangles: a surface that was drawn or scanned, and not laid
/// out in panels, even if a program has joined some of them.
pub fn is_mostly_triangles(mesh: &Mesh) -> bool {
    2 * mesh.faces.iter().filter(|face| face.len() <= 3).count() > mesh.faces.len()
}

/// Returns the reason why the kind does not apply to `mesh`, if so.
fn against(info: &Info, adjective: &str, mesh: &Mesh) -> Option<String> {
    if mesh.faces.is_empty() {
        match mesh.untouched.len() {
            0 => Some("There are no panels.".to_owned()),
            faces => Some(format!("There are no panels: {}.", untouched_words(faces))),
        }
    } else if is_of_triangles(mesh) {
        Some(format!("All panels are triangles, which are always {adjective}."))
    } else if fitting(info, mesh) == 0 {
        Some(format!("This needs panels with {}.", info.arity_in_words()))
    } else {
        None
    }
}

/// Counts the faces whose number of corners suits a kind.
fn fitting(info: &Info, mesh: &Mesh) -> usize {
    let size = |face: &[u32]| match info.centring {
        Centring::ByEdge => 2 * face.len(),
        Centring::Together | Centring::Placed => face.len(),
    };
    mesh.faces.iter().filter(|face| info.arity.fits(size(face))).count()
}

impl Scene {
    /// Requests the shape `kind`, soft or hard by `require`, for every suitable face of `mesh`, and
    /// returns the declaration of the kind. An existing constraint of this kind without
    /// parameters of its own on all faces is enabled instead, and stays exact if it was. Constraints of
    /// other offered kinds on all faces are disabled. Weights that would not keep the mesh intact are
    /// set by [`Scene::set_opened_defaults`]. What a search has chosen for other panels is taken back
    /// first: see [`Scene::as_asked`].
    ///
    /// # Errors
    /// If there is no such kind, or no face suits it.
    pub fn request_panels(
        &mut self,
        kind: &str,
        require: Require,
        mesh: &Mesh,
    ) -> Result<&'static Info, SceneError> {
        let error = |message: String| SceneError { path: "panels".to_owned(), message };
        let kind = Kind::new(kind, serde_json::json!({})).map_err(|failed| match failed {
            KindError::Unknown => error(format!("found `{kind}`, expected {}", known())),
            KindError::Params { path, message } => {
                error(format!("`{kind}` needs the parameter {path}: {message}"))
            }
        })?;
        let info = kind.info();
        let reason = info.panels.and_then(|adjective| against(info, adjective, mesh));
        if let Some(reason) = reason {
            return Err(error(reason));
        }
        if fitting(info, mesh) == 0 {
            let takes = info.arity_in_words();
            return Err(error(format!(
                "no face is suitable for `{}`, which takes {takes}",
                info.id
            )));
        }

        self.as_asked();
        for row in self.constraints.iter_mut().filter(|row| row.on == all_faces()) {
            let other = row.kind.info();
            if info.panels.is_some() && other.panels.is_some() && other.id != info.id {
                row.enabled = false;
            }
        }
        let is_asked = |row: &ConstraintSpec| row.kind == kind && row.on == all_faces();
        let asked = self.constraints.iter_mut().filter(|row| is_asked(row));
        match asked.min_by_key(|row| !row.enabled) {
            Some(row) => {
                row.enabled = true;
                if require.is_hard() && row.require != Require::Exact {
                    row.require = require;
                }
            }
            None => self.constraints.push(ConstraintSpec {
                kind,
                on: all_faces(),
                weight: 1.0,
                enabled: true,
                name: String::new(),
                require,
                eased: None,
                number: RowNumber::default(),
            }),
        }
        let is_close = self.weights.close > 0.0 && self.closeness.to != ClosenessTo::None;
        let held = is_close || self.weights.smooth > 0.0;
        if !held || self.weights.shape == 0.0 {
            self.set_opened_defaults();
        }
        Ok(info)
    }
}

/// The selector of a constraint on all panels.
pub(crate) fn all_faces() -> Selector {
    Selector::Each { element: Element::Face, within: None, radius: 0 }
}

fn known() -> String {
    KINDS.iter().map(|info| info.id).collect::<Vec<_>>().join(", ")
}

/// A change of the mesh, for panels of one shape or to mend a problem.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MeshSuggestion {
    /// Why it helps.
    pub words: String,
    /// The id of one of the [`MESH_OPERATIONS`].
    pub operation: &'static str,
    /// What it does: the label of a button.
    pub label: &'static str,
}

impl MeshSuggestion {
    /// Creates a suggestion from the id of an operation; none if there is no such operation.
    pub(super) fn new(operation: &str, words: String) -> Option<MeshSuggestion> {
        let operation = MESH_OPERATIONS.iter().find(|one| one.id == operation)?;
        Some(MeshSuggestion { words, operation: operation.id, label: operation.label })
    }
}

/// Fewer triangles have no curvature to speak of.
const FEWEST: usize = 10;
/// Faces that meet at a smaller mean angle are a flat plate, in degrees.
const FLAT: f64 = 0.01;

/// Whether new panels along the lines of curvature are offered for a mesh: one mostly of triangles, on
/// which no panels can be asked for, that is curved.
pub fn offers_new_panels(mesh: &Mesh, topology: &Topology) -> bool {
    let is_surface =
        mesh.tets.is_empty() && mesh.faces.len() >= FEWEST && is_mostly_triangles(mesh);
    is_surface && mean_dihedral_angle(mesh, topology, &mesh.positions) > FLAT
}

/// Returns the change of the mesh that mends a problem of it, if there is one: not for a surface with
/// one side only.
pub fn problem_suggestion(
    kind: ProblemKind,
    mesh: &Mesh,
    topology: &Topology,
) -> Option<MeshSuggestion> {
    let (id, label, words) = match kind {
        ProblemKind::UnjoinedVertex => {
            ("join", "Join them", "Nothing keeps the patches together at the seam.")
        }
        ProblemKind::FlippedNeighbour if orientation(&mesh.faces, topology).1.is_empty() => {
            ("unify", "Turn them", "The front of some faces is on the other side.")
        }
        _ => return None,
    };
    Some(MeshSuggestion { label, ..MeshSuggestion::new(id, words.to_owned())? })
}

/// Returns the change of the mesh after which the offered kinds apply, if there is one: none applies
/// to triangles, which can be joined to quads.
pub fn panel_suggestion(mesh: &Mesh, topology: &Topology) -> Option<MeshSuggestion> {
    let can_join = mesh.faces.len() > 1 && mesh.tets.is_empty() && is_of_triangles(mesh);
    let adjectives: Vec<&str> = KINDS.iter().filter_map(|info| info.panels).collect();
    let ways = match offers_new_panels(mesh, topology) {
        true => "New panels can follow the lines of curvature, or pairs of triangles can",
        false => "Pairs of triangles can",
    };
    let words = format!(
        "All panels are triangles, which are always {}. {ways} be joined to quads.",
        adjectives.join(" and ")
    );
    can_join.then(|| MeshSuggestion::new("quads", words)).flatten()
}
