//! Hard constraints that a run is meeting.

use crate::mesh::Point;
use crate::solve::{Exact, SolveError, Stage, clock};

/// Positions on the way are shown so often, in seconds: each time the energies are evaluated there.
const SHOWN_EVERY: f64 = 0.03;

/// What meets them, and when its positions were shown last.
pub(crate) struct Meeting {
    exact: Exact,
    shown: f64,
}

impl Meeting {
    pub(crate) fn new(exact: Exact) -> Meeting {
        Meeting { exact, shown: clock::now() }
    }

    /// One iteration or step; whether it has ended.
    ///
    /// # Errors
    /// As [`Exact::step`].
    pub(crate) fn step(&mut self) -> Result<bool, SolveError> {
        Ok(self.exact.step()? == Stage::Ended)
    }

    /// The positions, `#V by 3`, if it is time to show them.
    pub(crate) fn due_positions(&mut self) -> Option<Vec<Point>> {
        let now = clock::now();
        if now - self.shown < SHOWN_EVERY {
            return None;
        }
        self.shown = now;
        Some(self.exact.positions())
    }

    /// The best shape so far, and whether it had ended.
    pub(crate) fn end(mut self) -> (Exact, bool) {
        let ended = self.exact.stage() == Stage::Ended;
        self.exact.stop();
        (self.exact, ended)
    }
}
