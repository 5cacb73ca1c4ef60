//! The methods that lower the energy of a scene: the paper's iteration, and methods that use only
//! the energy and its gradient.

use super::curvature::Curvature;
use super::declaration::MethodInfo;
use super::descent::Descent;
use super::two_step::TwoStep;
use crate::scene::Accelerator;

/// Number of steps stored by L-BFGS.
const WINDOW: usize = 10;

/// With this many vertices the matrix of BFGS takes 29 MB; it grows with their square.
const MOST_VERTICES_OF_BFGS: usize = 640;

/// Fraction of the initial energy at which a method has reached its goal.
const GOAL: f64 = 1e-12;

pub(super) const CENTRED: MethodInfo = MethodInfo {
    id: "centred",
    label: "Mean-centred",
    summary: "The paper's iteration: project, then solve for all vertices, with each constraint free to move as a whole.",
    most_vertices: None,
    start: |scene, mesh| Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::None, true, GOAL)?)),
};

pub(super) const NOT_CENTRED: MethodInfo = MethodInfo {
    id: "not-centred",
    label: "Not centred",
    summary: "The same without mean-centring: each vertex moves to the mean of its projections, and changes spread by only one ring per iteration.",
    most_vertices: None,
    start: |scene, mesh| Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::None, false, GOAL)?)),
};

pub(super) const GRADIENT_DESCENT: MethodInfo = MethodInfo {
    id: "gradient-descent",
    label: "Gradient descent",
    summary: "Steps down the gradient of Appendix A, each as long as a line search allows.",
    most_vertices: None,
    start: |scene, mesh| Ok(Box::new(Descent::new(scene, mesh, |_| Curvature::Ignored, GOAL)?)),
};

pub(super) const BFGS: MethodInfo = MethodInfo {
    id: "bfgs",
    label: "BFGS",
    summary: "Learns the curvature from all of its steps, in a dense matrix over all coordinates (Nocedal and Wright, 2006, Algorithm 6.1): what the paper compares with.",
    most_vertices: Some(MOST_VERTICES_OF_BFGS),
    start: |scene, mesh| Ok(Box::new(Descent::new(scene, mesh, Curvature::dense, GOAL)?)),
};

pub(super) const L_BFGS: MethodInfo = MethodInfo {
    id: "l-bfgs",
    label: "L-BFGS",
    summary: "Learns the curvature from its last ten steps, without a linear system to start from.",
    most_vertices: None,
    start: |scene, mesh| {
        Ok(Box::new(Descent::new(scene, mesh, |_| Curvature::recent(WINDOW), GOAL)?))
    },
};

pub(super) const ACCELERATED: MethodInfo = MethodInfo {
    id: "accelerated",
    label: "Shape-Up, accelerated",
    summary: "L-BFGS on top of the mean-centred iteration: what Run does.",
    most_vertices: None,
    start: |scene, mesh| {
        Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::QuasiNewton, true, GOAL)?))
    },
};
