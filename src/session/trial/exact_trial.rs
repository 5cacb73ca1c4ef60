//! The cost of exactness, or the gain of an improvement, found from the current shape on without
//! touching it.

use crate::error::Error;
use crate::mesh::Point;
use crate::scene::ConstraintSpec;
use crate::session::Session;
use crate::session::requirements::Required;
use crate::session::state::{Part, RowValues};
use crate::solve::{Exact, ExactAnswer, Moved, Require, Stage};
use serde::Serialize;
use std::rc::Rc;

/// A trial of being exact instead of within a distance, or of an improvement, one step after the other.
pub struct ExactTrial {
    exact: Exact,
    /// How far it has come.
    stage: TrialStage,
    /// The rows that are to be exact, and the name of the step of undo.
    rows: Vec<usize>,
    name: &'static str,
    /// The shape that it began from, `#V by 3`.
    from: Rc<[Point]>,
    before: Price,
}

/// The stage of a trial.
enum TrialStage {
    /// Looks for the shape with the least energy, which may be far away.
    Far,
    /// That one has so many folded faces and that energy, more than the shape as it is: one that is near to it may cost
    /// less.
    Near(Box<Exact>, (usize, f64)),
    Ended,
}

/// The cost of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Price {
    /// The energies of all that is weighed, without what is met.
    pub energy: f64,
    /// The way from the original.
    pub moved: Moved,
}

/// The cost of exactness. Lengths are in the unit of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ExactOffer {
    /// Whether all that is required can be met.
    pub met: bool,
    /// Whether the mesh is too large for it, so that nothing was tried.
    pub too_large: bool,
    /// How many constraints cannot.
    pub misses: usize,
    /// How many faces are folded or dented in the exact shape and are not at rest.
    pub folded: usize,
    /// The greatest distance that is left.
    pub max_distance: f64,
    /// The shape as it is.
    pub before: Price,
    /// The exact shape.
    pub after: Price,
    /// The way from the one to the other.
    pub moved: Moved,
}

impl Session {
    /// Tries to meet exactly what is met within a distance; none where there is no such row of constraints.
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

    /// The exact solver of what is met within a distance, from the current shape on.
    fn exactly(&self) -> Result<Option<Exact>, Error> {
        self.meeting_with(&|row: &ConstraintSpec| match row.require {
            Require::Within(_) => Required { require: Require::Exact, eased: None },
            _ => Required::of(row),
        })
    }

    /// Looks for less energy among the shapes that meet what is required; none where that is not met now.
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
        let before = Price { energy: exact.energy().total, moved: self.moved() };
        let from = Rc::clone(self.scene.positions());
        ExactTrial { exact, stage: TrialStage::Far, rows, name, from, before }
    }

    /// Takes the shape of a trial as far as it has come and requires it, as a step of undo or as a part of the last
    /// one; whether the trial was of the current shape.
    ///
    /// # Errors
    /// When the system would be singular; nothing has changed then.
    pub fn make_exact(&mut self, trial: &ExactTrial, joins_last: bool) -> Result<bool, Error> {
        self.end_transaction();
        if !Rc::ptr_eq(&trial.from, self.scene.positions()) {
            return Ok(false);
        }
        let values = |&row: &usize| {
            let now = RowValues::of(&self.document().constraints[row]);
            Part::RowValues(row, RowValues { require: Require::Exact, eased: None, ..now })
        };
        let mut change = self.way_back();
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
    /// Goes on by one step, in the `session` that it is of; whether there is more to do.
    ///
    /// # Errors
    /// As [`Exact::step`] and [`Session::meeting`].
    pub fn step(&mut self, session: &Session) -> Result<bool, Error> {
        // A long approach would end far from what is asked.
        if matches!(self.stage, TrialStage::Ended) || !self.exact.can_polish() {
            return Ok(false);
        }
        if self.exact.step()? != Stage::Ended {
            return Ok(true);
        }
        let own = self.cost(session);
        match std::mem::replace(&mut self.stage, TrialStage::Ended) {
            TrialStage::Far if !self.rows.is_empty() && self.is_dear(own, session) => {
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

    /// How many faces are folded, and the energy.
    fn cost(&mut self, session: &Session) -> (usize, f64) {
        let folded = session.rest.folded_by(&self.exact.positions()).len();
        (folded, self.exact.energy().total)
    }

    /// Whether that costs more than the shape that it began from.
    fn is_dear(&self, (folded, energy): (usize, f64), session: &Session) -> bool {
        energy > self.before.energy || folded > session.rest.folded_by(&self.from).len()
    }

    /// What it costs, as of now, in the `session` that it is of.
    pub fn offer(&mut self, session: &Session) -> ExactOffer {
        let ExactAnswer { met, unmet, max_distance, moved, .. } = self.exact.answer();
        let positions = self.exact.positions();
        let moved_by = session.rest.moved_by(&positions);
        let after = Price { energy: self.exact.energy().total, moved: moved_by };
        ExactOffer {
            met,
            too_large: !self.exact.can_polish(),
            misses: unmet.len(),
            folded: session.rest.folded_by(&positions).len(),
            max_distance,
            before: self.before,
            after,
            moved,
        }
    }
}
