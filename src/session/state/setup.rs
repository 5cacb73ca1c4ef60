//! The solver of a document.

use super::rows::ResolvedRow;
use crate::error::Error;
use crate::mesh::{Mesh, Point, Topology};
use crate::scene::Scene;
use crate::solve::{Constraints, Handle, Kept, Problem, Solver};

/// Sets up a solver for the enabled rows.
pub(crate) fn solver(
    document: &Scene,
    mesh: &Mesh,
    topology: &Topology,
    rows: &[ResolvedRow],
    kept: Kept,
    handles: Vec<Handle>,
    start: &[Point],
) -> Result<Solver, Error> {
    let constraints: Vec<Constraints> =
        rows.iter().filter(|row| row.enabled).map(|row| row.constraints.clone()).collect();
    let closeness_factors = document.closeness.factors(mesh, topology, &document.sets)?;
    let problem = Problem {
        mesh,
        topology,
        constraints: &constraints,
        weights: document.weights,
        closeness: &document.closeness,
        closeness_factors: &closeness_factors,
        smoothness: document.smoothness,
        settings: document.solver,
    };
    Ok(Solver::new(&problem, kept, handles, start)?)
}
