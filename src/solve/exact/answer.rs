//! The result: the distances reached, and the constraints that are not met; and the distance of any
//! shape from its requirements.

use super::hard_rows::{HardBatch, HardRows};
use super::model::Model;
use super::requirement::GUARD_MARGIN;
use crate::constraint::Row;
use crate::math::{Lane, key_of_number, sort_by_number};
use crate::mesh::{Mesh, Point};
use crate::solve::energy::Constraints;
use crate::solve::local_frame::{centre_and_extent, rows};
use serde::{Deserialize, Serialize};

/// A constraint that is not met.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Unmet {
    /// Index of its row in the problem.
    pub row: usize,
    /// Its vertices.
    pub vertices: Vec<u32>,
    /// The greatest distance of one of them to the fitted shape, in the unit of the mesh.
    pub distance: f64,
}

/// The distances by which vertices were moved, in the unit of the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Moved {
    /// The maximum.
    pub max: f64,
    /// The mean over all vertices.
    pub mean: f64,
}

impl Moved {
    /// Computes this from the distance that each vertex moved.
    pub fn of(lengths: impl ExactSizeIterator<Item = f64>) -> Moved {
        let count = lengths.len().max(1) as f64;
        let (max, sum) =
            lengths.fold((0.0, 0.0), |(max, sum), length| (Lane::max(length, max), sum + length));
        Moved { max, mean: sum / count }
    }
}

/// The gain of an improvement: energies of all but the hard rows, in squared units of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Improved {
    /// The energy when all hard constraints were met.
    pub before: f64,
    /// The energy at the end of the improvement, never more.
    pub after: f64,
    /// Number of steps.
    pub steps: u32,
}

/// How well hard constraints are met, and the cost of meeting them. Lengths are in the unit of the
/// mesh.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ExactAnswer {
    /// The greatest distance of a vertex to the shape of a hard constraint, at the output
    /// positions.
    pub max_distance: f64,
    /// Constraints count as met up to this distance; the greatest one if they have several.
    pub tolerance: f64,
    /// Whether all hard constraints are met.
    pub met: bool,
    /// Whether the unmet constraints contradict each other: all others are met, and no step
    /// improves them.
    pub contradiction: bool,
    /// Whether constraints must be exact, but the problem is too large for the polish.
    pub too_large: bool,
    /// The unmet constraints, the worst first.
    pub unmet: Vec<Unmet>,
    /// The displacements of the vertices from the start.
    pub moved: Moved,
    /// Edges at their least allowed length, as pairs of vertices.
    pub on_guard: Vec<[u32; 2]>,
    /// The least ratio of a guarded edge to its length at rest; `None` without a guard.
    pub shortest_edge: Option<f64>,
    /// Number of iterations of the approach.
    pub iterations: u32,
    /// Number of factorisations of the scalar matrix.
    pub refactorizations: u32,
    /// Number of factorisations of the block matrix.
    pub block_factors: u32,
    /// Number of steps of the polish.
    pub steps: u32,
    /// The gain of the improvement; `None` if it was not requested or not possible.
    pub improved: Option<Improved>,
    /// Total time in seconds.
    pub seconds: f64,
}

/// A guarded edge counts as on the guard up to this fraction above its bound: the guard aims a
/// little higher if a tolerance is enough.
const ON_GUARD: f64 = 2.0 * GUARD_MARGIN;

impl Model {
    /// Returns the output positions, `#V by 3`.
    pub(in crate::solve) fn positions(&self, x: &[Row]) -> Vec<Point> {
        let node_of = self.parts.system.node_of();
        let given = self.put.iter().zip(node_of).map(|(&put, &node)| {
            let row = x[node as usize];
            if row == self.start[node as usize] { put } else { self.parts.to_point(row) }
        });
        given.collect()
    }

    /// See [`exact_tolerance`].
    pub(in crate::solve) fn tolerance(&self) -> f64 {
        tolerance_of(self.parts.centre, self.parts.extent)
    }

    /// Approximate rounding error of the position of a vertex in output coordinates.
    pub(in crate::solve) fn rounding(&self) -> f64 {
        rounding_of(self.parts.centre, self.parts.extent)
    }

    /// Measures the output positions; the caller adds the cost.
    pub(in crate::solve) fn measure(&self, x: &[Row]) -> ExactAnswer {
        let positions = self.positions(x);
        let rounded = self.parts.to_rows(&positions);
        let mut vertex_of = vec![0; x.len()];
        for (vertex, &node) in (0..).zip(&self.parts.system.node_of()[..positions.len()]) {
            vertex_of[node as usize] = vertex;
        }
        let tolerance = self.tolerance();
        let allowed = |hard: &HardBatch| hard.within.unwrap_or(tolerance);
        let rows = || self.hard.batches.iter().filter(|hard| hard.row.is_some());
        let (mut max_distance, mut unmet) = (0.0_f64, Vec::new());
        for hard in &self.hard.batches {
            let Some(row) = hard.row else { continue };
            let most = allowed(hard);
            hard.misses(&rounded, |i, miss| {
                max_distance = max_distance.max(miss.distance);
                // Written so that NaN is not met.
                let met = miss.distance <= most;
                if !met {
                    let nodes = hard.batch.nodes_of(i);
                    let vertices = nodes.map(|node| vertex_of[node as usize]).collect();
                    unmet.push(Unmet { row, vertices, distance: miss.distance });
                }
            });
        }
        sort_by_number(&mut unmet, |miss: &Unmet| key_of_number(-miss.distance));
        let (on_guard, shortest_edge) = self.guarded_edges(x);
        ExactAnswer {
            max_distance,
            tolerance: rows().map(allowed).reduce(f64::max).unwrap_or(tolerance),
            met: unmet.is_empty(),
            unmet,
            moved: self.moved(x),
            on_guard,
            shortest_edge,
            ..ExactAnswer::default()
        }
    }

    fn moved(&self, x: &[Row]) -> Moved {
        let nodes = self.parts.system.node_of()[..self.parts.n_vertices].iter();
        Moved::of(nodes.map(|&node| distance(x[node as usize], self.start[node as usize])))
    }

    fn guarded_edges(&self, x: &[Row]) -> (Vec<[u32; 2]>, Option<f64>) {
        let Some((edges, ratio)) = &self.guarded else { return (Vec::new(), None) };
        let node_of = self.parts.system.node_of();
        let rest = &self.parts.rest;
        let (mut on_guard, mut shortest) = (Vec::new(), f64::INFINITY);
        for &ends in edges {
            let [a, b] = ends.map(|v| node_of[v as usize] as usize);
            let (now, before) = (distance(x[a], x[b]), distance(rest[a], rest[b]));
            if before > 0.0 {
                shortest = shortest.min(now / before);
                if now <= (1.0 + ON_GUARD) * ratio * before {
                    on_guard.push(ends);
                }
            }
        }
        (on_guard, shortest.is_finite().then_some(shortest))
    }
}

/// Returns the distance up to which exact constraints on a mesh at rest count as met, in its unit:
/// a little more than the resolution of the coordinates.
pub fn exact_tolerance(rest: &Mesh) -> f64 {
    let (centre, extent) = centre_and_extent(rest);
    tolerance_of(centre, extent)
}

fn tolerance_of(centre: Point, extent: f64) -> f64 {
    const OF_THE_SIZE: f64 = 1e-10;
    (OF_THE_SIZE * extent).max(8.0 * rounding_of(centre, extent))
}

/// Returns the length, in the unit of a mesh, up to which distances between its vertices may be the
/// rounding of their coordinates: more, the farther it is from the origin.
pub fn coordinate_rounding(mesh: &Mesh) -> f64 {
    let (centre, extent) = centre_and_extent(mesh);
    8.0 * rounding_of(centre, extent)
}

fn rounding_of(centre: Point, extent: f64) -> f64 {
    let farthest = centre.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
    f64::EPSILON * (farthest + extent)
}

fn distance(a: Row, b: Row) -> f64 {
    (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt()
}

/// Returns the greatest distance of a vertex at `positions` (`#V by 3`) to the shape of one of the
/// `constraints`, in the unit of `mesh`. The rest shape is `mesh`, or the `pose` (`#V by 3`) for the
/// kinds that take theirs from one.
pub fn farthest(
    mesh: &Mesh,
    pose: Option<&[Point]>,
    positions: &[Point],
    constraints: &Constraints,
) -> f64 {
    let positions = rows(positions, centre_and_extent(mesh).0);
    HardRows::at_rest(mesh, pose, std::slice::from_ref(constraints)).worst_excess(&positions)
}
