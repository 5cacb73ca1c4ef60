//! L-BFGS whose initial metric is the factored normal matrix (Liu, Bouaziz, Kavan: Quasi-Newton
//! Methods for Real-Time Simulation of Hyperelastic Materials, 2017, section 4). With an empty
//! window it is exactly the plain two-step iteration.
//!
//! The memory is in single precision, as the metric is: what steps have taught is no better than
//! that, and reading it is most of what an accelerated iteration costs beside a plain one. For the
//! same reason the two-loop recursion (Nocedal and Wright, Algorithm 7.4) is written in inner
//! products, which are taken of all vectors at once, a block of rows at a time.

use super::accelerate::Iterate;
use super::metric::{Metric, SingleRow, rounded};
use crate::constraint::Row;
use std::collections::VecDeque;
use std::ops::Range;

/// Rows in a block: what is read twice is still in the nearest cache, and sums in single precision
/// are short.
const BLOCK: usize = 64;

/// A step and the change of half the gradient along it, scaled.
#[derive(Default)]
struct Pair {
    s: Vec<SingleRow>,
    y: Vec<SingleRow>,
    /// `s . y_j` of this step with every `y_j` in the window, oldest first.
    with_y: VecDeque<f64>,
    /// `alpha` of the recursion; `s . g` until it is known.
    alpha: f64,
    /// `beta` of the recursion; `y . step` until it is known.
    beta: f64,
}

/// The last steps, at most `window` of them.
pub(super) struct QuasiNewton {
    window: usize,
    /// Oldest first.
    pairs: VecDeque<Pair>,
    /// What gradients are multiplied by before they are rounded, the same for all pairs.
    scale: f64,
    /// The scaled gradient, then the scaled step.
    rows: Vec<SingleRow>,
}

impl QuasiNewton {
    /// With room for `window` steps.
    pub(super) fn new(window: usize) -> Self {
        QuasiNewton { window, pairs: VecDeque::new(), scale: 1.0, rows: Vec::new() }
    }

    /// Forgets all steps.
    pub(super) fn forget(&mut self) {
        self.pairs.clear();
    }

    /// See [`super::accelerate::Accelerator::propose`].
    pub(super) fn propose(
        &mut self,
        now: Iterate<'_>,
        before: Option<Iterate<'_>>,
        metric: &Metric,
        to: &mut [Row],
    ) {
        if let Some(before) = before {
            self.learn(now, before, metric.unit());
        }
        if self.pairs.is_empty() {
            self.scale = Metric::scale(now.gradient);
            self.rows.clear();
            self.rows.extend(now.gradient.iter().map(|&row| rounded(row, self.scale)));
        }
        self.first_loop();
        metric.solve(&mut self.rows);
        self.second_loop();
        let back = 1.0 / self.scale / metric.unit();
        for ((to, x), step) in to.iter_mut().zip(now.x).zip(&self.rows) {
            *to = std::array::from_fn(|i| x[i] - back * f64::from(step[i]));
        }
    }

    /// Adds the pair of the last step, and takes the products of all steps with the gradient, which
    /// `rows` becomes.
    fn learn(&mut self, now: Iterate<'_>, before: Iterate<'_>, unit: f64) {
        let mut new = if self.pairs.len() == self.window {
            for pair in &mut self.pairs {
                pair.with_y.pop_front();
            }
            self.pairs.pop_front().expect("a window holds at least one step")
        } else {
            Pair::default()
        };
        let n = now.x.len();
        new.s.resize(n, [0.0; 4]);
        new.y.resize(n, [0.0; 4]);
        new.alpha = 0.0;
        new.with_y.clear();
        new.with_y.resize(self.pairs.len() + 1, 0.0);
        self.rows.resize(n, [0.0; 4]);
        for pair in &mut self.pairs {
            pair.with_y.push_back(0.0);
            pair.alpha = 0.0;
        }
        let mut squares = [0.0; 2];
        for block in blocks(n) {
            let (s, y) = (&mut new.s[block.clone()], &mut new.y[block.clone()]);
            let gradient = &mut self.rows[block.clone()];
            let (now, before) = (now.block(&block), before.block(&block));
            subtract(s, now.x, before.x, self.scale * unit);
            subtract(y, now.gradient, before.gradient, self.scale);
            for (rounded_row, &row) in gradient.iter_mut().zip(now.gradient) {
                *rounded_row = rounded(row, self.scale);
            }
            for (j, pair) in self.pairs.iter_mut().enumerate() {
                let (s_j, y_j) = (&pair.s[block.clone()], &pair.y[block.clone()]);
                pair.alpha += dot(s_j, gradient);
                *pair.with_y.back_mut().expect("it was put there") += dot(s_j, y);
                new.with_y[j] += dot(s, y_j);
            }
            new.alpha += dot(s, gradient);
            *new.with_y.back_mut().expect("it was put there") += dot(s, y);
            squares[0] += dot(s, s);
            squares[1] += dot(y, y);
        }
        let curvature = new.with_y[self.pairs.len()];
        // A step along which the gradient does not grow says nothing about curvature.
        if curvature > 1e-12 * squares[0].sqrt() * squares[1].sqrt() {
            self.pairs.push_back(new);
        } else if squares[0] + squares[1] < f64::INFINITY {
            for pair in &mut self.pairs {
                pair.with_y.pop_back();
            }
        } else {
            // The scale does not fit any more.
            self.pairs.clear();
        }
    }

    /// Subtracts `sum alpha_j y_j` from the gradient.
    fn first_loop(&mut self) {
        for i in (0..self.pairs.len()).rev() {
            let pair = &self.pairs[i];
            let newer = (i + 1..self.pairs.len()).map(|j| self.pairs[j].alpha * pair.with_y[j]);
            let alpha = (pair.alpha - newer.sum::<f64>()) / pair.with_y[i];
            self.pairs[i].alpha = alpha;
        }
        for block in blocks(self.rows.len()) {
            let rows = &mut self.rows[block.clone()];
            for pair in &self.pairs {
                add_scaled(rows, -pair.alpha, &pair.y[block.clone()]);
            }
        }
    }

    /// Adds `sum (alpha_i - beta_i) s_i` to the step.
    fn second_loop(&mut self) {
        self.pairs.iter_mut().for_each(|pair| pair.beta = 0.0);
        for block in blocks(self.rows.len()) {
            let rows = &self.rows[block.clone()];
            for pair in &mut self.pairs {
                pair.beta += dot(&pair.y[block.clone()], rows);
            }
        }
        for i in 0..self.pairs.len() {
            let older = self.pairs.iter().take(i).map(|j| (j.alpha - j.beta) * j.with_y[i]);
            let beta = (self.pairs[i].beta + older.sum::<f64>()) / self.pairs[i].with_y[i];
            self.pairs[i].beta = beta;
        }
        for block in blocks(self.rows.len()) {
            let rows = &mut self.rows[block.clone()];
            for pair in &self.pairs {
                add_scaled(rows, pair.alpha - pair.beta, &pair.s[block.clone()]);
            }
        }
    }
}

/// The rows, a block at a time.
fn blocks(n: usize) -> impl Iterator<Item = Range<usize>> {
    (0..n).step_by(BLOCK).map(move |first| first..n.min(first + BLOCK))
}

/// `to = scale * (a - b)`.
#[inline(never)]
fn subtract(to: &mut [SingleRow], a: &[Row], b: &[Row], scale: f64) {
    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
        *to = rounded(std::array::from_fn(|i| a[i] - b[i]), scale);
    }
}

/// `to += factor * x`.
#[inline(never)]
fn add_scaled(to: &mut [SingleRow], factor: f64, x: &[SingleRow]) {
    let factor = factor as f32;
    for (to, x) in to.iter_mut().zip(x) {
        *to = std::array::from_fn(|i| to[i] + factor * x[i]);
    }
}

/// Sum of products over a block, in an order that is the same on every machine.
#[inline(never)]
fn dot(a: &[SingleRow], b: &[SingleRow]) -> f64 {
    let mut sum = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        sum = std::array::from_fn(|i| sum[i] + a[i] * b[i]);
    }
    let [x, y, z, _] = sum.map(f64::from);
    x + y + z
}
