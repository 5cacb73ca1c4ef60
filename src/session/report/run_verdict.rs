//! The verdict on a run in words: how it ended, and whether constraints without hard requirements
//! are met within a tolerance.

use super::worst::WorstElement;
use crate::session::Session;
use crate::words;
use serde::Serialize;

/// The verdict on a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct RunVerdict {
    /// Whether all constraints are met within the tolerance.
    pub met: bool,
    /// Whether all are met, or which element is the worst.
    pub brief: String,
    /// The distance of the worst element; empty if all are met.
    pub numbers: String,
    /// The element that is farthest from its constraint; none if all are met.
    pub worst: Option<WorstElement>,
}

/// How a run is described once it is over.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EndWords {
    /// If it has converged.
    pub converged: String,
    /// If it has not.
    pub paused: String,
}

impl EndWords {
    /// The words for a run that ended after this many iterations.
    pub fn after(iterations: u32) -> EndWords {
        let after = words::count(iterations as usize, "iteration", "iterations");
        EndWords {
            converged: format!("Converged after {after}"),
            paused: format!("Stopped after {after}"),
        }
    }
}

impl Session {
    /// Returns in words whether the constraints are met, with distances up to `tolerance`, in the unit of
    /// the mesh. None if no constraint acts.
    pub fn run_verdict(&mut self, tolerance: f64) -> Option<RunVerdict> {
        let document = self.scene.document();
        let units = document.units.clone();
        let (row, error) = self.scene.worst_row()?;
        let label = document.constraints[row].label().to_owned();
        let within = words::limit(tolerance, &units);
        if error <= tolerance {
            let brief = format!("All constraints are satisfied within {within}.");
            return Some(RunVerdict { met: true, brief, numbers: String::new(), worst: None });
        }
        let worst = self.worst_constraints(row, 1, Some(tolerance)).into_iter().next()?;
        let brief = format!(
            "The run has ended, and some constraints are beyond the tolerance of {within}. Worst: {label} on {}.",
            worst.element
        );
        let numbers = format!("Its distance is {}.", worst.words);
        Some(RunVerdict { met: false, brief, numbers, worst: Some(worst) })
    }
}
