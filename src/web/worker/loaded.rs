//! The summary of a file that was opened.

use crate::mesh::{Read, Weld};
use crate::scene::{
    MeshSuggestion, PanelOffer, Up, offers_new_panels, panel_offers, panel_suggestion,
    problem_suggestion,
};
use crate::session::{FACE_MEASURES, Guessed, Session, flaw_of};
use serde::Serialize;
use std::collections::BTreeMap;
use tsify::Tsify;

/// The summary of a file that was opened.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Loaded {
    name: String,
    title: String,
    vertices: usize,
    faces: usize,
    curves: usize,
    tets: usize,
    groups: Vec<Group>,
    units: String,
    up: Up,
    /// Unit and up axis where they were guessed because the file does not state them.
    guessed: GuessedFrame,
    /// The size at rest, by which rounding errors are told, in its unit.
    size: f64,
    /// For each measure of faces, by its id, the bound below which values are rounding errors.
    #[tsify(type = "Record<string, number>")]
    roundings: BTreeMap<&'static str, f64>,
    /// Mean edge length at rest; zero without edges.
    #[serde(rename = "meanEdge")]
    mean_edge: f64,
    /// The kinds that are offered for making all panels.
    panels: Vec<PanelOffer>,
    /// A change of the mesh after which they apply.
    #[serde(rename = "panelSuggestion")]
    panel_suggestion: Option<MeshSuggestion>,
    /// Whether new panels along the lines of curvature are offered for it at once.
    #[serde(rename = "newPanels")]
    new_panels: bool,
    /// None if nothing was welded.
    welded: Option<Welded>,
    problems: Vec<Problem>,
    notes: Vec<String>,
}

/// A unit and an up axis that were guessed.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct GuessedFrame {
    units: Option<String>,
    up: Option<Up>,
}

/// The vertex counts of file and mesh, and the distance within which vertices were merged.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct Welded {
    before: usize,
    after: usize,
    tolerance: f64,
}

#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct Group {
    name: String,
    faces: usize,
}

/// A recoverable problem of a file.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct Problem {
    /// One sentence: how often it occurs, and where first.
    message: String,
    count: usize,
    /// The line of the first occurrence.
    line: Option<usize>,
    /// The name for querying the elements with this problem; none if they are not in the mesh.
    flaw: Option<&'static str>,
    /// A change of the mesh that mends it.
    suggestion: Option<MeshSuggestion>,
}

impl Loaded {
    /// Creates the summary of the file `name`, opened as `session`; `read` has its messages.
    pub(super) fn new(
        name: &str,
        session: &Session,
        read: &Read,
        guessed: Guessed,
        weld: Option<&Weld>,
    ) -> Self {
        let mesh = session.mesh();
        let size = mesh.size();
        let groups = mesh.groups.iter();
        let problems = read.problems.iter();
        Loaded {
            name: name.to_owned(),
            title: session.document().title.clone(),
            vertices: mesh.positions.len(),
            faces: mesh.faces.len(),
            curves: mesh.curves.len(),
            tets: mesh.tets.len(),
            groups: groups
                .map(|group| Group { name: group.name.clone(), faces: group.faces.len() })
                .collect(),
            units: session.document().units.clone(),
            up: session.document().up,
            guessed: GuessedFrame {
                units: guessed.units.then(|| session.document().units.clone()),
                up: guessed.up.then_some(session.document().up),
            },
            size,
            roundings: FACE_MEASURES
                .iter()
                .map(|measure| (measure.id, measure.unit.rounding(size)))
                .collect(),
            mean_edge: session.mean_edge(),
            panels: panel_offers(mesh),
            panel_suggestion: panel_suggestion(mesh, session.topology()),
            new_panels: offers_new_panels(mesh, session.topology()),
            welded: weld.map(|weld| Welded {
                before: weld.to.len(),
                after: mesh.positions.len(),
                tolerance: weld.tolerance,
            }),
            problems: problems
                .map(|p| Problem {
                    message: p.to_string(),
                    count: p.count,
                    line: p.line,
                    flaw: flaw_of(p.kind),
                    suggestion: problem_suggestion(p.kind, mesh, session.topology()),
                })
                .collect(),
            notes: read.notes.clone(),
        }
    }
}
