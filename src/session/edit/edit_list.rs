//! The edits of the document: each is one step of undo.

use super::ConstraintTarget;
use super::remeshing::Remeshing;
use crate::constraint::{Selector, Set};
use crate::json::indices::{self, Indices};
use crate::json::{JsonError, from_text, objects};
use crate::mesh::{KEPT_TURN, Point, Scheme};
use crate::scene::{
    AttemptSetting, ConstraintSpec, Lesson, RowNumber, Scene, SceneError, Slide, Up, Weights,
    kind_of,
};
use crate::solve::Require;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};
use std::rc::Rc;

/// An edit of the document. As JSON it is an object with one key, the name of the variant in camel
/// case, and its fields as the value; or that name alone if it has none.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Edit {
    /// Appends a row of constraints.
    AddConstraint(
        #[cfg_attr(target_arch = "wasm32", tsify(type = "ConstraintEntry"))] NewConstraint,
    ),
    /// Constrains all suitable faces to one shape: see [`crate::scene::Scene::request_panels`].
    #[serde(skip_deserializing)]
    MakePanels {
        /// The id of the kind.
        kind: String,
        /// The required tolerance; without one the constraints are soft.
        within: Option<f64>,
        /// The shape to start from.
        from: PanelStart,
    },
    /// Removes row `index`.
    RemoveConstraint {
        /// Index of the row.
        index: usize,
    },
    /// Changes row `index`.
    SetConstraint {
        /// Index of the row.
        index: usize,
        /// New `w_i`.
        #[serde(default)]
        weight: Option<f64>,
        /// Whether the row is enabled.
        #[serde(default)]
        enabled: Option<bool>,
        /// Whether it is soft or hard, as in scene files.
        #[serde(default)]
        require: Option<Require>,
        /// New values of parameters, as in scene files; all others stay.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, ParamValue>"))]
        params: Map<String, Value>,
    },
    /// Adds a copy of row `index` after it.
    DuplicateConstraint {
        /// Index of the row.
        index: usize,
    },
    /// Renames row `index`.
    RenameConstraint {
        /// Index of the row.
        index: usize,
        /// The new name; empty for the label of the kind.
        name: String,
    },
    /// Names a set, replacing any set of that name.
    NameSet {
        /// The name, not empty, and not that of a group of the mesh, for which it would stand then.
        name: String,
        /// Its vertices.
        #[serde(default, deserialize_with = "indices::deserialize")]
        vertices: Vec<u32>,
        /// Its faces.
        #[serde(default, deserialize_with = "indices::deserialize")]
        faces: Vec<u32>,
    },
    /// Removes a set.
    RemoveSet {
        /// Its name.
        name: String,
    },
    /// Changes the value of a declared setting.
    Set {
        /// Its id.
        id: String,
        /// Its value, in one of the declared forms.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "ParamValue"))]
        value: Value,
    },
    /// Keeps some vertices closer or less close than the others.
    HoldClose {
        /// The vertices; all if there is no list.
        #[serde(default, deserialize_with = "list_or_none")]
        vertices: Option<Vec<u32>>,
        /// Factor of the closeness weight, not negative; 1 for the same as the others.
        weight: f64,
    },
    /// Holds all vertices closer to their rest positions.
    HoldCloser,
    /// Keeps vertices close to the surface of a mesh file instead of the original and its boundary, or of
    /// another such surface, with a weight of 1 if closeness has none. A file that states another unit or
    /// up axis than the model has is refused.
    FitTo {
        /// The name of the file.
        name: String,
        /// Its text, OBJ or OFF.
        text: String,
    },
    /// Uses another pose of the mesh, from a file, as the rest shape. A file is refused as for
    /// [`Edit::FitTo`].
    TakePose {
        /// The name of the file.
        name: String,
        /// Its text, OBJ or OFF, with the faces of the mesh.
        text: String,
    },
    /// Uses the mesh itself as the rest shape again.
    LeavePose,
    /// Makes handles soft, with a weight.
    WeighHandles {
        /// Their vertices.
        #[serde(deserialize_with = "indices::deserialize")]
        vertices: Vec<u32>,
        /// The weight, positive.
        weight: f64,
    },
    /// Replaces weights of Eq. 13.
    SetWeights(SomeWeights),
    /// Applies a preset: see [`crate::scene::PRESETS`].
    Preset {
        /// The id of a preset.
        id: String,
    },
    /// Sets the unit of the coordinates, which do not change.
    SetUnits {
        /// The symbol of the unit; empty if unknown.
        units: String,
    },
    /// Sets the vertical axis; the coordinates do not change.
    SetUp {
        /// The axis.
        up: Up,
    },
    /// Makes the scene an exercise, or ends that.
    SetLesson {
        /// The exercise, or none.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Lesson | null"))]
        lesson: Option<Lesson>,
        /// Goes to the rest shape and removes the variants, so that students get no solution.
        #[serde(default)]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        unsolved: bool,
    },
    /// Sets the distance within which panels have their shape.
    SetTolerance {
        /// In the unit of the mesh, above zero; null for that of the constraints or the mesh.
        tolerance: Option<f64>,
    },
    /// Changes how parts are built from the shape.
    SetBuild {
        /// Values by the paths of settings: see [`crate::scene::BuildSettings::with_all`]. The others stay.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, unknown>"))]
        values: Map<String, Value>,
    },
    /// Replaces the steps of the presentation.
    SetSteps {
        /// All steps; empty for no presentation.
        #[serde(deserialize_with = "objects")]
        steps: Vec<Slide>,
    },
    /// Goes to the shape and the weights of step `index` of the presentation.
    ShowStep {
        /// Index of the step.
        index: usize,
    },
    /// Adds the current shape to the variants, and makes it the design.
    #[serde(skip_deserializing)]
    KeepVariant {
        /// The shape that it was derived from, `#V by 3`, which becomes the first variant.
        start: Rc<[Point]>,
    },
    /// Goes to the shape of variant `index`, and makes it the design.
    GoToVariant {
        /// Index of the variant.
        index: usize,
    },
    /// Removes variant `index`.
    RemoveVariant {
        /// Index of the variant, which must not be the design.
        index: usize,
    },
    /// Makes vertices handles at their positions; if one is a handle, its hold changes.
    AddHandles {
        /// The vertices.
        #[serde(deserialize_with = "indices::deserialize")]
        vertices: Vec<u32>,
        /// Whether they are fixed or soft.
        fixed: bool,
    },
    /// Releases vertices.
    RemoveHandles {
        /// The vertices.
        #[serde(deserialize_with = "indices::deserialize")]
        vertices: Vec<u32>,
    },
    /// Subdivides each face: see [`crate::mesh::Subdivision`]. The scene is carried over.
    Refine {
        /// The scheme.
        scheme: Scheme,
        /// Number of levels, at least 1.
        levels: u32,
        /// Creases and corners with a larger turning angle than this, in degrees, stay sharp.
        #[serde(default = "kept_turn")]
        keep: f64,
        /// Whether the current shape becomes the original, for closeness to the mesh itself and for
        /// `moved`.
        #[serde(default)]
        adopt: bool,
    },
    /// Changes the mesh by one of the [`crate::mesh::MESH_OPERATIONS`]. The scene is carried over.
    Remesh(Remeshing),
    /// Goes back to the rest shape; constraints, handles and weights stay.
    Reset,
}

impl Edit {
    /// Reads an edit.
    ///
    /// # Errors
    /// As [`crate::scene::Scene::from_json`].
    pub fn from_json(text: &str) -> Result<Edit, SceneError> {
        Ok(from_text(text)?)
    }
}

fn kept_turn() -> f64 {
    KEPT_TURN
}

fn list_or_none<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec<u32>>, D::Error> {
    Option::<Indices>::deserialize(from).map(|list| list.map(|Indices(list)| list))
}

/// A new row of constraints. As JSON it has the keys of a scene file, but its parameters in `params`,
/// and in `set` the set that the empty name in `on` stands for.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(try_from = "ConstraintEntry")]
pub struct NewConstraint {
    /// The row.
    pub spec: ConstraintSpec,
    /// The set that [`ConstraintTarget::UNNAMED`] stands for in the selector.
    pub set: Option<Set>,
}

/// A row to be added, in JSON.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
struct ConstraintEntry {
    kind: String,
    #[cfg_attr(target_arch = "wasm32", tsify(type = "ConstraintTarget[\"on\"]"))]
    on: Selector,
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "ConstraintTarget[\"set\"]"))]
    set: Option<Set>,
    weight: f64,
    #[serde(default)]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Record<string, ParamValue>"))]
    params: Map<String, Value>,
}

impl TryFrom<ConstraintEntry> for NewConstraint {
    type Error = JsonError;

    fn try_from(entry: ConstraintEntry) -> Result<NewConstraint, JsonError> {
        let ConstraintEntry { kind, on, set, weight, params } = entry;
        let unnamed = Some(ConstraintTarget::UNNAMED);
        let is_meant = matches!(&on, Selector::Each { within, .. } if within.as_deref() == unnamed);
        if set.is_some() && !is_meant {
            let message = "found a set, expected none where `on` has no empty name to stand for it";
            return Err(JsonError::new("set", message));
        }
        let kind = kind_of(&kind, params)?;
        let (name, require, eased) = (String::new(), Require::Soft, None);
        let number = RowNumber::default();
        let spec = ConstraintSpec { kind, on, weight, enabled: true, name, require, eased, number };
        Ok(NewConstraint { spec, set })
    }
}

/// New values of some of the weights; the others stay.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SomeWeights {
    /// Of all constraints.
    pub shape: Option<f64>,
    /// Of closeness.
    pub close: Option<f64>,
    /// Of smoothness.
    pub smooth: Option<f64>,
}

impl SomeWeights {
    /// Replaces these weights of `scene`. That of smoothness is then the user's, also where a search had
    /// chosen this value.
    pub(super) fn put_into(self, scene: &mut Scene) {
        if self.smooth.is_some() {
            scene.attempt.release(AttemptSetting::Smoothness);
        }
        let Weights { shape, close, smooth } = &mut scene.weights;
        for (new, weight) in [(self.shape, shape), (self.close, close), (self.smooth, smooth)] {
            *weight = new.unwrap_or(*weight);
        }
    }
}

impl From<Weights> for SomeWeights {
    fn from(Weights { shape, close, smooth }: Weights) -> SomeWeights {
        SomeWeights { shape: Some(shape), close: Some(close), smooth: Some(smooth) }
    }
}

/// The start of a run that makes all panels one shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum PanelStart {
    /// The current shape.
    Now,
    /// The opened shape.
    Original,
    /// The opened shape, with ten times the smoothness weight.
    Smoother,
    /// The opened shape, with closeness to its surface instead of to the places of the vertices, and
    /// its boundary held softly.
    Surface,
    /// The opened shape, with vertices of the boundary exactly on it.
    Boundary,
}

impl PanelStart {
    /// The factor of the smoothness weight.
    pub(super) const SMOOTHER: f64 = 10.0;
}
