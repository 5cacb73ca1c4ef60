//! The weights `w_ij` of the smoothness energy (paper section 4, Eq. 12).

use super::cotangent::cotangent;
use super::polygon_weights::PolygonWeights;
use crate::math::{argsort, key_of_pair};
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
    /// functions is zero at interior vertices. See `polygon_weights.rs`.
    pub fn polygon(mesh: &Mesh) -> Laplacian {
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
