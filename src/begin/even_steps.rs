//! Points in equal steps along a curve of several pieces.

/// `n + 1` points in equal steps along a curve, each as the index of its piece and the fraction of
/// that piece. `ends` are the arc lengths where pieces begin, and the length of the curve. The ends
/// in `corners` replace the nearest points, as far as there are enough.
pub(super) fn even_steps(
    ends: &[f64],
    corners: impl IntoIterator<Item = usize>,
    n: usize,
) -> impl Iterator<Item = (usize, f64)> {
    let whole = ends[ends.len() - 1];
    let mut at: Vec<f64> = (0..=n).map(|k| whole * k as f64 / n as f64).collect();
    let mut last = 0;
    for corner in corners {
        let nearest = ((ends[corner] / whole * n as f64).round() as usize).max(last + 1);
        if nearest < n {
            at[nearest] = ends[corner];
            last = nearest;
        }
    }
    at.into_iter().map(|s| {
        let piece = ends[1..ends.len() - 1].partition_point(|&end| end <= s);
        let length = ends[piece + 1] - ends[piece];
        (piece, ((s - ends[piece]) / length).clamp(0.0, 1.0))
    })
}
