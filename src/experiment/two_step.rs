//! The project's own solver as a method: the two-step iteration, plain or accelerated.

use super::declaration::{Method, Step};
use crate::mesh::Mesh;
use crate::scene::{Accelerator, Scene};
use crate::session::Error;
use crate::session::Session;

/// The two-step iteration, until the total energy is a given fraction of its initial value.
pub(super) struct TwoStep {
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
