//! The search for a shape that meets the hard constraints: the attempts of a run, as exact solvers.

use super::Session;
use super::edit::check_lock;
use super::report::ConstraintCoverage;
use super::requirements::{Required, judged_by};
use super::run::{Attempt, Attempts, Eased, Meeting, Outcome, Search, ShapeMeasure, Tolerances};
use crate::constraint::{Element, Selector};
use crate::math::Vec3;
use crate::mesh::Point;
use crate::scene::{
    AttemptStart, BoundaryRequire, ClosenessTo, ConstraintSpec, EasedFaces, Lock, Scene,
    SmoothnessOf, all_faces,
};
use crate::session::Error;
use crate::solve::{Exact, ExactAnswer, Require, Solver, farthest};
use crate::words;

impl Session {
    /// Returns the search of a run that is no press for panels: with larger tolerances only if the
    /// scene says that it was solved so.
    pub(super) fn search_of_scene(&self) -> Search {
        let is_eased = self.document().attempt.from == AttemptStart::Eased;
        let mut rows = self.document().constraints.iter();
        let asked = rows.find_map(|row| match row.require {
            Require::Within(length) if is_eased && is_on_panels(row) => Some(length),
            _ => None,
        });
        asked.map_or(Search::Scene, Search::Panels)
    }

    /// Plans the attempts to meet the hard constraints.
    pub(super) fn attempts(&self) -> Attempts {
        let document = self.document();
        // Only displacements: a smoother surface would be another design.
        let is_smooth =
            document.weights.smooth > 0.0 && document.smoothness.of == SmoothnessOf::Displacement;
        let closeness = &document.closeness;
        let is_held =
            closeness.to == ClosenessTo::Rest && closeness.boundary.require == BoundaryRequire::Off;
        let is_locked = check_lock(Lock::Weights, document).is_err();
        let can_slide = is_held && document.weights.close > 0.0 && !is_locked;
        let can_ease = document.constraints.iter().any(|row| self.eases(row));
        let can = [!self.is_pulled(), is_smooth && !is_locked, can_slide, can_ease];
        let (faces, edge) = (self.mesh().faces.len(), self.edge_of_design());
        Attempts::new(self.search, document.attempt, can, faces, [self.rest.mean_edge(), edge])
    }

    /// Whether the shape is to be another than at rest: a handle is elsewhere, or the variation
    /// from which the user goes on.
    fn is_pulled(&self) -> bool {
        let least = self.mesh_tolerance();
        let rest = self.rest.positions();
        let is_away = |to: &Point, at: &Point| (Vec3::from(*to) - Vec3::from(*at)).length() > least;
        let design = self.document().variants.design_positions().unwrap_or_default();
        let mut handles = self.scene.handles().iter();
        design.iter().zip(rest).any(|(to, at)| is_away(to, at))
            || handles.any(|handle| is_away(&handle.target, &rest[handle.vertex as usize]))
    }

    /// Whether a hard constraint is to be far from the original: a sphere about all vertices, a surface
    /// beside it. Constraints on single faces are panels, which are where the original is.
    fn is_asked_elsewhere(&self) -> bool {
        let (rest, rows) = (&self.rest, &self.document().constraints);
        let pose = self.document().pose_positions();
        let is_far = |row: &ConstraintSpec, constraints| {
            let is_on_faces = matches!(row.on, Selector::Each { element: Element::Face, .. });
            row.require.is_hard()
                && !is_on_faces
                && farthest(rest.mesh(), pose, rest.positions(), constraints) > rest.mean_edge()
        };
        self.scene.enabled_rows().any(|row| is_far(&rows[row], &self.rows()[row].constraints))
    }

    /// The mean edge at rest, by which the place of a shape is judged; infinite if the shape is meant to
    /// be elsewhere than the original, which may be the surface that the panels were laid out on.
    pub(super) fn edge_of_design(&self) -> f64 {
        let closeness = &self.document().closeness;
        let is_kept = match closeness.to {
            ClosenessTo::Rest | ClosenessTo::Surface => true,
            _ => self.rest.original(closeness.target_mesh()).is_some(),
        };
        if is_kept && !self.is_pulled() && !self.is_asked_elsewhere() {
            self.rest.mean_edge()
        } else {
            f64::INFINITY
        }
    }

    /// Whether the first attempt of a run does not begin at the soft solution.
    pub(super) fn needs_no_soft_solution(&self) -> bool {
        self.search != Search::Off
            && matches!(self.document().attempt.from, AttemptStart::Rest | AttemptStart::Exact)
            && !self.is_pulled()
            && self.has_hard_rows()
    }

    /// Whether a later attempt begins with a soft solution of its own: that of other settings.
    fn softens(&self, attempt: &Attempt) -> bool {
        match attempt {
            Attempt::OnSurface | Attempt::SmootherFromSoft(_) => true,
            Attempt::Smoother(_) => self.is_pulled(),
            _ => false,
        }
    }

    /// Returns where an attempt begins, or its own soft solution: at the `soft` solution of the scene, or
    /// at rest. Within their tolerances there, handles would have no effect. All `#V by 3`.
    fn start_of(&self, attempt: &Attempt, soft: Vec<Point>) -> Vec<Point> {
        let is_soft = match attempt {
            Attempt::FromSoft => true,
            _ => self.is_pulled() && !self.softens(attempt),
        };
        if is_soft { soft } else { self.rest.positions().to_vec() }
    }

    /// Begins the next attempt after one has ended; returns false if there is none.
    ///
    /// # Errors
    /// As [`Session::meeting`].
    pub(super) fn try_next(&mut self) -> Result<bool, Error> {
        let Some(meeting) = &self.meeting else { return Ok(false) };
        let positions = meeting.exact().positions();
        let (exact, attempt) = (meeting.exact(), meeting.attempt());
        let ExactAnswer { met, unmet, iterations, .. } = self.answer_of(attempt, exact).0;
        let mut coverage = ConstraintCoverage::new(self.rest.mesh(), self.rest.topology());
        let missed = unmet.iter().flat_map(|miss| coverage.faces(&miss.vertices).to_vec());
        let missed = missed.collect();
        let Some(meeting) = &mut self.meeting else { return Ok(false) };
        let outcome = Outcome {
            met,
            misses: unmet.len(),
            missed,
            measure: ShapeMeasure::of(
                &positions,
                &self.rest,
                self.scene.document().closeness.target_mesh(),
            ),
            energy: meeting.energy(),
            work: u64::from(iterations) * positions.len() as u64,
        };
        let rest = &self.rest;
        let meeting_start = meeting.start().to_vec();
        let next = meeting.next(&outcome, &|faces| rest.faces_around(faces));
        let Some((attempt, start)) = next else { return Ok(false) };
        let start = match start {
            Some(whole) => self.eased_start(&attempt, whole, &positions),
            None => self.start_of(&attempt, meeting_start),
        };
        if self.softens(&attempt) {
            return self.soften(attempt, &start);
        }
        self.turn_to(attempt, &start)
    }

    /// Begins an attempt with its soft solution, from `start` (`#V by 3`).
    fn soften(&mut self, attempt: Attempt, start: &[Point]) -> Result<bool, Error> {
        let document = self.document_of(&attempt);
        let solver =
            self.with_requirements(&document, &Required::of, |problem, _, handles, _, cache| {
                Solver::new(&problem, cache, handles.to_vec(), start)
            })?;
        // Without a soft solution, it begins where that would have.
        let Some(Ok(solver)) = solver else { return self.turn_to(attempt, start) };
        let iterations = self.document().solver.iterations;
        Ok(self.meeting.as_mut().is_some_and(|meeting| {
            meeting.soften(solver, attempt, iterations);
            true
        }))
    }

    /// Goes on from the soft solution of an attempt; returns false if there is none.
    ///
    /// # Errors
    /// As [`Session::meeting`].
    pub(super) fn go_on_from_soft(&mut self) -> Result<bool, Error> {
        let softened = self.meeting.as_mut().and_then(Meeting::softened);
        let Some((attempt, start)) = softened else { return Ok(false) };
        self.turn_to(attempt, &start)
    }

    /// Begins an attempt at `start` (`#V by 3`); returns false if there are no hard constraints.
    fn turn_to(&mut self, attempt: Attempt, start: &[Point]) -> Result<bool, Error> {
        let next = self.attempt(&attempt, start)?;
        Ok(self.meeting.as_mut().zip(next).is_some_and(|(meeting, next)| {
            meeting.turn_to(next, attempt);
            true
        }))
    }

    /// Returns the exact solver of the first attempt; none if there are no hard constraints.
    ///
    /// # Errors
    /// As [`Session::meeting`].
    pub(super) fn first_attempt(&self, attempts: &Attempts) -> Result<Option<Exact>, Error> {
        self.attempt(attempts.now(), &self.start_of(attempts.now(), self.positions()))
    }

    /// Returns the exact solver of an attempt that starts at `start` (`#V by 3`).
    fn attempt(&self, attempt: &Attempt, start: &[Point]) -> Result<Option<Exact>, Error> {
        let document = self.document_of(attempt);
        let required = |row: &ConstraintSpec| self.required_by(attempt, row);
        self.with_requirements(
            &document,
            &required,
            |problem, mut requirements, handles, _, cache| {
                requirements.iterations = attempt.iterations();
                Exact::new(&problem, &requirements, handles, start, cache)
            },
        )
    }

    /// Returns the requirement of an attempt on a row.
    fn required_by(&self, attempt: &Attempt, row: &ConstraintSpec) -> Required {
        match attempt {
            Attempt::Exact if is_on_panels(row) => {
                Required { require: Require::Exact, eased: None }
            }
            Attempt::Eased(Tolerances { within, eased, .. }) if self.eases(row) => {
                Required { require: Require::Within(*within), eased: eased.clone() }
            }
            _ => Required::of(row),
        }
    }

    /// Returns the answer of an attempt, judged by the requirements of the scene, and the index in the list
    /// of constraints of each row of its solver.
    pub(super) fn answer_of(&self, attempt: &Attempt, exact: &Exact) -> (ExactAnswer, Vec<usize>) {
        let places = self.required_places(&|row| self.required_by(attempt, row), false);
        let rows = &self.document().constraints;
        let requires: Vec<Require> = places.iter().map(|&place| rows[place].require).collect();
        (judged_by(&requires, exact.answer()), places)
    }

    /// Returns the document with the settings of an attempt.
    fn document_of(&self, attempt: &Attempt) -> Scene {
        let mut document = self.document().clone();
        document.choose_attempt(attempt.chosen());
        document
    }

    /// Returns the start of an eased attempt, `#V by 3`: the end of the last one, but with the
    /// eased faces of the last shape without folds. From that shape alone it would take longer.
    fn eased_start(&self, attempt: &Attempt, whole: Vec<Point>, last: &[Point]) -> Vec<Point> {
        let Attempt::Eased(Tolerances { eased: Some(eased), .. }) = attempt else { return whole };
        let mut start = last.to_vec();
        for &face in &*eased.faces {
            for &vertex in self.rest.mesh().faces.row(face as usize) {
                start[vertex as usize] = whole[vertex as usize];
            }
        }
        start
    }

    /// Whether the search may ease the tolerance of a row: it is that of all panels.
    pub(super) fn eases(&self, row: &ConstraintSpec) -> bool {
        matches!(self.search, Search::Panels(asked) if row.require == Require::Within(asked))
            && is_on_panels(row)
    }

    /// Eases the rows of `document` to `tolerances`, and returns a report; none if none is eased.
    /// The first attempt has folded `folded` faces, and the `farthest` vertex has this distance to its
    /// projection. If the panels did not reach the required tolerance, all of them are eased.
    pub(super) fn ease(
        &self,
        document: &mut Scene,
        tolerances: &Tolerances,
        folded: usize,
        farthest: f64,
    ) -> Option<Eased> {
        let Search::Panels(asked) = self.search else { return None };
        let Tolerances { within, eased, .. } = tolerances;
        let mut eased = eased
            .clone()
            .unwrap_or_else(|| EasedFaces { within: *within, ..EasedFaces::default() });
        if *within > asked {
            eased.faces = (0..self.mesh().faces.len() as u32).collect();
        }
        if eased.faces.is_empty() {
            return None;
        }
        // Use no larger tolerance than needed.
        eased.within = two_digits_above(farthest).clamp(asked, eased.within);
        self.ease_rows(document, Some(&eased));
        Some(Eased { asked, within: eased.within, panels: eased.faces.len(), folded })
    }

    /// Gives these eased faces to the rows of `document` that may have them.
    pub(super) fn ease_rows(&self, document: &mut Scene, eased: Option<&EasedFaces>) {
        for row in document.constraints.iter_mut().filter(|row| self.eases(row)) {
            row.eased = eased.cloned();
        }
    }
}

/// Whether a row constrains all panels within a tolerance.
fn is_on_panels(row: &ConstraintSpec) -> bool {
    row.enabled && matches!(row.require, Require::Within(_)) && row.on == all_faces()
}

/// Rounds up to a number of two digits, at most a ninth larger.
fn two_digits_above(number: f64) -> f64 {
    words::rounded(1.06 * number, 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounded_number_is_above_and_near() {
        for k in 0..2000 {
            let number = 1e-3 * 1.01_f64.powi(k);
            let above = two_digits_above(number);
            assert!((1.0..1.112).contains(&(above / number)), "{number}: {above}");
        }
    }
}
