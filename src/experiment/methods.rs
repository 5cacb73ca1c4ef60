//! The methods that lower the energy of a scene: the paper's iteration, and methods that use only
//! the energy and its gradient.
//!
//! How fast they are is compared for the five of Fig. 10, which recover an animal whose
//! vertices have collapsed, with the rest shape of each ring of neighbours as a constraint; and all
//! methods, on any scene. The paper's BFGS stores a matrix of the squared number of unknowns, more
//! than half a gigabyte for this animal: L-BFGS replaces it there.

use super::curvature::Curvature;
use super::declaration::{
    Experiment, Limits, Method, MethodInfo, Over, Plot, Quantity, Step, Unit,
};
use super::descent::GradientMethod;
use crate::mesh::Mesh;
use crate::scene::{Accelerator, Scene};
use crate::session::{Error, Session};

/// The two-step iteration, until the total energy is a given fraction of its initial value.
struct TwoStep {
    session: Session,
    goal: f64,
}

impl TwoStep {
    /// `mean_centring` selects Eq. 5. `goal` is the fraction of the initial total energy at which
    /// to end.
    pub(super) fn new(
        scene: &Scene,
        mesh: &Mesh,
        accelerator: Accelerator,
        mean_centring: bool,
        goal: f64,
    ) -> Result<TwoStep, Error> {
        let mut scene = scene.clone();
        scene.solver.accelerator = accelerator;
        scene.solver.mean_centring = mean_centring;
        scene.solver.tolerance = 0.0;
        let session = Session::open(scene, mesh.clone())?;
        let goal = goal * session.solver().energy().total;
        Ok(TwoStep { session, goal })
    }
}

impl Method for TwoStep {
    fn set_up_seconds(&self) -> f64 {
        let seconds = self.session.solver().set_up_seconds();
        seconds.assemble + seconds.order + seconds.factor
    }

    fn step(&mut self) -> Result<Step, Error> {
        let before = self.session.solver().energy().total;
        self.session.step()?;
        let now = self.session.solver().energy().total;
        Ok(match now {
            now if now <= self.goal => Step::Reached,
            now if now == before => Step::Stalled,
            _ => Step::Going,
        })
    }

    fn values(&self) -> Vec<f64> {
        vec![self.session.solver().energy().total]
    }
}

/// Number of steps stored by L-BFGS.
const WINDOW: usize = 10;

/// With this many vertices the matrix of BFGS takes 29 MB; it grows with their square.
const MOST_VERTICES_OF_BFGS: usize = 640;

/// Fraction of the initial energy at which a method has reached its goal.
const GOAL: f64 = 1e-12;

const CENTRED: MethodInfo = MethodInfo {
    id: "centred",
    label: "Mean-centred",
    summary: "The paper's iteration: project, then solve for all vertices, with each constraint free to move as a whole.",
    most_vertices: None,
    start: |scene, mesh| Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::None, true, GOAL)?)),
};

const NOT_CENTRED: MethodInfo = MethodInfo {
    id: "not-centred",
    label: "Not centred",
    summary: "The same without mean-centring: each vertex moves to the mean of its projections, and changes spread by only one ring per iteration.",
    most_vertices: None,
    start: |scene, mesh| Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::None, false, GOAL)?)),
};

const GRADIENT_DESCENT: MethodInfo = MethodInfo {
    id: "gradient-descent",
    label: "Gradient descent",
    summary: "Steps down the gradient of Appendix A, each as long as a line search allows.",
    most_vertices: None,
    start: |scene, mesh| {
        Ok(Box::new(GradientMethod::new(scene, mesh, |_| Curvature::Ignored, GOAL)?))
    },
};

pub(super) const BFGS: MethodInfo = MethodInfo {
    id: "bfgs",
    label: "BFGS",
    summary: "Learns the curvature from all of its steps, in a dense matrix over all coordinates (Nocedal and Wright, 2006, Algorithm 6.1): what the paper compares with.",
    most_vertices: Some(MOST_VERTICES_OF_BFGS),
    start: |scene, mesh| Ok(Box::new(GradientMethod::new(scene, mesh, Curvature::dense, GOAL)?)),
};

const L_BFGS: MethodInfo = MethodInfo {
    id: "l-bfgs",
    label: "L-BFGS",
    summary: "Learns the curvature from its last ten steps, without a linear system to start from.",
    most_vertices: None,
    start: |scene, mesh| {
        Ok(Box::new(GradientMethod::new(scene, mesh, |_| Curvature::recent(WINDOW), GOAL)?))
    },
};

const ACCELERATED: MethodInfo = MethodInfo {
    id: "accelerated",
    label: "Shape-Up, accelerated",
    summary: "L-BFGS on top of the mean-centred iteration: what Run does.",
    most_vertices: None,
    start: |scene, mesh| {
        Ok(Box::new(TwoStep::new(scene, mesh, Accelerator::QuasiNewton, true, GOAL)?))
    },
};

const ENERGY: Quantity = Quantity { id: "energy", label: "Energy", unit: Unit::Energy };

pub(super) const RECOVERY: Experiment = Experiment {
    id: "recovery",
    label: "Five ways back from a collapse",
    summary: "The same start and the same energy, lowered by five methods. Compare how far each has come after the same number of iterations, and after the same time.",
    examples: &["fig-10-collapse", "fig-10-random"],
    quantities: &[ENERGY],
    plots: &[
        Plot { quantity: 0, over: Over::Iterations, above_lowest: false },
        Plot { quantity: 0, over: Over::Seconds, above_lowest: false },
    ],
    methods: &[CENTRED, NOT_CENTRED, GRADIENT_DESCENT, L_BFGS, ACCELERATED],
    limits: Limits { iterations: 500, seconds: 20.0 },
};

/// Runs on any scene with constraints.
pub const COMPARISON: Experiment = Experiment {
    id: "methods",
    label: "Methods compared",
    summary: "The same start and the same energy, lowered by six methods. The plots show how much of it is left above the lowest that any of them has found.",
    examples: &[],
    quantities: &[ENERGY],
    plots: &[
        Plot { quantity: 0, over: Over::Iterations, above_lowest: true },
        Plot { quantity: 0, over: Over::Seconds, above_lowest: true },
    ],
    methods: &[ACCELERATED, CENTRED, NOT_CENTRED, GRADIENT_DESCENT, L_BFGS, BFGS],
    limits: Limits { iterations: 300, seconds: 10.0 },
};
