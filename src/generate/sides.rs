//! Points in equal steps along a side, and the grid between four sides (a Coons patch).

use std::array;

/// The points of a grid between four sides, row by row from the south side. The sides follow each
/// other counterclockwise, and each contains both of its corners; opposite sides have equally many
/// points.
pub(super) fn coons_patch<const N: usize>(
    south: &[[f64; N]],
    east: &[[f64; N]],
    north: &[[f64; N]],
    west: &[[f64; N]],
) -> Vec<[f64; N]> {
    let (nx, ny) = (south.len() - 1, east.len() - 1);
    let mut points = Vec::with_capacity((nx + 1) * (ny + 1));
    for j in 0..=ny {
        for i in 0..=nx {
            let (u, v) = (i as f64 / nx as f64, j as f64 / ny as f64);
            let terms = [
                (1.0 - v, south[i]),
                (v, north[nx - i]),
                (1.0 - u, west[ny - j]),
                (u, east[j]),
                (-(1.0 - u) * (1.0 - v), south[0]),
                (-u * (1.0 - v), south[nx]),
                (-u * v, north[0]),
                (-(1.0 - u) * v, north[nx]),
            ];
            // Boundary points are copied, to avoid rounding.
            points.push(match (i, j) {
                (_, 0) => south[i],
                (_, j) if j == ny => north[nx - i],
                (0, _) => west[ny - j],
                (i, _) if i == nx => east[j],
                _ => array::from_fn(|k| terms.iter().map(|(t, point)| t * point[k]).sum()),
            });
        }
    }
    points
}

/// `n + 1` points in equal steps along a curve, each as the index of its piece and the fraction of
/// that piece. `ends` are the arc lengths where pieces begin, and the length of the curve. The ends
/// in `corners` replace the nearest points, as far as there are enough: these steps are second. The
/// start is the first point anyway.
pub(super) fn even_steps(
    ends: &[f64],
    corners: impl IntoIterator<Item = usize>,
    n: usize,
) -> (Vec<(usize, f64)>, Vec<usize>) {
    let whole = ends[ends.len() - 1];
    let mut at: Vec<f64> = (0..=n).map(|k| whole * k as f64 / n as f64).collect();
    let mut kept: Vec<usize> = Vec::new();
    for corner in corners.into_iter().filter(|&corner| ends[corner] > 0.0) {
        let least = kept.last().map_or(1, |last| last + 1);
        let nearest = ((ends[corner] / whole * n as f64).round() as usize).max(least);
        if nearest < n {
            at[nearest] = ends[corner];
            kept.push(nearest);
        }
    }
    let place = |s: f64| {
        let piece = ends[1..ends.len() - 1].partition_point(|&end| end <= s);
        let length = ends[piece + 1] - ends[piece];
        // A piece too short for the sum of lengths is its first point.
        let part = if length > 0.0 { (s - ends[piece]) / length } else { 0.0 };
        (piece, part.clamp(0.0, 1.0))
    };
    (at.into_iter().map(place).collect(), kept)
}
