//! Steps of a descent: an accelerated step, with vertices that stay on curves, and the way back to
//! where it began.

use super::accelerate::{Acceleration, Iterate};
use super::parts::Parts;
use super::settings::SolverSettings;
use crate::constraint::Row;

/// The steps of one descent. Positions are those of the caller, `#nodes` rows.
pub(super) struct Descent {
    pub accelerator: Acceleration,
    /// Half the gradient at the current positions; zero where fixed.
    pub gradient: Vec<Row>,
    /// Positions and half gradient before the last step.
    pub previous: (Vec<Row>, Vec<Row>),
    /// Whether there was a step since the problem changed.
    has_previous: bool,
    /// Storage for the next positions.
    next: Vec<Row>,
}

impl Descent {
    /// Begins with `n` nodes.
    pub(super) fn new(settings: &SolverSettings, n: usize) -> Descent {
        let zeros = || vec![[0.0; 4]; n];
        Descent {
            accelerator: Acceleration::new(settings),
            gradient: zeros(),
            previous: (zeros(), zeros()),
            has_previous: false,
            next: zeros(),
        }
    }

    /// Takes a step from `x`, where `gradient` is. Returns whether it is another one than the plain
    /// step in double precision, and whether it uses a previous step.
    pub(super) fn step(&mut self, parts: &mut Parts, x: &mut Vec<Row>) -> [bool; 2] {
        if let Some(gliding) = &parts.gliding {
            gliding.to_unknowns(x, &mut self.gradient);
        }
        let now = Iterate { x, gradient: &self.gradient };
        let previous = Iterate { x: &self.previous.0, gradient: &self.previous.1 };
        let learned = self.has_previous && self.accelerator.learns();
        let previous = learned.then_some(previous);
        let rounded = self.accelerator.propose(now, previous, &mut parts.system, &mut self.next);
        std::mem::swap(&mut self.previous.0, x);
        std::mem::swap(&mut self.previous.1, &mut self.gradient);
        std::mem::swap(x, &mut self.next);
        self.has_previous = true;
        parts.put_on_curves(x);
        [rounded, learned]
    }

    /// Takes the step of the plain iteration from the previous positions instead of the last one.
    pub(super) fn plain_step(&self, parts: &mut Parts, x: &mut [Row]) {
        let previous = Iterate { x: &self.previous.0, gradient: &self.previous.1 };
        previous.plain_step(&mut parts.system, x);
        parts.put_on_curves(x);
    }

    /// Reduces the last step to this part of it. Without vertices on curves it stays as it is.
    pub(super) fn shorten(&self, parts: &mut Parts, x: &mut [Row], part: f64) {
        if let Some(gliding) = &parts.gliding {
            gliding.shorten((&self.previous.0, &self.previous.1), x, part);
        }
        parts.put_on_curves(x);
    }

    /// Returns to the positions before the last step, and forgets it.
    pub(super) fn restore(&mut self, parts: &mut Parts, x: &mut [Row]) {
        x.copy_from_slice(&self.previous.0);
        parts.put_on_curves(x);
        self.forget();
    }

    /// Forgets the steps so far.
    pub(super) fn forget(&mut self) {
        self.accelerator.forget();
        self.has_previous = false;
    }
}
