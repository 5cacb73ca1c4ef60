//! The fill-reducing order of elimination: approximate minimum degree (Amestoy, Davis and Duff 1996, by
//! the crate `amd`), then a postorder of the elimination tree, which makes the columns of a supernode
//! consecutive without changing the fill (Davis 2006, section 4.3).

use super::elimination_tree::{elimination_tree, postorder};
use sprs::{CsStructureI, PermOwnedI};

/// Returns the permutation of a symmetric matrix, given by its full pattern with the diagonal:
/// `at(k)` is the row that is eliminated `k`-th, `at_inv` the inverse.
pub(crate) fn elimination_order(structure: &CsStructureI<u32>) -> PermOwnedI<u32> {
    let n = structure.cols();
    if n == 0 {
        return PermOwnedI::new(Vec::new());
    }
    let signed = |indices: &[u32]| indices.iter().map(|&i| i as i32).collect::<Vec<i32>>();
    let (columns, rows) = (signed(structure.indptr().raw_storage()), signed(structure.indices()));
    let (order, _, _) = amd::order(n as i32, &columns, &rows, &amd::Control::default())
        .expect("the pattern is valid: columns are sorted and in range");
    let order: Vec<u32> = order.iter().map(|&v| v as u32).collect();
    let mut step = vec![0; n];
    (0..).zip(&order).for_each(|(k, &v)| step[v as usize] = k);
    let parents = elimination_tree(n, |k| {
        let rows = structure.indptr().outer_inds_sz(order[k] as usize);
        structure.indices()[rows].iter().map(|&u| step[u as usize])
    });
    PermOwnedI::new(postorder(&parents).into_iter().map(|k| order[k as usize]).collect())
}
