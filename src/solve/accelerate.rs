//! Steps that learn from the steps before them, so that stiff problems need tens of iterations
//! where the plain two-step iteration needs thousands.
//!
//! An accelerator sees positions, half gradients and the factored normal matrix as a metric, and
//! nothing of the geometry. It proposes a step; the solver takes it only if the energy falls, and
//! falls back to the plain step otherwise. So it may work in single precision, where the plain
//! step, on which everything rests, is in double.

use super::anderson::Anderson;
use super::factor::Precision;
use super::quasi_newton::QuasiNewton;
use super::system::System;
use crate::constraint::Row;
use crate::scene;
use std::ops::Range;

/// Positions, and half the gradient there.
#[derive(Clone, Copy)]
pub(super) struct Iterate<'a> {
    /// `#nodes` rows.
    pub x: &'a [Row],
    /// `#nodes` rows; zero where fixed.
    pub gradient: &'a [Row],
}

impl Iterate<'_> {
    /// A block of its rows.
    pub(super) fn block(&self, rows: &Range<usize>) -> Self {
        Iterate { x: &self.x[rows.clone()], gradient: &self.gradient[rows.clone()] }
    }
}

/// The chosen accelerator with its memory.
pub(super) enum Accelerator {
    /// The plain iteration.
    None,
    /// See [`QuasiNewton`].
    QuasiNewton(QuasiNewton),
    /// See [`Anderson`].
    Anderson(Anderson),
}

impl Accelerator {
    /// The one that the settings ask for; a window of 0 is the plain iteration.
    pub(super) fn new(settings: &scene::SolverSettings) -> Self {
        let window = settings.window as usize;
        match settings.accelerator {
            _ if window == 0 => Accelerator::None,
            scene::Accelerator::None => Accelerator::None,
            scene::Accelerator::QuasiNewton => Accelerator::QuasiNewton(QuasiNewton::new(window)),
            scene::Accelerator::Anderson => Accelerator::Anderson(Anderson::new(window)),
        }
    }

    /// How the system is to be solved for it.
    pub(super) fn precision(&self) -> Precision {
        match self {
            Accelerator::None => Precision::Double,
            Accelerator::QuasiNewton(_) | Accelerator::Anderson(_) => Precision::Single,
        }
    }

    /// Steps from `now` to the positions `to`. `before` is the iterate before, if there is one since
    /// the problem changed. False when it is the plain step to full precision.
    pub(super) fn propose(
        &mut self,
        now: Iterate<'_>,
        before: Option<Iterate<'_>>,
        system: &mut System,
        to: &mut [Row],
    ) -> bool {
        match self {
            Accelerator::None => {
                system.plain_step(now, to);
                return false;
            }
            Accelerator::QuasiNewton(it) => it.propose(now, before, system.metric(), to),
            Accelerator::Anderson(it) => it.propose(now, before, system.metric(), to),
        }
        true
    }

    /// Forgets all steps: the problem has changed.
    pub(super) fn forget(&mut self) {
        match self {
            Accelerator::None => {}
            Accelerator::QuasiNewton(quasi_newton) => quasi_newton.forget(),
            Accelerator::Anderson(anderson) => anderson.forget(),
        }
    }
}
