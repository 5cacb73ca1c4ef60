//! What the worker tells the page, as plain objects in camelCase.

use super::lesson::{GoalNumbers, LessonWords};
use crate::constraint::{Element, Info, KINDS, Kind, LocalStep, Sketch, describe};
use crate::mesh::{Circularity, Planarity, Read, Weld};
use crate::scene::{Hold, PRESETS, PanelOffer, Preset, PresetOffer, Worded, panel_offers};
use crate::session::{Moved, Session, flaw_of, settings_of};
use crate::solve::Energy;
use serde::Serialize;
use serde_json::Value;

/// What was read from a file.
#[derive(Serialize)]
pub(super) struct Loaded {
    name: String,
    title: String,
    vertices: usize,
    faces: usize,
    curves: usize,
    tets: usize,
    groups: Vec<Group>,
    units: String,
    up: &'static str,
    guessed: Guessed,
    /// Mean length of an edge at rest; zero without edges.
    #[serde(rename = "meanEdge")]
    mean_edge: f64,
    /// For distances, in the unit of the mesh.
    tolerance: f64,
    panels: Vec<PanelOffer>,
    welded: Option<Welded>,
    problems: Vec<Problem>,
    notes: Vec<String>,
}

/// How many vertices the file has and the mesh has, and within which distance they are at one place.
#[derive(Serialize)]
struct Welded {
    before: usize,
    after: usize,
    tolerance: f64,
}

/// Which of these the file does not say.
#[derive(Serialize)]
pub(super) struct Guessed {
    pub(super) units: bool,
    pub(super) up: bool,
}

#[derive(Serialize)]
struct Group {
    name: String,
    faces: usize,
}

#[derive(Serialize)]
struct Problem {
    message: String,
    count: usize,
    line: Option<usize>,
    /// What to ask for the elements that have it.
    flaw: Option<&'static str>,
}

impl Loaded {
    /// About the file `name`, opened as `session`; `read` holds what its reader said.
    pub(super) fn new(
        name: &str,
        session: &Session,
        read: &Read,
        guessed: Guessed,
        weld: Option<&Weld>,
    ) -> Self {
        let mesh = session.mesh();
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
            up: session.document().up.word(),
            guessed,
            mean_edge: session.mean_edge(),
            tolerance: session.tolerance(),
            panels: panel_offers(mesh),
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
                })
                .collect(),
            notes: read.notes.clone(),
        }
    }
}

/// The document as it stands.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    title: &'a str,
    units: &'a str,
    up: &'static str,
    constraints: Vec<ConstraintRow<'a>>,
    handles: Vec<HandleRow>,
    weights: Weights,
    closeness: &'static str,
    smoothness: SmoothnessWords,
    /// Of every declared setting its value.
    settings: serde_json::Map<String, Value>,
    /// The id of the preset whose settings it has.
    preset: Option<&'static str>,
    presets: Vec<PresetOffer>,
    /// Vertices that nothing acts on.
    free: usize,
    sets: Vec<NamedSet<'a>>,
    /// Vertices that are kept close more or less than the others.
    #[serde(rename = "heldOtherwise")]
    held_otherwise: usize,
    undo: Option<&'a str>,
    redo: Option<&'a str>,
    pinned: &'a [u32],
    lesson: Option<LessonWords<'a>>,
}

#[derive(Serialize)]
struct NamedSet<'a> {
    name: &'a str,
    vertices: usize,
    faces: usize,
}

#[derive(Serialize)]
struct ConstraintRow<'a> {
    index: usize,
    kind: &'static str,
    /// Its name, or what its kind is called.
    label: &'a str,
    name: &'a str,
    colour: [u8; 3],
    on: String,
    count: usize,
    skipped: usize,
    weight: f64,
    enabled: bool,
    measure: Option<&'static str>,
    params: Value,
}

#[derive(Serialize)]
struct HandleRow {
    vertex: u32,
    target: [f64; 3],
    weight: f64,
    fixed: bool,
}

#[derive(Serialize)]
struct Weights {
    shape: f64,
    close: f64,
    smooth: f64,
}

#[derive(Serialize)]
struct SmoothnessWords {
    of: &'static str,
    weighting: &'static str,
}

impl<'a> Document<'a> {
    /// The document of `session`.
    pub(super) fn new(session: &'a Session) -> Self {
        let scene = session.document();
        let specs = scene.constraints.iter();
        let constraints = specs
            .zip(session.rows())
            .enumerate()
            .map(|(index, (spec, row))| {
                let info = spec.kind.info();
                ConstraintRow {
                    index,
                    kind: info.id,
                    label: spec.label(),
                    name: &spec.name,
                    colour: info.colour,
                    on: describe(&spec.on),
                    count: row.constraints.members.len(),
                    skipped: row.skipped,
                    weight: spec.weight,
                    enabled: spec.enabled,
                    measure: session.asked_measure(index),
                    params: spec.kind.params(),
                }
            })
            .collect();
        let handles = session.solver().handles().iter();
        let handles = handles
            .map(|handle| {
                let (weight, fixed) = match handle.hold {
                    Hold::Soft { weight } => (weight, false),
                    Hold::Fixed => (0.0, true),
                };
                HandleRow { vertex: handle.vertex, target: handle.target, weight, fixed }
            })
            .collect();
        let [undo, redo] = session.undo_and_redo();
        let crate::scene::Weights { shape, close, smooth } = scene.weights;
        Document {
            title: &scene.title,
            units: &scene.units,
            up: scene.up.word(),
            constraints,
            handles,
            weights: Weights { shape, close, smooth },
            closeness: scene.closeness.to.word(),
            smoothness: SmoothnessWords {
                of: scene.smoothness.of.word(),
                weighting: scene.smoothness.weighting.word(),
            },
            settings: settings_of(scene),
            preset: Preset::of(scene).map(|preset| preset.id),
            presets: PRESETS
                .iter()
                .map(|preset| preset.offer(session.topology(), session.solver().handles().len()))
                .collect(),
            free: session.free().len(),
            sets: scene
                .sets
                .iter()
                .map(|(name, set)| NamedSet {
                    name,
                    vertices: set.vertices.len(),
                    faces: set.faces.len(),
                })
                .collect(),
            held_otherwise: session.held_otherwise(),
            undo,
            redo,
            pinned: session.solver().pinned(),
            lesson: scene.lesson.as_ref().map(LessonWords::new),
        }
    }
}

/// The numbers of one state of the iteration.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Frame {
    iteration: u32,
    converged: bool,
    /// How the shape has collapsed.
    collapse: Option<String>,
    /// The local step is done, the global step is next.
    halfway: bool,
    energy: Energy,
    planarity: Planarity,
    circularity: Circularity,
    moved: Moved,
    /// The least length of an edge as a part of its length at rest.
    shortest_edge: f64,
    /// Of each row of the document, disabled ones included as zero.
    worst: Vec<f64>,
    /// Of each row its part of the total energy, from 0 to 1.
    shares: Vec<f64>,
    /// Of each goal of the lesson.
    goals: Vec<GoalNumbers>,
    step_ms: f64,
}

impl Frame {
    /// The state of `session`, whose last step took `step_ms`.
    pub(super) fn new(session: &mut Session, step_ms: f64) -> Self {
        let goals = GoalNumbers::of(session);
        let measures = session.measures();
        let mut found = session.solver().found();
        let rows = session.rows().iter().map(|row| row.enabled.then(|| found.next()).flatten());
        let rows: Vec<LocalStep> = rows.map(Option::unwrap_or_default).collect();
        let energy = session.solver().energy();
        let whole = session.document().weights.shape / energy.total;
        let share = |row: &LocalStep| if energy.total > 0.0 { row.energy * whole } else { 0.0 };
        Frame {
            iteration: session.iteration(),
            converged: session.converged(),
            collapse: session.collapse().map(|collapse| collapse.to_string()),
            halfway: session.halfway(),
            energy,
            planarity: measures.planarity,
            circularity: measures.circularity,
            moved: session.moved(),
            shortest_edge: session.shortest_edge(),
            worst: rows.iter().map(|row| row.worst_squared.sqrt()).collect(),
            shares: rows.iter().map(share).collect(),
            goals,
            step_ms,
        }
    }
}

/// An element that can carry one constraint each.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct ElementWords {
    id: &'static str,
    label: &'static str,
    face_based: bool,
}

/// Every element.
pub(super) fn elements() -> Vec<ElementWords> {
    let all = Element::ALL.iter();
    all.map(|&element| ElementWords {
        id: element.id(),
        label: element.label(),
        face_based: element == Element::Face,
    })
    .collect()
}

/// A kind with its drawing.
#[derive(Serialize)]
pub(super) struct KindWords {
    #[serde(flatten)]
    info: &'static Info,
    /// How many vertices or edges it takes, in words.
    takes: String,
    sketch: Sketch,
}

/// Every kind.
pub(super) fn kinds() -> Vec<KindWords> {
    let all = KINDS.iter();
    all.map(|info| {
        let kind = Kind::new(info.id, Value::Object(serde_json::Map::new()));
        let sketch = kind.expect("every parameter has a default").sketch();
        KindWords { info, takes: info.takes(), sketch }
    })
    .collect()
}
