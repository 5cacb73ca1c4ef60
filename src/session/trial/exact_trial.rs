//! The cost of exactness, or the gain of an improvement, computed from the current shape without
//! changing it.

use crate::mesh::Point;
use crate::scene::{AttemptStart, ConstraintSpec, Lock};
use crate::session::Error;
use crate::session::Session;
use crate::session::edit::check_lock;
use crate::session::report::{Exactness, TrialNumbers, TrialWords};
use crate::session::requirements::Required;
use crate::session::run::{ExactReport, Met};
use crate::solve::{Exact, ExactAnswer, Moved, Require, Stage};
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// A trial of exact constraints instead of those within a distance, or of an improvement.
pub struct ExactTrial {
    exact: Exact,
    stage: TrialStage,
    /// The rows that are tried exactly; none for an improvement.
    rows: Vec<usize>,
    /// The index in the scene's list of constraints of each row of the exact solver.
    places: Vec<usize>,
    /// The shape at which it began, `#V by 3`, and its number.
    from: Rc<[Point]>,
    generation: u32,
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
    /// Number of faces that are folded or dented in the exact shape but not at rest.
    pub folded: usize,
    /// The cost of the current shape.
    pub before: Cost,
    /// The cost of the exact shape.
    pub after: Cost,
    /// Displacements between these two shapes.
    pub moved: Moved,
    /// The same in words.
    pub words: TrialWords,
}

/// The shape of a trial, to be accepted by the session of which a copy was tried. The positions
/// travel beside it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct ExactShape {
    /// The generation of the session at which the trial began.
    pub generation: u32,
    /// Indices of the rows that it meets exactly instead of within a distance; none for an improvement.
    pub rows: Vec<usize>,
    /// How well the shape meets the hard constraints.
    pub report: ExactReport,
}

impl Session {
    /// Tries to meet exactly the constraints within a distance; none if there is no such row, the lesson
    /// locks them, or the shape is exact already.
    ///
    /// # Errors
    /// As [`Session::solve`].
    pub fn exact_trial(&self) -> Result<Option<ExactTrial>, Error> {
        let rows: Vec<usize> = self.rows_within().collect();
        let is_locked = check_lock(Lock::Constraints, self.document()).is_err();
        if rows.is_empty() || is_locked || self.is_exact() {
            return Ok(None);
        }
        let exact = self.meeting_with(&Required::exactly)?;
        Ok(exact.map(|exact| self.trial(exact, rows, &Required::exactly)))
    }

    /// Searches for less energy with all requirements met, and exactly if they are so now; none if they
    /// are not met now.
    ///
    /// # Errors
    /// As [`Session::solve`].
    pub fn improvement(&self) -> Result<Option<ExactTrial>, Error> {
        let Some(required) = self.met_requirements() else { return Ok(None) };
        let Some(mut exact) = self.meeting_with(&required)? else { return Ok(None) };
        exact.improve();
        Ok(Some(self.trial(exact, Vec::new(), &required)))
    }

    fn trial(
        &self,
        mut exact: Exact,
        rows: Vec<usize>,
        required: &dyn Fn(&ConstraintSpec) -> Required,
    ) -> ExactTrial {
        ExactTrial {
            before: Cost { energy: exact.energy().total, moved: self.moved() },
            exact,
            stage: TrialStage::Far,
            rows,
            places: self.required_places(required, false),
            from: Rc::clone(self.scene.positions()),
            generation: self.generation(),
        }
    }

    /// Accepts the shape of a trial, `#V by 3`, as a step of undo, in which its rows are required to be
    /// exact. An `unasked` one leaves the requirements as they are, and is a part of the last step if that
    /// moved the shape. Returns false if the trial began at another shape or with another problem, during
    /// a drag, or while a variation is shown.
    ///
    /// # Errors
    /// If the lesson locks the constraints and some become exact, or the system would be singular;
    /// nothing has changed then.
    pub fn make_exact(
        &mut self,
        shape: ExactShape,
        positions: &[Point],
        unasked: bool,
    ) -> Result<bool, Error> {
        if !self.is_at(shape.generation) {
            return Ok(false);
        }
        let requires = !unasked && !shape.rows.is_empty();
        if requires {
            check_lock(Lock::Constraints, self.document())?;
        }
        self.end_transaction();
        let before = self.state();
        // Renaming and the like may have come between.
        let joins = unasked && self.history.last_moved(&before);
        let mut after = before.clone();
        after.scene.positions = positions.into();
        if requires {
            let document = Rc::make_mut(&mut after.scene.document);
            // What panels are judged by stays, though no constraint has it any more.
            if let Some(Require::Within(length)) = self.panel_requirement() {
                document.tolerance.get_or_insert(length);
            }
            for &row in &shape.rows {
                document.constraints[row].require = Require::Exact;
            }
            // The shape was found with the settings of its attempt, and goes on following handles with them.
            document.attempt.from = AttemptStart::Soft;
            document.constraints.iter_mut().for_each(|row| row.eased = None);
        }
        self.go_to_state(after)?;
        let name = if shape.rows.is_empty() { "Improve" } else { "Make exact" };
        match joins {
            true => self.history.join(),
            false => self.add_step(name.to_owned(), before),
        }
        self.met = Some(Met::new(&self.scene, self.in_the_scene(shape.report)));
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
    /// As [`Exact::step`] and [`Session::solve`].
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
                let Some(mut near) = session.meeting_with(&Required::exactly)? else {
                    return Ok(false);
                };
                near.end_approach_early();
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
        energy > self.before.energy || folded > session.rest.folded_by(&self.from).len()
    }

    /// Returns the current result; none if the session has another shape or another problem than
    /// at the beginning.
    pub fn offer(&mut self, session: &Session) -> Option<ExactOffer> {
        if session.generation() != self.generation {
            return None;
        }
        let ExactAnswer { met, unmet, moved, .. } = self.exact.answer();
        let positions = self.exact.positions();
        let moved_by = session.rest.moved_by(&positions);
        let after = Cost { energy: self.exact.energy().total, moved: moved_by };
        let too_large = !self.exact.can_polish();
        let folded = session.rest.folded_by(&positions).len();
        let numbers = TrialNumbers {
            units: &session.document().units,
            size: session.rest.diameter(),
            moved: after.moved,
            energy: [self.before.energy, after.energy],
            by: moved.max,
        };
        let words = match (self.rows.is_empty(), too_large, met) {
            (true, ..) => TrialWords::of_improvement(&numbers),
            (_, true, _) => TrialWords::of_exactness(&numbers, &Exactness::TooLarge),
            (.., false) => TrialWords::of_exactness(&numbers, &Exactness::Missed(unmet.len())),
            _ => TrialWords::of_exactness(&numbers, &Exactness::Met(folded)),
        };
        Some(ExactOffer { met, too_large, folded, before: self.before, after, moved, words })
    }

    /// Returns the current shape, to be accepted.
    pub fn shape(&self) -> ExactShape {
        ExactShape {
            generation: self.generation,
            rows: self.rows.clone(),
            report: ExactReport::new(self.exact.answer(), &self.places),
        }
    }

    /// Returns the positions of that shape, `#V by 3`.
    pub fn positions(&self) -> Vec<Point> {
        self.exact.positions()
    }
}
