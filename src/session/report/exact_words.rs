//! How well hard constraints are met, what exactness costs, and what an improvement gains, in words.

use crate::constraint::describe;
use crate::scene::ConstraintSpec;
use crate::session::{ExactReport, Session};
use crate::solve::{Moved, Require};
use crate::words::{self, MeasureUnit};
use serde::Serialize;

/// The most rows of constraints for which suggestions are offered.
const MOST_ROWS: usize = 2;
/// A tolerance that is offered, relative to the distance that was reached.
const WIDER: f64 = 1.1;

/// How well hard constraints are met, in words.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ExactWords {
    /// Whether all are met, or which are not.
    pub brief: String,
    /// The largest error; empty if no constraint has to be exact.
    pub numbers: String,
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
    /// How far that shape is from the original; empty if it is not offered.
    pub away: String,
}

/// The numbers of a trial.
pub(crate) struct TrialNumbers<'a> {
    /// The symbol of the unit of the mesh.
    pub(crate) units: &'a str,
    /// The size of the mesh.
    pub(crate) size: f64,
    /// The displacements from the original after it.
    pub(crate) moved: Moved,
    /// The energies of the soft terms, before and after.
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

impl Session {
    /// Returns in words how well the hard constraints are met; none if they have not been met for
    /// the current shape, see [`Session::exact`].
    pub fn exact_words(&self) -> Option<ExactWords> {
        let report = self.exact()?;
        Some(if report.met { self.met_words(&report) } else { self.unmet_words(&report) })
    }

    fn met_words(&self, report: &ExactReport) -> ExactWords {
        let document = self.document();
        let units = &*document.units;
        let written = |error: f64| {
            words::length(MeasureUnit::Length.or_zero(error, self.rest.diameter()), units)
        };
        let enabled = document.constraints.iter().filter(|row| row.enabled);
        let found = enabled.zip(self.solver().found());
        let (exact, others): (Vec<_>, Vec<_>) = found
            .filter(|(row, _)| row.require.is_hard())
            .partition(|(row, _)| row.require == Require::Exact);
        let mut allowed: Vec<f64> = others.iter().flat_map(|(row, _)| tolerances(row)).collect();
        allowed.dedup();
        let limit = words::limit(report.tolerance, units);
        let within = match &*allowed {
            [] | [_] => limit,
            _ => format!("their tolerances, of at most {limit}"),
        };
        if exact.is_empty() {
            let brief = format!("All required constraints are satisfied within {within}.");
            return ExactWords { brief, numbers: String::new(), suggestions: Vec::new() };
        }
        let guarded = match report.on_guard {
            0 => String::new(),
            edges => format!(
                " {} as short as allowed: {} of the original length (Shortest edge, under Weights and solver).",
                words::count(edges, "edge is", "edges are"),
                words::number(report.shortest_edge.unwrap_or(0.0))
            ),
        };
        let (brief, numbers) = if others.is_empty() {
            let error = written(report.max_distance);
            (
                format!("All required constraints are exact.{guarded}"),
                format!("The largest error is {error}."),
            )
        } else {
            let far = exact.iter().map(|(_, found)| found.worst_squared).fold(0.0, f64::max);
            let error = written(far.sqrt());
            (
                format!(
                    "All exact constraints are met exactly, the others within {within}.{guarded}"
                ),
                format!("The largest error of the exact ones is {error}."),
            )
        };
        ExactWords { brief, numbers, suggestions: Vec::new() }
    }

    fn unmet_words(&self, report: &ExactReport) -> ExactWords {
        let document = self.document();
        let units = &*document.units;
        let rows =
            || report.unmet.iter().filter_map(|&row| Some((row, document.constraints.get(row)?)));
        let hard = document.constraints.iter().zip(self.rows());
        let hard = hard.filter(|(row, _)| row.enabled && row.require.is_hard());
        let all: usize = hard.map(|(_, row)| row.constraints.members.len()).sum();
        let places = |is_one: &dyn Fn(&ConstraintSpec) -> bool| -> Vec<String> {
            let rows = rows().filter(|(_, row)| is_one(row));
            rows.map(|(_, row)| format!("{} on {}", row.label(), describe(&row.on))).collect()
        };
        let unmet = places(&|_| true);
        // What has a tolerance is not too large for it.
        let too_large = places(&|row| report.too_large && row.require == Require::Exact);
        let why = "the mesh, or one constraint, is too large for that";
        let are = words::is_or_are(report.misses);
        let (cannot, mut more) = if !too_large.is_empty() && too_large.len() == unmet.len() {
            (format!("{are} not exact: {why}"), String::new())
        } else if report.contradiction {
            let closest = " This is the closest shape that was found.".to_owned();
            ("cannot be satisfied together".to_owned(), closest)
        } else {
            (format!("{are} not satisfied yet"), String::new())
        };
        if !too_large.is_empty() && too_large.len() < unmet.len() {
            more += &format!(" {} cannot be exact: {why}.", too_large.join(", "));
        }
        let brief = format!(
            "{} of {} constraints {cannot}: {}.{more}",
            words::group_digits(report.misses),
            words::group_digits(all),
            unmet.join(", ")
        );
        // Those that are met may be farther off, within their own tolerances.
        let farthest = |row: Option<usize>| {
            let mut own = report.worst.iter().filter(|miss| row.is_none_or(|row| miss.row == row));
            own.next().or(report.worst.last()).map_or(report.max_distance, |miss| miss.distance)
        };
        let error = words::length_like(farthest(None), units, report.tolerance);
        let numbers = format!("The largest error is {error}.");
        let suggestions = rows().take(MOST_ROWS).flat_map(|(index, row)| {
            let label = row.label();
            let within = words::rounded(WIDER * farthest(Some(index)), 2);
            [
                WeakerRequirement { label: format!("Make {label} soft"), index, within: None },
                WeakerRequirement {
                    label: format!("{label} within {}", words::limit(within, units)),
                    index,
                    within: Some(within),
                },
            ]
        });
        ExactWords { brief, numbers, suggestions: suggestions.collect() }
    }
}

/// The tolerances of a row, that of its eased faces last, in the unit of the mesh.
fn tolerances(row: &ConstraintSpec) -> impl Iterator<Item = f64> {
    let own = match row.require {
        Require::Within(length) => Some(length),
        Require::Soft | Require::Exact => None,
    };
    own.into_iter().chain(row.eased.as_ref().map(|eased| eased.within))
}

impl TrialWords {
    /// The words of a trial of exact constraints instead of those within a distance.
    pub(crate) fn of_exactness(numbers: &TrialNumbers<'_>, exactness: &Exactness) -> TrialWords {
        let units = numbers.units;
        let mut away = String::new();
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
                let moved = numbers.moved;
                if let Some(then) = words::moved(moved.max, moved.mean, units, numbers.size) {
                    away = format!("It would then be {then}, from the original.");
                }
                let folds = match folded {
                    0 => String::new(),
                    folded => {
                        format!(", and {} would fold", words::count(*folded, "panel", "panels"))
                    }
                };
                format!("If made exact, the shape would move by up to {far}{folds}.")
            }
        };
        TrialWords { taken: "Also made exact.".to_owned(), offered, away }
    }

    /// The words of a search for a shape of less energy that meets the same requirements.
    pub(crate) fn of_improvement(numbers: &TrialNumbers<'_>) -> TrialWords {
        let [before, after] = numbers.energy;
        let gain = if before > 0.0 { words::part(1.0 - after / before) } else { words::part(0.0) };
        let far = words::length(numbers.by, numbers.units);
        TrialWords {
            taken: format!(
                "Improved: {gain} less energy; all that is required stays satisfied. It moved by up to {far}."
            ),
            offered: "No better shape was found nearby.".to_owned(),
            away: String::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::scene::Scene;

    #[test]
    fn only_what_has_to_be_exact_is_said_to_be_too_large_for_that() {
        // Constraints within a tolerance were said not to be exact.
        let rows = |first: &str, second: &str| {
            format!(
                r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "m.obj" }},
                    "weights": {{ "close": 1 }}, "constraints": [
                    {{ "kind": "plane", "on": "faces", "require": {first} }},
                    {{ "kind": "circle", "on": "faces", "require": {second} }}] }}"#
            )
        };
        let mesh = Mesh {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]],
            faces: [[0, 1, 2, 3]].into_iter().collect(),
            ..Mesh::default()
        };
        let brief_of = |first: &str, second: &str, contradiction: bool| {
            let scene = Scene::from_json(&rows(first, second)).expect("it is a scene");
            let session = Session::open(scene, mesh.clone()).expect("it fits");
            let (unmet, misses) = (vec![0, 1], 2);
            let known = ExactReport { too_large: true, contradiction, ..ExactReport::default() };
            session.unmet_words(&ExactReport { unmet, misses, ..known }).brief
        };
        let brief = |first: &str, second: &str| brief_of(first, second, false);
        let within = r#"{ "within": 0.001 }"#;
        let why = "the mesh, or one constraint, is too large for that";
        assert_eq!(
            brief("\"exact\"", "\"exact\""),
            format!(
                "2 of 2 constraints are not exact: {why}: Plane on each face, Circle on each face."
            )
        );
        assert_eq!(
            brief("\"exact\"", within),
            format!(
                "2 of 2 constraints are not satisfied yet: Plane on each face, Circle on each face. \
                 Plane on each face cannot be exact: {why}."
            )
        );
        assert!(!brief(within, within).contains(why));
        let both = brief_of("\"exact\"", within, true);
        assert!(both.contains("This is the closest shape that was found. Plane"), "{both}");
        assert!(both.ends_with(&format!("{why}.")), "{both}");
    }
}
