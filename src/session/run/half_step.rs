//! One iteration in its two halves, as in Fig. 4 of the paper: the local step, which fits a shape to
//! the vertices of every constraint, and the global step, which moves all vertices at once.

use super::step::Step;
use crate::error::Error;
use crate::session::state::Session;
use serde::Serialize;

/// The outcome of half an iteration.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "half", rename_all = "camelCase")]
pub enum HalfStep {
    /// The local step: shapes are fitted, nothing has moved.
    Local {
        /// How many constraints of which kind, each kind once.
        fitted: Vec<FittedCount>,
    },
    /// The global step: the vertices have moved.
    Global {
        /// Whether the total changed by no more than the tolerance.
        converged: bool,
        /// Whether they went elsewhere than to the least-squares answer, because the scene accelerates
        /// its steps.
        accelerated: bool,
    },
}

/// Constraints of one kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FittedCount {
    /// The kind's name for people.
    pub label: &'static str,
    /// How many constraints.
    pub count: usize,
}

impl Session {
    /// The next half of an iteration. Two of them are one [`Session::step`], with the same positions to
    /// the last bit. The global step is one step of undo.
    ///
    /// The local step computes nothing: every state of a session has its projections at hand, because
    /// its energies are distances to them. It only says so, and [`Session::projections`] shows them.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn half_step(&mut self) -> Result<HalfStep, Error> {
        if !self.halfway {
            self.end_run();
            self.end_drag(true);
            self.halfway = true;
            return Ok(HalfStep::Local { fitted: self.fits() });
        }
        self.begin_run();
        let step = self.step();
        self.end_run();
        let Step { converged, .. } = step?;
        Ok(HalfStep::Global { converged, accelerated: self.solver.accelerated() })
    }

    /// Whether the local step is done and the global step is not. Whatever else changes the shape or
    /// the scene ends it.
    pub fn halfway(&self) -> bool {
        self.halfway
    }

    fn fits(&self) -> Vec<FittedCount> {
        let mut fits: Vec<FittedCount> = Vec::new();
        for row in self.rows.iter().filter(|row| row.enabled) {
            let (label, count) = (row.constraints.kind.info().label, row.constraints.members.len());
            match fits.iter_mut().find(|fits| fits.label == label) {
                Some(fits) => fits.count += count,
                None => fits.push(FittedCount { label, count }),
            }
        }
        fits
    }
}
