//! Anderson acceleration of the fixed-point iteration `x -> G(x)` of the two-step scheme (Peng,
//! Deng, Zhang, Geng, Qin, Liu: Anderson Acceleration for Geometry Optimization and Physics
//! Simulation, 2018, Algorithm 1).

use super::accelerate::{add_scaled, difference, dot};
use crate::constraint::Row;
use nalgebra::{DMatrix, DVector};
use std::collections::VecDeque;

/// The last changes of `G(x)` and of the residual `F(x) = G(x) - x`, at most `window` of them.
pub(super) struct Anderson {
    window: usize,
    changes: VecDeque<Change>,
    /// `G` and `F` of the step before; empty at the start.
    plain: Vec<Row>,
    residual: Vec<Row>,
}

#[derive(Default)]
struct Change {
    plain: Vec<Row>,
    residual: Vec<Row>,
}

impl Anderson {
    /// With room for `window` steps.
    pub(super) fn new(window: usize) -> Self {
        Anderson { window, changes: VecDeque::new(), plain: Vec::new(), residual: Vec::new() }
    }

    /// Forgets all steps.
    pub(super) fn forget(&mut self) {
        self.changes.clear();
        self.plain.clear();
        self.residual.clear();
    }

    /// See [`super::accelerate::Accelerator::propose`].
    pub(super) fn propose(
        &mut self,
        x: &[Row],
        step: &mut [Row],
        solve: impl Fn(&mut [Row]),
    ) -> bool {
        solve(step);
        let residual: Vec<Row> = step.iter().map(|row| row.map(|value| -value)).collect();
        let mut plain = x.to_vec();
        add_scaled(&mut plain, 1.0, &residual);
        self.learn(&plain, &residual);
        self.plain = plain;
        self.residual = residual;
        let Some(theta) = self.coefficients() else {
            return false;
        };
        for (change, &theta) in self.changes.iter().zip(theta.iter()) {
            add_scaled(step, theta, &change.plain);
        }
        !self.changes.is_empty()
    }

    fn learn(&mut self, plain: &[Row], residual: &[Row]) {
        if self.plain.is_empty() {
            return;
        }
        let mut change = if self.changes.len() == self.window {
            self.changes.pop_front().unwrap_or_default()
        } else {
            Change::default()
        };
        difference(&mut change.plain, plain, &self.plain);
        difference(&mut change.residual, residual, &self.residual);
        self.changes.push_back(change);
    }

    /// `theta` that minimises `|F - sum_j theta_j dF_j|`, by scaled normal equations; none when the
    /// changes are dependent to working precision.
    fn coefficients(&self) -> Option<DVector<f64>> {
        let m = self.changes.len();
        let of = |j: usize| &self.changes[j].residual;
        let scale = DVector::from_fn(m, |j, _| 1.0 / dot(of(j), of(j)).sqrt());
        let gram = DMatrix::from_fn(m, m, |i, j| {
            // The ridge bounds the coefficients where changes are nearly parallel.
            dot(of(i), of(j)) * scale[i] * scale[j] + if i == j { 1e-9 } else { 0.0 }
        });
        let right = DVector::from_fn(m, |j, _| dot(of(j), &self.residual) * scale[j]);
        let theta = gram.cholesky()?.solve(&right).component_mul(&scale);
        theta.iter().all(|value| value.is_finite()).then_some(theta)
    }
}
