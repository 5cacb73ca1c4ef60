//! The smallest eigenvector of `A u = lambda B u` over complex vectors, by inverse iteration of a
//! few vectors at once on the factored matrix (Rayleigh-Ritz).
//!
//! The matrix represents a complex vector as a real one of twice the length, and commutes with
//! multiplication by i, so a solve for a column is also one for its complex multiples. The four
//! columns that the factor solves for at once are therefore four complex vectors, and the iteration
//! converges with the ratio of the first to the fifth eigenvalue. `B` counts some unknowns, each
//! once, and leaves out the others: only the counted ones are iterated.

use crate::math::{orthonormalise, symmetric_eigen};
use crate::solve::system::System;
use nalgebra::{Complex, DMatrix};

/// Greatest number of iterations. Maps whose fifth eigenvalue is well separated need five to
/// fifteen.
const ITERATIONS: usize = 300;

/// The eigenvector has converged if a step turns it by less than this.
const TURN: f64 = 1e-11;

/// Number of complex vectors that are iterated.
pub(super) const VECTORS: usize = 4;

/// A vector with less than this fraction of its length outside the span of the previous ones is a
/// combination of them.
const INDEPENDENT: f64 = 1e-12;

/// Iterates from the vectors `x` (a column each, a row for each counted unknown) to the eigenvector
/// of the smallest eigenvalue besides that of the constants. Returns its values, `#unknowns by 2`,
/// of length one over the counted unknowns.
///
/// `system` must be factored as `A + shift B`; `nodes` are the two nodes of each unknown, its real
/// and its imaginary part, and `counted` the unknowns that `B` counts. Returns `None` if the
/// vectors vanish.
pub(super) fn smallest(
    system: &mut System,
    nodes: &[[u32; 2]],
    counted: &[u32],
    mut x: DMatrix<Complex<f64>>,
) -> Option<Vec<[f64; 2]>> {
    centre(&mut x);
    orthonormalise(&mut x, INDEPENDENT);
    let mut solution = vec![[0.0; VECTORS]; 2 * nodes.len()];
    let mut mix = DMatrix::zeros(VECTORS, VECTORS);
    for _ in 0..ITERATIONS {
        solution.fill([0.0; VECTORS]);
        for (&unknown, row) in counted.iter().zip(x.row_iter()) {
            let [real, imaginary] = nodes[unknown as usize];
            for (j, entry) in row.iter().enumerate() {
                solution[real as usize][j] = entry.re;
                solution[imaginary as usize][j] = entry.im;
            }
        }
        system.solve(&mut solution);
        let mut y = DMatrix::from_fn(counted.len(), VECTORS, |k, j| {
            entry(&solution, nodes[counted[k] as usize], j)
        });
        centre(&mut y);
        mix = principal(&x.ad_mul(&y))?;
        y *= &mix;
        orthonormalise(&mut y, INDEPENDENT);
        // The part of the first new vector that is no complex multiple of the first old one.
        let (old, new) = (x.column(0), y.column(0));
        let turn = (new - old * old.dotc(&new)).norm();
        x = y;
        if turn <= TURN {
            break;
        }
    }
    let at = |&nodes: &[u32; 2]| {
        let first: Complex<f64> =
            (0..VECTORS).map(|j| entry(&solution, nodes, j) * mix[(j, 0)]).sum();
        [first.re, first.im]
    };
    let mut map: Vec<[f64; 2]> = nodes.iter().map(at).collect();
    normalise(&mut map, counted);
    // Written so that NaN fails.
    map.iter().flatten().all(|value| value.is_finite()).then_some(map)
}

/// The entry of vector `j` for the unknown with these nodes.
fn entry(solution: &[[f64; VECTORS]], [real, imaginary]: [u32; 2], j: usize) -> Complex<f64> {
    Complex::new(solution[real as usize][j], solution[imaginary as usize][j])
}

/// Returns the eigenvectors of a Hermitian matrix, by descending eigenvalues. They are found as
/// those of the real matrix `[Re H, -Im H; Im H, Re H]`, in which each eigenvalue occurs twice: the
/// functions of complex numbers of nalgebra give other bits on other platforms. `None` unless all
/// entries are finite.
fn principal(matrix: &DMatrix<Complex<f64>>) -> Option<DMatrix<Complex<f64>>> {
    let n = matrix.nrows();
    let real = DMatrix::from_fn(2 * n, 2 * n, |i, j| {
        let entry = matrix[(i % n, j % n)];
        match (i < n, j < n) {
            (true, true) | (false, false) => entry.re,
            (true, false) => -entry.im,
            (false, true) => entry.im,
        }
    });
    let (_, vectors) = symmetric_eigen(&real)?;
    // The two real vectors of an eigenvalue are complex multiples of each other.
    let mut mix = DMatrix::zeros(n, n);
    let mut taken = 0;
    for vector in vectors.column_iter() {
        let mut own = DMatrix::from_fn(n, 1, |i, _| Complex::new(vector[i], vector[i + n]));
        for before in mix.columns(0, taken).column_iter() {
            let along = before.dotc(&own);
            own -= before * along;
        }
        let length = own.norm();
        if length * length > 0.5 && taken < n {
            mix.set_column(taken, &own.column(0).unscale(length));
            taken += 1;
        }
    }
    Some(mix)
}

/// Subtracts the mean of a map and scales it to length one, over the counted unknowns.
fn normalise(map: &mut [[f64; 2]], counted: &[u32]) {
    let over = |map: &[[f64; 2]], of: fn(f64) -> f64| {
        let mut sum = [0.0; 2];
        for &unknown in counted {
            let [x, y] = map[unknown as usize];
            sum = [sum[0] + of(x), sum[1] + of(y)];
        }
        sum
    };
    let mean = over(map, |value| value).map(|sum| sum / counted.len() as f64);
    map.iter_mut().for_each(|[x, y]| (*x, *y) = (*x - mean[0], *y - mean[1]));
    let squares = over(map, |value| value * value);
    let length = (squares[0] + squares[1]).sqrt();
    map.as_flattened_mut().iter_mut().for_each(|value| *value /= length);
}

/// Subtracts the constants, which are in the kernel of `A`.
fn centre(x: &mut DMatrix<Complex<f64>>) {
    for mut column in x.column_iter_mut() {
        let mean = column.mean();
        column.add_scalar_mut(-mean);
    }
}
