//! The weights `w_ij` of the smoothness energy (paper section 4, Eq. 12): uniform, clamped
//! cotangents of angles, or those of polygons.
//!
//! The weights of Eq. 12 for polygons with any number of corners, planar or not: Alexa and
//! Wardetzky, "Discrete Laplacians on General Polygonal Meshes", 2011.
//!
//! With `d` the differences along the sides of a face, its Laplacian is `d^T (B B^T / |f| + U) d`.
//! The rows of `B` are the midpoints of the sides, and `|f|` is the length of the vector area. `U`
//! is a multiple of the orthogonal projection onto the complement of the differences of linear
//! functions, on the face projected along its vector area. On triangles that complement is zero,
//! and the first term is the cotangent formula.

use crate::math::{PrincipalAxes, Vec3, argsort, key_of_pair, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged, Topology};

/// The neighbours `N(i)` of each vertex `i` and their weights `w_ij`. The Laplacian of `l` at `i`
/// is `sum_j w_ij (l_j - l_i)`; the row of a vertex without edges is empty.
#[derive(Clone, Debug, PartialEq)]
pub struct Laplacian {
    neighbours: Ragged,
    /// One weight per entry of `neighbours`, in its order.
    weights: Vec<f64>,
}

impl Laplacian {
    /// Returns uniform weights, `w_ij = 1` along every edge.
    pub fn uniform(topology: &Topology) -> Laplacian {
        let neighbours = topology.neighbours().clone();
        let weights = vec![1.0; neighbours.indices().len()];
        Laplacian { neighbours, weights }
    }

    /// Returns `w_ij = (cot a + cot b) / 2` on the rest mesh, with the angles `a` and `b` opposite
    /// to the edge: one term per face of the edge; an edge of no face, as of a curve, has weight 1.
    /// Cotangents are clamped to [`LARGEST_COTANGENT`](crate::mesh::LARGEST_COTANGENT); the angle at
    /// coincident points counts as a right angle.
    ///
    /// # Panics
    /// Where they are not defined: see [`Laplacian::has_cotangents`].
    pub fn cotangent(mesh: &Mesh, topology: &Topology) -> Laplacian {
        assert!(Laplacian::has_cotangents(mesh), "cotangent weights need triangles");
        let of_no_face = |faces: &[u32]| if faces.is_empty() { 1.0 } else { 0.0 };
        let mut of_edge: Vec<f64> = topology.edge_faces().iter().map(of_no_face).collect();
        for face in mesh.faces.iter() {
            for k in 0..3 {
                let [a, b, opposite] = [face[k], face[(k + 1) % 3], face[(k + 2) % 3]];
                // A side from a repeated corner to itself has no edge.
                if let Some(e) = topology.edge(a, b) {
                    let corner = [opposite, a, b].map(|v| mesh.positions[v as usize]);
                    of_edge[e as usize] += 0.5 * cotangent(corner);
                }
            }
        }
        let weights =
            topology.vertex_edges().indices().iter().map(|&e| of_edge[e as usize]).collect();
        Laplacian { neighbours: topology.neighbours().clone(), weights }
    }

    /// Whether cotangent weights are defined: the mesh has faces, and all are triangles.
    pub fn has_cotangents(mesh: &Mesh) -> bool {
        !mesh.faces.is_empty() && mesh.faces.iter().all(|face| face.len() == 3)
    }

    /// Maximum number of corners of a face for [`Laplacian::polygon`], which couples all pairs.
    pub const MOST_CORNERS: usize = 500;

    /// Returns the weights of Alexa and Wardetzky 2011 on the rest mesh, whose faces may have any
    /// number of corners and need not be planar. The neighbours of a vertex are the corners of its
    /// faces. On triangles these are the cotangent weights; on planar faces the Laplacian of linear
    /// functions is zero at interior vertices. An edge of no face, as of a curve, has weight 1.
    pub fn polygon(mesh: &Mesh, topology: &Topology) -> Laplacian {
        let (mut pairs, mut of_pair) = (Vec::new(), Vec::new());
        let mut weights = PolygonWeights::default();
        for face in mesh.faces.iter() {
            let corners: Vec<Point> = face.iter().map(|&v| mesh.positions[v as usize]).collect();
            weights.take(&corners);
            for j in 1..face.len() {
                for i in (0..j).filter(|&i| face[i] != face[j]) {
                    let weight = match corners[..] {
                        // Clamped like the weights of `Laplacian::cotangent`.
                        [_, _, _] => 0.5 * cotangent([3 - i - j, i, j].map(|k| corners[k])),
                        _ => weights.weight(i, j),
                    };
                    pairs.extend([[face[i], face[j]], [face[j], face[i]]]);
                    of_pair.extend([weight; 2]);
                }
            }
        }
        for (&[a, b], faces) in topology.edges().iter().zip(topology.edge_faces().iter()) {
            if faces.is_empty() {
                pairs.extend([[a, b], [b, a]]);
                of_pair.extend([1.0; 2]);
            }
        }
        let order = argsort(pairs.iter().copied().map(key_of_pair));
        let order: Vec<usize> = order.into_iter().map(|k| k as usize).collect();
        let (mut rows, mut sums) = (vec![Vec::new(); mesh.positions.len()], Vec::new());
        for same in order.chunk_by(|&a, &b| pairs[a] == pairs[b]) {
            let [vertex, neighbour] = pairs[same[0]];
            rows[vertex as usize].push(neighbour);
            sums.push(same.iter().map(|&k| of_pair[k]).sum());
        }
        Laplacian { neighbours: rows.iter().collect(), weights: sums }
    }

    /// Number of vertices.
    pub fn len(&self) -> usize {
        self.neighbours.len()
    }
    /// Whether there are no vertices.
    pub fn is_empty(&self) -> bool {
        self.neighbours.is_empty()
    }
    /// Returns the neighbours of vertex `i`, ascending, and their weights `w_ij`.
    pub fn row(&self, i: usize) -> (&[u32], &[f64]) {
        let offsets = self.neighbours.offsets();
        let range = offsets[i] as usize..offsets[i + 1] as usize;
        (&self.neighbours.indices()[range.clone()], &self.weights[range])
    }
    /// All rows in order.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = (&[u32], &[f64])> {
        (0..self.len()).map(|i| self.row(i))
    }
}

/// Bound to which cotangents are clamped, the cotangent of 0.057 degrees. Triangles with a smaller
/// angle or without area then have finite weights. The bound is independent of scale.
pub const LARGEST_COTANGENT: f64 = 1e3;

/// Returns the clamped cotangent of the angle at the first point.
fn cotangent([at, a, b]: [Point; 3]) -> f64 {
    let at = Vec3::from(at);
    let (u, v) = (Vec3::from(a) - at, Vec3::from(b) - at);
    let (cos, sin) = (u.dot(v), u.cross(v).length());
    if cos.abs() > LARGEST_COTANGENT * sin {
        LARGEST_COTANGENT.copysign(cos)
    } else if sin > 0.0 {
        cos / sin
    } else {
        0.0
    }
}

/// Factor of the projection in `U`, a free parameter of the method. With this value opposite
/// corners of a square have weight zero, and all weights on a grid of squares are one, as uniform
/// weights.
const STABILITY: f64 = 0.5;

/// Relative extent below which a direction of the projected face, or its vector area, counts as
/// rounding error.
const FLAT: f64 = 1e-10;

/// The weights of the pairs of corners of one face at a time.
#[derive(Default)]
pub(crate) struct PolygonWeights {
    /// The rows of `d^T B / |f|^1/2`, per corner: half the vector from the previous to the next
    /// corner, scaled.
    across: Vec<Vec3<f64>>,
    /// The rows of `d^T Q`, per corner, where `Q` is an orthonormal basis of the differences of
    /// linear functions.
    linear: Vec<Vec3<f64>>,
}

impl PolygonWeights {
    /// Computes the weights of the face with these corners. The area is bounded below so that no
    /// entry of the first term exceeds [`LARGEST_COTANGENT`]: faces without area have finite
    /// weights.
    pub(crate) fn take(&mut self, corners: &[Point]) {
        let n = corners.len();
        let at = |k: usize| Vec3::from(corners[k % n]);
        let vector_area = twice_vector_area((0..n).map(at)) * 0.5;

        self.across.clear();
        self.across.extend((0..n).map(|k| (at(k + 1) - at(k + n - 1)) * 0.5));
        let longest = self.across.iter().fold(0.0, |m: f64, v| m.max(v.length_squared()));
        let area = vector_area.length().max(longest / LARGEST_COTANGENT);
        let scale = if area > 0.0 { 1.0 / area.sqrt() } else { 0.0 };
        self.across.iter_mut().for_each(|v| *v = *v * scale);

        let has_direction = vector_area.length() > FLAT * longest;
        let normal =
            if has_direction { vector_area * (1.0 / vector_area.length()) } else { Vec3::zero() };
        let mut sides: Vec<Vec3<f64>> = (0..n).map(|k| at(k + 1) - at(k)).collect();
        sides.iter_mut().for_each(|side| *side -= normal * normal.dot(*side));
        PrincipalAxes::rotate(&mut sides);
        let squares = sides.iter().fold([0.0; 3], |[x, y, z], side| {
            [x + side.x * side.x, y + side.y * side.y, z + side.z * side.z]
        });
        let unit =
            squares.map(
                |square| {
                    if square > FLAT * FLAT * squares[0] { 1.0 / square.sqrt() } else { 0.0 }
                },
            );
        let basis = |k: usize| {
            let side = sides[k % n];
            Vec3::new(side.x * unit[0], side.y * unit[1], side.z * unit[2])
        };
        self.linear.clear();
        self.linear.extend((0..n).map(|k| basis(k + n - 1) - basis(k)));
    }

    /// Returns the weight of the corners `i` and `j` of the face, `i < j`.
    pub(crate) fn weight(&self, i: usize, j: usize) -> f64 {
        let are_neighbours = j - i == 1 || j - i + 1 == self.across.len();
        let beside_linear =
            f64::from(u8::from(are_neighbours)) + self.linear[i].dot(self.linear[j]);
        STABILITY * beside_linear - self.across[i].dot(self.across[j])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weights(corners: &[Point]) -> Vec<f64> {
        let mut face = PolygonWeights::default();
        face.take(corners);
        let n = corners.len();
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        pairs.map(|(i, j)| face.weight(i, j)).collect()
    }

    #[test]
    fn a_triangle_has_half_its_cotangents() {
        // Right angle at the first corner; legs of 1 and 2.
        let found = weights(&[[0.0; 3], [0.6, 0.8, 0.0], [0.0, 0.0, 2.0]]);
        for (found, cotangent) in found.into_iter().zip([2.0, 0.5, 0.0]) {
            assert!((found - cotangent / 2.0).abs() < 1e-15, "{found} {cotangent}");
        }
    }

    #[test]
    fn a_square_joins_its_sides_as_uniform_weights_do() {
        let found = weights(&[[0.0; 3], [3.0, 0.0, 0.0], [3.0, 3.0, 0.0], [0.0, 3.0, 0.0]]);
        for (found, expected) in found.into_iter().zip([0.5, 0.0, 0.5, 0.5, 0.0, 0.5]) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
    }

    #[test]
    fn faces_without_area_have_finite_weights() {
        let (o, x) = ([0.0; 3], [1.0, 0.0, 0.0]);
        let bow_tie = [o, x, [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        for corners in
            [&[o; 5][..], &[o, x, o, x], &[o, x, [2.0, 0.0, 0.0], [5.0, 0.0, 0.0]], &bow_tie]
        {
            let found = weights(corners);
            assert!(
                found.iter().all(|w| w.abs() <= 2.0 * LARGEST_COTANGENT),
                "{corners:?} {found:?}"
            );
        }
    }

    #[test]
    fn cotangents_of_known_angles() {
        let o = [0.0; 3];
        assert_eq!(cotangent([o, [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]]), 0.0);
        assert_eq!(cotangent([o, [2.0, 0.0, 0.0], [3.0, 3.0, 0.0]]), 1.0);
        assert_eq!(cotangent([o, [2.0, 0.0, 0.0], [-3.0, 0.0, 3.0]]), -1.0);
    }

    #[test]
    fn cotangents_of_degenerate_triangles_are_finite() {
        let (o, x) = ([0.0; 3], [1.0, 0.0, 0.0]);
        assert_eq!(cotangent([o, x, [2.0, 0.0, 0.0]]), LARGEST_COTANGENT);
        assert_eq!(cotangent([o, x, [-2.0, 0.0, 0.0]]), -LARGEST_COTANGENT);
        assert_eq!(cotangent([o, o, x]), 0.0);
        assert_eq!(cotangent([o, o, o]), 0.0);
    }
}
