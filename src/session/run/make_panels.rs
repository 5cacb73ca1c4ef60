//! One press for all panels: they are asked for one shape, and the run weighs the constraints more until
//! all panels are within a tolerance.

use crate::error::Error;
use crate::scene::{Scene, Weights};
use crate::session::edit::Edit;
use crate::session::state::{PanelGoal, Session, Transaction, TransactionKind};

/// The weight of the constraints is raised at most so often, and each time by at most and at least this:
/// distances fall like one over the weight.
const MOST_ROUNDS: u32 = 3;
const MOST_FACTOR: f64 = 1000.0;
const LEAST_FACTOR: f64 = 4.0;
/// How much more than that it is raised, since other panels give way.
const MARGIN: f64 = 1.6;
/// It is not raised again unless the worst distance has come below this part of what it was.
const HELPS: f64 = 0.7;

impl Session {
    /// Asks one shape of all panels ([`Edit::MakePanels`]) and begins a run that ends with all of them
    /// within `tolerance` (in the unit of the mesh) where that can be had. It is one step of undo.
    ///
    /// # Errors
    /// As [`Session::edit`].
    pub fn make_panels(&mut self, kind: &str, tolerance: f64) -> Result<(), Error> {
        let made = self.edit(Edit::MakePanels { kind: kind.to_owned() })?;
        self.begin_run();
        if let Some(transaction) = &mut self.run_state.transaction {
            transaction.joins_last = made;
            transaction.goal =
                Some(PanelGoal { tolerance, rounds: MOST_ROUNDS, worst: f64::INFINITY });
        }
        Ok(())
    }

    /// Where a run has converged with panels beyond its tolerance: weighs the constraints more, and
    /// returns whether it did.
    pub(crate) fn tighten(&mut self) -> bool {
        let Some(Transaction { kind: TransactionKind::Run, goal, .. }) =
            &mut self.run_state.transaction
        else {
            return false;
        };
        let Some(PanelGoal { tolerance, rounds, worst }) = goal.take() else { return false };
        let Some(verdict) = self.verdict(tolerance) else { return false };
        if verdict.within == verdict.panels || rounds == 0 || verdict.worst > HELPS * worst {
            return false;
        }
        let factor = (MARGIN * verdict.worst / tolerance).clamp(LEAST_FACTOR, MOST_FACTOR);
        let weights = self.document.weights;
        let mut state = self.snapshot();
        state.document = Scene {
            weights: Weights { shape: two_digits(factor * weights.shape), ..weights },
            ..state.document
        };
        if self.go_to(state).is_err() {
            return false;
        }
        if let Some(transaction) = &mut self.run_state.transaction {
            transaction.goal =
                Some(PanelGoal { tolerance, rounds: rounds - 1, worst: verdict.worst });
        }
        true
    }
}

/// A number that one says, near this one.
fn two_digits(number: f64) -> f64 {
    format!("{number:.1e}").parse().unwrap_or(number)
}
