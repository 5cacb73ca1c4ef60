//! The projections at the current positions, for drawing.

use super::Solver;
use crate::constraint::{Fitted, Projected};

impl Solver {
    /// Calls `each` with the row of every constraint, its vertices, and their displacements to the
    /// fitted shape at the current positions, in the unit of the mesh.
    pub fn projected(&mut self, mut each: impl FnMut(usize, &Projected)) {
        let mut vertex_of = vec![0; self.x.len()];
        for (vertex, &node) in (0..).zip(self.parts.node_of()) {
            vertex_of[node as usize] = vertex;
        }
        let mut points = Vec::new();
        self.parts.energies.shape.projected(&self.x, |row, projected| {
            points.clear();
            points.extend(projected.iter().map(|&(node, way)| (vertex_of[node as usize], way)));
            each(row, &points);
        });
    }

    /// The shapes fitted to the constraints at the current positions, for drawing.
    pub fn fitted(&self) -> Vec<Fitted> {
        let offset = self.parts.centre.into();
        let mut shapes = self.parts.energies.shape.fitted(&self.x);
        for shape in &mut shapes {
            match shape {
                Fitted::Circle { centre, .. } | Fitted::Sphere { centre, .. } => *centre += offset,
            }
        }
        shapes
    }
}
