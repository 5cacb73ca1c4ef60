//! Fill-reducing order of elimination: approximate minimum degree, then a postorder of the
//! elimination tree, which makes the columns of a supernode consecutive without changing the fill.

use super::elimination_tree::{elimination_tree, postorder};
use crate::mesh::Ragged;

/// The order of elimination of a matrix with this symmetric pattern: `order[k]` is the node that
/// is eliminated `k`-th. `adjacency` holds the neighbours of each node, ascending, without itself.
pub(super) fn elimination_order(adjacency: &Ragged) -> Vec<u32> {
    let n = adjacency.len();
    if n == 0 {
        return Vec::new();
    }
    // With the diagonal, which the crate counts on without saying so.
    let (mut columns, mut rows) = (vec![0], Vec::new());
    for (v, neighbours) in adjacency.iter().enumerate() {
        let (below, above) = neighbours.split_at(neighbours.partition_point(|&u| u < v as u32));
        rows.extend(below.iter().map(|&u| u as i32));
        rows.push(v as i32);
        rows.extend(above.iter().map(|&u| u as i32));
        columns.push(rows.len() as i32);
    }
    let (order, _, _) = amd::order(n as i32, &columns, &rows, &amd::Control::default())
        .expect("the pattern is valid: columns are sorted and in range");
    let order: Vec<u32> = order.iter().map(|&v| v as u32).collect();
    let step = inverse(&order);
    let parents =
        elimination_tree(n, |k| adjacency.row(order[k] as usize).iter().map(|&u| step[u as usize]));
    postorder(&parents).into_iter().map(|k| order[k as usize]).collect()
}

/// The inverse of a permutation.
pub(super) fn inverse(order: &[u32]) -> Vec<u32> {
    let mut inverse = vec![0; order.len()];
    for (k, &v) in order.iter().enumerate() {
        inverse[v as usize] = k as u32;
    }
    inverse
}
