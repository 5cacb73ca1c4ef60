//! The linear system of the global step: `Q^T Q` in the order of elimination, and its factor.

use super::accelerate::Iterate;
use super::assemble::{Assembler, Normal, Terms, adjacency};
use super::factor::{Factor, Precision};
use super::metric::Metric;
use super::ordered::Ordered;
use super::panels::Panels;
use super::rank_one::Change;
use super::{SolveError, clock};
use crate::constraint::Row;
use crate::scene::Factorization;
use std::rc::Rc;

/// Seconds that setting up took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SetUpSeconds {
    /// Terms, batches and the normal matrix.
    pub assemble: f64,
    /// The order of elimination, and the symbolic analysis; nearly nothing where those at hand fit.
    pub order: f64,
    /// The last factorisation.
    pub factor: f64,
}

/// The normal matrix over vertices and extra unknowns, called nodes once they are in the order of
/// elimination: everything that iterates is numbered by node, so that no step permutes.
pub struct System {
    ordered: Rc<Ordered>,
    assembler: Assembler,
    normal: Normal,
    factor: Factor,
    /// The nodes that are no unknowns.
    fixed: Vec<u32>,
    /// What setting up took.
    pub seconds: SetUpSeconds,
}

impl System {
    /// Orders the nodes of the given terms, of which there are `n`.
    pub fn new(n: usize, energies: Vec<Terms>) -> System {
        System::with_order(n, energies, Factorization::default(), None)
    }

    /// The same, with the order at hand where that is one of the same pattern.
    pub(super) fn with_order(
        n: usize,
        energies: Vec<Terms>,
        factorization: Factorization,
        at_hand: Option<&Rc<Ordered>>,
    ) -> System {
        let started = clock::now();
        let all: Vec<&Terms> = energies.iter().collect();
        let adjacency = adjacency(n, &all);
        let patterned = clock::now();
        let ordered = match at_hand.filter(|at_hand| at_hand.fits(&adjacency)) {
            Some(fitting) => Rc::clone(fitting),
            None => Rc::new(Ordered::new(adjacency)),
        };
        let arranged = clock::now();

        let renumbered = energies.into_iter().map(|terms| terms.renumbered(&ordered.node_of));
        let energies = renumbered.collect();
        let assembler = Assembler::new(n, energies);
        let normal = Normal::new(Rc::clone(&ordered.pattern));
        let factor = Factor::new(Rc::clone(&ordered.symbolic), factorization);
        let seconds = SetUpSeconds {
            assemble: patterned - started + clock::now() - arranged,
            order: arranged - patterned,
            factor: 0.0,
        };
        System { ordered, assembler, normal, factor, fixed: Vec::new(), seconds }
    }

    /// The order of elimination, for other systems of the same pattern.
    pub(super) fn ordered(&self) -> &Rc<Ordered> {
        &self.ordered
    }

    /// The node of each vertex, then of each extra unknown.
    pub fn node_of(&self) -> &[u32] {
        &self.ordered.node_of
    }

    /// The connected part of each node.
    pub fn parts(&self) -> &[u32] {
        &self.ordered.parts
    }

    /// Nodes that are unknowns.
    pub fn unknowns(&self) -> usize {
        self.ordered.order.len() - self.fixed.len()
    }

    /// Nonzeros of the factor.
    pub fn factor_nonzeros(&self) -> usize {
        self.factor.nonzeros()
    }

    /// Replaces `a` of every term of an energy, an entry for each entry of its nodes, as they were pushed:
    /// where terms are linear pieces of something that is not. Takes effect with the next factor.
    pub(crate) fn set_coefficients(&mut self, energy: usize, a: &[f64]) {
        self.assembler.set_coefficients(energy, a);
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
        self.factor_for(Precision::Double, scales, diagonal, fixed)
    }

    /// The same, to be solved with this precision. Another one is made when it is asked for.
    ///
    /// # Errors
    /// As [`System::factor`].
    pub(super) fn factor_for(
        &mut self,
        precision: Precision,
        scales: &[f64],
        diagonal: &[f64],
        fixed: Vec<bool>,
    ) -> Result<(), SolveError> {
        let started = clock::now();
        self.assembler.assemble(scales, diagonal, &fixed, &mut self.normal);
        self.fixed = (0..).zip(fixed).filter(|(_, fixed)| *fixed).map(|(node, _)| node).collect();
        let assembled = clock::now();
        self.seconds.assemble += assembled - started;
        self.factor.factor(&self.normal, &self.fixed, precision).map_err(|singular| {
            SolveError::NotPositiveDefinite { vertex: self.ordered.order[singular.column] }
        })?;
        self.seconds.factor = clock::now() - assembled;
        Ok(())
    }

    /// Holds some more nodes without factoring anew. False where that cannot be: nothing has
    /// changed then.
    pub(super) fn change(&mut self, changes: &[(u32, Change)]) -> bool {
        let started = clock::now();
        if !self.factor.changes() {
            return false;
        }
        for &(node, change) in changes {
            match change {
                Change::Weight(weight) => *self.normal.diagonal(node as usize) += weight,
                Change::Fix => {
                    let column = self.normal.pattern.column(node as usize);
                    self.normal.values[column].fill(0.0);
                    let below = self.ordered.symbolic.lower(node as usize);
                    below.for_each(|(_, place)| self.normal.values[place as usize] = 0.0);
                    *self.normal.diagonal(node as usize) = 1.0;
                    self.fixed.push(node);
                }
            }
            self.factor.change(node, change);
        }
        self.seconds.factor = clock::now() - started;
        true
    }

    /// The inverse of the normal matrix in single precision.
    pub(super) fn metric(&mut self) -> &Metric {
        self.factor.single(&self.normal, &self.fixed)
    }

    /// Step II: from `now` to the positions `to`, in double precision.
    pub(super) fn plain_step(&mut self, now: Iterate<'_>, to: &mut [Row]) {
        to.copy_from_slice(now.gradient);
        self.solve(to);
        for (to, x) in to.as_flattened_mut().iter_mut().zip(now.x.as_flattened()) {
            *to = x - *to;
        }
    }

    /// Applies the inverse of the normal matrix to `right` in place, in double precision.
    pub(crate) fn solve(&mut self, right: &mut [Row]) {
        self.double().solve(right);
    }

    fn double(&mut self) -> &Panels<f64> {
        self.factor.double(&self.normal, &self.fixed)
    }

    /// Clears the rows of nodes that are no unknowns.
    pub fn clear_fixed(&self, gradient: &mut [Row]) {
        self.fixed.iter().for_each(|&node| gradient[node as usize] = [0.0; 4]);
    }
}

#[cfg(test)]
mod tests;
