//! The Coons patch: the grid between four sides.

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
