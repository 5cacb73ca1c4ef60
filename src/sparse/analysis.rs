//! Symbolic analysis: the permutation, pattern and supernodes, which depend only on the pattern of
//! a symmetric matrix and serve all matrices of that pattern.
//!
//! The order of elimination keeps the fill small: approximate minimum degree (Amestoy, Davis and Duff
//! 1996, by the crate `amd`), then a postorder of the elimination tree, which makes the columns of a
//! supernode consecutive without changing the fill (Davis 2006, section 4.3).

use super::elimination_tree::{elimination_tree, postorder};
use super::matrix::UpperTriangle;
use super::supernodes::Supernodes;
use sprs::{CsMatI, CsStructureI, PermOwnedI};
use std::rc::Rc;

/// Returns the permutation of a symmetric matrix, given by its full pattern with the diagonal:
/// `at(k)` is the row that is eliminated `k`-th, `at_inv` the inverse.
fn elimination_order(structure: &CsStructureI<u32>) -> PermOwnedI<u32> {
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

/// The symbolic analysis of a pattern.
pub(crate) struct SymbolicAnalysis {
    /// The full pattern with its diagonal, in the original order.
    structure: CsStructureI<u32>,
    /// `at(k)` is the unknown that is eliminated `k`-th.
    permutation: PermOwnedI<u32>,
    /// The inverse of the permutation: the position of each unknown in the elimination order.
    position_of: Vec<u32>,
    /// The upper triangle in the elimination order.
    upper: CsStructureI<u32>,
    supernodes: Rc<Supernodes>,
}

impl SymbolicAnalysis {
    /// Orders and analyses a symmetric pattern with its diagonal.
    pub(crate) fn new(structure: CsStructureI<u32>) -> SymbolicAnalysis {
        let permutation = elimination_order(&structure);
        let position_of = permutation.inv_vec();
        let upper = permuted_upper(&structure, &permutation, &position_of);
        let supernodes = Rc::new(Supernodes::new(&upper));
        SymbolicAnalysis { structure, permutation, position_of, upper, supernodes }
    }

    /// Orders and analyses the pattern of `n` unknowns coupled by `edges`, each edge given once.
    pub(crate) fn of_edges(n: usize, edges: impl Iterator<Item = [u32; 2]>) -> SymbolicAnalysis {
        let mut near: Vec<Vec<u32>> = (0..n as u32).map(|v| vec![v]).collect();
        for [i, j] in edges {
            near[i as usize].push(j);
            near[j as usize].push(i);
        }
        let (mut columns, mut rows) = (vec![0], Vec::new());
        for mut row in near {
            row.sort_unstable();
            rows.append(&mut row);
            columns.push(rows.len() as u32);
        }
        let values = vec![(); rows.len()];
        SymbolicAnalysis::new(CsStructureI::new_csc((n, n), columns, rows, values))
    }

    /// Whether this is the analysis of `structure`.
    pub(crate) fn fits(&self, structure: &CsStructureI<u32>) -> bool {
        self.structure == *structure
    }

    /// The number of unknowns.
    pub(crate) fn size(&self) -> usize {
        self.position_of.len()
    }

    /// The unknown that is eliminated `k`-th.
    pub(crate) fn unknown_at(&self, k: usize) -> u32 {
        self.permutation.at(k) as u32
    }

    /// The position of each unknown in the elimination order.
    pub(crate) fn position_of(&self) -> &[u32] {
        &self.position_of
    }

    /// A number for each unknown, in the elimination order, that is shared within a connected
    /// component.
    pub(crate) fn components(&self) -> &[u32] {
        self.supernodes.components()
    }

    /// The supernodes of the factor.
    pub(crate) fn supernodes(&self) -> &Rc<Supernodes> {
        &self.supernodes
    }

    /// Returns a zero matrix of this pattern in the elimination order.
    pub(crate) fn zeros(&self) -> UpperTriangle {
        let columns = self.upper.indptr().raw_storage().to_vec();
        let rows = self.upper.indices().to_vec();
        CsMatI::new_csc(self.upper.shape(), columns, rows, vec![0.0; self.upper.nnz()])
    }
}

/// The upper triangle of `P A P^T`.
fn permuted_upper(
    structure: &CsStructureI<u32>,
    permutation: &PermOwnedI<u32>,
    position_of: &[u32],
) -> CsStructureI<u32> {
    let n = structure.cols();
    let (mut columns, mut rows) = (Vec::with_capacity(n + 1), Vec::new());
    columns.push(0);
    for k in 0..n {
        let first = rows.len();
        let neighbours = &structure.indices()[structure.indptr().outer_inds_sz(permutation.at(k))];
        rows.extend(
            neighbours.iter().map(|&u| position_of[u as usize]).filter(|&u| u as usize <= k),
        );
        rows[first..].sort_unstable();
        columns.push(rows.len() as u32);
    }
    let values = vec![(); rows.len()];
    CsStructureI::new_csc((n, n), columns, rows, values)
}
