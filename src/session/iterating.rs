//! Iterations, whole and in halves.

use super::Session;
use super::edit::PanelStart;
use super::run::{HalfStep, Search, Step, fitted};
use crate::scene::SolverSettings;
use crate::session::Error;

impl Session {
    /// Runs one iteration. In a run, hard constraints are met after the rest has converged.
    ///
    /// # Errors
    /// If a position is not finite; the shape is then that before the step.
    pub fn step(&mut self) -> Result<Step, Error> {
        self.iterate(true, false)
    }

    /// Runs one iteration as a run of its own, with hard constraints as soft ones, because they are
    /// met only at the end of a run. It has no effect after a run that has tried to.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn single_step(&mut self) -> Result<Step, Error> {
        self.begin_run();
        let step = self.iterate(false, false);
        self.end_run();
        step
    }

    /// Runs one iteration, or one step of meeting hard constraints, which follows if a run `meets` them.
    fn iterate(&mut self, meets: bool, improves: bool) -> Result<Step, Error> {
        self.progress.leave_half();
        if let Some(step) = self.meeting_step(improves)? {
            return Ok(step);
        }
        if self.is_searched() {
            return Ok(Step { converged: self.converged(), ended: true });
        }
        let is_due =
            || self.needs_no_soft_solution() || (self.has_hard_rows() && self.is_run_long());
        if meets && self.is_running() && is_due() && self.begin_meeting()? {
            return Ok(Step { converged: false, ended: false });
        }
        self.scene.step()?;
        self.progress.advance(self.scene.solver().energy());
        let ended = self.scene.solver().converged() || (meets && self.is_run_long());
        if meets && ended && self.is_running() && self.begin_meeting()? {
            return Ok(Step { converged: false, ended: false });
        }
        Ok(Step { converged: self.converged(), ended })
    }

    /// Whether the run has had as many iterations as the scene allows. With a tolerance of 0 it goes on
    /// until it is ended, unless hard constraints are to be met after it.
    fn is_run_long(&self) -> bool {
        let SolverSettings { iterations: most, tolerance, .. } = self.document().solver;
        let run = self.transaction.as_ref().filter(|run| run.is_run());
        if tolerance == 0.0 && !self.has_hard_rows() {
            return false;
        }
        run.is_some_and(|run| self.iteration().saturating_sub(run.before().iteration) >= most)
    }

    /// Runs the next half of an iteration. Two halves equal one [`Session::step`], to the last bit
    /// of the positions. The global step is one step of undo.
    ///
    /// The local step computes nothing: the projections of every state are already available,
    /// because its energies are distances to them. It only reports them as done, and
    /// [`Session::projections`] returns them.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn half_step(&mut self) -> Result<HalfStep, Error> {
        if !self.halfway() {
            self.end_transaction();
            self.progress.begin_half();
            return Ok(HalfStep::Local { fitted: fitted(self.scene.rows()) });
        }
        if self.is_searched() {
            self.progress.leave_half();
            let met = self.met_here().is_some_and(|met| met.report.met);
            return Ok(HalfStep::Held { met });
        }
        let Step { converged, .. } = self.single_step()?;
        Ok(HalfStep::Global { converged, accelerated: self.scene.solver().accelerated() })
    }

    /// Iterates until the tolerance or the limit of the scene is reached, and then meets the hard
    /// constraints, if there are any; the report lists those that cannot be met. It is one step of undo.
    /// With `trace` the energies of all iterations are recorded.
    ///
    /// # Errors
    /// As [`Session::step`], and if the system of the hard constraints is singular.
    pub fn solve(&mut self, trace: bool) -> Result<(), Error> {
        self.run(trace, false)
    }

    /// As [`Session::solve`], and then searches the shapes that meet the hard constraints for one
    /// of less energy. The energy never increases, and the constraints stay met.
    ///
    /// # Errors
    /// As [`Session::solve`].
    pub fn solve_and_improve(&mut self, trace: bool) -> Result<(), Error> {
        self.run(trace, true)
    }

    /// As a press for panels of this `kind` in the page: a search for a shape within `tolerance` (unit
    /// of the mesh), by all attempts, and with larger tolerances for some panels at last. Without a
    /// kind, of the constraints that there are. With `trace` the energies of all iterations are
    /// recorded.
    ///
    /// # Errors
    /// As [`Session::make_panels`] and [`Session::step`].
    pub fn solve_as_pressed(
        &mut self,
        kind: Option<&str>,
        tolerance: f64,
        trace: bool,
    ) -> Result<(), Error> {
        match kind {
            Some(kind) => self.make_panels(kind, tolerance, PanelStart::Now)?,
            None => {
                self.begin_run();
                self.search = Search::Panels(tolerance);
            }
        }
        self.run(trace, false)
    }

    /// Goes on with the run under way, or begins one, up to its end.
    fn run(&mut self, trace: bool, improves: bool) -> Result<(), Error> {
        if trace {
            self.progress.record_all(self.scene.solver().energy());
        }
        if !self.is_running() {
            // A drag under way would keep the run from beginning.
            self.end_transaction();
            self.begin_run();
        }
        let (first, most) = (self.iteration(), self.document().solver.iterations);
        // In the page a run without an end is ended by its button.
        let is_long = |session: &Session| {
            !session.has_hard_rows() && session.iteration().saturating_sub(first) >= most
        };
        let mut found = Ok(false);
        while matches!(found, Ok(false)) && !is_long(self) {
            found = self.iterate(true, improves).map(|step| step.ended);
        }
        self.end_run();
        found.map(|_| ())
    }

    /// Records the energies of this and all later iterations: up to some thousands all of them,
    /// beyond that as many at equal intervals.
    pub fn start_trace(&mut self) {
        self.progress.record(self.scene.solver().energy());
    }

    /// Looks for a collapse at the end of every run, as after an edit.
    pub fn watch_for_collapse(&mut self) {
        self.opened = None;
    }
}
