//! The second stage: steps of least change onto the linearised constraints, with one factor of the system of
//! blocks for several of them.

use super::block_system::BlockSystem;
use super::model::Model;
use crate::constraint::Row;
use crate::mesh::Laplacian;
use crate::solve::assemble::Terms;
use crate::solve::error::SolveError;
use crate::solve::rows::{add_scaled, dot};

/// Factors at most, and steps with one factor at most.
const MOST_FACTORS: u32 = 12;
const MOST_STEPS: u32 = 20;

/// Where only steps that gain are taken: after one that was cut, the springs are so many times softer, after one
/// that was not, stiffer.
const SOFTER: f64 = 30.0;
const STIFFER: f64 = 10.0;

/// So many full steps with a fresh factor that gain nothing show a contradiction; by then all else is met.
const STUCK: u32 = 6;

/// A step meets the linearised constraints but for this part: the shape itself is less linear. With a factor of other
/// positions it need not be so close.
const LINEAR: f64 = 1e-3;
const ROUGHLY: f64 = 0.1;

/// The factor serves as long as a step with it leaves less than this part of the residuals.
const SERVES: f64 = 0.9;

/// Where so much of the squares of the residuals is of constraints that the factor does not hold, they are added to it:
/// a step without them would not serve.
const LOOSE: f64 = 0.5;

/// The least relative denominator of a correction: below it, the steps so far carry no information.
const LEAST_LEFT: f64 = 0.05;

/// A step is halved down to this.
const SHORTEST: f64 = 0.125;

/// The steps of the second stage.
pub(in crate::solve) struct Polish {
    pub system: BlockSystem,
    dx: Vec<Row>,
    next: Vec<Row>,
    /// Factors and steps so far.
    pub factors: u32,
    pub steps: u32,
    /// Steps left with the factor at hand.
    left: u32,
    /// How often a full step with a fresh factor has gained nothing, as the linear model said.
    stuck: u32,
    /// Whether only steps that gain are taken.
    damped: bool,
    /// The last steps with the factor at hand, all of them full.
    taken: Vec<Vec<Row>>,
}

/// The outcome of a step.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::solve) enum Polished {
    /// There is another step to take.
    Goes,
    /// No step gains any more.
    Ended,
    /// The constraints contradict each other.
    Contradicts,
}

impl Polish {
    /// See [`BlockSystem::new`].
    pub(in crate::solve) fn new(
        model: &Model,
        held: f64,
        smooth_terms: fn(&Laplacian) -> Terms,
    ) -> Polish {
        let system = BlockSystem::new(model, held, smooth_terms);
        let n = system.size();
        Polish {
            dx: vec![[0.0; 4]; n],
            next: model.x.clone(),
            system,
            factors: 0,
            steps: 0,
            left: 0,
            stuck: 0,
            damped: false,
            taken: Vec::new(),
        }
    }

    /// Begins anew from other positions: with bold steps, or with those that gain, which are shorter by softer springs.
    pub(in crate::solve) fn restart(&mut self, damped: bool) {
        (self.left, self.stuck, self.damped) = (0, 0, damped);
        self.system.stiffen(f64::INFINITY);
    }

    /// Begins anew from other positions with the factor at hand, as long as that serves.
    pub(in crate::solve) fn resume(&mut self) {
        self.restart(false);
        self.left = MOST_STEPS;
        self.taken.clear();
    }

    /// Factors at the positions of `model`, for steps that begin there.
    ///
    /// # Errors
    /// When the matrix cannot be factored.
    pub(super) fn begin_at(&mut self, model: &Model) -> Result<(), SolveError> {
        self.system.stiffen(f64::INFINITY);
        self.factors += 1;
        self.system.factor(model, true)
    }

    /// One step, with a new factor where the last one has served.
    ///
    /// # Errors
    /// When the matrix cannot be factored.
    pub(in crate::solve) fn step(
        &mut self,
        model: &mut Model,
        factors: u32,
    ) -> Result<Polished, SolveError> {
        let fresh = self.left == 0;
        if fresh {
            if self.factors - factors >= MOST_FACTORS {
                return Ok(Polished::Ended);
            }
            self.system.factor(model, true)?;
            self.factors += 1;
            self.left = MOST_STEPS;
            self.taken.clear();
        }
        let before = self.system.residuals(model, &model.x);
        if !fresh && self.system.loose() > LOOSE && self.factors - factors < MOST_FACTORS {
            self.system.hold_more(model, true)?;
            self.factors += 1;
            self.left = MOST_STEPS;
            self.taken.clear();
        }
        self.left -= 1;
        self.steps += 1;
        self.system.least_change(&mut self.dx, if fresh { LINEAR } else { ROUGHLY });
        let predicted = self.system.predicted();
        self.correct();
        let noise = 1e-14 * model.parts.extent;
        let mut t = 1.0;
        let after = loop {
            self.displace(model, t);
            let after = self.system.residuals(model, &self.next);
            let enough = before - 0.1 * t * (before - predicted);
            if after < enough || after < noise || t <= SHORTEST {
                break after;
            }
            t *= 0.5;
        };
        // Written so that NaN gains nothing.
        let gains = after < before || after < noise;
        if gains || (!self.damped && after.is_finite()) {
            std::mem::swap(&mut model.x, &mut self.next);
        }
        if fresh && t == 1.0 && self.system.is_stiffest() {
            let stands = (after - before).abs() < 1e-3 * before && predicted > 0.9 * before;
            self.stuck = if stands { self.stuck + 1 } else { 0 };
            if self.stuck == STUCK {
                return Ok(Polished::Contradicts);
            }
        }
        if self.damped && (!gains || t < 1.0) {
            self.system.stiffen(1.0 / SOFTER);
            self.left = 0;
        } else if after > SERVES * before || !self.system.is_stiffest() {
            self.system.stiffen(STIFFER);
            self.left = 0;
        } else if t == 1.0 {
            self.taken.push(self.dx.clone());
        } else {
            self.taken.clear();
        }
        Ok(Polished::Goes)
    }

    /// Corrects a step by what those before it with the same factor have shown: Broyden's method, as Kelley has it
    /// (*Iterative Methods for Linear and Nonlinear Equations*, 1995, section 7.3).
    fn correct(&mut self) {
        let Some(last) = self.taken.last() else { return };
        for pair in self.taken.windows(2) {
            let along = dot(&pair[0], &self.dx) / dot(&pair[0], &pair[0]);
            add_scaled(&mut self.dx, along, &pair[1]);
        }
        let left = 1.0 - dot(last, &self.dx) / dot(last, last);
        if left > LEAST_LEFT {
            self.dx.as_flattened_mut().iter_mut().for_each(|value| *value /= left);
        }
    }

    fn displace(&mut self, model: &Model, t: f64) {
        self.next.copy_from_slice(&model.x);
        add_displacement(&mut self.next, (model, &self.system), &self.dx, t);
    }
}

/// Adds `t` times a displacement by nodes of the system of blocks to positions of the model.
pub(super) fn add_displacement(
    x: &mut [Row],
    (model, system): (&Model, &BlockSystem),
    dx: &[Row],
    t: f64,
) {
    for (&node, &own) in model.parts.system.node_of().iter().zip(system.node_of()) {
        let (row, by) = (&mut x[node as usize], dx[own as usize]);
        (0..3).for_each(|c| row[c] += t * by[c]);
    }
}
