//! Lessons: a task, and the goals that the shape has to meet.
//!
//! ```json
//! { "text": "Make every panel flat.",
//!   "goals": [ { "measure": "planarity", "at_most": 0.001 },
//!              { "measure": "planarity", "beyond": 0.001, "at_most": 3 },
//!              { "constraint": "Eaves", "at_most": 0.01 },
//!              { "build": "beam_warp", "at_most": 0.001 } ],
//!   "lock": ["mesh", "constraints"] }
//! ```
//!
//! A session that puts another mesh in place of the first one adds `"given"`, so that results are still of
//! the exercise that was handed out.

use crate::json::{JsonError, objects, present};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// An exercise on the mesh of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Lesson {
    /// Text of the task; line breaks are kept.
    pub text: String,
    /// The goals, at least one; all have to be met.
    #[serde(deserialize_with = "some_goals")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "GoalFile[]"))]
    pub goals: Vec<Goal>,
    /// The parts of the scene that students may not change; a session refuses edits of them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(optional, type = "(\"weights\" | \"constraints\" | \"handles\" | \"mesh\")[]")
    )]
    pub lock: Vec<Lock>,
    /// The [fingerprint](crate::scene::Scene::fingerprint) of the exercise on its first mesh, once
    /// another one is in its place.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub given: Option<String>,
}

impl Lesson {
    /// Whether text, goals and locks are those of another lesson, whatever the mesh.
    pub fn asks_the_same(&self, other: &Lesson) -> bool {
        let asked = |lesson: &Lesson| Lesson { given: None, ..lesson.clone() };
        asked(self) == asked(other)
    }
}

fn some_goals<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<Goal>, D::Error> {
    let goals: Vec<Goal> = objects(from)?;
    match goals.is_empty() {
        true => Err(D::Error::custom("found an array of 0, expected at least one goal")),
        false => Ok(goals),
    }
}

/// A part of a scene that a lesson locks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "kebab-case"))]
pub enum Lock {
    /// The weights of energies and constraints, and the closeness and smoothness settings.
    Weights,
    /// The constraints, their parameters, and the sets that they refer to.
    Constraints,
    /// The handles.
    Handles,
    /// The mesh, its unit and up axis, and the meshes of the closeness target and the pose.
    Mesh,
}

/// An upper bound on a quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "GoalFile", into = "GoalFile")]
pub struct Goal {
    /// The quantity.
    pub of: GoalOf,
    /// The bound, not negative, in the unit of the quantity, or a number of faces. Zero requires a
    /// constraint to be met exactly, up to [`crate::solve::exact_tolerance`].
    pub at_most: f64,
}

/// The quantity that a goal bounds.
#[derive(Clone, Debug, PartialEq)]
pub enum GoalOf {
    /// The largest value over all faces of the measure with this id.
    Measure(String),
    /// The number of faces whose value of a measure exceeds a tolerance.
    Beyond {
        /// Id of the measure.
        measure: String,
        /// Tolerance in the unit of the measure, not negative; a face exactly at it does not count.
        tolerance: f64,
    },
    /// The largest error of the enabled constraints with this name, or, if they have no name, with
    /// this label of their kind.
    Constraint(String),
    /// The value with this id of the build with the settings of the scene; lengths in the unit of
    /// the mesh.
    Build(String),
}

/// The form of a goal in files.
#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
struct GoalFile {
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    measure: Option<String>,
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    beyond: Option<f64>,
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    constraint: Option<String>,
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    build: Option<String>,
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    at_most: Option<f64>,
}

impl TryFrom<GoalFile> for Goal {
    type Error = JsonError;

    fn try_from(file: GoalFile) -> Result<Goal, JsonError> {
        const WHAT: &str = "{\"measure\": ...}, {\"constraint\": ...} or {\"build\": ...}";
        let error = |message: String| Err(JsonError::new("", message));
        let from_zero = |key: &str, value: f64| match value >= 0.0 {
            true => Ok(value),
            false => Err(JsonError::new(key, format!("found {value}, expected a number from 0"))),
        };
        let beyond = file.beyond.map(|beyond| from_zero("beyond", beyond)).transpose()?;
        let of = match (file.measure, file.constraint, file.build) {
            (Some(measure), None, None) => match beyond {
                Some(tolerance) => GoalOf::Beyond { measure, tolerance },
                None => GoalOf::Measure(measure),
            },
            (None, ..) if beyond.is_some() => {
                return error("`beyond` is only for measures, expected a \"measure\"".to_owned());
            }
            (None, Some(name), None) => GoalOf::Constraint(name),
            (None, None, Some(id)) => GoalOf::Build(id),
            (None, None, None) => {
                return error(format!("the goal has no quantity, expected {WHAT}"));
            }
            _ => return error(format!("the goal has two quantities, expected {WHAT}")),
        };
        let at_most = file.at_most.ok_or_else(|| JsonError::missing_key("at_most"))?;
        Ok(Goal { of, at_most: from_zero("at_most", at_most)? })
    }
}

impl From<Goal> for GoalFile {
    fn from(Goal { of, at_most }: Goal) -> GoalFile {
        let mut file = GoalFile { at_most: Some(at_most), ..GoalFile::default() };
        match of {
            GoalOf::Measure(id) => file.measure = Some(id),
            GoalOf::Beyond { measure, tolerance } => {
                (file.measure, file.beyond) = (Some(measure), Some(tolerance));
            }
            GoalOf::Constraint(name) => file.constraint = Some(name),
            GoalOf::Build(id) => file.build = Some(id),
        }
        file
    }
}
