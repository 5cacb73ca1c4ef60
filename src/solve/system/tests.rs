//! Tests of the linear system against dense ones.

use super::*;
use crate::sparse::{round, supernodal_factor};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

/// Returns the dense matrix of some terms over `n` nodes, and the terms.
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

/// Checks `system.solve` against a dense solution of the rows and columns that are not fixed.
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
    let (zeros, scale) = (vec![[0.0; 4]; n], F32Factor::scale(&by_node));
    let mut single = vec![[0.0; 4]; n];
    round(&mut single, &by_node, scale);
    let mut by_metric = vec![[0.0; 4]; n];
    let metric = system.f32_factor();
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
        let term = (nodes, 0.0..2.0, 0.0..3.0)
            .prop_map(|(nodes, diagonal, outer)| (nodes.into_iter().collect(), diagonal, outer));
        (Just(n), proptest::collection::vec(term, 0..80))
    })
}

const FACTORIZATIONS: [Factorization; 2] = [Factorization::Supernodal, Factorization::SprsLdl];

proptest! {
    #[test]
    fn solves_what_a_dense_factor_solves(
        (n, terms) in any_terms(),
        weight in 0.1..10.0,
        fixed in proptest::collection::vec(any::<bool>(), 60),
    ) {
        let (matrix, sparse) = dense(n, &terms, &vec![weight; n]);
        for factorization in FACTORIZATIONS {
            let mut system = System::with_order([n, n], vec![sparse.clone()], factorization, None);
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
    fn holding_more_nodes_is_factoring_again(
        (n, terms) in any_terms(),
        weight in 0.1..10.0,
        held in proptest::collection::vec((0usize..60, proptest::option::of(1e-6..1e6)), 1..12),
    ) {
        for factorization in FACTORIZATIONS {
        let (mut matrix, sparse) = dense(n, &terms, &vec![weight; n]);
        let mut system = System::with_order([n, n], vec![sparse], factorization, None);
        system.factor(&[1.0], &vec![weight; n], vec![false; n]).expect("positive definite");
        system.f32_factor();
        let mut fixed = vec![false; n];
        for (v, weight) in held.iter().copied().filter(|&(v, _)| v < n) {
            if fixed[v] {
                continue;
            }
            let update = match weight {
                Some(weight) => {
                    matrix[(v, v)] += weight;
                    Update::Weight(weight)
                }
                None => {
                    fixed[v] = true;
                    Update::Fix
                }
            };
            assert!(system.update(&[(system.node_of()[v], update)]));
        }
        // First the updated factors in both precisions, then new ones computed from the updated
        // matrix.
        check(&mut system, &matrix, &fixed);
        let mut again = Factor::new(Rc::clone(system.analysis.supernodes()), factorization);
        again.factor(&system.normal, &system.matrix.fixed, Precision::Double).expect("positive definite");
        system.factor = again;
        check(&mut system, &matrix, &fixed);
        }
    }

    #[test]
    fn a_matrix_that_was_left_upwards_is_come_back_to_without_factoring(
        (n, terms) in any_terms(),
        added in proptest::collection::vec((any::<bool>(), 0.0..1e3), 60),
    ) {
        for factorization in FACTORIZATIONS {
        let (matrix, sparse) = dense(n, &terms, &vec![1.0; n]);
        let mut system = System::with_order([n, n], vec![sparse], factorization, None);
        let free = vec![false; n];
        system.factor(&[1.0], &vec![1.0; n], free.clone()).expect("positive definite");
        let solution = |system: &mut System| {
            let mut rows = right_side(n);
            system.solve(&mut rows);
            rows
        };
        let before = solution(&mut system);
        let fixed: Vec<bool> = added[..n].iter().map(|(fixed, _)| *fixed).collect();
        let more: Vec<f64> = added[..n].iter().map(|(_, weight)| 1.0 + weight).collect();
        for (diagonal, fixed) in [(&more, &free), (&more, &fixed), (&vec![1.0; n], &vec![true; n])] {
            system.set_matrix(Precision::Double, &[1.0], diagonal, fixed.clone()).expect("it is above");
            let is_other = *diagonal != vec![1.0; n] || *fixed != free;
            assert_eq!(system.state, if is_other { State::Regular } else { State::Factored });
            system.prepare().expect("positive definite");
            let mut expected = matrix.clone();
            let mut by_vertex = free.clone();
            for (v, &node) in system.node_of().iter().enumerate() {
                expected[(v, v)] += diagonal[node as usize] - 1.0;
                by_vertex[v] = fixed[node as usize];
            }
            check(&mut system, &expected, &by_vertex);
        }
        system.set_matrix(Precision::Double, &[1.0], &vec![1.0; n], free).expect("it was before");
        assert_eq!(system.state, State::Factored);
        assert_eq!(solution(&mut system), before, "the same factor, bit by bit");
        }
    }

    #[test]
    fn a_known_order_serves_systems_of_its_pattern((n, terms) in any_terms(), weight in 0.1..10.0) {
        let (_, sparse) = dense(n, &terms, &vec![0.0; n]);
        let other: Vec<_> =
            terms.iter().map(|(nodes, diagonal, outer)| (nodes.clone(), 2.0 * diagonal, outer + 1.0)).collect();
        let (matrix, other) = dense(n, &other, &vec![weight; n]);
        let kept = Rc::clone(System::new(n, vec![sparse]).analysis());
        let mut system = System::with_order([n, n], vec![other], Factorization::default(), Some(&kept));
        assert!(Rc::ptr_eq(&kept, system.analysis()), "the pattern is the same");
        system.factor(&[1.0], &vec![weight; n], vec![false; n]).expect("positive definite");
        check(&mut system, &matrix, &vec![false; n]);
        let mut chain = Terms::default();
        (1..n as u32).for_each(|v| chain.push(&[v - 1, v], [1.0, -1.0], 0.0, 1.0));
        chain.push(&[0, n as u32 - 1], [1.0; 2], 0.0, 1.0);
        let fits = kept.fits(&structure(n, &[&chain]));
        let system = System::with_order([n, n], vec![chain], Factorization::default(), Some(&kept));
        assert_eq!(fits, Rc::ptr_eq(&kept, system.analysis()));
    }
}

/// `L` and `D` by sprs-ldl, and the pattern of the whole lower triangle.
fn reference(normal: &UpperTriangle) -> (Vec<Vec<(u32, f64)>>, Vec<f64>) {
    let n = normal.cols();
    let view = normal.view();
    let symbolic = sprs_ldl::LdlSymbolic::new_perm(
        view,
        sprs::PermOwnedI::identity(n),
        sprs::SymmetryCheck::DontCheckSymmetry,
    );
    let numeric = symbolic.factor(view).expect("positive definite");
    let l = numeric.l();
    let columns = l
        .outer_iterator()
        .map(|column| column.iter().map(|(row, &value)| (row as u32, value)).collect());
    (columns.collect(), numeric.d().to_vec())
}

#[test]
fn the_factor_of_a_grid_is_that_of_the_reference() {
    let side = 40u32;
    let mut terms = Terms::default();
    for j in 1..side - 1 {
        for i in 1..side - 1 {
            let v = j * side + i;
            let weights = [4.0, -1.0, -1.1, -0.9, -1.0];
            terms.push(&[v, v - 1, v + 1, v - side, v + side], weights, 0.01, 1.0);
        }
    }
    let n = (side * side) as usize;
    let mut system = System::new(n, vec![terms]);
    system.factor(&[1.0], &vec![0.1; n], vec![false; n]).expect("positive definite");
    let (columns, pivots) = reference(&system.normal);
    let entries: usize = columns.iter().map(Vec::len).sum();
    assert_eq!(system.factor_nonzeros(), entries + n, "counted without forming it");
    let mut found = vec![Vec::new(); n];
    let supernodes = system.analysis.supernodes();
    let mut own = vec![0.0; n];
    supernodal_factor(
        supernodes,
        &system.normal,
        &vec![false; n],
        0.0,
        &mut own,
        &mut |s, front| {
            let front = front.expect("nothing is fixed");
            for (c, column) in supernodes.columns(s).enumerate() {
                let rows = supernodes.rows(s)[c + 1..].iter().copied();
                found[column] = rows.zip(front.column(c, c + 1)).collect::<Vec<_>>();
            }
        },
    )
    .expect("positive definite");
    for c in 0..n {
        assert!((own[c] - pivots[c]).abs() <= 1e-12 * pivots[c], "pivot {c}");
        let stored: std::collections::BTreeMap<u32, f64> = found[c].iter().copied().collect();
        for (row, value) in &columns[c] {
            let own = stored.get(row).expect("no entry is missing");
            assert!((own - value).abs() <= 1e-12, "entry {row}, {c}: {own} is not {value}");
        }
        let zeros = stored.keys().filter(|row| columns[c].iter().all(|(other, _)| other != *row));
        zeros.for_each(|row| assert_eq!(stored[row], 0.0, "entry {row}, {c} is stored zero"));
    }
}

#[test]
fn a_matrix_that_may_be_singular_is_factored_at_once() {
    let mut terms = Terms::default();
    terms.push(&[0, 1, 2, 3], [1.0; 4], 0.3, -0.3 / 4.0);
    let mut system = System::new(4, vec![terms]);
    system.set_matrix(Precision::Single, &[1.0], &[1.0; 4], vec![false; 4]).expect("it is regular");
    assert_eq!(system.state, State::Whole);
    let less = system.set_matrix(Precision::Single, &[1.0], &[0.0; 4], vec![false; 4]);
    assert!(matches!(less, Err(SolveError::NotPositiveDefinite { .. })));
    assert_eq!(system.state, State::Unknown);
    system.set_matrix(Precision::Single, &[1.0], &[1.0; 4], vec![false; 4]).expect("it is regular");
    // Matrices with other scales are not comparable.
    system.set_matrix(Precision::Single, &[2.0], &[2.0; 4], vec![false; 4]).expect("it is regular");
    assert_eq!(system.state, State::Whole);
}

#[test]
fn names_a_vertex_where_the_matrix_is_singular() {
    // Two parts that hold only themselves together: constants are in the kernel, and rounding
    // leaves a pivot that is tiny but not zero.
    let mut terms = Terms::default();
    for nodes in [[0, 1, 2, 3], [4, 5, 6, 7]] {
        terms.push(&nodes, [1.0; 4], 0.3, -0.3 / 4.0);
    }
    for factorization in FACTORIZATIONS {
        let mut system = System::with_order([8, 8], vec![terms.clone()], factorization, None);
        for (scale, free) in [(1.0, 0.0), (-1.0, 1e-3), (f64::NAN, 1.0)] {
            let error = system.factor(&[scale], &[free; 8], vec![false; 8]);
            let error = error.expect_err("it is singular, indefinite, not a number");
            let SolveError::NotPositiveDefinite { vertex } = error else { panic!("{error}") };
            assert!(vertex < 8);
        }
        // A failure does not affect the next factorisation.
        system.factor(&[1.0], &[1.0; 8], vec![false; 8]).expect("it is regular");
        let mut rows = vec![[1.0, 2.0, 3.0, 0.0]; 8];
        system.solve(&mut rows);
        rows.iter().flatten().zip([1.0, 2.0, 3.0, 0.0].iter().cycle()).for_each(
            |(found, expected)| {
                assert!((found - expected).abs() <= 1e-12, "{found} is not {expected}");
            },
        );
    }
    let system = System::new(8, vec![terms]);
    let components = system.components();
    assert_ne!(components[system.node_of()[0] as usize], components[system.node_of()[4] as usize]);
}

/// An extra unknown has no vertex: an index beyond the last one was named.
#[test]
fn of_an_extra_unknown_a_vertex_is_named() {
    // The mean of vertices 2 to 4 is unknown 6; its pivot is lost in rounding.
    let mut terms = Terms::default();
    for v in [2, 3, 4] {
        terms.push(&[v, 6], [1.0, -1.0], 0.0, 1e17);
    }
    for factorization in FACTORIZATIONS {
        let mut system = System::with_order([7, 6], vec![terms.clone()], factorization, None);
        let mut held = vec![1.0; 7];
        held[6] = 0.0;
        let error = system.factor(&[1.0], &held, vec![false; 7]).expect_err("digits are lost");
        let SolveError::NotPositiveDefinite { vertex } = error else { panic!("{error}") };
        assert!((2..=4).contains(&vertex), "{vertex}");
    }
}
