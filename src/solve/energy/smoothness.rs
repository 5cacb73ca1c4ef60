//! `E_smooth` (Eq. 12): the Laplacian of the surface or of its displacement.

use crate::constraint::Row;
use crate::mesh::{Laplacian, Ragged};
use crate::solve::assemble::Terms;

/// Number of nodes per call of `laplace`: V8 replaces wasm functions by optimised code only between
/// calls.
const BLOCK: usize = 64;

/// A row with more neighbours is in the metric as [`springs`]: it would couple each with all others,
/// which a cap of many thousand triangles about one vertex has no memory for.
const MOST_COUPLED: usize = 1000;

/// The terms of `L^T L` over vertices: one for each row `sum_j w_ij (l_j - l_i)`.
pub(crate) fn terms(laplacian: &Laplacian) -> Terms {
    let mut terms = Terms::default();
    let mut nodes = Vec::new();
    for (i, (neighbours, weights)) in laplacian.rows().enumerate() {
        if neighbours.len() > MOST_COUPLED {
            push_springs(i as u32, (neighbours, weights), &mut terms);
            continue;
        }
        nodes.clear();
        nodes.push(i as u32);
        nodes.extend_from_slice(neighbours);
        let own = -weights.iter().sum::<f64>();
        terms.push(&nodes, std::iter::once(own).chain(weights.iter().copied()), 0.0, 1.0);
    }
    terms
}

/// Springs along edges that are at least as stiff as `L^T L`, by the inequality of Cauchy and
/// Schwarz for each of its rows. They couple only neighbours. `L^T L` also couples neighbours of
/// neighbours: on a mesh of quads its factor has twice the nonzeros, and takes four times as long.
pub(crate) fn springs(laplacian: &Laplacian) -> Terms {
    let mut terms = Terms::default();
    (0..).zip(laplacian.rows()).for_each(|(i, row)| push_springs(i, row, &mut terms));
    terms
}

fn push_springs(i: u32, (neighbours, weights): (&[u32], &[f64]), terms: &mut Terms) {
    let sum: f64 = weights.iter().map(|weight| weight.abs()).sum();
    for (&j, weight) in neighbours.iter().zip(weights) {
        terms.push(&[i, j], [1.0, -1.0], 0.0, sum * weight.abs());
    }
}

/// The Laplacian in the elimination order.
pub(crate) struct SmoothEnergy {
    neighbours: Ragged,
    /// `w_ij`, aligned with `neighbours`.
    weights: Vec<f64>,
    /// `v'` if displacements are smoothed, empty if positions are.
    rest: Vec<Row>,
    /// `sum_j w_ij (l_j - l_i)` of each node.
    rows: Vec<Row>,
    l: Vec<Row>,
}

impl SmoothEnergy {
    /// `node_of` is the node of each vertex, of `n_nodes`; `rest` is empty or the rest positions.
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

    /// Adds half the gradient of `lambda * E_smooth` at `x`, and returns `E_smooth`.
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
        // w_ij = w_ji, so that L^T = L, and the gradient is the same gather once more.
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

/// `sum_j w_ij (l_j - l_i)` for each node `i` of a block, from node `first` on.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Topology, read};
    use crate::solve::system::System;

    /// `x^T A x` of the matrix of some terms.
    fn quadratic(terms: Terms, x: &[f64]) -> f64 {
        let system = System::new(x.len(), vec![terms]);
        let matrix = system.values(&[1.0], &vec![0.0; x.len()], &vec![false; x.len()]);
        let mut by_node = vec![0.0; x.len()];
        system.node_of().iter().zip(x).for_each(|(&node, &value)| by_node[node as usize] = value);
        let entries = matrix.iter().map(|(&value, (row, column))| {
            let times = if row == column { 1.0 } else { 2.0 };
            times * value * by_node[row as usize] * by_node[column as usize]
        });
        entries.sum()
    }

    #[test]
    fn springs_are_at_least_as_stiff_as_smoothness() {
        let obj = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1.2 .9 .3\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0\n\
            f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 4 5 8\nf 4 8 7\nf 5 6 9\nf 5 9 8\n";
        let mesh = read("grid.obj", obj.as_bytes()).expect("it is a mesh").mesh;
        let topology = Topology::new(&mesh);
        for laplacian in [Laplacian::uniform(&topology), Laplacian::cotangent(&mesh, &topology)] {
            for k in 0..50_u32 {
                let entry = |v: u32| f64::from((v * v * 7 + v * k * 3 + k) % 11) - 5.0;
                let x: Vec<f64> = (0..9).map(entry).collect();
                let (of_springs, smooth) =
                    (quadratic(springs(&laplacian), &x), quadratic(terms(&laplacian), &x));
                assert!(of_springs >= smooth * (1.0 - 1e-12), "{of_springs}, {smooth}");
            }
            let still = quadratic(springs(&laplacian), &[1.0; 9]);
            assert!(still.abs() < 1e-12, "what moves as one costs nothing");
        }
    }
}
