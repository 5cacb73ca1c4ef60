//! L-BFGS whose initial metric is the factored normal matrix (Liu, Bouaziz, Kavan: Quasi-Newton
//! Methods for Real-Time Simulation of Hyperelastic Materials, 2017, section 4). With an empty
//! window it is exactly the plain two-step iteration.
//!
//! The memory is in single precision, like the metric: curvature learnt from steps is no more
//! accurate, and reading it is most of the extra cost of an accelerated iteration. For the same
//! reason the two-loop recursion (Nocedal and Wright, Algorithm 7.4) is written in inner products,
//! computed for all vectors at once, one block of rows at a time.

use super::plain::Iterate;
use crate::constraint::Row;
use crate::sparse::{F32Factor, F32Row, round};
use std::collections::VecDeque;
use std::ops::Range;

/// Rows in a block, so that data read twice is still in the nearest cache, and sums in single
/// precision are short.
const BLOCK: usize = 64;

/// A step and the change of half the gradient along it, scaled.
#[derive(Default)]
struct Pair {
    s: Vec<F32Row>,
    y: Vec<F32Row>,
    /// `s . y_j` of this step with its own `y` and with those of all later steps.
    with_y: Vec<f64>,
    /// `alpha` of the recursion; `s . g` until it is computed.
    alpha: f64,
    /// `beta` of the recursion; `y . step` until it is computed.
    beta: f64,
}

/// The last steps, at most `window` of them.
pub(crate) struct QuasiNewton {
    window: usize,
    /// Oldest first.
    pairs: VecDeque<Pair>,
    /// Gradients are multiplied by this before they are rounded; the same for all pairs.
    scale: f64,
    /// The scaled gradient, then the scaled step.
    rows: Vec<F32Row>,
}

impl QuasiNewton {
    /// Creates an empty window of `window` steps.
    pub(super) fn new(window: usize) -> Self {
        QuasiNewton { window, pairs: VecDeque::new(), scale: 1.0, rows: Vec::new() }
    }

    /// Clears the window, because the problem has changed.
    pub(super) fn forget(&mut self) {
        self.pairs.clear();
    }

    /// See [`super::Acceleration::propose`].
    pub(super) fn propose(
        &mut self,
        now: Iterate<'_>,
        before: Option<Iterate<'_>>,
        factor: &F32Factor,
        to: &mut [Row],
    ) {
        if let Some(before) = before {
            self.learn(now, before, factor.unit());
        }
        if self.pairs.is_empty() {
            self.scale = F32Factor::scale(now.gradient);
            self.rows.resize(now.x.len(), [0.0; 4]);
            round(&mut self.rows, now.gradient, self.scale);
        }
        self.first_loop();
        factor.solve(&mut self.rows);
        self.second_loop();
        factor.subtract_step(to, now.x, &self.rows, self.scale);
    }

    /// Adds the pair of the last step, rounds the gradient into `rows`, and computes its products
    /// with all steps.
    fn learn(&mut self, now: Iterate<'_>, before: Iterate<'_>, unit: f64) {
        let mut new = if self.pairs.len() == self.window {
            self.pairs.pop_front().expect("a window holds at least one step")
        } else {
            Pair::default()
        };
        let n = now.x.len();
        new.s.resize(n, [0.0; 4]);
        new.y.resize(n, [0.0; 4]);
        self.rows.resize(n, [0.0; 4]);
        for pair in &mut self.pairs {
            pair.alpha = 0.0;
            pair.with_y.push(0.0);
        }
        new.alpha = 0.0;
        let (mut curvature, mut squares) = (0.0, [0.0; 2]);
        for block in blocks(n) {
            let (s, y) = (&mut new.s[block.clone()], &mut new.y[block.clone()]);
            let gradient = &mut self.rows[block.clone()];
            let (now, before) = (now.block(&block), before.block(&block));
            subtract(s, now.x, before.x, self.scale * unit);
            subtract(y, now.gradient, before.gradient, self.scale);
            round(gradient, now.gradient, self.scale);
            for pair in &mut self.pairs {
                let s_i = &pair.s[block.clone()];
                pair.alpha += dot(s_i, gradient);
                *pair.with_y.last_mut().expect("it was put there") += dot(s_i, y);
            }
            new.alpha += dot(s, gradient);
            curvature += dot(s, y);
            squares[0] += dot(s, s);
            squares[1] += dot(y, y);
        }
        // A step along which the gradient does not grow carries no information about curvature.
        if curvature > 1e-12 * squares[0].sqrt() * squares[1].sqrt() {
            new.with_y.clear();
            new.with_y.push(curvature);
            self.pairs.push_back(new);
        } else if squares[0] + squares[1] < f64::INFINITY {
            for pair in &mut self.pairs {
                pair.with_y.pop();
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
            let later = self.pairs.range(i + 1..).zip(&pair.with_y[1..]);
            let known: f64 = later.map(|(later, with_y)| later.alpha * with_y).sum();
            let alpha = (pair.alpha - known) / pair.with_y[0];
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
            let earlier = self.pairs.range(..i).enumerate();
            let known: f64 = earlier.map(|(j, it)| (it.alpha - it.beta) * it.with_y[i - j]).sum();
            let pair = &mut self.pairs[i];
            pair.beta = (pair.beta + known) / pair.with_y[0];
        }
        for block in blocks(self.rows.len()) {
            let rows = &mut self.rows[block.clone()];
            for pair in &self.pairs {
                add_scaled(rows, pair.alpha - pair.beta, &pair.s[block.clone()]);
            }
        }
    }
}

/// The ranges of rows of the blocks.
fn blocks(n: usize) -> impl Iterator<Item = Range<usize>> {
    (0..n).step_by(BLOCK).map(move |first| first..n.min(first + BLOCK))
}

/// `to = scale * (a - b)`.
// Flat, like the loops below: rows of four would be unpacked before they are loaded into registers.
#[inline(never)]
fn subtract(to: &mut [F32Row], a: &[Row], b: &[Row], scale: f64) {
    let (a, b) = (a.as_flattened(), b.as_flattened());
    for ((to, a), b) in to.as_flattened_mut().iter_mut().zip(a).zip(b) {
        *to = (scale * (a - b)) as f32;
    }
}

/// `to += factor * x`.
#[inline(never)]
fn add_scaled(to: &mut [F32Row], factor: f64, x: &[F32Row]) {
    let factor = factor as f32;
    for (to, x) in to.as_flattened_mut().iter_mut().zip(x.as_flattened()) {
        *to += factor * x;
    }
}

/// Inner product over a block, in the same order on every platform. Sums side by side hide the
/// latency of an addition.
#[inline(never)]
fn dot(a: &[F32Row], b: &[F32Row]) -> f64 {
    let mut sums = [[0.0; 4]; 4];
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    for (a, b) in a.iter().zip(b) {
        for k in 0..4 {
            sums[k] = add_product(sums[k], a[k], b[k]);
        }
    }
    let [mut sum, second, third, fourth] = sums;
    for (a, b) in a_rest.iter().zip(b_rest) {
        sum = add_product(sum, *a, *b);
    }
    // Padding included: four are faster than three.
    let [x, y, z, pad] =
        std::array::from_fn(|i| f64::from((sum[i] + second[i]) + (third[i] + fourth[i])));
    (x + y) + (z + pad)
}

#[inline(always)]
fn add_product(mut sum: F32Row, a: F32Row, b: F32Row) -> F32Row {
    // A loop, because `array::from_fn` may not be inlined.
    for i in 0..sum.len() {
        sum[i] += a[i] * b[i];
    }
    sum
}
