//! Fill-reducing order of elimination: approximate minimum degree, then a postorder of the
//! elimination tree, which makes the columns of a supernode consecutive without changing the fill.

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
    let parents = elimination_tree(adjacency, &order);
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

const NONE: u32 = u32::MAX;

/// Liu's algorithm with path compression (Davis, Direct Methods for Sparse Linear Systems, 4.1):
/// the parent of each step of elimination, or `NONE` for a root.
fn elimination_tree(adjacency: &Ragged, order: &[u32]) -> Vec<u32> {
    let n = order.len();
    let step = inverse(order);
    let (mut parents, mut ancestors) = (vec![NONE; n], vec![NONE; n]);
    for k in 0..n as u32 {
        for &u in adjacency.row(order[k as usize] as usize) {
            let mut i = step[u as usize];
            while i < k {
                let next = ancestors[i as usize];
                ancestors[i as usize] = k;
                if next == NONE {
                    parents[i as usize] = k;
                    break;
                }
                i = next;
            }
        }
    }
    parents
}

/// Children before parents, each subtree in one run.
fn postorder(parents: &[u32]) -> Vec<u32> {
    let n = parents.len();
    let (mut first_child, mut next_sibling) = (vec![NONE; n], vec![NONE; n]);
    for v in (0..n as u32).rev() {
        let parent = parents[v as usize];
        if parent != NONE {
            next_sibling[v as usize] = first_child[parent as usize];
            first_child[parent as usize] = v;
        }
    }
    let mut order = Vec::with_capacity(n);
    let mut path = Vec::new();
    for root in (0..n as u32).filter(|&v| parents[v as usize] == NONE) {
        path.push(root);
        while let Some(&v) = path.last() {
            let child = first_child[v as usize];
            if child == NONE {
                path.pop();
                order.push(v);
            } else {
                first_child[v as usize] = next_sibling[child as usize];
                path.push(child);
            }
        }
    }
    order
}
