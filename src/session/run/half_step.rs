//! The outcome of an iteration, and of its two halves, as in Fig. 4 of the paper: the local step fits a
//! shape to the vertices of every constraint, the global step moves all vertices at once.

use crate::session::state::ResolvedRow;
use serde::Serialize;

/// The outcome of one iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Whether the total changed by no more than the tolerance, and the shape has not collapsed.
    pub converged: bool,
    /// Whether there is nothing to go on for: the total did not change, or the shape collapsed.
    pub ended: bool,
}

/// The outcome of half an iteration.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(tag = "half", rename_all = "camelCase")]
pub enum HalfStep {
    /// The local step: shapes are fitted, nothing has moved.
    Local {
        /// How many constraints of which kind, each kind once.
        fitted: Vec<FittedCount>,
    },
    /// The global step: the vertices have moved.
    Global {
        /// Whether the total changed by no more than the tolerance.
        converged: bool,
        /// Whether they went elsewhere than to the least-squares answer, because the scene accelerates
        /// its steps.
        accelerated: bool,
    },
}

/// Constraints of one kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct FittedCount {
    /// The kind's name for people.
    pub label: &'static str,
    /// How many constraints.
    pub count: usize,
}

/// The constraints of the rows that are on, counted by kind in the order of the rows.
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
