//! The verdict on a run in words: how it ended, and whether constraints without hard requirements
//! are met within a tolerance.

use super::measuring::Measuring;
use super::worst::{WorstElement, worst_constraints};
use crate::solve::Moved;
use crate::words;
use serde::Serialize;

/// The verdict on a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct RunVerdict {
    /// Whether all constraints are met within the tolerance.
    pub met: bool,
    /// The verdict for a reader who has that on the panels already; empty if all are met.
    pub brief: String,
    /// The whole verdict, with the worst element and how far the mesh moved.
    pub full: String,
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

impl RunVerdict {
    /// The verdict on the current shape, with distances up to `tolerance`, in the unit of the mesh.
    /// None if no constraint has a weight.
    pub(crate) fn of(model: &mut Measuring<'_>, tolerance: f64) -> Option<RunVerdict> {
        let document = model.scene.document();
        let units = document.units.clone();
        let rows = document.constraints.iter().enumerate().filter(|(_, row)| row.enabled);
        let errors = rows.zip(model.scene.solver().found());
        let weighed = errors.filter(|((_, row), _)| row.weight > 0.0);
        let (row, label, error) = weighed
            .map(|((index, row), found)| {
                (index, row.label().to_owned(), found.worst_squared.sqrt())
            })
            .reduce(|worst, other| if other.2 > worst.2 { other } else { worst })?;
        let far = moved_in_words(
            model.rest.moved_by(model.scene.positions()),
            &units,
            model.rest.diameter(),
        );
        let within = words::limit(tolerance, &units);
        if error <= tolerance {
            let full = format!("All constraints are satisfied within {within}. {far}");
            return Some(RunVerdict { met: true, brief: String::new(), full, worst: None });
        }
        let worst = worst_constraints(model, row, 1).into_iter().next()?;
        let brief = "The run has ended, and some constraints are beyond the tolerance.".to_owned();
        let value = words::length_like(worst.value, &units, tolerance);
        let full = format!(
            "{brief} Worst: {label} on {}, {value}; the tolerance is {within}. {far}",
            worst.element
        );
        Some(RunVerdict { met: false, brief, full, worst: Some(worst) })
    }
}

/// Says how far the mesh moved, as a sentence.
pub(super) fn moved_in_words(moved: Moved, units: &str, size: f64) -> String {
    match words::moved(moved.max, moved.mean, units, size) {
        Some(far) => format!("Moved {far}."),
        None => "Nothing moved.".to_owned(),
    }
}
