//! The first stage: quasi-Newton iterations with shifted projections and a weight of the hard
//! constraints that grows from round to round. It determines the quality of the shape; the polish
//! only completes it.

use super::model::Model;
use super::requirement::Requirements;
use crate::math::Lane;
use crate::solve::descent::Descent;
use crate::solve::energy::IterateSeconds;
use crate::solve::error::SolveError;
use crate::solve::settings::{Accelerator, SolverSettings};
use crate::sparse::Precision;

/// The weight at the start, relative to that which makes hard constraints as stiff as the energies.
const START: f64 = 0.3;

/// The parameters of rounds.
#[derive(Clone, Copy)]
struct Rounds {
    /// Factor by which the weight grows from one round to the next.
    growth: f64,
    /// Greatest number of iterations of a round.
    most: u32,
    /// A round ends when an iteration gains less than this fraction of the objective.
    least_gain: f64,
}

/// The rounds of an approach at first, and those after some iterations, which must end at the price
/// of some energy.
struct Schedule {
    first: Rounds,
    late: Rounds,
    /// Number of iterations after which an approach has to end, and the factor of the greatest number.
    late_after: u32,
    longer: u32,
}

/// The schedule if some rows must be exact.
const TO_THE_SHAPE: Schedule = Schedule {
    first: Rounds { growth: 1.5, most: 60, least_gain: 1e-4 },
    // With long rounds and a steeply growing weight, the horse model ends where no polish succeeds.
    late: Rounds { growth: 1.3, most: 20, least_gain: 3e-4 },
    late_after: LATE_AFTER,
    longer: 1,
};

/// The schedule if a tolerance is enough: a band is reached without a polish. Growth by 1.5 would
/// cost up to twice the energy, and rounds that end before they have settled crumple smooth
/// surfaces: with at most 20 iterations, the vertices of a wavy grid of 10,000 flat panels moved
/// nine times as far.
const INTO_BANDS: Schedule = Schedule {
    first: Rounds { growth: 1.2, most: 60, least_gain: 1e-4 },
    late: Rounds { growth: 1.4, most: 20, least_gain: 3e-4 },
    late_after: LATE_AFTER,
    longer: 1,
};

/// The same on a mesh of at most [`SMALL`] vertices, whose rounds settle. Where the shape must leave
/// a symmetry, or faces are about to fold, rounds that end before that lead where their rounding
/// errors do: noise of a millionth of an edge decided which of the attempts of a search succeeded.
const INTO_BANDS_OF_SMALL: Schedule = Schedule {
    first: Rounds { growth: 1.5, most: 1000, least_gain: 1e-6 },
    late: Rounds { growth: 1.4, most: 200, least_gain: 1e-5 },
    late_after: Requirements::LONGER * LATE_AFTER,
    longer: Requirements::LONGER,
};
const SMALL: usize = 100;

/// Number of iterations after which an approach has to end.
const LATE_AFTER: u32 = 900;

/// Upper bound of the weight, relative to the same as [`START`]: the metric is in single precision,
/// and must still resolve the energies.
const MOST: f64 = 1e5;

/// The approach stands still after this many consecutive short rounds that end at the same distance.
const STILL_ROUNDS: u32 = 6;

/// Greatest number of iterations of a short round.
const SHORT: u32 = 3;

/// Greatest number of times that a step along curves is halved.
const SHORTENED: u32 = 8;

/// The iteration of the first stage.
pub(super) struct Approach {
    descent: Descent,
    rho: f64,
    most: f64,
    schedule: &'static Schedule,
    round: Rounds,
    /// Iterations left in the round; zero before the first round.
    left: u32,
    in_round: u32,
    /// Number of consecutive rounds that stood still, and the worst excess after the last one.
    still: u32,
    worst: f64,
    /// Number of all iterations so far, and of all rounds: factorisations of the scalar matrix.
    pub iterations: u32,
    pub rounds: u32,
    /// The objective at the current positions.
    merit: f64,
    seconds: IterateSeconds,
}

impl Approach {
    pub(super) fn new(model: &Model, settings: &SolverSettings) -> Approach {
        let quasi_newton = SolverSettings {
            accelerator: Accelerator::QuasiNewton,
            window: settings.window.max(5),
            ..*settings
        };
        let [metric, hard] = model.stiffness;
        let unit = if metric > 0.0 { metric / hard } else { 1.0 };
        let schedule = match model.hard.any_exact() {
            true => &TO_THE_SHAPE,
            false if model.put.len() <= SMALL => &INTO_BANDS_OF_SMALL,
            false => &INTO_BANDS,
        };
        Approach {
            descent: Descent::new(&quasi_newton, model.x.len()),
            // The start may be a soft solution with a greater weight, which a much smaller one
            // cannot undo.
            rho: Lane::max(START * unit, 0.05 * model.parts.energies.weights.shape),
            most: MOST * unit,
            schedule,
            round: schedule.first,
            left: 0,
            in_round: 0,
            still: 0,
            worst: 0.0,
            iterations: 0,
            rounds: 0,
            merit: 0.0,
            seconds: IterateSeconds::default(),
        }
    }

    /// Performs one iteration; returns true if it was the last one of a round.
    ///
    /// # Errors
    /// If the normal matrix is not positive definite.
    pub(super) fn iterate(&mut self, model: &mut Model) -> Result<bool, SolveError> {
        if self.left == 0 {
            self.begin_round(model)?;
        }
        self.left -= 1;
        self.in_round += 1;
        self.iterations += 1;
        let before = self.merit;
        let gains = self.step(model) || {
            // The memory misleads: takes the plain step, in single precision.
            self.restore(model);
            self.step(model)
        };
        let gains = gains || self.shorten_step(model, before);
        if !gains {
            self.restore(model);
        }
        if !gains || before - self.merit < self.round.least_gain * before {
            self.left = 0;
        }
        if self.left == 0 {
            model.hard.update_shifts();
        }
        Ok(self.left == 0)
    }

    fn begin_round(&mut self, model: &mut Model) -> Result<(), SolveError> {
        let Schedule { first, late, .. } = *self.schedule;
        self.round = if self.is_long() { late } else { first };
        let growth = Lane::min(self.round.growth, self.most / self.rho);
        if growth > 1.0 || self.rounds == 0 {
            self.rho *= growth;
            model.hard.divide_shifts(growth);
            let scales = model.scales(self.rho);
            let (fixed, diagonal) = (model.fixed_in_approach(), &model.holding.diagonal);
            let system = &mut model.parts.system;
            system.set_matrix(Precision::Single, &scales, diagonal, fixed)?;
            system.prepare()?;
        }
        (self.left, self.in_round, self.rounds) = (self.round.most, 0, self.rounds + 1);
        self.descent.forget();
        // A polish that failed may have left them elsewhere.
        if let Some(gliding) = &mut model.parts.gliding {
            gliding.follow(&mut model.x);
        }
        self.evaluate(model);
        Ok(())
    }

    /// Whether there were so many iterations that it has to end.
    pub(super) fn is_long(&self) -> bool {
        self.iterations >= self.schedule.late_after
    }

    /// The factor of the greatest number of iterations.
    pub(super) fn longer(&self) -> u32 {
        self.schedule.longer
    }

    /// Whether rounds stand still at the `worst` excess of the last one. The constraints then
    /// contradict each other, and their shifts would grow without bound.
    pub(super) fn stands_still(&mut self, worst: f64) -> bool {
        // While the weight is small, hardly anything moves either.
        let stood = self.rho >= 0.01 * self.most
            && self.in_round <= SHORT
            && (worst - self.worst).abs() <= 1e-3 * worst;
        self.still = if stood { self.still + 1 } else { 0 };
        self.worst = worst;
        if self.still < STILL_ROUNDS {
            return false;
        }
        self.still = 0;
        true
    }

    /// Steps and evaluates; returns false if the objective did not fall.
    fn step(&mut self, model: &mut Model) -> bool {
        self.descent.step(&mut model.parts, &mut model.x);
        let before = self.merit;
        self.evaluate(model);
        self.merit < before
    }

    /// With vertices on curves, halves a step until the objective falls: even the plain step need not
    /// lower it. Returns whether it fell.
    fn shorten_step(&mut self, model: &mut Model, before: f64) -> bool {
        let most = if model.parts.gliding.is_some() { SHORTENED } else { 0 };
        for _ in 0..most {
            self.descent.shorten(&mut model.parts, &mut model.x, 0.5);
            self.evaluate(model);
            if self.merit < before {
                return true;
            }
        }
        false
    }

    /// Returns to the positions before the last step.
    fn restore(&mut self, model: &mut Model) {
        self.descent.restore(&mut model.parts, &mut model.x);
        self.evaluate(model);
    }

    fn evaluate(&mut self, model: &mut Model) {
        let Model { parts, hard, x, .. } = model;
        let gradient = &mut self.descent.gradient;
        let energy = parts.energies.evaluate(x, gradient, &mut self.seconds);
        let hard = hard.local_step(x, gradient, self.rho);
        parts.constrain(gradient);
        self.merit = energy.total + self.rho * hard;
    }
}
