//! Steps that learn from the steps before them, so that stiff problems need tens of iterations
//! where the plain two-step iteration needs thousands.
//!
//! An accelerator sees positions, half gradients and the factored normal matrix as a metric, and
//! nothing of the geometry. It proposes a step; the solver takes it only if the energy falls, and
//! falls back to the plain step otherwise.

use super::anderson::Anderson;
use super::quasi_newton::QuasiNewton;
use crate::constraint::Row;
use crate::scene;

/// The chosen accelerator with its memory.
pub(super) enum Accelerator {
    /// The plain iteration.
    None,
    /// See [`QuasiNewton`].
    QuasiNewton(QuasiNewton),
    /// See [`Anderson`].
    Anderson(Anderson),
}

impl Accelerator {
    /// The one that the settings ask for; a window of 0 is the plain iteration.
    pub(super) fn new(settings: &scene::SolverSettings) -> Self {
        let window = settings.window as usize;
        match settings.accelerator {
            _ if window == 0 => Accelerator::None,
            scene::Accelerator::None => Accelerator::None,
            scene::Accelerator::QuasiNewton => Accelerator::QuasiNewton(QuasiNewton::new(window)),
            scene::Accelerator::Anderson => Accelerator::Anderson(Anderson::new(window)),
        }
    }

    /// Turns `step`, which is half the gradient at `x` when it comes in, into the step to be
    /// subtracted from `x`. `solve` applies the inverse of the normal matrix in place. False when
    /// it is the plain step.
    pub(super) fn propose(
        &mut self,
        x: &[Row],
        step: &mut [Row],
        solve: impl Fn(&mut [Row]),
    ) -> bool {
        match self {
            Accelerator::None => {
                solve(step);
                false
            }
            Accelerator::QuasiNewton(quasi_newton) => quasi_newton.propose(x, step, solve),
            Accelerator::Anderson(anderson) => anderson.propose(x, step, solve),
        }
    }

    /// Forgets all steps: the problem has changed.
    pub(super) fn forget(&mut self) {
        match self {
            Accelerator::None => {}
            Accelerator::QuasiNewton(quasi_newton) => quasi_newton.forget(),
            Accelerator::Anderson(anderson) => anderson.forget(),
        }
    }
}

/// Sum of products, in an order that is the same on every machine.
#[inline(never)]
pub(super) fn dot(a: &[Row], b: &[Row]) -> f64 {
    let mut sum = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for i in 0..4 {
            sum[i] += a[i] * b[i];
        }
    }
    (sum[0] + sum[1]) + (sum[2] + sum[3])
}

/// `y += factor * x`.
#[inline(never)]
pub(super) fn add_scaled(y: &mut [Row], factor: f64, x: &[Row]) {
    for (y, x) in y.iter_mut().zip(x) {
        for i in 0..4 {
            y[i] += factor * x[i];
        }
    }
}

/// `y = a - b`.
#[inline(never)]
pub(super) fn difference(y: &mut Vec<Row>, a: &[Row], b: &[Row]) {
    y.clear();
    y.extend(a.iter().zip(b).map(|(a, b)| std::array::from_fn::<f64, 4, _>(|i| a[i] - b[i])));
}
