//! From an exact shape to a better one: steps downhill along the constraints, each brought back onto them. The valley
//! was chosen by the approach; held back too early, that one may end far above its bottom.
//!
//! A step minimises the energy, in the metric of the polish, among all displacements that are tangent to the
//! constraints (Gauss-Newton: their curvature is left out, so that steps may be too long, and are cut then). The steps
//! of the polish bring it back with the same factor. Only a shape that is met and has less energy is taken.

use super::answer::Improved;
use super::model::Model;
use super::polish::{Polish, Polished, add_displacement};
use crate::constraint::Row;
use crate::solve::energy::IterateSeconds;
use crate::solve::error::SolveError;
use crate::solve::rows::dot;

/// So many steps at most, a factor each.
const MOST_STEPS: u32 = 60;

/// New factors that bring one step back, at most.
const MOST_FACTORS: u32 = 2;

/// A step is halved down to this, and may grow to that.
const SHORTEST: f64 = 1.0 / 64.0;
const LONGEST: f64 = 4.0;

/// It ends after so many steps in a row that gain less than this part of the energy.
const LITTLE: (f64, u32) = (2e-4, 3);

/// A step gains at least this part of what its slope promises (Armijo's condition).
const ENOUGH: f64 = 1e-4;

/// The steps of an improvement.
pub(super) struct Improve {
    /// The energy at the start.
    before: f64,
    /// The energy, and half its gradient, at the positions at hand.
    energy: f64,
    gradient: Vec<Row>,
    /// The same gradient by nodes of the system of blocks.
    pull: Vec<Row>,
    dx: Vec<Row>,
    from: Vec<Row>,
    /// The part of a step that is tried first.
    length: f64,
    steps: u32,
    /// Steps in a row that gained little.
    little: u32,
}

impl Improve {
    /// From the positions of `model`, where its hard constraints are met.
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

    /// One step; whether it gained anything and another may.
    ///
    /// # Errors
    /// When the system is not positive definite; the positions of `model` are as before then.
    pub(super) fn step(
        &mut self,
        model: &mut Model,
        polish: &mut Polish,
    ) -> Result<bool, SolveError> {
        self.from.copy_from_slice(&model.x);
        let stepped = self.go(model, polish);
        if !matches!(stepped, Ok(true)) {
            model.x.copy_from_slice(&self.from);
        }
        self.steps += 1;
        Ok(stepped? && self.little < LITTLE.1 && self.steps < MOST_STEPS)
    }

    /// Whether a step was found that gains.
    fn go(&mut self, model: &mut Model, polish: &mut Polish) -> Result<bool, SolveError> {
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
                    let is_little = before - after < LITTLE.0 * before;
                    self.little = if is_little { self.little + 1 } else { 0 };
                    return Ok(true);
                }
            }
            t *= 0.5;
        }
        Ok(false)
    }
}

/// Brings positions back onto the constraints, with the factor at hand as long as it serves; whether it got there.
fn bring_back(model: &mut Model, polish: &mut Polish) -> Result<bool, SolveError> {
    polish.resume();
    let (goal, began) = (model.goal(), polish.factors);
    while !model.is_met(goal) {
        let goes = match polish.step(model, began) {
            Ok(polished) => polished == Polished::Goes,
            // A step too far may leave what can be factored.
            Err(SolveError::NotPositiveDefinite { .. }) => false,
            Err(error) => return Err(error),
        };
        if !goes || polish.factors - began > MOST_FACTORS {
            return Ok(false);
        }
    }
    Ok(true)
}

fn energy(model: &mut Model, gradient: &mut [Row]) -> f64 {
    let mut seconds = IterateSeconds::default();
    model.parts.energies.evaluate(&model.x, gradient, &mut seconds).total
}
