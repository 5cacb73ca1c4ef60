//! Assembly of the normal matrix `Q^T Q` (Eq. 6, 13) straight into compressed columns.
//!
//! `Q` is never formed. Every energy is a sum of terms that couple a few nodes, and each term adds
//! `diagonal * I + outer * a a^T` to the rows and columns of its nodes: `N_i = I - 1 1^T / n` of a
//! shape constraint, one row of the Laplacian for smoothness, the star of a big constraint.

use crate::mesh::Ragged;
use std::ops::Range;
use std::rc::Rc;

/// Terms of one energy, each `diagonal * I + outer * a a^T` on its nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Terms {
    /// The nodes of each term, distinct.
    nodes: Ragged,
    /// `a`, an entry for each entry of `nodes`.
    a: Vec<f64>,
    /// Two numbers for each term: `diagonal` and `outer`.
    coefficients: Vec<[f64; 2]>,
}

impl Terms {
    /// Adds a term.
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

    /// The same terms with every node `v` called `name[v]`.
    pub fn renumbered(mut self, name: &[u32]) -> Terms {
        self.nodes.rename(name);
        self.nodes.shrink_to_fit();
        self.a.shrink_to_fit();
        self.coefficients.shrink_to_fit();
        self
    }
}

/// For each node, where it occurs among the terms of an energy.
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

/// Where the upper triangle of a symmetric matrix has entries, in compressed columns, rows
/// ascending, diagonal included in every column.
#[derive(Debug, PartialEq)]
pub(super) struct Pattern {
    /// `#nodes + 1`.
    pub columns: Vec<u32>,
    /// Row of each entry.
    pub rows: Vec<u32>,
}

impl Pattern {
    /// From the neighbours of each node (see [`adjacency`]).
    pub(super) fn new(adjacency: &Ragged) -> Pattern {
        let (mut columns, mut rows) = (Vec::with_capacity(adjacency.len() + 1), Vec::new());
        columns.push(0);
        for (v, neighbours) in (0..).zip(adjacency.iter()) {
            rows.extend(neighbours.iter().filter(|&&u| u < v));
            rows.push(v);
            columns.push(rows.len() as u32);
        }
        rows.shrink_to_fit();
        Pattern { columns, rows }
    }

    /// The entries of column `v`, its diagonal last.
    pub(super) fn column(&self, v: usize) -> Range<usize> {
        self.columns[v] as usize..self.columns[v + 1] as usize
    }
}

/// The upper triangle of the normal matrix.
#[derive(Clone, Debug)]
pub(super) struct Normal {
    /// Where its entries are.
    pub pattern: Rc<Pattern>,
    /// Value of each entry.
    pub values: Vec<f64>,
}

impl Normal {
    /// Zeros.
    pub(super) fn new(pattern: Rc<Pattern>) -> Normal {
        Normal { values: vec![0.0; pattern.rows.len()], pattern }
    }

    /// The entry of `v` on the diagonal.
    pub(super) fn diagonal(&mut self, v: usize) -> &mut f64 {
        &mut self.values[self.pattern.columns[v + 1] as usize - 1]
    }
}

/// The pattern of the whole symmetric matrix without its diagonal, as ordering wants it:
/// the neighbours of each node, ascending.
pub(super) fn adjacency(n: usize, energies: &[&Terms]) -> Ragged {
    let occurrences: Vec<_> = energies.iter().map(|terms| Occurrences::new(n, terms)).collect();
    let mut seen = vec![u32::MAX; n];
    let mut column = Vec::new();
    let mut adjacency = Ragged::new();
    for v in 0..n {
        column.clear();
        seen[v] = v as u32;
        for (terms, occurrences) in energies.iter().zip(&occurrences) {
            for &[t, _] in occurrences.of(v) {
                for &u in terms.nodes.row(t as usize) {
                    if seen[u as usize] != v as u32 {
                        seen[u as usize] = v as u32;
                        column.push(u);
                    }
                }
            }
        }
        column.sort_unstable();
        adjacency.push(&column);
    }
    adjacency.shrink_to_fit();
    adjacency
}

/// Assembles and re-assembles the normal matrix in one pattern.
pub(super) struct Assembler {
    energies: Vec<Terms>,
    occurrences: Vec<Occurrences>,
    n: usize,
}

impl Assembler {
    /// For the terms of several energies over `n` nodes.
    pub(super) fn new(n: usize, energies: Vec<Terms>) -> Self {
        let occurrences = energies.iter().map(|terms| Occurrences::new(n, terms)).collect();
        Assembler { energies, occurrences, n }
    }

    /// Replaces `a` of every term of an energy, an entry for each entry of its nodes.
    pub(super) fn set_coefficients(&mut self, energy: usize, a: &[f64]) {
        self.energies[energy].a.copy_from_slice(a);
    }

    /// Fills `normal` with `sum_k scales[k] * energies[k] + diag(diagonal)`.
    ///
    /// A node that is `fixed` is no unknown: its row and column become those of the identity, which
    /// keeps the pattern, so that fixing and releasing needs no new ordering.
    pub(super) fn assemble(
        &self,
        scales: &[f64],
        diagonal: &[f64],
        fixed: &[bool],
        normal: &mut Normal,
    ) {
        let Normal { pattern, values } = normal;
        values.fill(0.0);
        let mut slot = vec![0u32; self.n];
        for v in 0..self.n {
            let entries = pattern.column(v);
            let last = entries.end - 1;
            if fixed[v] {
                values[last] = 1.0;
                continue;
            }
            for k in entries {
                slot[pattern.rows[k] as usize] = k as u32;
            }
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
                        if u as usize <= v && !fixed[u as usize] {
                            values[slot[u as usize] as usize] += factor * terms.a[first + k];
                        }
                    }
                }
            }
        }
    }
}
