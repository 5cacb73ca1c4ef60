//! The linear system of the global step: `Q^T Q` in the order of elimination, and its factor.

use super::assemble::{Assembler, Normal, Terms, adjacency};
use super::factor::Factor;
use super::order::{elimination_order, inverse};
use super::{SolveError, clock};
use crate::constraint::Row;
use crate::mesh::{Ragged, components};

/// Seconds that setting up took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SetUpSeconds {
    /// Terms, batches and the normal matrix.
    pub assemble: f64,
    /// The order of elimination.
    pub order: f64,
    /// The last factorisation.
    pub factor: f64,
}

/// The normal matrix over vertices and extra unknowns, called nodes once they are in the order of
/// elimination: everything that iterates is numbered by node, so that no step permutes.
pub struct System {
    order: Vec<u32>,
    node_of: Vec<u32>,
    /// The connected part of each node.
    parts: Vec<u32>,
    assembler: Assembler,
    normal: Normal,
    factor: Option<Factor>,
    /// Of each node: whether it is no unknown.
    fixed: Vec<bool>,
    /// What setting up took.
    pub seconds: SetUpSeconds,
}

impl System {
    /// Orders the nodes of the given terms, of which there are `n`.
    pub fn new(n: usize, energies: &[Terms]) -> System {
        let started = clock::now();
        let all: Vec<&Terms> = energies.iter().collect();
        let pattern = adjacency(n, &all);
        let patterned = clock::now();
        let order = elimination_order(&pattern);
        let node_of = inverse(&order);
        let ordered = clock::now();

        let energies: Vec<Terms> = all.iter().map(|terms| terms.renumbered(&node_of)).collect();
        let parts = components(n, energies.iter().flat_map(|terms| terms.nodes().iter()));
        let assembler = Assembler::new(n, energies);
        let normal = assembler.pattern(&renumbered(&pattern, &order, &node_of));
        let seconds = SetUpSeconds {
            assemble: patterned - started + clock::now() - ordered,
            order: ordered - patterned,
            factor: 0.0,
        };
        let fixed = vec![false; n];
        System { order, node_of, parts, assembler, normal, factor: None, fixed, seconds }
    }

    /// The node of each vertex, then of each extra unknown.
    pub fn node_of(&self) -> &[u32] {
        &self.node_of
    }

    /// The connected part of each node.
    pub fn parts(&self) -> &[u32] {
        &self.parts
    }

    /// Nodes that are unknowns.
    pub fn unknowns(&self) -> usize {
        self.fixed.iter().filter(|fixed| !**fixed).count()
    }

    /// Nonzeros of the factor.
    pub fn factor_nonzeros(&self) -> usize {
        self.factor.as_ref().map_or(0, Factor::nonzeros)
    }

    /// Assembles `sum_k scales[k] * energies[k] + diag(diagonal)` and factors it. Nodes that are
    /// `fixed` are no unknowns. The pattern and the order stay.
    ///
    /// # Errors
    /// When it is not positive definite. The system is then not usable before it was factored again.
    pub fn factor(
        &mut self,
        scales: &[f64],
        diagonal: &[f64],
        fixed: Vec<bool>,
    ) -> Result<(), SolveError> {
        let started = clock::now();
        self.assembler.assemble(scales, diagonal, &fixed, &mut self.normal);
        self.fixed = fixed;
        let assembled = clock::now();
        self.seconds.assemble += assembled - started;
        match &mut self.factor {
            Some(factor) => factor.update(&self.normal),
            None => Factor::new(&self.normal).map(|factor| self.factor = Some(factor)),
        }
        .map_err(|singular| SolveError::NotPositiveDefinite {
            vertex: self.order[singular.column],
        })?;
        self.seconds.factor = clock::now() - assembled;
        Ok(())
    }

    /// Step II: applies the inverse of the normal matrix to `right` in place.
    pub fn solve(&self, right: &mut [Row]) {
        self.factor.as_ref().expect("a system is factored before it is solved").solve(right);
    }

    /// Clears the rows of nodes that are no unknowns.
    pub fn clear_fixed(&self, gradient: &mut [Row]) {
        for (row, &fixed) in gradient.iter_mut().zip(&self.fixed) {
            if fixed {
                *row = [0.0; 4];
            }
        }
    }
}

/// The pattern with every node in its place in the order of elimination.
fn renumbered(pattern: &Ragged, order: &[u32], node_of: &[u32]) -> Ragged {
    let mut row = Vec::new();
    let mut renumbered = Ragged::new();
    for &v in order {
        row.clear();
        row.extend(pattern.row(v as usize).iter().map(|&u| node_of[u as usize]));
        row.sort_unstable();
        renumbered.push(&row);
    }
    renumbered
}
