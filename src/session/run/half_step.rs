//! The outcome of an iteration and of its two halves, as in Fig. 4 of the paper: the local step
//! fits a shape to the vertices of every constraint, the global step moves all vertices.

use crate::session::state::ResolvedRow;
use serde::Serialize;

/// The outcome of one iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Whether the total changed by no more than the tolerance.
    pub converged: bool,
    /// Whether there is no reason to continue: it has converged, a run has met its hard constraints as
    /// well as it can, or it has had as many iterations as the scene allows.
    pub ended: bool,
}

/// The outcome of half an iteration.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(tag = "half", rename_all = "camelCase")]
pub enum HalfStep {
    /// The local step: shapes were fitted, and nothing has moved.
    Local {
        /// Number of constraints by kind.
        fitted: Vec<FittedCount>,
    },
    /// The global step: the vertices have moved.
    Global {
        /// Whether the total changed by no more than the tolerance.
        converged: bool,
        /// Whether the vertices moved elsewhere than to the least-squares solution, because the
        /// scene accelerates its steps.
        accelerated: bool,
    },
    /// Instead of the global step, nothing: vertices that moved to the least-squares solution would
    /// leave the shape that a run has found for the hard constraints.
    Held {
        /// Whether it meets them.
        met: bool,
    },
}

/// Number of constraints of a kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct FittedCount {
    /// The label of the kind.
    pub label: &'static str,
    /// Number of constraints.
    pub count: usize,
}

/// Counts the constraints of the enabled rows by kind, in the order of the rows.
pub(crate) fn fitted(rows: &[ResolvedRow]) -> Vec<FittedCount> {
    let mut fitted: Vec<FittedCount> = Vec::new();
    for row in rows.iter().filter(|row| row.enabled) {
        let (label, count) = (row.constraints.kind.info().label, row.constraints.members.len());
        match fitted.iter_mut().find(|fitted| fitted.label == label) {
            Some(fitted) => fitted.count += count,
            None => fitted.push(FittedCount { label, count }),
        }
    }
    fitted
}
