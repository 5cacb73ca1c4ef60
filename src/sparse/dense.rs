//! Dense kernels of the supernodal factor, on lower triangles in panels of four columns.
//!
//! A panel stores its rows one after another, four values each, starting at the row of its first
//! column. Values above the diagonal and beyond the last column are undefined. A row is one or two
//! registers, so that nothing is packed or shuffled.

use crate::math::{Lane, Lanes};

/// One row of a panel.
pub(crate) type Quad = [f64; 4];

/// Number of rows of all panels of the first `width` columns of a lower triangle with `height`
/// rows.
#[inline]
pub(crate) fn size(width: usize, height: usize) -> usize {
    start(width.div_ceil(4), height)
}

/// Start of panel `p` of a lower triangle with `height` rows.
#[inline]
pub(crate) fn start(p: usize, height: usize) -> usize {
    p * (height + 2) - 2 * p * p
}

/// Factors the first `width` columns of a lower triangle with `height` rows in place, `L D L^T`.
/// Calls `accept` with each column and pivot before dividing by the pivot.
///
/// # Errors
/// The first column whose pivot is not accepted.
pub(crate) fn factor(
    panels: &mut [Quad],
    width: usize,
    height: usize,
    pivots: &mut [f64],
    accept: impl Fn(usize, f64) -> bool,
) -> Result<(), usize> {
    for p in 0..width.div_ceil(4) {
        let (before, panel) = panels.split_at_mut(start(p, height));
        let panel = &mut panel[..height - 4 * p];
        for q in 0..p {
            // The rows of panel `q` from the first one of this panel on.
            let source = &before[start(q, height) + 4 * (p - q)..][..panel.len()];
            let right = times_pivots(source, &pivots[4 * q..4 * q + 4]);
            subtract_product::<4>(panel, source, &right);
        }
        let columns = 4 * p..width.min(4 * p + 4);
        let own = &mut pivots[columns.clone()];
        let (below, inverse) = factor_tile(panel, own, |c, pivot| accept(columns.start + c, pivot))
            .map_err(|c| columns.start + c)?;
        divide(&mut panel[own.len()..], &below, &inverse);
    }
    Ok(())
}

/// Factors the diagonal tile of a panel. Returns its strict lower triangle column by column, and
/// the inverse pivots, padded with zeros and ones if there are fewer than four columns.
fn factor_tile(
    panel: &mut [Quad],
    pivots: &mut [f64],
    accept: impl Fn(usize, f64) -> bool,
) -> Result<([Quad; 3], Quad), usize> {
    let width = pivots.len();
    let (mut below, mut inverse) = ([[0.0; 4]; 3], [1.0; 4]);
    for c in 0..width {
        let pivot = panel[c][c];
        if !accept(c, pivot) {
            return Err(c);
        }
        pivots[c] = pivot;
        inverse[c] = 1.0 / pivot;
        for r in c + 1..width {
            let l = panel[r][c] * inverse[c];
            below[c][r] = l;
            for k in c + 1..=r {
                panel[r][k] -= l * panel[k][c];
            }
        }
        for r in c + 1..width {
            panel[r][c] = below[c][r];
        }
    }
    Ok((below, inverse))
}

/// Turns the rows below the diagonal tile from those of the matrix into those of `L`.
#[inline(never)]
fn divide(rows: &mut [Quad], below: &[Quad; 3], inverse: &Quad) {
    for row in rows {
        let mut values = *row;
        // Loops, because `array::from_fn` may not be inlined.
        for c in 0..3 {
            let own = values[c];
            for k in 0..4 {
                values[k] -= own * below[c][k];
            }
        }
        for k in 0..4 {
            row[k] = values[k] * inverse[k];
        }
    }
}

/// Whether any row below the first `width` columns of `panels` has a nonzero in these columns.
#[inline]
pub(crate) fn has_below(panels: &[Quad], width: usize, height: usize) -> bool {
    (0..width.div_ceil(4)).any(|p| {
        let rows = &panels[start(p, height)..][..height - 4 * p];
        rows[width - 4 * p..].as_flattened().iter().any(|&value| value != 0.0)
    })
}

/// Subtracts `L D L^T` of the rows below the first `width` columns of `panels`, which are factored,
/// from the lower triangle `update`.
pub(crate) fn subtract_outer(
    update: &mut [Quad],
    panels: &[Quad],
    width: usize,
    height: usize,
    pivots: &[f64],
) {
    let below = height - width;
    for q in 0..below.div_ceil(4) {
        let target = &mut update[start(q, below)..][..below - 4 * q];
        for p in 0..width.div_ceil(4) {
            let source = &panels[start(p, height) + width + 4 * q - 4 * p..][..target.len()];
            let own = &pivots[4 * p..width.min(4 * p + 4)];
            let right = times_pivots(source, own);
            match own.len() {
                1 => subtract_product::<1>(target, source, &right),
                2 => subtract_product::<2>(target, source, &right),
                3 => subtract_product::<3>(target, source, &right),
                _ => subtract_product::<4>(target, source, &right),
            }
        }
    }
}

/// `D L^T` of the first four rows, or of all rows if there are fewer.
#[inline]
fn times_pivots(rows: &[Quad], pivots: &[f64]) -> [Quad; 4] {
    let mut product = [[0.0; 4]; 4];
    for (c, row) in rows.iter().take(4).enumerate() {
        for (k, pivot) in pivots.iter().enumerate() {
            product[k][c] = pivot * row[k];
        }
    }
    product
}

/// `target -= left * right`, over the first `W` columns of `left`. Most of the time is spent here.
///
/// In registers by hand: what the compiler made of loops over rows took 1.3 to 1.8 times as long.
// Not inlined: V8 replaces wasm functions by optimised code only between calls.
#[inline(never)]
fn subtract_product<const W: usize>(target: &mut [Quad], left: &[Quad], right: &[Quad; 4]) {
    let registers = |row: &Quad| Lanes::<2>::from_fn(|c| row[c]);
    for (target, left) in target.iter_mut().zip(left) {
        let mut sum = registers(target);
        for k in 0..W {
            sum -= Lanes::splat(left[k]) * registers(&right[k]);
        }
        for c in 0..4 {
            target[c] = sum.lane(c);
        }
    }
}
