//! One iteration, with its fallbacks: from an accelerated step to the plain one, from non-finite
//! numbers to the previous positions, from the end of a run to its lowest total.

use super::Solver;
use crate::constraint::Row;
use crate::solve::clock;
use crate::solve::energy::Energy;
use crate::solve::error::SolveError;

/// Greatest number of reductions of a step along curves; the last one makes it zero.
const SHORTENED: u32 = 12;

impl Solver {
    /// Performs one iteration: step II from the current projections, then step I at the new
    /// positions.
    ///
    /// # Errors
    /// If a position becomes NaN or infinite; the positions are then those before the step.
    pub fn step(&mut self) -> Result<(), SolveError> {
        if self.parts.system.unknowns() == 0 && self.energy.total.is_finite() {
            self.accelerated = false;
            self.converged = self.settings.tolerance > 0.0;
            return Ok(());
        }
        self.parts.system.prepare()?;
        let before = self.energy;
        let started = clock::now();
        let [rounded, learned] = self.descent.step(&mut self.parts, &mut self.x);
        self.seconds.global += clock::now() - started;
        self.evaluate();
        // Without a previous step, a proposal is the plain step in fewer digits.
        self.accelerated = rounded && learned;
        // Written so that NaN falls back too.
        let falls = |energy: Energy| energy.total < before.total;
        if rounded && !falls(self.energy) {
            self.accelerated = false;
            self.take_plain_step();
        }
        if self.parts.gliding.is_some() && !falls(self.energy) {
            self.shorten_step(before.total);
        }
        if self.descent.accelerator.learns() {
            self.keep_best(before.total);
        }
        self.stop_non_finite()?;
        let change = (self.energy.total - before.total).abs();
        let tolerance = self.settings.tolerance;
        let standing = (tolerance * before.total).max(self.rounding);
        self.converged = tolerance > 0.0 && change <= standing;
        if self.converged {
            let is_near = |total: f64| (total - self.energy.total).abs() <= 10.0 * standing;
            let is_known = self.no_saddle.is_some_and(is_near);
            // The plain iteration is that of the paper, and stays where it stands.
            let may_leave = self.descent.accelerator.learns() && !is_known;
            if may_leave && self.leave_saddle(10.0 * standing) {
                (self.converged, self.accelerated) = (false, true);
            } else {
                self.no_saddle = Some(self.energy.total);
            }
        }
        Ok(())
    }

    /// Takes the step of the plain iteration from the previous positions.
    fn take_plain_step(&mut self) {
        let started = clock::now();
        self.descent.plain_step(&mut self.parts, &mut self.x);
        self.seconds.global += clock::now() - started;
        self.parts.energies.shape.undo_step();
        self.evaluate();
    }

    /// Halves a step until the total falls: with vertices on curves, the plain step need not lower
    /// it.
    fn shorten_step(&mut self, before: f64) {
        for k in (0..SHORTENED).rev() {
            let part = if k == 0 { 0.0 } else { 0.5 };
            self.descent.shorten(&mut self.parts, &mut self.x, part);
            self.parts.energies.shape.undo_step();
            self.evaluate();
            if self.energy.total < before {
                break;
            }
        }
    }

    /// With approximate operators even the plain step can raise the total.
    fn keep_best(&mut self, before: f64) {
        if self.energy.total > before && self.best.as_ref().is_none_or(|best| before < best.0) {
            self.best = Some((before, self.descent.previous.0.clone()));
        }
    }

    /// Returns to the lowest total of the run, if the last step did not reach it.
    pub fn settle(&mut self) {
        if let Some((total, x)) = self.best.take()
            && total < self.energy.total
        {
            self.x = x;
            self.parts.put_on_curves(&mut self.x);
            self.forget();
            self.evaluate();
        }
    }

    /// The second of two gates for non-finite numbers; the first is where input is read.
    fn stop_non_finite(&mut self) -> Result<(), SolveError> {
        let finite = |row: &Row| row.iter().all(|value| value.is_finite());
        // Without an early exit the loop can be vectorised.
        let all_finite = |all: bool, value: &f64| all & value.is_finite();
        if self.energy.total.is_finite() && self.x.as_flattened().iter().fold(true, all_finite) {
            return Ok(());
        }
        let node = self.x.iter().position(|row| !finite(row)).unwrap_or(0) as u32;
        let vertex = self.parts.node_of().iter().position(|&of| of == node);
        self.descent.restore(&mut self.parts, &mut self.x);
        self.no_saddle = None;
        self.evaluate();
        Err(SolveError::NotFinite { vertex: vertex.unwrap_or(0) as u32 })
    }
}
