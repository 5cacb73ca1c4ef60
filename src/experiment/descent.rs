//! Methods that see the total energy and its gradient and nothing else: `2 w_i (x - P_i(x))`, summed
//! (Appendix A). No part of the projections is differentiated, and no linear system is solved.

use super::declaration::{Method, Step};
use super::line_search::{Along, wolfe_step};
use crate::error::Error;
use crate::mesh::{Mesh, Point};
use crate::scene::Scene;
use crate::session::Session;
use crate::solve::Solver;
use std::collections::VecDeque;

/// Gradient descent, or L-BFGS (Nocedal and Wright, Algorithms 7.4 and 7.5), with a line search, until
/// the total energy is a given part of that at the start.
///
/// The paper compares with BFGS, whose matrix has the square of the number of unknowns as entries: for
/// the animal more than half a gigabyte. L-BFGS is that method with as much memory as there is.
pub(super) struct Descent {
    /// Evaluates the energy; its linear system is not used.
    solver: Solver,
    x: Vec<f64>,
    gradient: Vec<f64>,
    energy: f64,
    goal: f64,
    /// How many steps are remembered; 0 is gradient descent.
    window: usize,
    /// Oldest first.
    pairs: VecDeque<Pair>,
    /// The length and the slope of the last step.
    last: Option<(f64, f64)>,
}

/// A step and the change of the gradient along it.
struct Pair {
    s: Vec<f64>,
    y: Vec<f64>,
    /// `s . y`
    curvature: f64,
}

impl Descent {
    /// Remembers `window` steps; with 0 it is gradient descent. `goal` is the part of the total energy at
    /// the start that is asked for.
    pub(super) fn new(
        scene: &Scene,
        mesh: &Mesh,
        window: usize,
        goal: f64,
    ) -> Result<Descent, Error> {
        let solver = Session::open(scene.clone(), mesh.clone())?.into_solver();
        let x: Vec<Point> = solver.positions().collect();
        let gradient: Vec<Point> = solver.gradient().collect();
        let energy = solver.energy().total;
        Ok(Descent {
            solver,
            x: x.into_flattened(),
            gradient: gradient.into_flattened(),
            energy,
            goal: goal * energy,
            window,
            pairs: VecDeque::new(),
            last: None,
        })
    }

    /// Minus the gradient, or the direction of the two-loop recursion.
    fn direction(&self) -> Vec<f64> {
        let mut q = self.gradient.clone();
        let mut alphas = Vec::new();
        for pair in self.pairs.iter().rev() {
            let alpha = dot(&pair.s, &q) / pair.curvature;
            add_scaled(&mut q, -alpha, &pair.y);
            alphas.push(alpha);
        }
        let newest = self.pairs.back();
        let scale = newest.map_or(1.0, |pair| pair.curvature / dot(&pair.y, &pair.y));
        q.iter_mut().for_each(|q| *q *= scale);
        for (pair, alpha) in self.pairs.iter().zip(alphas.iter().rev()) {
            let beta = dot(&pair.y, &q) / pair.curvature;
            add_scaled(&mut q, alpha - beta, &pair.s);
        }
        q.iter_mut().for_each(|q| *q = -*q);
        q
    }

    /// The step that is tried first along a direction of this slope.
    fn first_trial(&self, slope: f64) -> f64 {
        match self.last {
            // The direction has the length of the step in it.
            Some(_) if !self.pairs.is_empty() => 1.0,
            // As long a step as the last one would be, had it the same decrease (N&W 3.60).
            Some((step, before)) => step * before / slope,
            // To where a parabola with this slope would be zero.
            None => -2.0 * self.energy / slope,
        }
    }
}

impl Method for Descent {
    fn step(&mut self) -> Result<Step, Error> {
        let mut direction = self.direction();
        let mut slope = dot(&direction, &self.gradient);
        // Written so that NaN starts anew.
        let falls = slope < 0.0;
        if !falls {
            self.pairs.clear();
            direction = self.direction();
            slope = dot(&direction, &self.gradient);
        }
        if slope == 0.0 {
            return Ok(Step::Stalled);
        }
        let first = self.first_trial(slope);
        let (mut next, mut gradient, mut energy) = (self.x.clone(), Vec::new(), self.energy);
        let start = Along { value: self.energy, slope };
        let Descent { solver, x, .. } = self;
        let found = wolfe_step(start, first, |step| {
            next.copy_from_slice(x);
            add_scaled(&mut next, step, &direction);
            solver.set_positions(next.as_chunks::<3>().0);
            energy = solver.energy().total;
            gradient.clear();
            gradient.extend(solver.gradient().flatten());
            Along { value: energy, slope: dot(&direction, &gradient) }
        });
        let Some(step) = found else {
            if self.pairs.is_empty() {
                return Ok(Step::Stalled);
            }
            // What the steps have taught is wrong here: the next one is along the gradient.
            self.pairs.clear();
            self.last = None;
            return Ok(Step::Going);
        };
        let difference =
            |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a - b).collect() };
        if self.window > 0 {
            let (s, y) = (difference(&next, &self.x), difference(&gradient, &self.gradient));
            let curvature = dot(&s, &y);
            if self.pairs.len() == self.window {
                self.pairs.pop_front();
            }
            // A step along which the gradient does not grow says nothing about curvature.
            if curvature > 0.0 {
                self.pairs.push_back(Pair { s, y, curvature });
            }
        }
        self.last = Some((step, slope));
        (self.x, self.gradient, self.energy) = (next, gradient, energy);
        Ok(if self.energy <= self.goal { Step::Reached } else { Step::Going })
    }

    fn values(&self) -> Vec<f64> {
        vec![self.energy]
    }
}

/// Sum of products, in an order that is the same on every machine.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `y += factor * x`.
fn add_scaled(y: &mut [f64], factor: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += factor * x;
    }
}
