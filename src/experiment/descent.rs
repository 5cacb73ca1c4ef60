//! Methods that use only the total energy and its gradient, the sum of `2 w_i (x - P_i(x))`
//! (Appendix A). The projections are not differentiated, and no linear system is solved.

use super::curvature::Curvature;
use super::declaration::{Method, Step};
use super::line_search::{Along, wolfe_step};
use crate::math::{add_scaled, inner_product};
use crate::mesh::{Mesh, Point};
use crate::scene::Scene;
use crate::session::Error;
use crate::session::Session;
use crate::solve::Solver;

/// Gradient descent, L-BFGS or BFGS, depending on `curvature`, with a line search. Ends when the
/// total energy is a given fraction of its initial value.
pub(super) struct GradientMethod {
    /// Evaluates the energy; its linear system is not used.
    solver: Solver,
    x: Vec<f64>,
    gradient: Vec<f64>,
    energy: f64,
    goal: f64,
    curvature: Curvature,
    /// Length and slope of the last step.
    last: Option<(f64, f64)>,
}

impl GradientMethod {
    /// Calls `curvature` with the number of unknowns. `goal` is the fraction of the initial total
    /// energy at which to end.
    pub(super) fn new(
        scene: &Scene,
        mesh: &Mesh,
        curvature: fn(usize) -> Curvature,
        goal: f64,
    ) -> Result<GradientMethod, Error> {
        let solver = Session::open(scene.clone(), mesh.clone())?.into_solver();
        let x: Vec<Point> = solver.positions().collect();
        let gradient: Vec<Point> = solver.gradient().collect();
        let energy = solver.energy().total;
        Ok(GradientMethod {
            solver,
            curvature: curvature(3 * x.len()),
            x: x.into_flattened(),
            gradient: gradient.into_flattened(),
            energy,
            goal: goal * energy,
            last: None,
        })
    }

    /// Returns the first step to try along a direction of this slope.
    fn first_trial(&self, slope: f64) -> f64 {
        match self.last {
            // The direction includes the step length.
            Some(_) if self.curvature.has_learned() => 1.0,
            // The step with the same first-order decrease as the last one (N&W 3.60).
            Some((step, before)) => step * before / slope,
            // The minimum of a parabola with this value and slope that touches zero.
            None => -2.0 * self.energy / slope,
        }
    }
}

impl Method for GradientMethod {
    fn step(&mut self) -> Result<Step, Error> {
        let mut direction = self.curvature.direction(&self.gradient);
        let mut slope = inner_product(&direction, &self.gradient);
        // Written so that NaN also resets the curvature.
        let falls = slope < 0.0;
        if !falls {
            self.curvature.forget();
            direction = self.curvature.direction(&self.gradient);
            slope = inner_product(&direction, &self.gradient);
        }
        if slope == 0.0 {
            return Ok(Step::Stalled);
        }
        let first = self.first_trial(slope);
        let (mut next, mut gradient, mut energy) = (self.x.clone(), Vec::new(), self.energy);
        let start = Along { value: self.energy, slope };
        let GradientMethod { solver, x, .. } = self;
        let found = wolfe_step(start, first, |step| {
            next.copy_from_slice(x);
            add_scaled(&mut next, step, &direction);
            solver.set_positions(next.as_chunks::<3>().0);
            energy = solver.energy().total;
            gradient.clear();
            gradient.extend(solver.gradient().flatten());
            Along { value: energy, slope: inner_product(&direction, &gradient) }
        });
        let Some(step) = found else {
            if !self.curvature.has_learned() {
                return Ok(Step::Stalled);
            }
            // The curvature estimate is wrong here: the next step is along the gradient.
            self.curvature.forget();
            self.last = None;
            return Ok(Step::Going);
        };
        let difference =
            |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a - b).collect() };
        self.curvature.learn(difference(&next, &self.x), difference(&gradient, &self.gradient));
        self.last = Some((step, slope));
        (self.x, self.gradient, self.energy) = (next, gradient, energy);
        Ok(if self.energy <= self.goal { Step::Reached } else { Step::Going })
    }

    fn values(&self) -> Vec<f64> {
        vec![self.energy]
    }
}
