//! The edits of the document: each is one step of undo.

use super::remeshing::Remeshing;
use crate::constraint::Set;
use crate::fabricate::BuildSettings;
use crate::json::indices::{self, Indices};
use crate::mesh::{KEPT_TURN, Point, Scheme};
use crate::scene::{ConstraintSpec, Lesson, Slide, Up, Weights};
use crate::solve::Require;
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value};
use std::rc::Rc;

/// An edit of the document; [`Edit::from_json`] reads one.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Edit {
    /// Appends a row of constraints.
    AddConstraint(
        #[cfg_attr(target_arch = "wasm32", tsify(type = "ConstraintEntry"))] NewConstraint,
    ),
    /// Asks for one shape of every face that can have it: see [`crate::scene::Scene::ask_of_panels`].
    #[serde(skip_deserializing)]
    MakePanels {
        /// The id of the kind.
        kind: String,
        /// The tolerance that they have to be within; none weighs them.
        within: Option<f64>,
        /// From the shape as it was opened, whatever it is now.
        afresh: bool,
    },
    /// Removes row `index`.
    RemoveConstraint {
        /// Which row.
        index: usize,
    },
    /// Changes row `index`.
    SetConstraint {
        /// Which row.
        index: usize,
        /// New `w_i`.
        #[serde(default)]
        weight: Option<f64>,
        /// Whether it is solved for.
        #[serde(default)]
        enabled: Option<bool>,
        /// Whether it is weighed, or met: as in scene files.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Require"))]
        require: Option<Require>,
        /// New values of parameters, as in scene files; those that are not here stay.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, ParamValue>"))]
        params: Map<String, Value>,
    },
    /// Adds a row like row `index` after it.
    DuplicateConstraint {
        /// Which row.
        index: usize,
    },
    /// Gives row `index` another name.
    RenameConstraint {
        /// Which row.
        index: usize,
        /// Empty for the label of its kind.
        name: String,
    },
    /// Gives a set a name, instead of what had that name.
    NameSet {
        /// Not empty.
        name: String,
        /// Its vertices.
        #[serde(default, deserialize_with = "indices::deserialize")]
        vertices: Vec<u32>,
        /// Its faces.
        #[serde(default, deserialize_with = "indices::deserialize")]
        faces: Vec<u32>,
    },
    /// Takes a set away.
    RemoveSet {
        /// Its name.
        name: String,
    },
    /// Gives one of the declared settings another value.
    Set {
        /// Its id.
        id: String,
        /// Its value, in one of its forms.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "ParamValue"))]
        value: Value,
    },
    /// Keeps some vertices close more or less than the others.
    HoldClose {
        /// Which vertices; all of them where there is no list.
        #[serde(default, deserialize_with = "list_or_none")]
        vertices: Option<Vec<u32>>,
        /// A factor of the weight of closeness, not negative; 1 is as the others.
        weight: f64,
    },
    /// Goes back to where iterating began, if the shape has collapsed since, and holds all vertices
    /// closer to where they were.
    HoldCloser,
    /// Keeps vertices close to the surface of a mesh file instead of the original.
    FitTo {
        /// The name of the file.
        name: String,
        /// Its text, OBJ or OFF.
        text: String,
    },
    /// Takes the shapes that vertices keep from another pose of the mesh, in a file.
    TakePose {
        /// The name of the file.
        name: String,
        /// Its text: OBJ or OFF with the faces of the mesh.
        text: String,
    },
    /// Takes the shapes that vertices keep from the mesh itself again.
    LeavePose,
    /// Makes handles soft, with a weight.
    WeighHandles {
        /// Their vertices.
        #[serde(deserialize_with = "indices::deserialize")]
        vertices: Vec<u32>,
        /// Positive.
        weight: f64,
    },
    /// Replaces the weights of Eq. 13.
    SetWeights(#[cfg_attr(target_arch = "wasm32", tsify(type = "Partial<Weights>"))] Weights),
    /// Sets what belongs together: see [`crate::scene::PRESETS`].
    Preset {
        /// The id of a preset.
        id: String,
    },
    /// Says in which unit the coordinates are; they stay as they are.
    SetUnits {
        /// Empty when not known.
        units: String,
    },
    /// Says which axis points up; the coordinates stay as they are.
    SetUp {
        /// Which one.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "\"y\" | \"z\""))]
        up: Up,
    },
    /// Makes the scene an exercise, or no longer.
    SetLesson {
        /// The exercise; none for no longer.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "LessonFile | null"))]
        lesson: Option<Lesson>,
        /// Goes back to the rest shape and forgets the variants: students get no solution.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        unsolved: bool,
    },
    /// Says what is to be made of the shape.
    SetBuild {
        /// All settings; those that are left out get their defaults.
        build: Box<BuildSettings>,
    },
    /// Replaces the steps of the presentation.
    SetSteps {
        /// All of them; none for no presentation.
        steps: Vec<Slide>,
    },
    /// Makes the shape and the weights those of step `index` of the presentation.
    ShowStep {
        /// Which one.
        index: usize,
    },
    /// Keeps the current shape among the variants, and makes it the design.
    #[serde(skip_deserializing)]
    KeepVariant {
        /// The shape that it is a variant of, `#V by 3`: the first one that is kept.
        start: Rc<[Point]>,
    },
    /// Goes to variant `index`, and makes it the design.
    GoToVariant {
        /// Which one.
        index: usize,
    },
    /// Takes variant `index` out of those that are kept.
    RemoveVariant {
        /// Which one; not the design.
        index: usize,
    },
    /// Makes vertices handles where they are now; those that are handles already change how they hold.
    AddHandles {
        /// Which vertices.
        #[serde(deserialize_with = "indices::deserialize")]
        vertices: Vec<u32>,
        /// Fixed or soft.
        fixed: bool,
    },
    /// Releases vertices.
    RemoveHandles {
        /// Which vertices.
        #[serde(deserialize_with = "indices::deserialize")]
        vertices: Vec<u32>,
    },
    /// Makes several faces of each: see [`crate::mesh::Subdivision`]. The scene goes along.
    Refine {
        /// The scheme.
        #[cfg_attr(
            target_arch = "wasm32",
            tsify(type = "\"catmull-clark\" | \"linear\" | \"loop\"")
        )]
        scheme: Scheme,
        /// How often, at least once.
        levels: u32,
        /// Creases and corners that turn by more than this stay sharp, in degrees.
        #[serde(default = "kept_turn")]
        keep: f64,
        /// The shape as it is becomes the original: the new mesh is kept close to it, and `moved` is measured from it.
        #[serde(default)]
        adopt: bool,
    },
    /// Changes the mesh by one of the [`crate::mesh::MESH_OPERATIONS`]. The scene goes along.
    Remesh(Remeshing),
    /// Goes back to the rest shape; constraints, handles and weights stay.
    Reset,
}

fn kept_turn() -> f64 {
    KEPT_TURN
}

fn list_or_none<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec<u32>>, D::Error> {
    Option::<Indices>::deserialize(from).map(|list| list.map(|Indices(list)| list))
}

/// A row of constraints to be added.
#[derive(Clone, Debug, PartialEq)]
pub struct NewConstraint {
    /// The row.
    pub spec: ConstraintSpec,
    /// The set that [`super::ConstraintTarget::UNNAMED`] names in the selector.
    pub set: Option<Set>,
}
