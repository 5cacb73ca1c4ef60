//! Meeting hard constraints. A run iterates with them as soft constraints until it has converged,
//! and then meets them step by step, showing intermediate shapes.

use super::Session;
use super::requirements::Required;
use super::run::{Attempt, ExactReport, Meeting, MeetingEnd, MeetingStage, Met, Search, Step};
use super::state::SceneState;
use crate::mesh::Point;
use crate::scene::{ConstraintSpec, Scene};
use crate::session::Error;
use crate::solve::{Exact, clock};
use std::rc::Rc;

impl Session {
    /// Returns the exact solver with these requirements for the enabled rows, which starts at the current
    /// shape; none if no row is then hard.
    ///
    /// # Errors
    /// If a set of the scene does not exist.
    pub(super) fn meeting_with(
        &self,
        required: &dyn Fn(&ConstraintSpec) -> Required,
    ) -> Result<Option<Exact>, Error> {
        self.with_requirements(
            self.document(),
            required,
            |problem, requirements, handles, start, cache| {
                Exact::new(&problem, &requirements, handles, start, cache)
            },
        )
    }

    /// How well the hard constraints are met; none if they have not been met for the current shape.
    pub fn exact(&self) -> Option<ExactReport> {
        if let Some(met) = self.met_here() {
            return Some(met.report.clone());
        }
        self.hard_distance()
            .filter(|(_, _, met)| *met)
            .map(|(most, tolerance, _)| ExactReport::of_what_is_met(most, tolerance))
    }

    /// Whether the current run is meeting hard constraints.
    pub fn is_meeting(&self) -> bool {
        self.meeting.is_some()
    }

    /// What the current run tries to meet its hard constraints, in words; none before that.
    pub fn attempt_words(&self) -> Option<&'static str> {
        self.meeting.as_ref().map(|meeting| meeting.attempt().words())
    }

    /// The result of the exact solver, if it is the current shape.
    pub(super) fn met_here(&self) -> Option<&Met> {
        self.met.as_ref().filter(|met| met.is_of(&self.scene))
    }

    /// Whether all attempts to meet the hard constraints have ended, met or not, and nothing has
    /// changed since.
    pub(super) fn is_searched(&self) -> bool {
        self.met_here().is_some_and(|met| met.is_searched(&self.scene))
    }

    /// Begins to meet the hard constraints; returns false if there are none.
    pub(super) fn begin_meeting(&mut self) -> Result<bool, Error> {
        let begun = clock::now();
        self.scene.settle();
        let converged = self.converged();
        // What an interrupted run had eased by then may be more than is needed.
        let is_eased = |row: &ConstraintSpec| row.eased.is_some() && self.eases(row);
        if self.document().constraints.iter().any(is_eased) {
            let mut document = self.document().clone();
            self.ease_rows(&mut document, None);
            self.go_to(&self.positions(), document)?;
        }
        let attempts = self.attempts();
        let Some(exact) = self.first_attempt(&attempts)? else { return Ok(false) };
        self.meeting = Some(Meeting::new(exact, attempts, converged, begun));
        Ok(true)
    }

    /// Runs one step of meeting hard constraints, which is no iteration of the scene; none if the run is
    /// not meeting any. The shape is improved at the end if requested.
    pub(super) fn meeting_step(&mut self, improves: bool) -> Result<Option<Step>, Error> {
        let begun = clock::now();
        let Some(meeting) = &mut self.meeting else { return Ok(None) };
        let stage = meeting.step();
        let shown = meeting.due_positions();
        let goes_on = self.goes_on(stage)?;
        let Some(meeting) = &mut self.meeting else { return Ok(None) };
        meeting.seconds += clock::now() - begun;
        if !goes_on {
            let error = meeting.error();
            self.end_meeting(improves)?;
            error.map_or(Ok(()), Err)?;
            return Ok(Some(Step { converged: self.converged(), ended: true }));
        }
        shown.into_iter().for_each(|positions| self.scene.show(&positions));
        Ok(Some(Step { converged: false, ended: false }))
    }

    /// Whether the meeting continues after a step: until it has ended, and then with the next
    /// attempt, which this begins.
    fn goes_on(&mut self, stage: MeetingStage) -> Result<bool, Error> {
        match stage {
            MeetingStage::Going => Ok(true),
            MeetingStage::Softened => self.go_on_from_soft(),
            MeetingStage::Ended => self.try_next(),
        }
    }

    /// Ends the meeting of hard constraints with the best shape so far, improved if requested.
    /// Returns false if none was under way.
    pub(super) fn end_meeting(&mut self, improves: bool) -> Result<bool, Error> {
        let Some(end) = self.meeting.take().map(Meeting::end) else { return Ok(false) };
        let MeetingEnd { mut exact, attempt, is_whole, folded_at_first, tried, chosen, .. } = end;
        let begun = clock::now();
        let mut improved = Ok(());
        if improves {
            exact.improve();
            improved = exact.run();
        }
        let seconds = end.seconds + clock::now() - begun;
        let far = exact.answer().max_distance;
        let mut document = self.document().clone();
        let eased = match &attempt {
            Attempt::Eased(tolerances) => {
                self.ease(&mut document, tolerances, folded_at_first, far)
            }
            _ => None,
        };
        // A search that is interrupted has chosen nothing: the next run begins it anew.
        if self.search != Search::Off && is_whole {
            document.choose_attempt(attempt.chosen());
        }
        self.go_to(&exact.positions(), document)?;
        let (answer, places) = self.answer_of(&attempt, &exact);
        let attempts = tried.len() as u32;
        let report = ExactReport { attempts, eased, seconds, ..ExactReport::new(answer, &places) };
        let mut met = Met::new(&self.scene, self.in_the_scene(report));
        (met.tried, met.chosen) = (tried, chosen);
        (met.converged, met.is_whole) = (end.converged, is_whole);
        self.met = Some(met);
        Ok(improved.map(|()| true)?)
    }

    /// Sets the positions, `#V by 3`, and the document, as a part of the run under way.
    fn go_to(&mut self, positions: &[Point], document: Scene) -> Result<(), Error> {
        let handles = Rc::clone(self.scene.handles());
        let document = self.scene.shared(document);
        self.go_to_scene(SceneState { document, handles, positions: positions.into() })?;
        self.progress.end_with(self.scene.solver().energy());
        Ok(())
    }
}
