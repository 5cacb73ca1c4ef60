//! Meeting hard constraints in a run.

use super::attempt::{Attempt, Tried};
use super::attempts::Attempts;
use super::outcome::Outcome;
use crate::mesh::Point;
use crate::solve::{Exact, SolveError, Solver, Stage, clock};

/// Interval of showing intermediate positions, in seconds: each time their energies are evaluated.
const SHOWN_EVERY: f64 = 0.03;

/// What a step of the search leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MeetingStage {
    /// The attempt goes on.
    Going,
    /// Its soft solution is found: the exact solver follows.
    Softened,
    /// It has ended.
    Ended,
}

/// The soft solution of an attempt with other settings than the scene, on the way.
struct Softening {
    solver: Solver,
    attempt: Attempt,
    /// Iterations left.
    left: u32,
}

/// The current exact solver, the best attempt so far, and the time of the last display.
pub(crate) struct Meeting {
    /// The solver of the current attempt; while the soft solution of the next one is found, of the
    /// last one.
    exact: Exact,
    softening: Option<Box<Softening>>,
    attempts: Attempts,
    /// The last shape without folds within a larger tolerance, `#V by 3`.
    eased: Option<Vec<Point>>,
    /// The shape at the beginning, `#V by 3`.
    start: Vec<Point>,
    /// The best attempt that has ended.
    best: Option<(Exact, Attempt)>,
    shown: f64,
    converged: bool,
    /// Whether an attempt ended without an error, and the first error.
    has_ended: bool,
    error: Option<SolveError>,
    /// The time of all attempts so far.
    pub(crate) seconds: f64,
}

/// The outcome of a meeting.
pub(crate) struct MeetingEnd {
    /// The best shape.
    pub(crate) exact: Exact,
    /// The attempt that found it.
    pub(crate) attempt: Attempt,
    /// Whether all attempts have ended.
    pub(crate) is_whole: bool,
    /// Number of faces folded by the first attempt.
    pub(crate) folded_at_first: usize,
    /// The attempts that have ended, and the index of the one that found the shape.
    pub(crate) tried: Vec<Tried>,
    pub(crate) chosen: Option<usize>,
    /// Whether the iterations before it had converged.
    pub(crate) converged: bool,
    /// The time of all attempts.
    pub(crate) seconds: f64,
}

impl Meeting {
    /// Begins at the end of iterations that have `converged` or not; `begun` is the time at which the
    /// first attempt was prepared.
    pub(crate) fn new(exact: Exact, attempts: Attempts, converged: bool, begun: f64) -> Meeting {
        let (start, now) = (exact.positions(), clock::now());
        Meeting {
            exact,
            softening: None,
            eased: None,
            start,
            attempts,
            best: None,
            shown: now,
            converged,
            has_ended: false,
            error: None,
            seconds: now - begun,
        }
    }

    /// Runs one iteration or step of the current attempt. One that errs ends, with its best shape so
    /// far: another may not err.
    pub(crate) fn step(&mut self) -> MeetingStage {
        let Some(softening) = &mut self.softening else {
            match self.exact.step() {
                Ok(Stage::Ended) => self.has_ended = true,
                Ok(_) => return MeetingStage::Going,
                Err(error) => {
                    self.error.get_or_insert(error);
                }
            }
            return MeetingStage::Ended;
        };
        let has_erred = softening.solver.step().is_err();
        softening.left = softening.left.saturating_sub(1);
        let ended = has_erred || softening.left == 0 || softening.solver.converged();
        if ended { MeetingStage::Softened } else { MeetingStage::Going }
    }

    /// Returns the error of the first attempt, if all erred.
    pub(crate) fn error(&mut self) -> Option<SolveError> {
        self.error.take_if(|_| !self.has_ended)
    }

    /// Begins the next attempt with its soft solution, in at most this number of iterations.
    pub(crate) fn soften(&mut self, solver: Solver, attempt: Attempt, iterations: u32) {
        self.softening = Some(Box::new(Softening { solver, attempt, left: iterations }));
    }

    /// Ends the soft solution; returns the attempt, and its start, `#V by 3`.
    pub(crate) fn softened(&mut self) -> Option<(Attempt, Vec<Point>)> {
        let Softening { mut solver, attempt, .. } = *self.softening.take()?;
        solver.settle();
        Some((attempt, solver.positions().collect()))
    }

    pub(crate) fn exact(&self) -> &Exact {
        &self.exact
    }

    /// The current attempt.
    pub(crate) fn attempt(&self) -> &Attempt {
        self.softening.as_ref().map_or(self.attempts.now(), |softening| &softening.attempt)
    }

    /// The shape at the beginning, `#V by 3`.
    pub(crate) fn start(&self) -> &[Point] {
        &self.start
    }

    /// The energy of the soft terms at the current positions of the attempt.
    pub(crate) fn energy(&mut self) -> f64 {
        self.exact.energy().total
    }

    /// Returns the next attempt, if any, and its start, `#V by 3`: the last shape within a larger
    /// tolerance, or none before there is one. `outcome` is of this attempt; see
    /// [`Attempts::after`].
    pub(crate) fn next(
        &mut self,
        outcome: &Outcome,
        around: &dyn Fn(&[u32]) -> Vec<u32>,
    ) -> Option<(Attempt, Option<Vec<Point>>)> {
        if matches!(self.attempts.now(), Attempt::Eased(_)) && outcome.is_whole() {
            self.eased = Some(self.exact.positions());
        }
        let next = self.attempts.after(outcome, around)?;
        Some((next, self.eased.clone()))
    }

    /// Proceeds to the exact solver of the next attempt.
    pub(crate) fn turn_to(&mut self, exact: Exact, attempt: Attempt) {
        let before = std::mem::replace(&mut self.exact, exact);
        if let Some(attempt) = self.attempts.begin(attempt) {
            self.best = Some((before, attempt));
        }
    }

    /// The positions, `#V by 3`, if it is time to show them.
    pub(crate) fn due_positions(&mut self) -> Option<Vec<Point>> {
        let now = clock::now();
        if now - self.shown < SHOWN_EVERY {
            return None;
        }
        self.shown = now;
        Some(match &self.softening {
            Some(softening) => softening.solver.positions().collect(),
            None => self.exact.positions(),
        })
    }

    /// Stops, and returns the best shape so far.
    pub(crate) fn end(mut self) -> MeetingEnd {
        let is_whole = self.exact.stage() == Stage::Ended && self.softening.is_none();
        self.exact.stop();
        let folded_at_first = self.attempts.folded_at_first();
        let (tried, chosen) = self.attempts.tried();
        let tried = tried.to_vec();
        let (exact, attempt) = match self.best {
            Some(best) if !self.attempts.is_best() => best,
            _ => (self.exact, self.attempts.now().clone()),
        };
        let (converged, seconds) = (self.converged, self.seconds);
        MeetingEnd { exact, attempt, is_whole, folded_at_first, tried, chosen, converged, seconds }
    }
}
