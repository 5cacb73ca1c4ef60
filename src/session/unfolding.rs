//! Where faces fold as hard constraints are met: other ways to meet them, one after the other.

use super::Session;
use super::run::{Attempt, Attempts, Outcome, Unfolding};
use crate::error::Error;
use crate::mesh::Point;
use crate::scene::SmoothnessOf;
use crate::solve::{Exact, ExactAnswer, Require, Requirements, Weights};

impl Session {
    /// The attempts at the hard constraints.
    pub(super) fn attempts(&self) -> Attempts {
        let document = self.document();
        // A surface that is smoother is another one.
        let is_smooth =
            document.weights.smooth > 0.0 && document.smoothness.of == SmoothnessOf::Displacement;
        Attempts::new(self.unfolding, is_smooth, self.rest.mean_edge())
    }

    /// Goes on to the next attempt, after one that has ended; false where there is none.
    ///
    /// # Errors
    /// As [`Session::meeting`].
    pub(super) fn try_next(&mut self) -> Result<bool, Error> {
        let Some(meeting) = &mut self.meeting else { return Ok(false) };
        let positions = meeting.exact().positions();
        let ExactAnswer { met, iterations, .. } = meeting.exact().answer();
        let outcome = Outcome {
            met,
            folded: self.rest.folded_by(&positions).len(),
            moved: self.rest.moved_by(&positions).max,
            work: u64::from(iterations) * positions.len() as u64,
        };
        let Some((attempt, start)) = meeting.next(outcome) else { return Ok(false) };
        let start = start.as_deref().unwrap_or(self.rest.positions());
        let next = self.attempt(attempt, start)?;
        Ok(self.meeting.as_mut().zip(next).is_some_and(|(meeting, next)| {
            meeting.turn_to(next, attempt);
            true
        }))
    }

    /// The exact solver of an attempt, from `start` (`#V by 3`) on.
    fn attempt(&self, attempt: Attempt, start: &[Point]) -> Result<Option<Exact>, Error> {
        let Attempt { smoother, within, iterations } = attempt;
        let instead = |require| match (require, self.unfolding, within) {
            (Require::Within(length), Unfolding::Eased(asked), Some(within)) if length == asked => {
                Require::Within(within)
            }
            _ => require,
        };
        self.with_requirements(instead, |mut problem, mut requirements, handles, _, cache| {
            let weights = problem.weights;
            problem.weights = Weights { smooth: smoother * weights.smooth, ..weights };
            requirements.iterations = iterations.unwrap_or(Requirements::ITERATIONS);
            Exact::new(&problem, &requirements, handles, start, cache)
        })
    }
}
