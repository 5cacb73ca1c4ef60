//! The projections of constraints at the rest shape, for hosts that draw them; no solver takes part.

use super::energy::{Constraints, ShapeEnergy};
use super::local_frame::{centre_and_extent, relative, rest_surface};
use crate::constraint::{Projected, Reference, Row};
use crate::mesh::{Mesh, Point};
use std::rc::Rc;

/// Gives `each` the vertices of every constraint, and the way from each of these to its projected
/// point at the rest shape of `mesh`, in its unit. Shapes are taken from the `pose`, `#V by 3`, if there is one.
pub fn rest_projections(
    mesh: &Mesh,
    pose: Option<&[Point]>,
    constraints: &[Constraints],
    mut each: impl FnMut(&Projected),
) {
    let (centre, _) = centre_and_extent(&mesh.positions);
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
