//! What constraints ask of a mesh at rest, without a solver: their projections, and the least
//! distances that vertices must move for them to hold, to first order.

use super::answer::Moved;
use super::hard_rows::HardRows;
use super::normal_space::{Differences, Linear};
use crate::constraint::Projected;
use crate::math::{Vec3, add_scaled, inner_product};
use crate::mesh::{Mesh, Point, Ragged};
use crate::solve::energy::Constraints;
use crate::solve::local_frame::{centre_and_extent, rows};
use std::slice;

/// Greatest number of steps of conjugate gradients; with fewer the movement is smaller, never
/// greater.
const STEPS: usize = 60;
/// The steps end at this fraction of the residual.
const PRECISION: f64 = 0.02;
/// A column of an approximate orthogonal projector counts from this length on: shorter ones are
/// rounding error, for example if every position is as required.
const RANK: f64 = 1e-3;

/// Returns the smallest change of the positions of `mesh`, in least squares, after which the
/// linearised `constraints` hold: the first step of the polish, with lengths as the metric. Lengths
/// are in the unit of the mesh.
pub fn least_move(mesh: &Mesh, constraints: &[Constraints]) -> Moved {
    let (centre, extent) = centre_and_extent(mesh);
    let x = rows(&mesh.positions, centre);
    let mut conditions = Conditions::default();
    for hard in &HardRows::at_rest(mesh, None, constraints).batches {
        let (points, count) = (hard.batch.points(), hard.batch.count());
        let size = 3 * points;
        let mut residuals = vec![0.0; size * count];
        hard.residuals(&x, None, &mut residuals);
        let mut differences = Differences::new(points, hard.batch.centring());
        let mut normal = vec![0.0; size * size];
        for (i, residual) in residuals.chunks_exact_mut(size).enumerate() {
            let to = Linear { residual: &mut *residual, normal: &mut normal };
            differences.linearise((hard, None), i, &x, extent, to);
            let vertices: Vec<u32> = hard.batch.nodes_of(i).collect();
            conditions.add(&vertices, &mut normal, residual);
        }
    }
    let step = conditions.least_step(x.len());
    Moved::of(step.iter().map(|displacement| displacement.length()))
}

/// Calls `each` with the vertices of every constraint and the displacements to their projected
/// points, at `positions` (`#V by 3`) and in the unit of `mesh`, the rest shape. Kinds take theirs from
/// the `pose`, `#V by 3`, if given.
pub fn projections_at(
    positions: &[Point],
    mesh: &Mesh,
    pose: Option<&[Point]>,
    constraints: &Constraints,
    mut each: impl FnMut(&Projected),
) {
    let x = rows(positions, centre_and_extent(mesh).0);
    for hard in &mut HardRows::at_rest(mesh, pose, slice::from_ref(constraints)).batches {
        hard.batch.projected(&x, &mut each);
    }
}

/// Linear conditions `direction . (residual + change) = 0` on the points of single constraints.
#[derive(Default)]
struct Conditions {
    /// The vertices of each condition.
    vertices: Ragged,
    /// The part of the direction at each of these vertices; each direction is a unit vector.
    directions: Vec<Vec3<f64>>,
    /// The residual along each direction.
    residuals: Vec<f64>,
}

impl Conditions {
    /// Adds a condition for each dimension of the normal space of a constraint, which is spanned by
    /// the columns of the symmetric `normal`: an orthonormal basis by Gram and Schmidt, the largest
    /// column first. Reduces `normal` to zero.
    fn add(&mut self, vertices: &[u32], normal: &mut [f64], residual: &[f64]) {
        let size = residual.len();
        for _ in 0..size {
            let columns = normal.chunks_exact(size).map(|column| inner_product(column, column));
            let longest = columns.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b));
            let Some((place, squared)) = longest else { return };
            if squared.is_nan() || squared <= RANK * RANK {
                return;
            }
            let scale = 1.0 / squared.sqrt();
            let direction: Vec<f64> =
                normal[place * size..][..size].iter().map(|value| value * scale).collect();
            for column in normal.chunks_exact_mut(size) {
                let along = inner_product(column, &direction);
                add_scaled(column, -along, &direction);
            }
            self.vertices.push(vertices);
            self.residuals.push(inner_product(&direction, residual));
            let parts = direction.chunks_exact(3).map(|part| Vec3::new(part[0], part[1], part[2]));
            self.directions.extend(parts);
        }
    }

    /// Computes `J^T (J J^T)^-1 r`, `#V by 3`, with the directions `J` and the residuals `r`, by
    /// conjugate gradients.
    fn least_step(&self, n_vertices: usize) -> Vec<Vec3<f64>> {
        let mut residual = self.residuals.clone();
        let mut along = residual.clone();
        let mut step = vec![Vec3::zero(); n_vertices];
        let mut change = step.clone();
        let mut left = inner_product(&residual, &residual);
        let enough = PRECISION * PRECISION * left;
        for _ in 0..STEPS {
            if left <= enough {
                break;
            }
            self.transposed(&along, &mut change);
            let image = self.times(&change);
            let size = left / inner_product(&along, &image);
            if !size.is_finite() {
                break;
            }
            step.iter_mut().zip(&change).for_each(|(step, &change)| *step += change * size);
            add_scaled(&mut residual, -size, &image);
            let before = std::mem::replace(&mut left, inner_product(&residual, &residual));
            let kept = left / before;
            along.iter_mut().zip(&residual).for_each(|(along, left)| *along = left + kept * *along);
        }
        step
    }

    /// Sets `change` to `J^T` times a number for each condition.
    fn transposed(&self, numbers: &[f64], change: &mut [Vec3<f64>]) {
        change.fill(Vec3::zero());
        let mut directions = self.directions.iter();
        for (vertices, &number) in self.vertices.iter().zip(numbers) {
            for (&vertex, &direction) in vertices.iter().zip(&mut directions) {
                change[vertex as usize] += direction * number;
            }
        }
    }

    /// Returns `J` times a change of the positions.
    fn times(&self, change: &[Vec3<f64>]) -> Vec<f64> {
        let mut directions = self.directions.iter();
        let each = self.vertices.iter().map(|vertices| {
            let both = vertices.iter().zip(&mut directions);
            both.map(|(&vertex, direction)| direction.dot(change[vertex as usize])).sum()
        });
        each.collect()
    }
}
