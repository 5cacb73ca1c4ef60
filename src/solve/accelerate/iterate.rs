//! An iterate: the state from which a step starts.

use crate::constraint::Row;
use crate::solve::system::System;
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
