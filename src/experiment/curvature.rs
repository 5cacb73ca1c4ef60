//! The curvature that a descent method estimates from its steps.

use std::collections::VecDeque;

/// The inverse of the Hessian, as far as a method approximates it from steps `s` and the changes `y` of the
/// gradient along them. Without any step it is the identity.
pub(super) enum Curvature {
    /// None: gradient descent.
    Ignored,
    /// L-BFGS (Nocedal and Wright, Algorithm 7.4): the last `window` steps, the oldest first.
    Recent { pairs: VecDeque<Pair>, window: usize },
    /// BFGS (Algorithm 6.1): the matrix, `n by n`, and whether it has learned anything.
    Dense { inverse: Vec<f64>, learned: bool },
}

/// A step and the change of the gradient along it.
pub(super) struct Pair {
    s: Vec<f64>,
    y: Vec<f64>,
    /// `s . y`
    curvature: f64,
}

impl Curvature {
    /// L-BFGS.
    pub(super) fn recent(window: usize) -> Curvature {
        Curvature::Recent { pairs: VecDeque::new(), window }
    }

    /// BFGS for `n` unknowns.
    pub(super) fn dense(n: usize) -> Curvature {
        Curvature::Dense { inverse: identity(n), learned: false }
    }

    /// Whether steps have taught it anything: then a direction has the length of the step in it.
    pub(super) fn has_learned(&self) -> bool {
        match self {
            Curvature::Ignored => false,
            Curvature::Recent { pairs, .. } => !pairs.is_empty(),
            Curvature::Dense { learned, .. } => *learned,
        }
    }

    /// Begins anew.
    pub(super) fn forget(&mut self) {
        match self {
            Curvature::Ignored => {}
            Curvature::Recent { pairs, .. } => pairs.clear(),
            Curvature::Dense { inverse, learned } => {
                *inverse = identity(inverse.len().isqrt());
                *learned = false;
            }
        }
    }

    /// Minus the inverse times the gradient.
    pub(super) fn direction(&self, gradient: &[f64]) -> Vec<f64> {
        let mut q = match self {
            Curvature::Dense { inverse, learned: true } => product(inverse, gradient),
            Curvature::Recent { pairs, .. } => two_loops(pairs, gradient),
            _ => gradient.to_vec(),
        };
        q.iter_mut().for_each(|q| *q = -*q);
        q
    }

    /// Takes in a step. One along which the gradient does not grow says nothing about curvature.
    pub(super) fn learn(&mut self, s: Vec<f64>, y: Vec<f64>) {
        let curvature = dot(&s, &y);
        let says_something = curvature > 0.0;
        if !says_something {
            return;
        }
        match self {
            Curvature::Ignored => {}
            Curvature::Recent { pairs, window } => {
                if pairs.len() == *window {
                    pairs.pop_front();
                }
                pairs.push_back(Pair { s, y, curvature });
            }
            Curvature::Dense { inverse, learned } => {
                if !*learned {
                    // The scale of the first step (6.20).
                    let scale = curvature / dot(&y, &y);
                    inverse.iter_mut().for_each(|entry| *entry *= scale);
                    *learned = true;
                }
                update(inverse, &s, &y, curvature);
            }
        }
    }
}

/// Algorithm 7.4.
fn two_loops(pairs: &VecDeque<Pair>, gradient: &[f64]) -> Vec<f64> {
    let mut q = gradient.to_vec();
    let mut alphas = Vec::new();
    for pair in pairs.iter().rev() {
        let alpha = dot(&pair.s, &q) / pair.curvature;
        add_scaled(&mut q, -alpha, &pair.y);
        alphas.push(alpha);
    }
    let newest = pairs.back();
    let scale = newest.map_or(1.0, |pair| pair.curvature / dot(&pair.y, &pair.y));
    q.iter_mut().for_each(|q| *q *= scale);
    for (pair, alpha) in pairs.iter().zip(alphas.iter().rev()) {
        let beta = dot(&pair.y, &q) / pair.curvature;
        add_scaled(&mut q, alpha - beta, &pair.s);
    }
    q
}

/// `H <- (I - s y' / c) H (I - y s' / c) + s s' / c` with `c = s . y` (6.17), multiplied out.
fn update(inverse: &mut [f64], s: &[f64], y: &[f64], curvature: f64) {
    let along = product(inverse, y);
    let own = (1.0 + dot(y, &along) / curvature) / curvature;
    for ((row, &s_row), &along_row) in inverse.chunks_exact_mut(s.len()).zip(s).zip(&along) {
        let (by_s, by_along) = (own * s_row - along_row / curvature, -s_row / curvature);
        for ((entry, &s), &along) in row.iter_mut().zip(s).zip(&along) {
            *entry += by_s * s + by_along * along;
        }
    }
}

fn identity(n: usize) -> Vec<f64> {
    let mut matrix = vec![0.0; n * n];
    matrix.iter_mut().step_by(n + 1).for_each(|entry| *entry = 1.0);
    matrix
}

fn product(matrix: &[f64], x: &[f64]) -> Vec<f64> {
    matrix.chunks_exact(x.len()).map(|row| dot(row, x)).collect()
}

/// Sum of products, in an order that is the same on every machine.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `y += factor * x`.
pub(super) fn add_scaled(y: &mut [f64], factor: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += factor * x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quadratic with this Hessian.
    const HESSIAN: [[f64; 3]; 3] = [[4.0, 1.0, 0.0], [1.0, 3.0, -1.0], [0.0, -1.0, 2.0]];

    /// Steps along directions that are conjugate teach the whole of a quadratic.
    #[test]
    fn as_many_conjugate_steps_as_unknowns_teach_a_quadratic() {
        let times = |x: &[f64]| HESSIAN.map(|row| dot(&row, x)).to_vec();
        let mut conjugate: Vec<Vec<f64>> = Vec::new();
        for k in 0..3 {
            let mut s = vec![0.0; 3];
            s[k] = 1.0;
            for other in &conjugate {
                let part = dot(&times(other), &s) / dot(&times(other), other);
                add_scaled(&mut s, -part, other);
            }
            conjugate.push(s);
        }
        for mut curvature in [Curvature::recent(3), Curvature::dense(3)] {
            assert!(!curvature.has_learned());
            conjugate.iter().for_each(|s| curvature.learn(s.clone(), times(s)));
            let minimum = [0.5, -2.0, 1.5];
            let direction = curvature.direction(&times(&minimum));
            for (found, expected) in direction.iter().zip(minimum) {
                assert!((found + expected).abs() < 1e-12, "{direction:?}");
            }
            curvature.forget();
            assert_eq!(curvature.direction(&minimum), [-0.5, 2.0, -1.5]);
        }
    }

    #[test]
    fn a_step_along_which_the_gradient_falls_teaches_nothing() {
        for mut curvature in [Curvature::recent(3), Curvature::dense(2), Curvature::Ignored] {
            curvature.learn(vec![1.0, 0.0], vec![-1.0, 0.0]);
            assert!(!curvature.has_learned());
        }
    }
}
