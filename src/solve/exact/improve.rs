//! The improvement of an exact shape: steps downhill along the constraints, each followed by a
//! return onto them. The approach has chosen the valley; if it was held back too early, it may end
//! far above the bottom.
//!
//! A step minimises the energy, in the metric of the polish, among all displacements that are
//! tangent to the constraints. This is Gauss-Newton: the curvature of the constraints is left out,
//! so that steps may be too long, and are then cut. Steps of the polish return onto the constraints
//! with the same factor. A shape is accepted only if it meets them and has less energy.

use super::answer::Improved;
use super::model::Model;
use super::polish::{Polish, Polished, add_displacement};
use crate::constraint::Row;
use crate::solve::energy::IterateSeconds;
use crate::solve::error::SolveError;
use crate::solve::rows::dot;

/// Greatest number of steps, each with a factor.
const MOST_STEPS: u32 = 60;

/// Greatest number of new factors for the return of one step.
const MOST_FACTORS: u32 = 2;

/// Least and greatest length of a step.
const SHORTEST: f64 = 1.0 / 64.0;
const LONGEST: f64 = 4.0;

/// A step that gains less than this fraction of the energy gains little.
const LITTLE: f64 = 2e-4;

/// The improvement ends after this many consecutive steps that gain little.
const MOST_LITTLE: u32 = 3;

/// A step gains at least this fraction of what its slope predicts (Armijo's condition).
const ENOUGH: f64 = 1e-4;

/// The steps of an improvement.
pub(super) struct Improve {
    /// The energy at the start.
    before: f64,
    /// The energy, and half its gradient, at the current positions.
    energy: f64,
    gradient: Vec<Row>,
    /// The same gradient by nodes of the block system.
    pull: Vec<Row>,
    dx: Vec<Row>,
    from: Vec<Row>,
    /// The fraction of a step that is tried first.
    length: f64,
    steps: u32,
    /// Number of consecutive steps that gained little.
    little: u32,
}

impl Improve {
    /// Starts from the positions of `model`, where its hard constraints are met.
    pub(super) fn new(model: &mut Model, polish: &Polish) -> Improve {
        let n = polish.system.size();
        let mut gradient = vec![[0.0; 4]; model.x.len()];
        let energy = energy(model, &mut gradient);
        Improve {
            before: energy,
            energy,
            gradient,
            pull: vec![[0.0; 4]; n],
            dx: vec![[0.0; 4]; n],
            from: model.x.clone(),
            length: 1.0,
            steps: 0,
            little: 0,
        }
    }

    /// The gain so far.
    pub(super) fn gained(&self) -> Improved {
        Improved { before: self.before, after: self.energy, steps: self.steps }
    }

    /// Takes one step; returns whether it gained anything and another one may follow.
    ///
    /// # Errors
    /// If the system is not positive definite; the positions of `model` are then as before.
    pub(super) fn step(
        &mut self,
        model: &mut Model,
        polish: &mut Polish,
    ) -> Result<bool, SolveError> {
        self.from.copy_from_slice(&model.x);
        let stepped = self.try_step(model, polish);
        if !matches!(stepped, Ok(true)) {
            model.x.copy_from_slice(&self.from);
        }
        self.steps += 1;
        Ok(stepped? && self.little < MOST_LITTLE && self.steps < MOST_STEPS)
    }

    /// Returns whether a step was found that gains.
    fn try_step(&mut self, model: &mut Model, polish: &mut Polish) -> Result<bool, SolveError> {
        polish.begin_at(model)?;
        let nodes = polish.system.node_of().iter().zip(model.parts.system.node_of());
        for (&own, &node) in nodes {
            self.pull[own as usize] = self.gradient[node as usize];
        }
        polish.system.downhill(&self.pull, &mut self.dx);
        let slope = 2.0 * dot(&self.pull, &self.dx);
        // Written so that NaN gains nothing.
        let falls = slope < 0.0;
        let mut t = self.length;
        while falls && t >= SHORTEST {
            let mut x = std::mem::take(&mut model.x);
            x.copy_from_slice(&self.from);
            add_displacement(&mut x, (model, &polish.system), &self.dx, t);
            model.x = x;
            if bring_back(model, polish)? {
                let before = self.energy;
                let after = energy(model, &mut self.gradient);
                if after <= before + ENOUGH * t * slope {
                    self.energy = after;
                    self.length = (2.0 * t).min(LONGEST);
                    let is_little = before - after < LITTLE * before;
                    self.little = if is_little { self.little + 1 } else { 0 };
                    return Ok(true);
                }
            }
            t *= 0.5;
        }
        Ok(false)
    }
}

/// Brings positions back onto the constraints, with the current factor as long as it serves;
/// returns whether that succeeded.
fn bring_back(model: &mut Model, polish: &mut Polish) -> Result<bool, SolveError> {
    polish.resume();
    let (goal, began) = (model.goal(), polish.factors);
    while !model.is_met(goal) {
        let polished = polish.try_step(model, began)?;
        if polished != Some(Polished::Continues) || polish.factors - began > MOST_FACTORS {
            return Ok(false);
        }
    }
    Ok(true)
}

fn energy(model: &mut Model, gradient: &mut [Row]) -> f64 {
    let mut seconds = IterateSeconds::default();
    model.parts.energies.evaluate(&model.x, gradient, &mut seconds).total
}
