//! The problem of a scene, as passed to the solver.

use super::closeness::Target;
use super::document::Scene;
use crate::mesh::{Mesh, Topology};
use crate::solve::{Constraints, Problem};

impl Scene {
    /// Returns the problem on `mesh`, the mesh that [`Scene::mesh`] refers to. `constraints` are
    /// the enabled constraints with resolved selectors, and `closeness_factors`, `#V`, the result
    /// of [`crate::scene::Closeness::factors`].
    pub fn problem<'a>(
        &'a self,
        mesh: &'a Mesh,
        topology: &'a Topology,
        constraints: &'a [Constraints],
        closeness_factors: &'a [f64],
    ) -> Problem<'a> {
        Problem {
            mesh,
            design: self.variants.design_positions(),
            pose: self.pose_positions(),
            topology,
            constraints,
            weights: self.weights,
            closeness_to: self.closeness.to,
            closeness_target: self.closeness.target.as_ref().and_then(Target::mesh),
            boundary_closeness: self.closeness.boundary,
            closeness_factors,
            smoothness: self.smoothness,
            settings: self.solver,
        }
    }
}
