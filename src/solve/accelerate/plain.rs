//! An iterate, the state from which a step starts; and the plain two-step iteration (section 2.2),
//! with a factor in the precision that suits its size.
//!
//! A global step does little more than read the factor twice. A factor that exceeds the processor's
//! caches comes from memory, and half as many bytes take half the time. The iteration is in delta
//! form, so that a factor in single precision is only a metric: steps agree to about 1e-6 of their
//! length, and the limit is the same.

use crate::constraint::Row;
use crate::solve::system::System;
use crate::sparse::{F32Factor, F32Row, Precision, round};
use std::ops::Range;

/// Positions, and half the gradient there.
#[derive(Clone, Copy)]
pub(crate) struct Iterate<'a> {
    /// `#nodes` rows.
    pub x: &'a [Row],
    /// `#nodes` rows; zero where fixed.
    pub gradient: &'a [Row],
}

impl Iterate<'_> {
    /// A block of its rows.
    pub(crate) fn block(&self, rows: &Range<usize>) -> Self {
        Iterate { x: &self.x[rows.clone()], gradient: &self.gradient[rows.clone()] }
    }

    /// Takes the plain step (step II of section 2.2) from here to the positions `to`, in double
    /// precision. `system` must be factored.
    pub(crate) fn plain_step(&self, system: &mut System, to: &mut [Row]) {
        to.copy_from_slice(self.gradient);
        system.solve(to);
        for (to, x) in to.as_flattened_mut().iter_mut().zip(self.x.as_flattened()) {
            *to = x - *to;
        }
    }
}

/// Greatest number of nonzeros of a factor in double precision, 4 MB: about 8,000 vertices of a
/// quad mesh.
const MOST_DOUBLE: usize = 1 << 19;

/// Plain steps.
#[derive(Default)]
pub(in crate::solve) struct Plain {
    /// The scaled gradient, then the scaled step.
    rows: Vec<F32Row>,
}

impl Plain {
    /// The precision in which `system` is solved for it.
    pub(super) fn precision(system: &System) -> Precision {
        if system.factor_nonzeros() > MOST_DOUBLE { Precision::Single } else { Precision::Double }
    }

    /// See [`super::Acceleration::propose`].
    pub(super) fn propose(
        &mut self,
        now: Iterate<'_>,
        system: &mut System,
        to: &mut [Row],
    ) -> bool {
        let precision = Plain::precision(system);
        match precision {
            Precision::Double => now.plain_step(system, to),
            Precision::Single => {
                let scale = F32Factor::scale(now.gradient);
                self.rows.resize(now.x.len(), [0.0; 4]);
                round(&mut self.rows, now.gradient, scale);
                let factor = system.f32_factor();
                factor.solve(&mut self.rows);
                factor.subtract_step(to, now.x, &self.rows, scale);
            }
        }
        precision == Precision::Single
    }
}
