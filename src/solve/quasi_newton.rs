//! L-BFGS whose initial metric is the factored normal matrix (Liu, Bouaziz, Kavan: Quasi-Newton
//! Methods for Real-Time Simulation of Hyperelastic Materials, 2017, section 4). With an empty
//! window it is exactly the plain two-step iteration.

use super::accelerate::{add_scaled, difference, dot};
use crate::constraint::Row;
use std::collections::VecDeque;

/// A step and the change of half the gradient along it.
struct Pair {
    s: Vec<Row>,
    y: Vec<Row>,
    /// `1 / (s . y)`
    rho: f64,
}

/// The last steps, at most `window` of them.
pub(super) struct QuasiNewton {
    window: usize,
    pairs: VecDeque<Pair>,
    /// Positions and half gradient of the step before; empty at the start.
    x: Vec<Row>,
    gradient: Vec<Row>,
}

impl QuasiNewton {
    /// With room for `window` steps.
    pub(super) fn new(window: usize) -> Self {
        QuasiNewton { window, pairs: VecDeque::new(), x: Vec::new(), gradient: Vec::new() }
    }

    /// Forgets all steps.
    pub(super) fn forget(&mut self) {
        self.pairs.clear();
        self.x.clear();
        self.gradient.clear();
    }

    /// See [`super::accelerate::Accelerator::propose`].
    pub(super) fn propose(
        &mut self,
        x: &[Row],
        step: &mut [Row],
        solve: impl Fn(&mut [Row]),
    ) -> bool {
        self.learn(x, step);
        self.x.clear();
        self.x.extend_from_slice(x);
        self.gradient.clear();
        self.gradient.extend_from_slice(step);
        // The two-loop recursion (Nocedal and Wright, Algorithm 7.4).
        let mut alphas = Vec::with_capacity(self.pairs.len());
        for pair in self.pairs.iter().rev() {
            let alpha = pair.rho * dot(&pair.s, step);
            add_scaled(step, -alpha, &pair.y);
            alphas.push(alpha);
        }
        solve(step);
        for (pair, alpha) in self.pairs.iter().zip(alphas.iter().rev()) {
            let beta = pair.rho * dot(&pair.y, step);
            add_scaled(step, alpha - beta, &pair.s);
        }
        !self.pairs.is_empty()
    }

    /// Adds the pair of the last step.
    fn learn(&mut self, x: &[Row], gradient: &[Row]) {
        if self.x.is_empty() {
            return;
        }
        let mut pair = if self.pairs.len() == self.window {
            self.pairs.pop_front().expect("a window holds at least one step")
        } else {
            Pair { s: Vec::new(), y: Vec::new(), rho: 0.0 }
        };
        difference(&mut pair.s, x, &self.x);
        difference(&mut pair.y, gradient, &self.gradient);
        let curvature = dot(&pair.s, &pair.y);
        // A step along which the gradient does not grow says nothing about curvature.
        if curvature > 1e-12 * dot(&pair.y, &pair.y).sqrt() * dot(&pair.s, &pair.s).sqrt() {
            pair.rho = 1.0 / curvature;
            self.pairs.push_back(pair);
        }
    }
}
