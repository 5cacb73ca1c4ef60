//! The cost of exactness, or the gain of an improvement, computed from the current shape without
//! changing it.

use crate::scene::ConstraintSpec;
use crate::session::Error;
use crate::session::Session;
use crate::session::report::{Exactness, TrialNumbers, TrialWords};
use crate::session::requirements::Required;
use crate::session::run::SolvedFor;
use crate::session::state::{Part, RowValues};
use crate::solve::{Exact, ExactAnswer, Moved, Require, Stage};
use serde::Serialize;

/// A trial of exact constraints instead of those within a distance, or of an improvement.
pub struct ExactTrial {
    exact: Exact,
    stage: TrialStage,
    /// The rows to be made exact, and the name of the step of undo.
    rows: Vec<usize>,
    name: &'static str,
    /// The shape at which it began, and its problem.
    from: SolvedFor,
    before: Cost,
}

/// The stage of a trial.
enum TrialStage {
    /// Searches for the shape with the least energy, which may be far away.
    Far,
    /// Searches near the current shape, because the far shape costs more than the current one.
    /// Stores the far shape with its number of folded faces and its energy.
    Near(Box<Exact>, (usize, f64)),
    Ended,
}

/// The cost of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Cost {
    /// The total energy of the soft terms, without the hard constraints.
    pub energy: f64,
    /// Displacements from the original.
    pub moved: Moved,
}

/// The cost of exactness. Lengths are in the unit of the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ExactOffer {
    /// Whether all requirements can be met.
    pub met: bool,
    /// Whether the mesh is too large, so that nothing was tried.
    pub too_large: bool,
    /// Number of constraints that cannot be met.
    pub misses: usize,
    /// Number of faces that are folded or dented in the exact shape but not at rest.
    pub folded: usize,
    /// The largest remaining distance.
    pub max_distance: f64,
    /// The cost of the current shape.
    pub before: Cost,
    /// The cost of the exact shape.
    pub after: Cost,
    /// Displacements between these two shapes.
    pub moved: Moved,
    /// The same in words.
    pub words: TrialWords,
}

impl Session {
    /// Tries to meet exactly the constraints within a distance; none if there is no such row.
    ///
    /// # Errors
    /// As [`Session::meeting`].
    pub fn exact_trial(&self) -> Result<Option<ExactTrial>, Error> {
        let rows: Vec<usize> = self.rows_within().collect();
        if rows.is_empty() {
            return Ok(None);
        }
        let exact = self.exactly()?;
        Ok(exact.map(|exact| self.trial(exact, rows, "Make exact")))
    }

    /// Returns the exact solver with those constraints exact, starting at the current shape.
    fn exactly(&self) -> Result<Option<Exact>, Error> {
        self.meeting_with(&|row: &ConstraintSpec| match row.require {
            Require::Within(_) => Required { require: Require::Exact, eased: None },
            _ => Required::of(row),
        })
    }

    /// Searches for less energy with all requirements met; none if they are not met now.
    ///
    /// # Errors
    /// As [`Session::meeting`].
    pub fn improvement(&self) -> Result<Option<ExactTrial>, Error> {
        if !self.exact().is_some_and(|report| report.met) {
            return Ok(None);
        }
        let Some(mut exact) = self.meeting()? else { return Ok(None) };
        exact.improve();
        Ok(Some(self.trial(exact, Vec::new(), "Improve")))
    }

    fn trial(&self, mut exact: Exact, rows: Vec<usize>, name: &'static str) -> ExactTrial {
        let before = Cost { energy: exact.energy().total, moved: self.moved() };
        let from = SolvedFor::new(&self.scene);
        ExactTrial { exact, stage: TrialStage::Far, rows, name, from, before }
    }

    /// Accepts the current shape of a trial and its requirements, as a step of undo or as a part of
    /// the last one. Returns false if the trial began at another shape or with another problem.
    ///
    /// # Errors
    /// If the system would be singular; nothing has changed then.
    pub fn make_exact(&mut self, trial: &ExactTrial, joins_last: bool) -> Result<bool, Error> {
        self.end_transaction();
        if !trial.is_of(self) {
            return Ok(false);
        }
        let values = |&row: &usize| {
            let now = RowValues::of(&self.document().constraints[row]);
            Part::RowValues(row, RowValues { require: Require::Exact, eased: None, ..now })
        };
        let mut change = self.snapshot();
        change.scene.parts = trial.rows.iter().map(values).collect();
        change.scene.positions = trial.exact.positions().into();
        self.exchange(&mut change)?;
        match joins_last {
            true => self.history.join(change),
            false => self.history.push(trial.name.to_owned(), change),
        }
        self.note_met(&trial.exact);
        Ok(true)
    }

    fn rows_within(&self) -> impl Iterator<Item = usize> {
        let rows = &self.document().constraints;
        self.scene.enabled_rows().filter(|&row| matches!(rows[row].require, Require::Within(_)))
    }
}

impl ExactTrial {
    /// Runs one step, in the `session` of the trial; returns whether there is more to do.
    ///
    /// # Errors
    /// As [`Exact::step`] and [`Session::meeting`].
    pub fn step(&mut self, session: &Session) -> Result<bool, Error> {
        // If the polish does not fit in memory, a long approach would end far from exact.
        if matches!(self.stage, TrialStage::Ended) || !self.exact.can_polish() {
            return Ok(false);
        }
        if self.exact.step()? != Stage::Ended {
            return Ok(true);
        }
        let own = self.cost(session);
        match std::mem::replace(&mut self.stage, TrialStage::Ended) {
            TrialStage::Far if !self.rows.is_empty() && self.costs_more(own, session) => {
                let Some(mut near) = session.exactly()? else { return Ok(false) };
                near.hurry();
                let far = std::mem::replace(&mut self.exact, near);
                self.stage = TrialStage::Near(Box::new(far), own);
                Ok(true)
            }
            TrialStage::Near(far, of_far) if own >= of_far || !self.exact.answer().met => {
                self.exact = *far;
                Ok(false)
            }
            _ => Ok(false),
        }
    }

    /// Returns the number of folded faces, and the energy.
    fn cost(&mut self, session: &Session) -> (usize, f64) {
        let folded = session.rest.folded_by(&self.exact.positions()).len();
        (folded, self.exact.energy().total)
    }

    /// Whether this is more than the shape costs at which the trial began.
    fn costs_more(&self, (folded, energy): (usize, f64), session: &Session) -> bool {
        energy > self.before.energy || folded > session.rest.folded_by(self.from.positions()).len()
    }

    /// Whether the session has the shape and the problem with which the trial began.
    fn is_of(&self, session: &Session) -> bool {
        self.from.is_of(&session.scene) && self.from.has_handles_of(&session.scene)
    }

    /// Returns the current result; none if the session has another shape or another problem than
    /// at the beginning.
    pub fn offer(&mut self, session: &Session) -> Option<ExactOffer> {
        if !self.is_of(session) {
            return None;
        }
        let ExactAnswer { met, unmet, max_distance, moved, .. } = self.exact.answer();
        let positions = self.exact.positions();
        let moved_by = session.rest.moved_by(&positions);
        let after = Cost { energy: self.exact.energy().total, moved: moved_by };
        let (too_large, misses) = (!self.exact.can_polish(), unmet.len());
        let folded = session.rest.folded_by(&positions).len();
        let distance = session.exact().map_or(max_distance, |report| report.max_distance);
        let numbers = TrialNumbers {
            units: &session.document().units,
            size: session.rest.diameter(),
            distance: [distance, max_distance],
            tolerance: session.tolerance(),
            moved: [self.before.moved, after.moved],
            energy: [self.before.energy, after.energy],
            by: moved.max,
        };
        let words = match (self.rows.is_empty(), too_large, met) {
            (true, ..) => TrialWords::of_improvement(&numbers),
            (_, true, _) => TrialWords::of_exactness(&numbers, &Exactness::TooLarge),
            (.., false) => TrialWords::of_exactness(&numbers, &Exactness::Missed(misses)),
            _ => TrialWords::of_exactness(&numbers, &Exactness::Met(folded)),
        };
        let before = self.before;
        Some(ExactOffer {
            met,
            too_large,
            misses,
            folded,
            max_distance,
            before,
            after,
            moved,
            words,
        })
    }
}
