//! Lessons: a task, and the goals that the shape has to meet.

/// An exercise on the mesh of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// Text of the task; line breaks are kept.
    pub text: String,
    /// The goals, at least one; all have to be met.
    pub goals: Vec<Goal>,
    /// The parts of the scene that students may not change; a session refuses edits of them.
    pub lock: Vec<Lock>,
}

/// A part of a scene that a lesson locks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
#[derive(Clone, Debug, PartialEq)]
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
