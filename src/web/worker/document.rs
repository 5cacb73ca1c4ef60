//! The document as the page shows it.

use super::solver::Solver;
use crate::constraint::describe;
use crate::scene::{
    ClosenessTo, Hold, Lesson, Lock, PRESETS, Preset, PresetOffer, Slide, SmoothnessOf, Up,
};
use crate::session::{
    EasedPanels, GoalWords, Session, UnusedCloseness, goals_in_words, settings_of,
};
use crate::solve::Require;
use crate::web::values::{Js, plain};
use serde::Serialize;
use serde_json::Value;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// The current document.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Document<'a> {
    title: &'a str,
    units: &'a str,
    up: Up,
    /// The distance within which panels have their shape, in the unit of the mesh.
    tolerance: f64,
    constraints: Vec<ConstraintRow<'a>>,
    /// The id of the measure of faces that fits the constraints, if there are any.
    measure: Option<&'static str>,
    handles: Vec<HandleRow>,
    weights: Weights,
    closeness: ClosenessTo,
    /// Whether the target shapes are taken from another pose.
    pose: bool,
    smoothness: SmoothnessOf,
    /// The value of each declared setting.
    #[tsify(type = "Record<string, ParamValue>")]
    settings: serde_json::Map<String, Value>,
    /// Why closeness has no effect, and the settings that have none therefore.
    #[serde(rename = "unusedCloseness")]
    unused_closeness: Option<UnusedCloseness>,
    /// The id of the preset that has the same settings.
    preset: Option<&'static str>,
    presets: Vec<PresetOffer>,
    /// The number of vertices on which nothing acts.
    free: usize,
    sets: Vec<NamedSet<'a>>,
    /// The number of vertices with a closeness weight of their own.
    #[serde(rename = "reweightedVertices")]
    reweighted_vertices: usize,
    /// The name of the step that Undo reverts.
    undo: Option<&'a str>,
    /// The name of the step that Redo repeats.
    redo: Option<&'a str>,
    /// Vertices that were fixed because nothing else holds their connected component.
    pinned: &'a [u32],
    lesson: Option<LessonWords<'a>>,
    /// The presentation.
    steps: &'a [Slide],
    /// A sentence for each constraint on pairs of vertices, some of which have no partner.
    unpaired: Vec<String>,
    /// The settings for building the shape.
    #[tsify(type = "Required<BuildSettings> | null")]
    build: Option<Value>,
    /// The names of the variants that were kept.
    variants: Vec<&'a str>,
    /// The index of the variant that is the design.
    design: Option<usize>,
    /// Whether the mesh is too large for exact constraints.
    #[serde(rename = "tooLargeForExact")]
    too_large_for_exact: bool,
}

#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct NamedSet<'a> {
    name: &'a str,
    vertices: usize,
    faces: usize,
}

#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct ConstraintRow<'a> {
    index: usize,
    /// Tells it from all other rows, whatever its index is by then.
    number: u32,
    kind: &'static str,
    /// Its name, or the label of its kind.
    label: &'a str,
    /// Empty without a name.
    name: &'a str,
    /// Three sRGB bytes.
    colour: [u8; 3],
    /// Its selector, in words.
    on: String,
    /// The number of constraints.
    count: usize,
    /// The number of elements whose vertex count does not fit the kind.
    skipped: usize,
    /// The id of the measure of faces whose largest value is the largest distance of the row.
    measure: Option<&'static str>,
    weight: f64,
    enabled: bool,
    /// In the form of the scene file.
    require: Require,
    /// The panels with a weaker requirement.
    eased: Option<EasedPanels>,
    #[tsify(type = "Record<string, ParamValue>")]
    params: Value,
}

#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct HandleRow {
    vertex: u32,
    target: [f64; 3],
    weight: f64,
    fixed: bool,
}

#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct Weights {
    shape: f64,
    close: f64,
    smooth: f64,
}

/// The exercise of the scene.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
struct LessonWords<'a> {
    text: &'a str,
    goals: Vec<GoalWords<'a>>,
    /// The locked parts.
    lock: &'a [Lock],
}

impl<'a> LessonWords<'a> {
    fn new(lesson: &'a Lesson, units: &str) -> Self {
        let goals = goals_in_words(lesson, units);
        LessonWords { text: &lesson.text, goals, lock: &lesson.lock }
    }
}

impl<'a> Document<'a> {
    /// Creates the document of `session`.
    fn new(session: &'a Session) -> Self {
        let scene = session.document();
        let specs = scene.constraints.iter();
        let constraints = specs
            .zip(session.rows())
            .enumerate()
            .map(|(index, (spec, row))| {
                let info = spec.kind.info();
                ConstraintRow {
                    index,
                    number: spec.number.get(),
                    kind: info.id,
                    label: spec.label(),
                    name: &spec.name,
                    colour: info.colour,
                    on: describe(&spec.on),
                    count: row.constraints.members.len(),
                    skipped: row.skipped,
                    measure: session.row_measure(index),
                    weight: spec.weight,
                    enabled: spec.enabled,
                    require: spec.require,
                    eased: spec.eased.as_ref().map(|eased| EasedPanels {
                        panels: eased.faces.len(),
                        within: eased.within,
                    }),
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
            up: scene.up,
            tolerance: session.tolerance(),
            constraints,
            measure: session.scene_measure(),
            handles,
            weights: Weights { shape, close, smooth },
            closeness: scene.closeness.to,
            pose: scene.pose.is_some(),
            smoothness: scene.smoothness.of,
            settings: settings_of(scene),
            unused_closeness: UnusedCloseness::of(scene, session.topology()),
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
            reweighted_vertices: session.reweighted_vertices(),
            undo,
            redo,
            pinned: session.solver().pinned(),
            lesson: scene.lesson.as_ref().map(|lesson| LessonWords::new(lesson, &scene.units)),
            steps: &scene.steps,
            variants: scene.variants.kept.iter().map(|variant| &*variant.name).collect(),
            design: scene.variants.design,
            too_large_for_exact: session.is_too_large_for_exact(),
            unpaired: session.unpaired_words(),
            build: scene.build.as_deref().and_then(|build| serde_json::to_value(build).ok()),
        }
    }
}

#[wasm_bindgen]
impl Solver {
    /// Returns the document: constraints, handles, weights, undo and redo.
    pub fn document(&self) -> Result<Js<Document<'static>>, JsValue> {
        plain(&Document::new(self.open()?))
    }
}
