//! Steps that use previous steps, so that stiff problems need tens of iterations where the plain
//! two-step iteration needs thousands.
//!
//! An accelerator works on positions, half gradients and the inverse of the normal matrix,
//! independent of the geometry. It proposes a step; the solver accepts it only if the energy falls,
//! and falls back to the plain step otherwise. Proposals may therefore be in single precision, but
//! the plain step of the fallback is in double.

mod anderson;
mod plain;
mod quasi_newton;

pub(super) use plain::Iterate;

use super::settings::{Accelerator, SolverSettings};
use super::system::System;
use crate::constraint::Row;
use crate::sparse::Precision;
use anderson::Anderson;
use plain::Plain;
use quasi_newton::QuasiNewton;

/// The chosen accelerator with its memory.
pub(in crate::solve) enum Acceleration {
    /// None: the plain two-step iteration of section 2.2.
    None(Plain),
    /// See [`QuasiNewton`].
    QuasiNewton(QuasiNewton),
    /// See [`Anderson`].
    Anderson(Anderson),
}

impl Acceleration {
    /// Returns the accelerator of the settings; a window of 0 is the plain iteration.
    pub(super) fn new(settings: &SolverSettings) -> Self {
        let window = settings.window as usize;
        match settings.accelerator {
            _ if window == 0 => Acceleration::None(Plain::default()),
            Accelerator::None => Acceleration::None(Plain::default()),
            Accelerator::QuasiNewton => Acceleration::QuasiNewton(QuasiNewton::new(window)),
            Accelerator::Anderson => Acceleration::Anderson(Anderson::new(window)),
        }
    }

    /// Whether its steps depend on previous steps.
    pub(super) fn learns(&self) -> bool {
        !matches!(self, Acceleration::None(_))
    }

    /// The precision in which `system` is solved for it.
    pub(super) fn precision(&self, system: &System) -> Precision {
        match self {
            Acceleration::None(_) => Plain::precision(system),
            Acceleration::QuasiNewton(_) | Acceleration::Anderson(_) => Precision::Single,
        }
    }

    /// Steps from `now` to the positions `to`. `before` is the previous iterate, if there is one
    /// since the problem changed. Returns false if the step is the plain step in double precision.
    pub(super) fn propose(
        &mut self,
        now: Iterate<'_>,
        before: Option<Iterate<'_>>,
        system: &mut System,
        to: &mut [Row],
    ) -> bool {
        match self {
            Acceleration::None(it) => return it.propose(now, system, to),
            Acceleration::QuasiNewton(it) => it.propose(now, before, system.f32_factor(), to),
            Acceleration::Anderson(it) => it.propose(now, before, system.f32_factor(), to),
        }
        true
    }

    /// Forgets all steps, because the problem has changed.
    pub(super) fn forget(&mut self) {
        match self {
            Acceleration::None(_) => {}
            Acceleration::QuasiNewton(quasi_newton) => quasi_newton.forget(),
            Acceleration::Anderson(anderson) => anderson.forget(),
        }
    }
}
