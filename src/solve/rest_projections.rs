//! The projections of constraints at the rest shape, for hosts that draw them; no solver takes part.

use super::energy::{Constraints, ShapeEnergy};
use super::local_frame::{centre_and_extent, relative, rest_surface};
use crate::constraint::{Projected, Reference, Row};
use crate::mesh::Mesh;
use std::rc::Rc;

/// Gives `each` the vertices of every constraint, and the way from each of these to its projected
/// point at the rest shape of `mesh`, in its unit.
pub fn rest_projections(
    mesh: &Mesh,
    constraints: &[Constraints],
    mut each: impl FnMut(&Projected),
) {
    let (centre, _) = centre_and_extent(&mesh.positions);
    let rest: Vec<Row> = mesh.positions.iter().map(|&point| relative(point, centre)).collect();
    let own_nodes: Vec<u32> = (0..rest.len() as u32).collect();
    let surface = || Rc::new(rest_surface(mesh, centre));
    let reference = Reference { surface: &surface };
    let mut energy = ShapeEnergy::new(constraints, &own_nodes, &rest, false, &reference);
    energy.projected(&rest, |_, points| each(points));
}
