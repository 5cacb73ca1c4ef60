//! A drag or a run that is under way.

use super::history::Snapshot;

/// A drag or a run that has begun and is not yet a step of undo.
pub(crate) struct Transaction {
    pub(crate) kind: TransactionKind,
    pub(crate) before: Snapshot,
    /// It belongs to the step of undo that was made last, and becomes none of its own.
    pub(crate) joins_last: bool,
    /// See [`Session::make_panels`].
    pub(crate) goal: Option<PanelGoal>,
}

#[derive(PartialEq)]
pub(crate) enum TransactionKind {
    Drag,
    Run,
}

/// The tolerance for which a run goes on after it has converged.
pub(crate) struct PanelGoal {
    /// In the unit of the mesh.
    pub(crate) tolerance: f64,
    /// How often the weight may still be raised.
    pub(crate) rounds: u32,
    /// The worst distance when it was last raised.
    pub(crate) worst: f64,
}
