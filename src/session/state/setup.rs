//! The solver of a document.

use super::rows::ResolvedRow;
use crate::error::Error;
use crate::mesh::{Mesh, Point, Topology};
use crate::scene::Scene;
use crate::solve::{Constraints, Handle, SetupCache, Solver};

/// Sets up a solver for the enabled rows.
pub(crate) fn solver(
    document: &Scene,
    mesh: &Mesh,
    topology: &Topology,
    rows: &[ResolvedRow],
    cache: SetupCache,
    handles: Vec<Handle>,
    start: &[Point],
) -> Result<Solver, Error> {
    let constraints: Vec<Constraints> =
        rows.iter().filter(|row| row.enabled).map(|row| row.constraints.clone()).collect();
    let closeness_factors = document.closeness.factors(mesh, topology, &document.sets)?;
    let problem = document.problem(mesh, topology, &constraints, &closeness_factors);
    Ok(Solver::new(&problem, cache, handles, start)?)
}
