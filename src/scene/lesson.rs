//! Lessons: a text, goals that a shape is to meet.

/// An exercise on the mesh of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// The task, in words; lines are kept.
    pub text: String,
    /// The goals, at least one; all of them have to be met.
    pub goals: Vec<Goal>,
    /// The parts of the scene that students may not change; a session refuses edits of them.
    pub lock: Vec<Lock>,
}

/// A part of a scene that a lesson keeps as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lock {
    /// The weights of the energies and of constraints, and what is kept close and smooth.
    Weights,
    /// The constraints, their parameters, and the sets that they are on.
    Constraints,
    /// The handles.
    Handles,
    /// The mesh, its unit and axis, and other meshes that it is fitted to or takes shapes from.
    Mesh,
}

/// Something that is to be at most so large.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// Of what.
    pub of: GoalOf,
    /// How large it may be, not negative, in the unit of what is measured; of faces, how many. Zero asks a constraint to be met
    /// exactly, up to [`crate::solve::exact_tolerance`].
    pub at_most: f64,
}

/// The quantity that a goal bounds.
#[derive(Clone, Debug, PartialEq)]
pub enum GoalOf {
    /// The worst face by the measure of this id.
    Measure(String),
    /// How many faces are beyond `tolerance`, in the unit of the measure of this id.
    Beyond {
        /// Its id.
        measure: String,
        /// Not negative; a face at it is not beyond.
        tolerance: f64,
    },
    /// The worst error of the enabled rows of constraints that are called so: by their name, or by
    /// the label of their kind where they have none.
    Constraint(String),
    /// A number of what is built of the shape with the settings of the scene, by its id; lengths in the unit of the mesh.
    Build(String),
}
