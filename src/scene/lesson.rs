//! Lessons: a text, goals that a shape is to meet.

/// An exercise on the mesh of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// The task, in words; lines are kept.
    pub text: String,
    /// The goals, at least one; all of them have to be met.
    pub goals: Vec<Goal>,
}

/// Something that is to be at most so large.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// Of what.
    pub of: GoalOf,
    /// How large it may be, not negative, in the unit of what is measured. Zero asks a constraint to be met
    /// exactly, up to [`crate::solve::exact_tolerance`].
    pub at_most: f64,
}

/// The quantity that a goal bounds.
#[derive(Clone, Debug, PartialEq)]
pub enum GoalOf {
    /// The worst face by the measure of this id.
    Measure(String),
    /// The worst error of the enabled rows of constraints that are called so: by their name, or by
    /// the label of their kind where they have none.
    Constraint(String),
}
