//! The tolerance to offer where panels are as asked and faces are folded: within a larger one they may not be.

use crate::error::Error;
use crate::session::Session;
use crate::session::edit::Edit;
use serde::Serialize;

/// What the tolerance is multiplied by, in turn.
const FACTORS: [f64; 4] = [5.0, 10.0, 30.0, 100.0];
/// A tolerance of more than this part of the mean edge is none.
const MOST: f64 = 0.1;

/// A tolerance within which fewer faces are folded.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Unfolded {
    /// The id of the kind that panels are asked to be.
    pub kind: &'static str,
    /// In the unit of the mesh.
    pub tolerance: f64,
    /// How many faces are folded within it.
    pub folded: usize,
}

/// The trials, one solve after the other.
pub struct Unfolding {
    /// The copy that is solved.
    session: Session,
    /// The kind that panels are asked to be.
    kind: &'static str,
    /// Not tried yet, the largest one first.
    untried: Vec<f64>,
    best: Option<Unfolded>,
    /// How many are folded in the session.
    before: usize,
}

impl Unfolding {
    /// Of a session whose panels are asked to be something within `tolerance`; none where they are not, or no face
    /// is folded.
    ///
    /// # Errors
    /// As [`Session::open`]; what could be solved before can be solved again.
    pub fn new(session: &mut Session, tolerance: f64) -> Result<Option<Unfolding>, Error> {
        let Some(verdict) = session.verdict(tolerance).filter(|verdict| verdict.folded > 0) else {
            return Ok(None);
        };
        let most = MOST * session.rest.mean_edge();
        let larger = FACTORS.iter().rev().map(|factor| factor * tolerance);
        Ok(Some(Unfolding {
            session: Session::open(session.scene(), session.mesh().clone())?,
            kind: verdict.kind,
            untried: larger.filter(|&larger| larger <= most).collect(),
            best: None,
            before: verdict.folded,
        }))
    }

    /// Tries the next tolerance, from the original shape; whether there is more to try.
    ///
    /// # Errors
    /// As [`Session::solve`].
    pub fn step(&mut self) -> Result<bool, Error> {
        let Some(tolerance) = self.untried.pop() else { return Ok(false) };
        let (kind, within) = (self.kind.to_owned(), Some(tolerance));
        self.session.edit(Edit::MakePanels { kind, within, afresh: true })?;
        self.session.solve(false)?;
        let folded = self.session.rest.folded_by(self.session.scene.positions()).len();
        if folded < self.best.map_or(self.before, |best| best.folded) {
            self.best = Some(Unfolded { kind: self.kind, tolerance, folded });
        }
        if folded == 0 {
            self.untried.clear();
        }
        Ok(!self.untried.is_empty())
    }

    /// The smallest tolerance tried that folds the fewest faces, where that is fewer than now.
    pub fn found(&self) -> Option<Unfolded> {
        self.best
    }
}
