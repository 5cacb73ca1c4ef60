//! Boundary vertices that stay exactly on their boundary curve. Their unknown is the length along
//! it: in terms of unknowns, their rows contain that length and the slope of the energy along the
//! curve. All step computations work on these.
//!
//! In the metric these nodes are decoupled from the others, since the couplings between lengths
//! along a curve and coordinates differ between the three coordinates.

use super::energy::{Handle, Hold};
use super::settings::BoundaryCloseness;
use crate::constraint::Row;
use crate::math::{Vec3, cosine, marked};
use crate::mesh::{BoundaryCurves, Point, Polyline, Topology};

/// The boundary vertices of a solver, except corners, with their curves.
pub(super) struct Gliding {
    curves: Vec<Polyline>,
    vertices: Vec<Glider>,
    /// Differences of coordinates below this are rounding error.
    rounding: f64,
}

struct Glider {
    vertex: u32,
    node: u32,
    curve: u32,
    /// Length along the curve.
    s: f64,
    /// Slope of half the energy along the curve, in the direction in which it falls; 0 if there is
    /// none.
    slope: f64,
    /// Whether a fixed handle holds the vertex instead.
    taken: bool,
}

impl Gliding {
    /// Finds the boundary of the shape at `positions` (`#V by 3`), and its corners. Vertices that
    /// are `released` are treated as interior ones. `node_of` is the node of each vertex.
    /// Coordinates are relative to `centre`.
    pub(super) fn new(
        (positions, centre): (&[Point], Point),
        topology: &Topology,
        boundary: BoundaryCloseness,
        released: impl Fn(u32) -> bool,
        node_of: &[u32],
    ) -> (Gliding, Vec<u32>) {
        let found = BoundaryCurves::new(positions, topology, cosine(boundary.corners / 360.0));
        let largest = positions.as_flattened().iter().chain(&centre);
        let largest = largest.fold(0.0, |largest: f64, coordinate| largest.max(coordinate.abs()));
        let rounding = 8.0 * f64::EPSILON * largest;
        let mut gliding = Gliding { curves: Vec::new(), vertices: Vec::new(), rounding };
        let is_corner = marked(positions.len(), &found.corners);
        for piece in found.curves.into_iter().flat_map(|curve| curve.pieces) {
            let points = piece.vertices.iter().map(|&v| positions[v as usize]);
            let curve = Polyline::new(points, piece.closed);
            let own = if piece.closed { piece.vertices.len() - 1 } else { piece.vertices.len() };
            for (k, &vertex) in piece.vertices[..own].iter().enumerate() {
                if !is_corner[vertex as usize] && !released(vertex) {
                    gliding.vertices.push(Glider {
                        vertex,
                        node: node_of[vertex as usize],
                        curve: gliding.curves.len() as u32,
                        s: curve.length_to(k),
                        slope: 0.0,
                        taken: false,
                    });
                }
            }
            gliding.curves.push(curve);
        }
        (gliding, found.corners.into_iter().filter(|&v| !released(v)).collect())
    }

    /// The vertices, each with its node.
    pub(super) fn vertices(&self) -> impl Iterator<Item = (u32, u32)> {
        self.vertices.iter().map(|glider| (glider.vertex, glider.node))
    }

    /// Moves each vertex to the closest point on its curve, except those with a fixed handle.
    pub(super) fn place(&mut self, x: &mut [Row], handles: &[Handle]) {
        let fixed = handles.iter().filter(|it| it.hold == Hold::Fixed);
        let mut fixed: Vec<u32> = fixed.map(|it| it.vertex).collect();
        fixed.sort_unstable();
        for glider in &mut self.vertices {
            glider.taken = fixed.binary_search(&glider.vertex).is_ok();
        }
        self.follow(x);
    }

    /// The same with the handles of before.
    pub(super) fn follow(&mut self, x: &mut [Row]) {
        for glider in &mut self.vertices {
            let row = &mut x[glider.node as usize];
            let curve = &self.curves[glider.curve as usize];
            if glider.taken || curve.point(glider.s) == row[..3] {
                continue;
            }
            glider.s = curve.closest([row[0], row[1], row[2]], glider.s);
            let on_curve = at(curve, glider.s);
            // Positions on the curve up to rounding stay unchanged to the last bit.
            if row.iter().zip(&on_curve).any(|(a, b)| (a - b).abs() > self.rounding) {
                *row = on_curve;
            }
        }
    }

    /// Reduces the gradient to its component along the curves, in the direction in which the energy
    /// falls.
    pub(super) fn constrain(&mut self, gradient: &mut [Row]) {
        for glider in self.vertices.iter_mut().filter(|glider| !glider.taken) {
            let row = &mut gradient[glider.node as usize];
            let g = Vec3::new(row[0], row[1], row[2]);
            let [backward, forward] = self.curves[glider.curve as usize].directions(glider.s);
            let slope = |along: Option<Vec3<f64>>| along.map_or(0.0, |along| g.dot(along));
            // At a vertex of the curve the energy can fall on both sides, or on neither.
            let (rising, falling) = (slope(backward).max(0.0), slope(forward).min(0.0));
            let (slope, direction) =
                if rising > -falling { (rising, backward) } else { (falling, forward) };
            glider.slope = slope;
            let along = direction.unwrap_or(Vec3::zero()) * slope;
            *row = [along.x, along.y, along.z, 0.0];
        }
    }

    /// The nodes that are not held by a fixed handle.
    pub(super) fn moving(&self) -> impl Iterator<Item = u32> {
        self.vertices.iter().filter(|glider| !glider.taken).map(|glider| glider.node)
    }

    /// Converts positions and their gradient to unknowns.
    pub(super) fn to_unknowns(&self, x: &mut [Row], gradient: &mut [Row]) {
        for glider in self.vertices.iter().filter(|glider| !glider.taken) {
            x[glider.node as usize] = [glider.s, 0.0, 0.0, 0.0];
            gradient[glider.node as usize] = [glider.slope, 0.0, 0.0, 0.0];
        }
    }

    /// Converts the unknowns back to positions. Lengths beyond the end of a curve are clamped to
    /// it.
    pub(super) fn put_on_curves(&mut self, x: &mut [Row]) {
        for glider in self.vertices.iter_mut().filter(|glider| !glider.taken) {
            let (curve, row) = (&self.curves[glider.curve as usize], &mut x[glider.node as usize]);
            // A length that is not finite stays, and is detected at the end of the step.
            if row[0].is_finite() {
                glider.s = curve.bounded(row[0]);
                *row = at(curve, glider.s);
            }
        }
    }

    /// In terms of unknowns, sets `x` to `part` of the step from `before` (positions and gradient)
    /// to the current state. That state is `x`, except for these vertices, whose lengths are stored
    /// here. Vertices that would go uphill along their curve stay, so that the step is a descent
    /// step if it is one for all other nodes.
    pub(super) fn shorten(&self, before: (&[Row], &[Row]), x: &mut [Row], part: f64) {
        for glider in self.vertices.iter().filter(|glider| !glider.taken) {
            x[glider.node as usize][..3].copy_from_slice(&[glider.s, 0.0, 0.0]);
        }
        for (to, before) in x.as_flattened_mut().iter_mut().zip(before.0.as_flattened()) {
            *to = before + part * (*to - before);
        }
        for glider in self.vertices.iter().filter(|glider| !glider.taken) {
            let node = glider.node as usize;
            let (start, slope) = (before.0[node][0], before.1[node][0]);
            if (x[node][0] - start) * slope >= 0.0 {
                x[node][0] = start;
            }
        }
    }
}

fn at(curve: &Polyline, s: f64) -> Row {
    let [x, y, z] = curve.point(s);
    [x, y, z, 0.0]
}
