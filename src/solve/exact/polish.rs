//! The second stage: least-change steps onto the linearised constraints, several of them with one
//! factor of the block system.

use super::block_system::BlockSystem;
use super::model::Model;
use crate::constraint::Row;
use crate::mesh::Laplacian;
use crate::solve::assemble::Terms;
use crate::solve::error::SolveError;
use crate::solve::rows::{add_scaled, dot};

/// Greatest number of factors, and of steps with one factor.
const MOST_FACTORS: u32 = 12;
const MOST_STEPS: u32 = 20;

/// If only steps that gain are taken, the springs become so many times softer after a step that was
/// cut, and [`STIFFER`] after one that was not.
const SOFTER: f64 = 30.0;
const STIFFER: f64 = 10.0;

/// A contradiction is detected after this number of full steps with a fresh factor that gain
/// nothing; all other constraints are met by then.
const STUCK: u32 = 6;

/// A step meets the linearised constraints except for this fraction: the shape itself is less
/// linear. With a factor of other positions, [`ROUGHLY`] is enough.
const LINEAR: f64 = 1e-3;
const ROUGHLY: f64 = 0.1;

/// The factor is kept as long as a step with it leaves less than this fraction of the residuals.
const SERVES: f64 = 0.9;

/// If more than this fraction of the squared residuals is of constraints that the factor does not
/// hold, they are added to it: a step without them would not serve.
const LOOSE: f64 = 0.5;

/// The least relative denominator of a correction: below it, the previous steps carry no
/// information.
const LEAST_LEFT: f64 = 0.05;

/// The least fraction of a step, reached by halving.
const SHORTEST: f64 = 0.125;

/// The steps of the second stage.
pub(in crate::solve) struct Polish {
    pub system: BlockSystem,
    dx: Vec<Row>,
    next: Vec<Row>,
    /// Number of factors and of steps so far.
    pub factors: u32,
    pub steps: u32,
    /// Number of steps left with the current factor.
    left: u32,
    /// Number of full steps with a fresh factor that gained nothing, as the linear model predicted.
    stuck: u32,
    /// Whether only steps that gain are taken.
    damped: bool,
    /// The last steps with the current factor, all of them full.
    taken: Vec<Vec<Row>>,
}

/// The outcome of a step.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::solve) enum Polished {
    /// There is another step to take.
    Continues,
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

    /// Restarts from other positions: with steps that need not gain, or, if `damped`, with steps
    /// that must, which softer springs shorten.
    pub(in crate::solve) fn restart(&mut self, damped: bool) {
        (self.left, self.stuck, self.damped) = (0, 0, damped);
        self.system.stiffen(f64::INFINITY);
    }

    /// Restarts from other positions with the current factor, as long as that serves.
    pub(in crate::solve) fn resume(&mut self) {
        self.restart(false);
        self.left = MOST_STEPS;
        self.taken.clear();
    }

    /// Factors at the positions of `model`, for steps that begin there.
    ///
    /// # Errors
    /// If the matrix cannot be factored.
    pub(super) fn begin_at(&mut self, model: &Model) -> Result<(), SolveError> {
        self.system.stiffen(f64::INFINITY);
        self.factors += 1;
        self.system.factor(model, true)
    }

    /// As [`Polish::step`]; none where the matrix is not positive definite, which can happen after
    /// a step that went too far.
    ///
    /// # Errors
    /// If the matrix cannot be factored for another reason.
    pub(in crate::solve) fn try_step(
        &mut self,
        model: &mut Model,
        factors: u32,
    ) -> Result<Option<Polished>, SolveError> {
        match self.step(model, factors) {
            Ok(polished) => Ok(Some(polished)),
            Err(SolveError::NotPositiveDefinite { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Takes one step, with a new factor if the last one no longer serves. `factors` is the number
    /// of factors when the polish began.
    ///
    /// # Errors
    /// If the matrix cannot be factored.
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
        if !fresh
            && self.system.inactive_fraction() > LOOSE
            && self.factors - factors < MOST_FACTORS
        {
            self.system.hold_others(model, true)?;
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
        Ok(Polished::Continues)
    }

    /// Corrects a step by what previous steps with the same factor have shown: Broyden's method,
    /// according to Kelley (*Iterative Methods for Linear and Nonlinear Equations*, 1995, section
    /// 7.3).
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

/// Adds `t` times a displacement, by nodes of the block system, to positions of the model.
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
