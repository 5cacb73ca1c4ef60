//! Projections of constraints at the rest shape, for hosts that draw them, without a solver.

use super::energy::{Constraints, ShapeEnergy};
use super::local_frame::{centre_and_extent, relative, rest_surface};
use crate::constraint::{Projected, Reference, Row};
use crate::mesh::{Mesh, Point};
use std::rc::Rc;

/// Calls `each` with the vertices of every constraint and the displacements to their projected
/// points, at the rest shape of `mesh` and in its unit. Kinds take their rest shape from the
/// `pose`, `#V by 3`, if given.
pub fn rest_projections(
    mesh: &Mesh,
    pose: Option<&[Point]>,
    constraints: &[Constraints],
    mut each: impl FnMut(&Projected),
) {
    let (centre, _) = centre_and_extent(mesh);
    let rows = |positions: &[Point]| -> Vec<Row> {
        positions.iter().map(|&point| relative(point, centre)).collect()
    };
    let (rest, pose) = (rows(&mesh.positions), pose.map(rows));
    let own_nodes: Vec<u32> = (0..rest.len() as u32).collect();
    let surface = || Rc::new(rest_surface(mesh, centre));
    let reference = Reference { surface: &surface, pose: pose.as_deref() };
    let mut energy = ShapeEnergy::new(constraints, &own_nodes, &rest, false, &reference);
    energy.projected(&rest, |_, points| each(points));
}
