//! The projections of the constraints, for drawing: the projected points, and mesh edges between
//! them.

use super::constraint_map::ConstraintCoverage;
use super::measuring::Shape;
use crate::constraint::{Centring, Projected};
use crate::session::Session;
use crate::session::state::{RestMesh, SolvedScene, edges_among};
use crate::solve::projections_at;

/// Every point of every enabled constraint with its projection. A vertex has one point in each of
/// its constraints.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Projections {
    /// Vertex of each point.
    pub vertices: Vec<u32>,
    /// Displacement of each point to its projection, `#points by 3`, in the unit of the mesh.
    pub displacements: Vec<[f64; 3]>,
    /// Row of constraints of each point.
    pub rows: Vec<u32>,
    /// The outlines of the projected shapes, as pairs of points of the same constraint: the ends of
    /// the edges that it acts on, or otherwise of the mesh edges among its vertices.
    pub outlines: Vec<[u32; 2]>,
}

impl Session {
    /// Returns the projections at the current positions.
    pub fn projections(&mut self) -> Projections {
        let enabled: Vec<(u32, Centring)> = (0..)
            .zip(self.scene.rows())
            .filter(|(_, row)| row.enabled)
            .map(|(index, row)| (index, row.constraints.kind.info().centring))
            .collect();
        let mut found = Projections::default();
        self.scene.projected(|row, points| {
            let (row, centring) = enabled[row];
            let first = found.vertices.len() as u32;
            for (vertex, displacement) in points {
                found.vertices.push(*vertex);
                found.displacements.push([displacement.x, displacement.y, displacement.z]);
                found.rows.push(row);
            }
            let own = &found.vertices[first as usize..];
            match centring {
                Centring::ByEdge => found
                    .outlines
                    .extend((0..own.len() as u32 / 2).map(|k| [first + 2 * k, first + 2 * k + 1])),
                Centring::Together | Centring::Placed => {
                    let edges = edges_among(own, self.rest.topology()).into_iter();
                    found.outlines.extend(edges.map(|ends| ends.map(|end| first + end)));
                }
            }
        });
        found
    }

    /// Returns the residual of each face, `#F`, in the unit of the mesh: the largest distance of a
    /// corner to its projection in any enabled constraint.
    pub(super) fn residuals_of(&mut self, shape: &Shape) -> Vec<f64> {
        let mut squares = vec![0.0f64; self.rest.positions().len()];
        projected_at(&mut self.scene, &self.rest, shape, |_, points| {
            for (vertex, displacement) in points {
                let worst = &mut squares[*vertex as usize];
                *worst = worst.max(displacement.length_squared());
            }
        });
        let worst = |face: &[u32]| face.iter().fold(0.0, |w: f64, &v| w.max(squares[v as usize]));
        self.faces().iter().map(|face| worst(face).sqrt()).collect()
    }

    /// Returns the largest distance of a corner of each face to the shape that the enabled row `index`
    /// asks of it, `#F`, in the unit of the mesh; zero for faces on which it does not act.
    pub(super) fn row_distances(&mut self, index: usize, shape: &Shape) -> Vec<f64> {
        let enabled: Vec<usize> = self.scene.enabled_rows().collect();
        let mut cover = ConstraintCoverage::new(self.rest.mesh(), self.rest.topology());
        let mut distances = vec![0.0f64; self.rest.mesh().faces.len()];
        projected_at(&mut self.scene, &self.rest, shape, |row, points| {
            if enabled[row] != index {
                return;
            }
            let corners: Vec<u32> = points.iter().map(|(vertex, _)| *vertex).collect();
            let squares = points.iter().map(|(_, displacement)| displacement.length_squared());
            let far = squares.fold(0.0, f64::max).sqrt();
            for &face in cover.faces(&corners) {
                let worst = &mut distances[face as usize];
                *worst = worst.max(far);
            }
        });
        distances
    }
}

/// Calls `each` with every constraint of a shape, as [`SolvedScene::projected`].
fn projected_at(
    scene: &mut SolvedScene,
    rest: &RestMesh,
    shape: &Shape,
    mut each: impl FnMut(usize, &Projected),
) {
    let positions = match shape {
        Shape::Now => return scene.projected(each),
        Shape::Original => rest.positions(),
        Shape::At(positions) => positions,
    };
    let pose = scene.document().pose_positions();
    for (row, index) in scene.enabled_rows().enumerate() {
        let constraints = &scene.rows()[index].constraints;
        projections_at(positions, rest.mesh(), pose, constraints, |points| each(row, points));
    }
}
