//! Assembly of the normal matrix `Q^T Q` (Eq. 6, 13) directly into the compressed columns of a
//! [`sprs::CsMatI`].
//!
//! `Q` is never formed. Every energy is a sum of terms that couple a few nodes. Each term adds
//! `diagonal * I + outer * a a^T` to the rows and columns of its nodes: `N_i = I - 1 1^T / n` of a
//! shape constraint, one row of the Laplacian for smoothness, the star of a big constraint.

use crate::mesh::Ragged;
use crate::sparse::UpperTriangle;
use sprs::CsStructureI;

/// Terms of one energy, each `diagonal * I + outer * a a^T` on its nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Terms {
    /// The nodes of each term, distinct.
    nodes: Ragged,
    /// `a`, one entry for each entry of `nodes`.
    a: Vec<f64>,
    /// `diagonal` and `outer` of each term.
    coefficients: Vec<[f64; 2]>,
}

impl Terms {
    /// Adds a term on distinct `nodes`, with one entry of `a` for each of them.
    pub fn push(
        &mut self,
        nodes: &[u32],
        a: impl IntoIterator<Item = f64>,
        diagonal: f64,
        outer: f64,
    ) {
        self.nodes.push(nodes);
        self.a.extend(a);
        self.coefficients.push([diagonal, outer]);
        debug_assert_eq!(self.a.len(), self.nodes.indices().len(), "one coefficient for each node");
    }

    /// The nodes of each term.
    pub fn nodes(&self) -> &Ragged {
        &self.nodes
    }

    /// Renumbers the nodes: `v` becomes `name[v]`.
    pub fn renumbered(mut self, name: &[u32]) -> Terms {
        self.nodes.rename(name);
        self.nodes.shrink_to_fit();
        self.a.shrink_to_fit();
        self.coefficients.shrink_to_fit();
        self
    }
}

/// The occurrences of each node in the terms of an energy.
struct Occurrences {
    /// `#nodes + 1`.
    offsets: Vec<u32>,
    /// Index of the term, index of the entry.
    entries: Vec<[u32; 2]>,
}

impl Occurrences {
    fn new(n: usize, terms: &Terms) -> Self {
        let mut offsets = vec![0u32; n + 1];
        for &v in terms.nodes.indices() {
            offsets[v as usize + 1] += 1;
        }
        for v in 0..n {
            offsets[v + 1] += offsets[v];
        }
        let mut next = offsets.clone();
        let mut entries = vec![[0; 2]; terms.nodes.indices().len()];
        for t in 0..terms.nodes.len() {
            let first = terms.nodes.offsets()[t];
            for (k, &v) in terms.nodes.row(t).iter().enumerate() {
                entries[next[v as usize] as usize] = [t as u32, first + k as u32];
                next[v as usize] += 1;
            }
        }
        Occurrences { offsets, entries }
    }

    fn of(&self, v: usize) -> &[[u32; 2]] {
        &self.entries[self.offsets[v] as usize..self.offsets[v + 1] as usize]
    }
}

/// Returns the full pattern, with its diagonal, of the normal matrix of some energies over `n`
/// nodes.
pub(super) fn structure(n: usize, energies: &[&Terms]) -> CsStructureI<u32> {
    let occurrences: Vec<_> = energies.iter().map(|terms| Occurrences::new(n, terms)).collect();
    let mut seen = vec![u32::MAX; n];
    let (mut columns, mut rows) = (Vec::with_capacity(n + 1), Vec::new());
    columns.push(0);
    for v in 0..n {
        let first = rows.len();
        rows.push(v as u32);
        seen[v] = v as u32;
        for (terms, occurrences) in energies.iter().zip(&occurrences) {
            for &[t, _] in occurrences.of(v) {
                for &u in terms.nodes.row(t as usize) {
                    if seen[u as usize] != v as u32 {
                        seen[u as usize] = v as u32;
                        rows.push(u);
                    }
                }
            }
        }
        rows[first..].sort_unstable();
        columns.push(rows.len() as u32);
    }
    rows.shrink_to_fit();
    let values = vec![(); rows.len()];
    CsStructureI::new_csc((n, n), columns, rows, values)
}

/// Assembles the normal matrix repeatedly in one pattern.
pub(super) struct Assembler {
    energies: Vec<Terms>,
    occurrences: Vec<Occurrences>,
    n: usize,
    /// `#nodes`: whether the node is decoupled from the nodes that are not.
    is_decoupled: Vec<bool>,
}

impl Assembler {
    /// Creates an assembler for the terms of several energies over `n` nodes.
    pub(super) fn new(n: usize, energies: Vec<Terms>) -> Self {
        let occurrences = energies.iter().map(|terms| Occurrences::new(n, terms)).collect();
        Assembler { energies, occurrences, n, is_decoupled: vec![false; n] }
    }

    /// Decouples these nodes: entries between them and other nodes become zero.
    pub(super) fn decouple(&mut self, nodes: impl Iterator<Item = u32>) {
        nodes.for_each(|node| self.is_decoupled[node as usize] = true);
    }

    /// `#nodes`: which nodes are decoupled.
    pub(super) fn is_decoupled(&self) -> &[bool] {
        &self.is_decoupled
    }

    /// Replaces `a` of every term of an energy, one entry for each entry of its nodes.
    #[cfg(feature = "cli")]
    pub(super) fn set_coefficients(&mut self, energy: usize, a: &[f64]) {
        self.energies[energy].a.copy_from_slice(a);
    }

    /// Fills `normal` with `sum_k scales[k] * energies[k] + diag(diagonal)`.
    ///
    /// A node marked `fixed` is not an unknown: its row and column become those of the identity.
    /// The pattern stays, so that fixing and releasing need no new ordering.
    pub(super) fn assemble(
        &self,
        scales: &[f64],
        diagonal: &[f64],
        fixed: &[bool],
        normal: &mut UpperTriangle,
    ) {
        normal.data_mut().fill(0.0);
        let mut slot = vec![0u32; self.n];
        for v in 0..self.n {
            let entries = normal.indptr().outer_inds_sz(v);
            let last = entries.end - 1;
            if fixed[v] {
                normal.data_mut()[last] = 1.0;
                continue;
            }
            for k in entries {
                slot[normal.indices()[k] as usize] = k as u32;
            }
            let values = normal.data_mut();
            values[last] = diagonal[v];
            for ((terms, occurrences), &scale) in
                self.energies.iter().zip(&self.occurrences).zip(scales)
            {
                for &[t, entry] in occurrences.of(v) {
                    let [on_diagonal, outer] = terms.coefficients[t as usize];
                    values[last] += scale * on_diagonal;
                    let factor = scale * outer * terms.a[entry as usize];
                    let first = terms.nodes.offsets()[t as usize] as usize;
                    for (k, &u) in terms.nodes.row(t as usize).iter().enumerate() {
                        let couples = !fixed[u as usize]
                            && self.is_decoupled[u as usize] == self.is_decoupled[v];
                        if u as usize <= v && couples {
                            values[slot[u as usize] as usize] += factor * terms.a[first + k];
                        }
                    }
                }
            }
        }
    }
}
