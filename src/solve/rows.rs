//! Vector operations on rows of numbers, one row for each node.

use crate::constraint::Row;
use crate::math;

/// Inner product, summed in the same order on every platform.
#[inline(never)]
pub(super) fn dot(a: &[Row], b: &[Row]) -> f64 {
    let mut sum = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for i in 0..4 {
            sum[i] += a[i] * b[i];
        }
    }
    (sum[0] + sum[1]) + (sum[2] + sum[3])
}

/// `y += factor * x`.
#[inline(never)]
pub(super) fn add_scaled(y: &mut [Row], factor: f64, x: &[Row]) {
    math::add_scaled(y.as_flattened_mut(), factor, x.as_flattened());
}
