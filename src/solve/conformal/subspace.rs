//! The smallest eigenvector of `A u = lambda B u` over complex vectors, by inverse iteration of a
//! few vectors at once on the factored matrix (Rayleigh-Ritz).
//!
//! The matrix represents a complex vector as a real one of twice the length, and commutes with
//! multiplication by i, so a solve for a column is also one for its complex multiples. The four
//! columns that the factor solves for at once are therefore four complex vectors, and the iteration
//! converges with the ratio of the first to the fifth eigenvalue. `B` counts some unknowns, each
//! once, and leaves out the others: only the counted ones are iterated.

use crate::constraint::Row;
use crate::math::{argsort, key_of_number, symmetric_eigen};
use crate::solve::system::System;

/// Greatest number of iterations. Maps whose fifth eigenvalue is well separated need five to
/// fifteen.
const ITERATIONS: usize = 300;

/// The eigenvector has converged if a step turns it by less than this.
const TURN: f64 = 1e-11;

/// Number of complex vectors that are iterated.
const VECTORS: usize = 4;
/// Their real dimensions.
const REAL: usize = 2 * VECTORS;

/// The real and the imaginary parts of one unknown in all vectors.
pub(super) type Pair = [Row; 2];

/// A vector with less than this fraction of its length outside the span of the previous ones is a
/// combination of them.
const INDEPENDENT: f64 = 1e-12;

/// Iterates from the vectors `x` (one [`Pair`] for each counted unknown) to the eigenvector of the
/// smallest eigenvalue besides that of the constants. Returns its values, `#unknowns by 2`, of
/// length one over the counted unknowns.
///
/// `system` must be factored as `A + shift B`; `nodes` are the two nodes of each unknown, its real
/// and its imaginary part, and `counted` the unknowns that `B` counts. Returns `None` if the
/// vectors vanish.
pub(super) fn smallest(
    system: &mut System,
    nodes: &[[u32; 2]],
    counted: &[u32],
    mut x: Vec<Pair>,
) -> Option<Vec<[f64; 2]>> {
    centre(&mut x);
    orthonormalise(&mut x);
    let mut solution = vec![[0.0; VECTORS]; 2 * nodes.len()];
    let mut mix = [[0.0; REAL]; VECTORS];
    for _ in 0..ITERATIONS {
        solution.fill([0.0; VECTORS]);
        for (&unknown, pair) in counted.iter().zip(&x) {
            let [real, imaginary] = nodes[unknown as usize];
            (solution[real as usize], solution[imaginary as usize]) = (pair[0], pair[1]);
        }
        system.solve(&mut solution);
        let pair = |unknown: u32| nodes[unknown as usize].map(|node| solution[node as usize]);
        let mut y: Vec<Pair> = counted.iter().map(|&unknown| pair(unknown)).collect();
        centre(&mut y);
        mix = principal(products(&x, &y));
        y.iter_mut().for_each(|pair| *pair = mixed(pair, &mix));
        orthonormalise(&mut y);
        let turn = turn(&x, &y);
        x = y;
        if turn <= TURN {
            break;
        }
    }
    let at = |&[real, imaginary]: &[u32; 2]| {
        let [real, imaginary] = [real, imaginary].map(|node| solution[node as usize]);
        mixed(&[real, imaginary], &mix).map(|row| row[0])
    };
    let mut map: Vec<[f64; 2]> = nodes.iter().map(at).collect();
    normalise(&mut map, counted);
    // Written so that NaN fails.
    map.iter().flatten().all(|value| value.is_finite()).then_some(map)
}

/// The new vectors in terms of the old ones: entry `i` of vector `j` is the factor of vector `i`,
/// with all real parts before all imaginary ones.
type Mix = [[f64; REAL]; VECTORS];
/// A Hermitian matrix `H` as the real one `[Re H, -Im H; Im H, Re H]`, in which each of its
/// eigenvalues occurs twice.
type Hermitian = [[f64; REAL]; REAL];

/// Returns the eigenvectors of a Hermitian matrix, by descending eigenvalues.
fn principal(matrix: Hermitian) -> Mix {
    let symmetric =
        std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (matrix[i][j] + matrix[j][i])));
    let (values, vectors) = symmetric_eigen(symmetric);
    let descending = argsort(values.iter().map(|&value| !key_of_number(value)));
    // The two real vectors of an eigenvalue are complex multiples of each other.
    let mut mix = [[0.0; REAL]; VECTORS];
    let mut taken = 0;
    for k in descending {
        let mut vector = vectors[k as usize];
        for before in mix[..taken].iter().flat_map(|&before| [before, turned(before)]) {
            let along = dot(before, vector);
            vector = std::array::from_fn(|i| vector[i] - along * before[i]);
        }
        let square = dot(vector, vector);
        if square > 0.5 && taken < VECTORS {
            mix[taken] = vector.map(|value| value / square.sqrt());
            taken += 1;
        }
    }
    mix
}

fn dot(a: [f64; REAL], b: [f64; REAL]) -> f64 {
    a.iter().zip(&b).map(|(a, b)| a * b).sum()
}

/// Orthonormalises the vectors, each against those before it; combinations of those become zero.
fn orthonormalise(x: &mut [Pair]) {
    for j in 0..VECTORS {
        let before = length(x, j);
        // Twice is enough (Kahan, Parlett).
        for i in (0..j).chain(0..j) {
            let [along, across] = product(x, i, x, j);
            for [real, imaginary] in x.iter_mut() {
                real[j] -= along * real[i] - across * imaginary[i];
                imaginary[j] -= along * imaginary[i] + across * real[i];
            }
        }
        let after = length(x, j);
        let factor = if after > INDEPENDENT * before { 1.0 / after } else { 0.0 };
        for [real, imaginary] in x.iter_mut() {
            (real[j], imaginary[j]) = (factor * real[j], factor * imaginary[j]);
        }
    }
}

fn length(x: &[Pair], j: usize) -> f64 {
    x.iter().map(|[a, b]| a[j] * a[j] + b[j] * b[j]).sum::<f64>().sqrt()
}

/// The complex inner product of vector `i` of `x` with vector `j` of `y`.
fn product(x: &[Pair], i: usize, y: &[Pair], j: usize) -> [f64; 2] {
    let (mut along, mut across) = (0.0, 0.0);
    for ([a, b], [c, d]) in x.iter().zip(y) {
        along += a[i] * c[j] + b[i] * d[j];
        across += a[i] * d[j] - b[i] * c[j];
    }
    [along, across]
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

/// The vector times i.
fn turned(vector: [f64; REAL]) -> [f64; REAL] {
    std::array::from_fn(|k| if k < VECTORS { -vector[k + VECTORS] } else { vector[k - VECTORS] })
}

/// The new vectors at one unknown.
fn mixed([real, imaginary]: &Pair, mix: &Mix) -> Pair {
    let part = |factors: &[f64; REAL], of: &Row, times_i: &Row| -> f64 {
        (0..VECTORS).map(|i| of[i] * factors[i] + times_i[i] * factors[i + VECTORS]).sum()
    };
    let minus = imaginary.map(|value| -value);
    [
        std::array::from_fn(|j| part(&mix[j], real, &minus)),
        std::array::from_fn(|j| part(&mix[j], imaginary, real)),
    ]
}

/// The length of the part of the first new vector that is no complex multiple of the first old one.
fn turn(old: &[Pair], new: &[Pair]) -> f64 {
    let [along, across] = product(old, 0, new, 0);
    let outside = old.iter().zip(new).map(|([a, b], [c, d])| {
        let real = c[0] - (along * a[0] - across * b[0]);
        let imaginary = d[0] - (along * b[0] + across * a[0]);
        real * real + imaginary * imaginary
    });
    outside.sum::<f64>().sqrt()
}

/// Subtracts the constants, which are in the kernel of `A`.
fn centre(x: &mut [Pair]) {
    let mut mean = [[0.0; VECTORS]; 2];
    for pair in x.iter() {
        for (mean, value) in mean.as_flattened_mut().iter_mut().zip(pair.as_flattened()) {
            *mean += value;
        }
    }
    let n = x.len() as f64;
    for pair in x {
        for (value, mean) in pair.as_flattened_mut().iter_mut().zip(mean.as_flattened()) {
            *value -= mean / n;
        }
    }
}

/// The complex inner products of the vectors of `a` with those of `b`.
fn products(a: &[Pair], b: &[Pair]) -> Hermitian {
    let (mut real, mut imaginary) = ([[0.0; VECTORS]; VECTORS], [[0.0; VECTORS]; VECTORS]);
    for ([a, ai], [b, bi]) in a.iter().zip(b) {
        for i in 0..VECTORS {
            for j in 0..VECTORS {
                real[i][j] += a[i] * b[j] + ai[i] * bi[j];
                imaginary[i][j] += a[i] * bi[j] - ai[i] * b[j];
            }
        }
    }
    let entry = |row: usize, column: usize| {
        let (i, j) = (row % VECTORS, column % VECTORS);
        match (row < VECTORS, column < VECTORS) {
            (true, true) | (false, false) => real[i][j],
            (true, false) => -imaginary[i][j],
            (false, true) => imaginary[i][j],
        }
    };
    std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)))
}
