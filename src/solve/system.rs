//! The linear system of the global step: `Q^T Q` in the order of elimination, and its factor.

use super::accelerate::Iterate;
use super::assemble::{Assembler, Normal, Terms, adjacency};
use super::factor::{Factor, Precision};
use super::metric::Metric;
use super::order::{elimination_order, inverse};
use super::panels::Panels;
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
    /// The nodes that are no unknowns.
    fixed: Vec<u32>,
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
        let fixed = Vec::new();
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
        self.order.len() - self.fixed.len()
    }

    /// Nonzeros of the factor.
    pub fn factor_nonzeros(&self) -> usize {
        self.factor.as_ref().map_or(0, Factor::nonzeros)
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
        let started = clock::now();
        self.assembler.assemble(scales, diagonal, &fixed, &mut self.normal);
        self.fixed = (0..).zip(fixed).filter(|(_, fixed)| *fixed).map(|(node, _)| node).collect();
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

    /// Fills what [`System::plain_step`] or [`System::metric`] needs, which they would do themselves.
    pub(super) fn prepare(&mut self, precision: Precision) {
        let started = clock::now();
        match precision {
            Precision::Single => _ = self.metric(),
            Precision::Double => _ = self.double(),
        }
        self.seconds.factor += clock::now() - started;
    }

    /// The inverse of the normal matrix in single precision.
    pub(super) fn metric(&mut self) -> &Metric {
        self.factor.as_mut().expect(FACTORED).single(&self.fixed)
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
        self.factor.as_mut().expect(FACTORED).double()
    }

    /// Clears the rows of nodes that are no unknowns.
    pub fn clear_fixed(&self, gradient: &mut [Row]) {
        self.fixed.iter().for_each(|&node| gradient[node as usize] = [0.0; 4]);
    }
}

const FACTORED: &str = "a system is factored before it is solved";

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

#[cfg(test)]
mod tests {
    use super::super::metric::round;
    use super::*;
    use nalgebra::{DMatrix, DVector};
    use proptest::prelude::*;

    /// Terms over `n` nodes: what they add to a dense matrix, and themselves.
    fn dense(n: usize, terms: &[(Vec<u32>, f64, f64)], diagonal: &[f64]) -> (DMatrix<f64>, Terms) {
        let mut matrix = DMatrix::from_diagonal(&DVector::from_column_slice(diagonal));
        let mut sparse = Terms::default();
        for (nodes, on_diagonal, outer) in terms {
            let a: Vec<f64> = nodes.iter().map(|&v| 1.0 + f64::from(v) / n as f64).collect();
            for (i, &u) in nodes.iter().enumerate() {
                matrix[(u as usize, u as usize)] += on_diagonal;
                for (j, &v) in nodes.iter().enumerate() {
                    matrix[(u as usize, v as usize)] += outer * a[i] * a[j];
                }
            }
            sparse.push(nodes, a, *on_diagonal, *outer);
        }
        (matrix, sparse)
    }

    fn right_side(n: usize) -> Vec<Row> {
        (0..n).map(|i| std::array::from_fn(|k| ((i * 7 + k * 3) % 11) as f64 - 5.0)).collect()
    }

    /// `system.solve` against a dense solution of the rows and columns that are not fixed.
    fn check(system: &mut System, matrix: &DMatrix<f64>, fixed: &[bool]) {
        let n = fixed.len();
        let mut rows = right_side(n);
        for (row, _) in rows.iter_mut().zip(fixed).filter(|(_, fixed)| **fixed) {
            *row = [0.0; 4];
        }
        let mut reduced = matrix.clone();
        for v in (0..n).filter(|&v| fixed[v]) {
            reduced.fill_row(v, 0.0);
            reduced.fill_column(v, 0.0);
            reduced[(v, v)] = 1.0;
        }
        let mut by_node = vec![[0.0; 4]; n];
        for (v, &node) in system.node_of().iter().enumerate() {
            by_node[node as usize] = rows[v];
        }
        let (zeros, scale) = (vec![[0.0; 4]; n], Metric::scale(&by_node));
        let mut single = vec![[0.0; 4]; n];
        round(&mut single, &by_node, scale);
        let mut by_metric = vec![[0.0; 4]; n];
        let metric = system.metric();
        metric.solve(&mut single);
        metric.subtract_step(&mut by_metric, &zeros, &single, scale);
        system.double().solve(&mut by_node);
        let dense = reduced.cholesky().expect("the matrix is positive definite");
        for k in 0..4 {
            let expected = dense.solve(&DVector::from_fn(n, |v, _| rows[v][k]));
            for v in 0..n {
                let node = system.node_of()[v] as usize;
                for (found, tolerance) in [(by_node[node][k], 1e-9), (-by_metric[node][k], 1e-3)] {
                    assert!(
                        (found - expected[v]).abs() <= tolerance * expected.amax().max(1.0),
                        "unknown {v}: {found} is not {}",
                        expected[v]
                    );
                }
            }
        }
    }

    fn any_terms() -> impl Strategy<Value = (usize, Vec<(Vec<u32>, f64, f64)>)> {
        (2usize..60).prop_flat_map(|n| {
            let nodes = proptest::collection::btree_set(0..n as u32, 1..n.min(7));
            let term = (nodes, 0.0..2.0, 0.0..3.0).prop_map(|(nodes, diagonal, outer)| {
                (nodes.into_iter().collect(), diagonal, outer)
            });
            (Just(n), proptest::collection::vec(term, 0..80))
        })
    }

    proptest! {
        #[test]
        fn solves_what_a_dense_factor_solves(
            (n, terms) in any_terms(),
            weight in 0.1..10.0,
            fixed in proptest::collection::vec(any::<bool>(), 60),
        ) {
            let (matrix, sparse) = dense(n, &terms, &vec![weight; n]);
            let mut system = System::new(n, &[sparse]);
            let fixed = &fixed[..n];
            let by_node = |fixed: &[bool]| {
                let mut by_node = vec![false; n];
                fixed.iter().zip(system.node_of()).for_each(|(&f, &node)| by_node[node as usize] = f);
                by_node
            };
            let (some_fixed, none_fixed) = (by_node(fixed), vec![false; n]);
            system.factor(&[1.0], &vec![weight; n], some_fixed.clone()).expect("positive definite");
            check(&mut system, &matrix, fixed);
            // Other values in the same pattern, and back.
            system.factor(&[1.0], &vec![weight; n], none_fixed).expect("positive definite");
            check(&mut system, &matrix, &vec![false; n]);
            system.factor(&[1.0], &vec![weight; n], some_fixed).expect("positive definite");
            check(&mut system, &matrix, fixed);
        }
    }

    #[test]
    fn names_a_vertex_where_the_matrix_is_singular() {
        // Two parts that only hold themselves together: constants are in the kernel, and rounding
        // leaves a pivot that is tiny and not zero.
        let mut terms = Terms::default();
        for nodes in [[0, 1, 2, 3], [4, 5, 6, 7]] {
            terms.push(&nodes, [1.0; 4], 0.3, -0.3 / 4.0);
        }
        let mut system = System::new(8, &[terms]);
        let free = vec![false; 8];
        let error = system.factor(&[1.0], &[0.0; 8], free.clone()).expect_err("it is singular");
        let SolveError::NotPositiveDefinite { vertex } = error else { panic!("{error}") };
        assert!(vertex < 8);
        let parts = system.parts();
        assert_ne!(parts[system.node_of()[0] as usize], parts[system.node_of()[4] as usize]);
    }
}
