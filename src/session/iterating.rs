//! Iterations, whole and in halves.

use super::Session;
use super::run::{HalfStep, Step, fitted};
use crate::error::Error;

impl Session {
    /// One iteration. In a run, hard constraints are met after all else has converged.
    ///
    /// # Errors
    /// When a position leaves the finite numbers; the shape is then that before the step.
    pub fn step(&mut self) -> Result<Step, Error> {
        self.iterate(true)
    }

    /// One iteration as a run of its own, with hard constraints as soft ones: that they are met is for the end of a
    /// run. Where they are met it changes nothing.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn single_step(&mut self) -> Result<Step, Error> {
        self.begin_run();
        let step = self.iterate(false);
        self.end_run();
        step
    }

    fn iterate(&mut self, meets: bool) -> Result<Step, Error> {
        self.progress.leave_half();
        if let Some(step) = self.meeting_step()? {
            return Ok(step);
        }
        if self.is_met() {
            return Ok(Step { converged: self.converged(), ended: true });
        }
        let dragging = self.is_dragging();
        if !dragging {
            self.guard.take_start(&self.scene, &self.rest, self.progress.iteration());
        }
        self.scene.step()?;
        self.progress.advance(self.scene.solver().energy());
        let collapsed = self.guard.watch(&self.scene, &self.rest, dragging);
        let ended = self.scene.solver().converged() || collapsed;
        if meets && ended && !collapsed && self.is_running() && self.begin_meeting()? {
            return Ok(Step { converged: false, ended: false });
        }
        Ok(Step { converged: self.converged(), ended })
    }

    /// The next half of an iteration. Two of them are one [`Session::step`], with the same positions to
    /// the last bit. The global step is one step of undo.
    ///
    /// The local step computes nothing: every state of a session has its projections at hand, because
    /// its energies are distances to them. It only says so, and [`Session::projections`] shows them.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn half_step(&mut self) -> Result<HalfStep, Error> {
        if !self.halfway() {
            self.end_transaction();
            self.progress.begin_half();
            return Ok(HalfStep::Local { fitted: fitted(self.scene.rows()) });
        }
        let Step { converged, .. } = self.single_step()?;
        Ok(HalfStep::Global { converged, accelerated: self.scene.solver().accelerated() })
    }

    /// Iterates until the tolerance or the limit of the scene is reached, and meets the hard constraints, if there are
    /// any: what cannot be met the report says. With `trace` the energies of all iterations are recorded.
    ///
    /// # Errors
    /// As [`Session::step`], and when the system of the hard constraints is singular.
    pub fn solve(&mut self, trace: bool) -> Result<(), Error> {
        self.iterate_all(trace)?;
        self.meet(false)
    }

    /// [`Session::solve`], and then looks for less energy among the shapes that meet the hard constraints. It never
    /// ends with more, nor with constraints that are not met.
    ///
    /// # Errors
    /// As [`Session::solve`].
    pub fn solve_and_improve(&mut self, trace: bool) -> Result<(), Error> {
        self.iterate_all(trace)?;
        self.meet(true)
    }

    fn iterate_all(&mut self, trace: bool) -> Result<(), Error> {
        if trace {
            self.progress.record_all(self.scene.solver().energy());
        }
        for _ in 0..self.document().solver.iterations {
            if self.step()?.ended {
                break;
            }
        }
        self.scene.settle();
        Ok(())
    }

    /// Records the energies of the iterations from here on, this one included. Of some thousands
    /// there are all; of more, as many at equal distances.
    pub fn start_trace(&mut self) {
        self.progress.record(self.scene.solver().energy());
    }

    /// Watches over the shape from here on, as after an edit.
    pub fn arm_guard(&mut self) {
        self.guard.arm();
    }
}
