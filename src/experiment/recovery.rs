//! Fig. 10: an animal whose vertices have collapsed comes back, because each ring of neighbours is to
//! have the shape that it had; by five methods.

use super::declaration::{Experiment, Limits, MethodInfo, Over, Plot, Quantity, Unit};
use super::descent::Descent;
use super::two_step::TwoStep;
use crate::scene::Accelerator;

/// Steps that L-BFGS remembers.
const WINDOW: usize = 10;

/// The part of the energy at the start at which the shape counts as recovered.
const GOAL: f64 = 1e-12;

pub(super) const RECOVERY: Experiment = Experiment {
    id: "recovery",
    label: "Five ways back from a collapse",
    summary: "The same start and the same energy, lowered by five methods. Compare how far each one is after the same iterations, and after the same time.",
    examples: &["fig-10-collapse", "fig-10-random"],
    quantities: &[Quantity { id: "energy", label: "Energy", unit: Unit::Energy }],
    plots: &[
        Plot { quantity: 0, over: Over::Iterations },
        Plot { quantity: 0, over: Over::Seconds },
    ],
    methods: &[
        MethodInfo {
            id: "centred",
            label: "Mean-centred",
            summary: "The paper's iteration: project, then solve for all vertices, with each constraint free to move as a whole.",
            start: |scene, mesh| {
                Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::None, true, GOAL)?))
            },
        },
        MethodInfo {
            id: "not-centred",
            label: "Not centred",
            summary: "The same without mean-centring: each vertex moves to the mean of its projections, and news travels one ring an iteration.",
            start: |scene, mesh| {
                Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::None, false, GOAL)?))
            },
        },
        MethodInfo {
            id: "gradient-descent",
            label: "Gradient descent",
            summary: "Steps down the gradient of Appendix A, each as long as a line search allows.",
            start: |scene, mesh| Ok(Box::new(Descent::new(scene, mesh, 0, GOAL)?)),
        },
        MethodInfo {
            id: "l-bfgs",
            label: "L-BFGS",
            summary: "Learns the curvature from its last ten steps, without a linear system to start from.",
            start: |scene, mesh| Ok(Box::new(Descent::new(scene, mesh, WINDOW, GOAL)?)),
        },
        MethodInfo {
            id: "accelerated",
            label: "Shape-Up, accelerated",
            summary: "L-BFGS on top of the mean-centred iteration: what Run does.",
            start: |scene, mesh| {
                Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::QuasiNewton, true, GOAL)?))
            },
        },
    ],
    limits: Limits { iterations: 500, seconds: 20.0 },
};
