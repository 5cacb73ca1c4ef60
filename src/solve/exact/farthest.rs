//! The distance of a shape from its requirements, without an energy.

use super::hard_rows::HardRows;
use super::requirement::Require;
use crate::constraint::{Reference, Row};
use crate::mesh::{Mesh, Point};
use crate::solve::energy::Constraints;
use crate::solve::local_frame::{centre_and_extent, relative, rest_surface};
use std::rc::Rc;

/// Returns the greatest distance of a vertex at `positions` (`#V by 3`) to the shape of one of the
/// `constraints`, with `mesh` as the rest shape, in the unit of `mesh`.
pub fn farthest(mesh: &Mesh, positions: &[Point], constraints: &Constraints) -> f64 {
    let (centre, _) = centre_and_extent(mesh);
    let rows = |points: &[Point]| -> Vec<Row> {
        points.iter().map(|&point| relative(point, centre)).collect()
    };
    let surface = || Rc::new(rest_surface(mesh, centre));
    let reference = Reference { surface: &surface, pose: None };
    let own_nodes: Vec<u32> = (0..positions.len() as u32).collect();
    let hard = [(constraints, None, Require::Exact)];
    HardRows::new(&hard, &own_nodes, &rows(&mesh.positions), &reference)
        .worst_excess(&rows(positions))
}
