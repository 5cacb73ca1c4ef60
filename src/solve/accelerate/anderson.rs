//! Anderson acceleration of the fixed-point iteration `x -> G(x)` of the two-step scheme (Peng,
//! Deng, Zhang, Geng, Qin, Liu: Anderson Acceleration for Geometry Optimization and Physics
//! Simulation, 2018, Algorithm 1).

use super::plain::Iterate;
use crate::constraint::Row;
use crate::solve::rows::{add_scaled, dot};
use crate::sparse::{F32Factor, F32Row, round};
use nalgebra::{DMatrix, DVector};
use std::collections::VecDeque;

/// The last changes of `G(x)` and of the residual `F(x) = G(x) - x`, at most `window` of them.
pub(crate) struct Anderson {
    window: usize,
    changes: VecDeque<Change>,
    /// `G` and `F`, now and one step before.
    now: Change,
    before: Change,
    /// The scaled gradient, then the scaled step.
    rows: Vec<F32Row>,
}

#[derive(Default)]
struct Change {
    plain: Vec<Row>,
    residual: Vec<Row>,
}

impl Anderson {
    /// Creates an empty window of `window` steps.
    pub(super) fn new(window: usize) -> Self {
        Anderson {
            window,
            changes: VecDeque::new(),
            now: Change::default(),
            before: Change::default(),
            rows: Vec::new(),
        }
    }

    /// Clears the window, because the problem has changed.
    pub(super) fn forget(&mut self) {
        self.changes.clear();
    }

    /// See [`super::Acceleration::propose`].
    pub(super) fn propose(
        &mut self,
        now: Iterate<'_>,
        before: Option<Iterate<'_>>,
        factor: &F32Factor,
        to: &mut [Row],
    ) {
        std::mem::swap(&mut self.now, &mut self.before);
        let n = now.x.len();
        let Change { plain, residual } = &mut self.now;
        for rows in [&mut *plain, &mut *residual] {
            rows.resize(n, [0.0; 4]);
        }
        self.rows.resize(n, [0.0; 4]);
        let scale = F32Factor::scale(now.gradient);
        round(&mut self.rows, now.gradient, scale);
        factor.solve(&mut self.rows);
        factor.subtract_step(plain, now.x, &self.rows, scale);
        difference(residual, plain, now.x);
        to.copy_from_slice(plain);
        if before.is_some() {
            self.learn();
        }
        let theta = self.coefficients();
        for (change, &theta) in self.changes.iter().zip(theta.iter().flat_map(|theta| theta.iter()))
        {
            add_scaled(to, -theta, &change.plain);
        }
    }

    /// Adds the changes of the last step.
    fn learn(&mut self) {
        let mut change = if self.changes.len() == self.window {
            self.changes.pop_front().unwrap_or_default()
        } else {
            Change::default()
        };
        for rows in [&mut change.plain, &mut change.residual] {
            rows.resize(self.now.plain.len(), [0.0; 4]);
        }
        difference(&mut change.plain, &self.now.plain, &self.before.plain);
        difference(&mut change.residual, &self.now.residual, &self.before.residual);
        self.changes.push_back(change);
    }

    /// Returns the `theta` that minimises `|F - sum_j theta_j dF_j|`, by scaled normal equations;
    /// `None` if the changes are dependent to working precision.
    fn coefficients(&self) -> Option<DVector<f64>> {
        let m = self.changes.len();
        let of = |j: usize| &self.changes[j].residual;
        let scale = DVector::from_fn(m, |j, _| 1.0 / dot(of(j), of(j)).sqrt());
        let gram = DMatrix::from_fn(m, m, |i, j| {
            // The ridge bounds the coefficients if changes are nearly parallel.
            dot(of(i), of(j)) * scale[i] * scale[j] + if i == j { 1e-9 } else { 0.0 }
        });
        let right = DVector::from_fn(m, |j, _| dot(of(j), &self.now.residual) * scale[j]);
        let theta = gram.cholesky()?.solve(&right).component_mul(&scale);
        theta.iter().all(|value| value.is_finite()).then_some(theta)
    }
}

/// `y = a - b`.
#[inline(never)]
fn difference(y: &mut [Row], a: &[Row], b: &[Row]) {
    let (a, b) = (a.as_flattened(), b.as_flattened());
    for ((y, a), b) in y.as_flattened_mut().iter_mut().zip(a).zip(b) {
        *y = a - b;
    }
}
