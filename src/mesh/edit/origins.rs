//! Where the parts of a mesh come from that was made from another one.

use crate::mesh::{Mesh, Point, Ragged};

/// A mesh made from another one, with the map from that.
#[derive(Clone, Debug, PartialEq)]
pub struct Edited {
    /// The new mesh.
    pub mesh: Mesh,
    /// Where its parts come from.
    pub origins: Origins,
}

impl Edited {
    /// Where the new vertices are in another state of the old mesh than the one `from` that this was made of; all
    /// three `#V by 3`.
    pub fn in_other_state(&self, from: &[Point], other: &[Point]) -> Vec<Point> {
        let combined = [from, other].map(|points| self.origins.positions.apply(points));
        let [from, mut other] = combined;
        for ((other, from), to) in other.iter_mut().zip(from).zip(&self.mesh.positions) {
            for axis in 0..3 {
                // What is a combination of old ones keeps every bit.
                if to[axis] != from[axis] {
                    other[axis] += to[axis] - from[axis];
                }
            }
        }
        other
    }
}

/// Where the parts of a mesh come from. Old vertices that are left come first, in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Origins {
    /// The new index of each old vertex: none where it is gone, the same where several became one.
    pub vertices: Vec<Option<u32>>,
    /// The position of each new vertex as an affine combination of old ones.
    pub positions: Combinations,
    /// The old vertices that each new vertex stands between, ascending: one for an old vertex, two for a vertex
    /// on an old edge, the corners of a face for one inside it.
    pub between: Ragged,
    /// The old faces that each new face is a part of, or was made of, ascending: none for one that closes a hole.
    pub faces: Ragged,
}

impl Origins {
    /// Those of a mesh that is unchanged.
    pub(super) fn unchanged(mesh: &Mesh) -> Origins {
        let vertices = 0..mesh.positions.len() as u32;
        let mut positions = Combinations::default();
        vertices.clone().for_each(|v| positions.push(&[(v, 1.0)]));
        Origins {
            vertices: vertices.clone().map(Some).collect(),
            positions,
            between: vertices.map(|v| [v]).collect(),
            faces: (0..mesh.faces.len() as u32).map(|face| [face]).collect(),
        }
    }

    /// From the mesh before these, where `next` leads on from here.
    pub(super) fn then(&self, next: &Origins) -> Origins {
        let union = |olds: &Ragged, row: &[u32]| {
            let olds = row.iter().flat_map(|&i| olds.row(i as usize));
            let mut olds: Vec<u32> = olds.copied().collect();
            olds.sort_unstable();
            olds.dedup();
            olds
        };
        let now = |v: &Option<u32>| v.and_then(|v| next.vertices[v as usize]);
        Origins {
            vertices: self.vertices.iter().map(now).collect(),
            positions: next.positions.of(&self.positions),
            between: next.between.iter().map(|row| union(&self.between, row)).collect(),
            faces: next.faces.iter().map(|row| union(&self.faces, row)).collect(),
        }
    }
}

/// Points as affine combinations of other points: weighted sums whose weights add up to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Combinations {
    /// `#points + 1`: those of point `i` are `terms[offsets[i]..offsets[i + 1]]`.
    offsets: Vec<u32>,
    /// Index of a point, and its weight.
    terms: Vec<(u32, f64)>,
}

impl Combinations {
    /// The points, from others.
    pub fn apply(&self, points: &[Point]) -> Vec<Point> {
        let sum = |terms: &[(u32, f64)]| {
            // Relative to one of them: far from the origin no digits are lost, and what stays keeps every bit.
            let base = points[terms[0].0 as usize];
            let mut sum = [0.0; 3];
            for &(point, weight) in &terms[1..] {
                for axis in 0..3 {
                    sum[axis] += weight * (points[point as usize][axis] - base[axis]);
                }
            }
            std::array::from_fn(|axis| base[axis] + sum[axis])
        };
        self.rows().map(sum).collect()
    }

    /// The weighted points that each point is the sum of, at least one.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[(u32, f64)]> {
        self.offsets.windows(2).map(|ends| &self.terms[ends[0] as usize..ends[1] as usize])
    }

    /// Combinations of points that are themselves `combined` from others.
    fn of(&self, combined: &Combinations) -> Combinations {
        let row = |place: u32| {
            let ends = [place, place + 1].map(|i| combined.offsets[i as usize] as usize);
            &combined.terms[ends[0]..ends[1]]
        };
        let mut expanded = Combinations::default();
        for terms in self.rows() {
            let mut sum = Sum::default();
            for &(point, weight) in terms {
                row(point).iter().for_each(|&(old, part)| sum.add(old, weight * part));
            }
            expanded.push(&sum.terms);
        }
        expanded
    }

    /// Appends a point: indices of old points with weights that add up to 1.
    pub(super) fn push(&mut self, terms: &[(u32, f64)]) {
        self.terms.extend_from_slice(terms);
        self.offsets.push(self.terms.len() as u32);
    }
}

impl Default for Combinations {
    fn default() -> Self {
        Combinations { offsets: vec![0], terms: Vec::new() }
    }
}

/// An affine combination while it is added up.
#[derive(Default)]
pub(super) struct Sum {
    pub(super) terms: Vec<(u32, f64)>,
}

impl Sum {
    pub(super) fn add(&mut self, point: u32, weight: f64) {
        match self.terms.iter_mut().find(|(known, _)| *known == point) {
            Some((_, sum)) => *sum += weight,
            None => self.terms.push((point, weight)),
        }
    }
}
