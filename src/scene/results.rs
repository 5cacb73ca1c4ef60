//! The results of a lesson that a student hands in.

use super::document::{ConstraintSpec, HandleSpec, MeshSource, Scene};
use super::lesson::Goal;
use crate::json::{Entries, object_or_none, objects, points, present};
use crate::mesh::{Mesh, Point};
use crate::solve::Weights;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};

/// The results of a student: the shape, and the values of the goals.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Results {
    /// Name, as typed by the student.
    pub student: String,
    /// Title of the scene.
    pub title: String,
    /// [`Scene::fingerprint`] of the original scene.
    pub scene: String,
    /// The mesh at the end without the shape, inline, if it is not that of the scene.
    #[serde(default, deserialize_with = "object_or_none", skip_serializing_if = "Option::is_none")]
    pub mesh: Option<MeshSource>,
    /// Time of saving, as formatted by the page; empty if unknown.
    pub time: String,
    /// Number of iterations since the start of the scene.
    pub iterations: u32,
    /// Whether all goals were met.
    pub passed: bool,
    /// The value of each goal.
    #[serde(deserialize_with = "objects")]
    pub goals: Vec<GoalResult>,
    /// The constraints at the end.
    pub constraints: Vec<ConstraintSpec>,
    /// The handles at the end.
    pub handles: Vec<HandleSpec>,
    /// The names of the steps that led here, as shown by Undo; the oldest may be missing.
    #[serde(default)]
    pub steps: Vec<String>,
    /// The weights of the energies at the end; `None` in older files.
    #[serde(default, deserialize_with = "object_or_none", skip_serializing_if = "Option::is_none")]
    pub weights: Option<Weights>,
    /// The declared settings at the end, by id.
    #[serde(default, deserialize_with = "unrepeated")]
    pub settings: Map<String, Value>,
    /// Largest displacement of a vertex, in the unit of the mesh.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub moved: Option<f64>,
    /// Largest distance of a vertex to the shape of a constraint, in the same unit.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub distance: Option<f64>,
    /// The shape, `#V by 3`.
    #[serde(deserialize_with = "points")]
    pub positions: Vec<Point>,
}

fn unrepeated<'de, D: Deserializer<'de>>(from: D) -> Result<Map<String, Value>, D::Error> {
    Entries::deserialize(from).map(|Entries(values)| values.into_iter().collect())
}

/// A goal and its value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GoalResult {
    /// The goal, of which the keys are beside the others.
    #[serde(flatten)]
    pub goal: Goal,
    /// The value; `None` if it is not defined.
    pub value: Option<f64>,
    /// Whether the goal is met.
    pub met: bool,
}

impl Scene {
    /// Returns the fingerprint of the exercise: 16 hexadecimal digits that depend on the mesh and
    /// the lesson, with a chance of one in 2^64 of a collision. Constraints, handles and weights
    /// are not included, since students change them. It is kept where another mesh takes the place
    /// of the first. It detects mistakes, but is not secure against forgery.
    pub fn fingerprint(&self, mesh: &Mesh) -> String {
        if let Some(given) = self.lesson.as_ref().and_then(|lesson| lesson.given.as_ref()) {
            return given.clone();
        }
        let mut exercise = Scene::default();
        exercise.lesson.clone_from(&self.lesson);
        format!("{:016x}", fnv1a(exercise.to_json(mesh).as_bytes()))
    }
}

/// Computes the Fowler-Noll-Vo hash, variant 1a, 64 bits.
fn fnv1a(bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_its_published_examples() {
        assert_eq!(fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }
}
