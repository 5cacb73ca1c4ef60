//! How well hard constraints are met, what exactness costs, and what an improvement gains, in words.

use super::run_verdict::moved_in_words;
use crate::constraint::describe;
use crate::session::run::ExactReport;
use crate::session::state::{RestMesh, SolvedScene};
use crate::solve::{Moved, Require};
use crate::words;
use serde::Serialize;

/// The most rows of constraints for which suggestions are offered.
const MOST_ROWS: usize = 2;
/// A tolerance that is offered, relative to the distance that was reached.
const WIDER: f64 = 1.1;

/// How well hard constraints are met, in words.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ExactWords {
    /// The verdict for a reader who has that on the panels already; may be empty.
    pub brief: String,
    /// The whole verdict.
    pub full: String,
    /// Weaker requirements, after which the others can be met; empty if all are met.
    pub suggestions: Vec<WeakerRequirement>,
}

/// A weaker requirement on a row of constraints.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct WeakerRequirement {
    /// What it does: "Make Plane soft".
    pub label: String,
    /// The index of the row.
    pub index: usize,
    /// The tolerance that it gets, in the unit of the mesh; none if it becomes soft.
    pub within: Option<f64>,
}

/// A trial of exactness, or of an improvement, in words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct TrialWords {
    /// The result, if its shape is taken.
    pub taken: String,
    /// The result, if its shape is not taken.
    pub offered: String,
    /// The shapes before and after: a name, and both values.
    pub table: Vec<[String; 3]>,
}

/// The numbers of a trial, before and after.
pub(crate) struct TrialNumbers<'a> {
    /// The symbol of the unit of the mesh.
    pub(crate) units: &'a str,
    /// The size of the mesh.
    pub(crate) size: f64,
    /// The largest distances of a vertex to its projection, and the tolerance of the mesh, in whose
    /// unit they are written.
    pub(crate) distance: [f64; 2],
    pub(crate) tolerance: f64,
    /// Displacements from the original.
    pub(crate) moved: [Moved; 2],
    /// The energies of the soft terms.
    pub(crate) energy: [f64; 2],
    /// The largest distance between the two shapes.
    pub(crate) by: f64,
}

/// Why exactness cannot be had, or what it costs besides the move.
pub(crate) enum Exactness {
    /// The mesh is too large; nothing was tried.
    TooLarge,
    /// This many constraints cannot be met.
    Missed(usize),
    /// All are met, and this many faces fold.
    Met(usize),
}

impl ExactWords {
    /// The verdict of `report` on the current shape.
    pub(crate) fn of(scene: &SolvedScene, rest: &RestMesh, report: &ExactReport) -> ExactWords {
        let document = scene.document();
        let units = &*document.units;
        if !report.met {
            return ExactWords::unmet(scene, report);
        }
        let mut hard =
            document.constraints.iter().filter(|row| row.enabled && row.require.is_hard());
        if !hard.all(|row| row.require == Require::Exact) {
            let within = words::limit(report.tolerance, units);
            let full = format!("All required constraints are satisfied within {within}.");
            return ExactWords { brief: String::new(), full, suggestions: Vec::new() };
        }
        let exact = format!(
            "All are exact. The largest error is {}.",
            words::length(report.max_distance, units)
        );
        let moved = moved_in_words(rest.moved_by(scene.positions()), units, rest.diameter());
        let guarded = match report.on_guard {
            0 => String::new(),
            edges => format!(
                " {} as short as allowed: {} of the original length (Shortest edge, under Weights and solver).",
                words::count(edges, "edge is", "edges are"),
                words::number(report.shortest_edge.unwrap_or(0.0))
            ),
        };
        ExactWords {
            brief: format!("{exact}{guarded}"),
            full: format!("{exact} {moved}{guarded}"),
            suggestions: Vec::new(),
        }
    }

    fn unmet(scene: &SolvedScene, report: &ExactReport) -> ExactWords {
        let document = scene.document();
        let units = &*document.units;
        let rows =
            || report.unmet.iter().filter_map(|&row| Some((row, document.constraints.get(row)?)));
        let hard = document.constraints.iter().zip(scene.rows());
        let hard = hard.filter(|(row, _)| row.enabled && row.require.is_hard());
        let all: usize = hard.map(|(_, row)| row.constraints.members.len()).sum();
        let (cannot, closest) = if report.too_large {
            (
                "are not exact: the mesh, or one constraint, is too large for that",
                "The largest error is",
            )
        } else if report.contradiction {
            (
                "cannot be satisfied together",
                "In the closest shape that was found, the largest error is",
            )
        } else {
            ("are not satisfied yet", "The largest error is")
        };
        let places: Vec<String> =
            rows().map(|(_, row)| format!("{} on {}", row.label(), describe(&row.on))).collect();
        let full = format!(
            "{} of {} constraints {cannot}: {}. {closest} {}.",
            words::group_digits(report.misses),
            words::group_digits(all),
            places.join(", "),
            words::length_like(report.max_distance, units, report.tolerance)
        );
        let within = words::rounded(WIDER * report.max_distance, 2);
        let suggestions = rows().take(MOST_ROWS).flat_map(|(index, row)| {
            let label = row.label();
            [
                WeakerRequirement { label: format!("Make {label} soft"), index, within: None },
                WeakerRequirement {
                    label: format!("{label} within {}", words::limit(within, units)),
                    index,
                    within: Some(within),
                },
            ]
        });
        ExactWords { brief: full.clone(), full, suggestions: suggestions.collect() }
    }
}

impl TrialWords {
    /// The words of a trial of exact constraints instead of those within a distance.
    pub(crate) fn of_exactness(numbers: &TrialNumbers<'_>, exactness: &Exactness) -> TrialWords {
        let units = numbers.units;
        let offered = match exactness {
            Exactness::TooLarge => {
                "The mesh, or one constraint, is too large for Exact. Within is possible."
                    .to_owned()
            }
            Exactness::Missed(misses) => format!(
                "{} cannot be exact together with the others.",
                words::count(*misses, "constraint", "constraints")
            ),
            Exactness::Met(folded) => {
                let far = words::length(numbers.by, units);
                let folds = match folded {
                    0 => String::new(),
                    folded => {
                        format!(", and {} would fold", words::count(*folded, "panel", "panels"))
                    }
                };
                format!("If made exact, the shape would move by up to {far} more{folds}.")
            }
        };
        let taken = format!(
            "Also made exact. The largest error is {}.",
            words::length_like(numbers.distance[1], units, numbers.tolerance)
        );
        TrialWords { taken, offered, table: numbers.table() }
    }

    /// The words of a search for an equally exact shape of less energy.
    pub(crate) fn of_improvement(numbers: &TrialNumbers<'_>) -> TrialWords {
        let [before, after] = numbers.energy;
        let gain = if before > 0.0 { words::part(1.0 - after / before) } else { words::part(0.0) };
        let far = words::length(numbers.by, numbers.units);
        TrialWords {
            taken: format!(
                "Improved: what is not exact is satisfied better ({gain} less energy). It moved by up to {far}."
            ),
            offered: "No better exact shape was found nearby.".to_owned(),
            table: numbers.table(),
        }
    }
}

impl TrialNumbers<'_> {
    fn table(&self) -> Vec<[String; 3]> {
        let row = |name: &str, [before, after]: [String; 2]| [name.to_owned(), before, after];
        let length = |length| words::length(length, self.units);
        let still =
            |moved: Moved| words::moved(moved.max, moved.mean, self.units, self.size).is_none();
        let moved = |of: fn(Moved) -> f64| {
            self.moved.map(
                |moved| if still(moved) { "did not move".to_owned() } else { length(of(moved)) },
            )
        };
        let error = |distance| words::length_like(distance, self.units, self.tolerance);
        vec![
            row("Largest error", self.distance.map(error)),
            row("Moved at most", moved(|moved| moved.max)),
            row("on average", moved(|moved| moved.mean)),
            row("Energy", self.energy.map(words::number)),
        ]
    }
}
