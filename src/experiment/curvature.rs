//! Curvature estimates of descent methods, from their steps.

use crate::math::{LimitedMemory, inner_product};

/// Approximation of the inverse Hessian from the steps `s` and the changes `y` of the gradient
/// along them. It is the identity before the first step.
pub(super) enum Curvature {
    /// None: gradient descent.
    Ignored,
    /// L-BFGS.
    Recent(LimitedMemory),
    /// BFGS (Algorithm 6.1): the matrix, `n by n`, and whether it has been updated.
    Dense { inverse: Vec<f64>, learned: bool },
}

impl Curvature {
    /// L-BFGS.
    pub(super) fn recent(window: usize) -> Curvature {
        Curvature::Recent(LimitedMemory::of(window))
    }

    /// BFGS for `n` unknowns.
    pub(super) fn dense(n: usize) -> Curvature {
        Curvature::Dense { inverse: identity(n), learned: false }
    }

    /// Whether any step has been used: a direction then includes the step length.
    pub(super) fn has_learned(&self) -> bool {
        match self {
            Curvature::Ignored => false,
            Curvature::Recent(memory) => !memory.is_empty(),
            Curvature::Dense { learned, .. } => *learned,
        }
    }

    /// Resets the approximation to the identity.
    pub(super) fn forget(&mut self) {
        match self {
            Curvature::Ignored => {}
            Curvature::Recent(memory) => memory.clear(),
            Curvature::Dense { inverse, learned } => {
                *inverse = identity(inverse.len().isqrt());
                *learned = false;
            }
        }
    }

    /// Returns minus the approximate inverse Hessian times the gradient.
    pub(super) fn direction(&self, gradient: &[f64]) -> Vec<f64> {
        let mut q = match self {
            Curvature::Dense { inverse, learned: true } => product(inverse, gradient),
            _ => gradient.to_vec(),
        };
        if let Curvature::Recent(memory) = self {
            memory.apply(&mut q);
        }
        q.iter_mut().for_each(|q| *q = -*q);
        q
    }

    /// Updates the approximation with a step, unless the gradient does not grow along it.
    pub(super) fn learn(&mut self, s: Vec<f64>, y: Vec<f64>) {
        let curvature = inner_product(&s, &y);
        let is_convex = curvature > 0.0;
        if !is_convex {
            return;
        }
        match self {
            Curvature::Ignored => {}
            Curvature::Recent(memory) => memory.push(s, y),
            Curvature::Dense { inverse, learned } => {
                if !*learned {
                    // Scaling from the first step (6.20).
                    let scale = curvature / inner_product(&y, &y);
                    inverse.iter_mut().for_each(|entry| *entry *= scale);
                    *learned = true;
                }
                update(inverse, &s, &y, curvature);
            }
        }
    }
}

/// `H <- (I - s y' / c) H (I - y s' / c) + s s' / c` with `c = s . y` (6.17), expanded.
fn update(inverse: &mut [f64], s: &[f64], y: &[f64], curvature: f64) {
    let along = product(inverse, y);
    let own = (1.0 + inner_product(y, &along) / curvature) / curvature;
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
    matrix.chunks_exact(x.len()).map(|row| inner_product(row, x)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::add_scaled;

    /// Hessian of the quadratic.
    const HESSIAN: [[f64; 3]; 3] = [[4.0, 1.0, 0.0], [1.0, 3.0, -1.0], [0.0, -1.0, 2.0]];

    /// As many conjugate steps as unknowns determine the Hessian.
    #[test]
    fn as_many_conjugate_steps_as_unknowns_teach_a_quadratic() {
        let times = |x: &[f64]| HESSIAN.map(|row| inner_product(&row, x)).to_vec();
        let mut conjugate: Vec<Vec<f64>> = Vec::new();
        for k in 0..3 {
            let mut s = vec![0.0; 3];
            s[k] = 1.0;
            for other in &conjugate {
                let part = inner_product(&times(other), &s) / inner_product(&times(other), other);
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
