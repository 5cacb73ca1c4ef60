//! `E_smooth` (Eq. 12): the Laplacian of the surface or of its displacement.

use crate::constraint::Row;
use crate::mesh::{Laplacian, Ragged};
use crate::solve::assemble::Terms;

/// Nodes that are treated by one call of a function that is entered often.
const BLOCK: usize = 64;

/// The terms of `L^T L` over vertices: one for each row `sum_j w_ij (l_j - l_i)`.
pub(crate) fn terms(laplacian: &Laplacian) -> Terms {
    let mut terms = Terms::default();
    let mut nodes = Vec::new();
    for (i, (neighbours, weights)) in laplacian.rows().enumerate() {
        nodes.clear();
        nodes.push(i as u32);
        nodes.extend_from_slice(neighbours);
        let own = -weights.iter().sum::<f64>();
        terms.push(&nodes, std::iter::once(own).chain(weights.iter().copied()), 0.0, 1.0);
    }
    terms
}

/// The Laplacian in the order of elimination.
pub(crate) struct SmoothEnergy {
    neighbours: Ragged,
    /// `w_ij`, aligned with `neighbours`.
    weights: Vec<f64>,
    /// `v'` where displacements are smoothed, empty where positions are.
    rest: Vec<Row>,
    /// `sum_j w_ij (l_j - l_i)` of each node.
    rows: Vec<Row>,
    l: Vec<Row>,
}

impl SmoothEnergy {
    /// For vertices called `node_of[v]` among `n_nodes` nodes; `rest` is empty or their rest positions.
    pub(crate) fn new(
        laplacian: &Laplacian,
        node_of: &[u32],
        n_nodes: usize,
        rest: Vec<Row>,
    ) -> Self {
        let mut by_node: Vec<(&[u32], &[f64])> = vec![(&[], &[]); n_nodes];
        for (&node, row) in node_of.iter().zip(laplacian.rows()) {
            by_node[node as usize] = row;
        }
        let mut neighbours: Ragged = by_node.iter().map(|(neighbours, _)| neighbours).collect();
        neighbours.rename(node_of);
        SmoothEnergy {
            neighbours,
            weights: by_node.iter().flat_map(|(_, weights)| weights.iter().copied()).collect(),
            l: vec![[0.0; 4]; rest.len()],
            rest,
            rows: vec![[0.0; 4]; n_nodes],
        }
    }

    /// Adds half the gradient of `lambda * E_smooth` at `x`, and gives `E_smooth`.
    pub(crate) fn step(&mut self, x: &[Row], gradient: &mut [Row], lambda: f64) -> f64 {
        let SmoothEnergy { neighbours, weights, rest, rows, l } = self;
        let smoothed = if rest.is_empty() {
            x
        } else {
            for ((l, x), rest) in l.iter_mut().zip(x).zip(&*rest) {
                *l = std::array::from_fn(|i| x[i] - rest[i]);
            }
            l
        };
        for (k, block) in rows.chunks_mut(BLOCK).enumerate() {
            laplace(neighbours, weights, k * BLOCK, smoothed, block);
        }
        let mut energy = [0.0; 3];
        let mut twice = [[0.0; 4]; BLOCK];
        // w_ij = w_ji, so that L^T = L and the gradient is the same gather once more.
        for (k, gradient) in gradient.chunks_mut(BLOCK).enumerate() {
            let twice = &mut twice[..gradient.len()];
            laplace(neighbours, weights, k * BLOCK, rows, twice);
            for ((gradient, twice), row) in gradient.iter_mut().zip(twice).zip(&rows[k * BLOCK..]) {
                for i in 0..3 {
                    energy[i] += row[i] * row[i];
                    gradient[i] += lambda * twice[i];
                }
            }
        }
        energy[0] + energy[1] + energy[2]
    }
}

/// `sum_j w_ij (l_j - l_i)` for each node `i` of a block, the first of which is `first`.
#[inline(never)]
fn laplace(neighbours: &Ragged, weights: &[f64], first: usize, l: &[Row], block: &mut [Row]) {
    let offsets = &neighbours.offsets()[first..=first + block.len()];
    for ((ends, own), to) in offsets.windows(2).zip(&l[first..]).zip(block) {
        let entries = ends[0] as usize..ends[1] as usize;
        let neighbours = &neighbours.indices()[entries.clone()];
        let mut sum = [0.0; 4];
        for (&j, &w) in neighbours.iter().zip(&weights[entries]) {
            let other = l[j as usize];
            for i in 0..4 {
                sum[i] += w * (other[i] - own[i]);
            }
        }
        *to = sum;
    }
}
