//! Polygons over a square: mostly hexagons, with pentagons and heptagons where the number of cells
//! across changes. They are the dual of rows of triangles.

use super::finish::edited;
use crate::mesh::{KEPT_TURN, Mesh, Point, Ragged};
use std::ops::Range;

/// The dual of rows of triangles over the square from -1 to 1 in `u` and `v`, mapped by `point`.
/// There are `rows + 1` rows of triangle corners along `u`; an even row has `across(u)` of them, an
/// odd row one more, shifted by half their distance.
pub(super) fn hexagons(
    rows: usize,
    across: impl Fn(f64) -> usize,
    point: impl Fn(f64, f64) -> Point,
) -> Mesh {
    let triangles = triangle_rows(rows, &across);
    let Mesh { positions, mut faces, .. } = edited(&triangles, "dual", &[KEPT_TURN], &[]);
    // Links and results refer to vertices by their numbers from before `dual` was used: the centres of the
    // triangles, then those of the border as faces come to them. `dual` begins with the corners of the square,
    // which it keeps.
    const CORNERS: u32 = 4;
    let centres = CORNERS..CORNERS + triangles.faces.len() as u32;
    let mut numbers = vec![u32::MAX; positions.len()];
    let mut ordered = Vec::with_capacity(positions.len());
    for v in centres.chain(faces.indices().iter().copied()) {
        let [x, y, _] = positions[v as usize];
        if numbers[v as usize] == u32::MAX {
            numbers[v as usize] = ordered.len() as u32;
            ordered.push(point(x, y));
        }
    }
    faces.rename(&numbers);
    Mesh { positions: ordered, faces, ..Mesh::default() }
}

/// Rows of triangles over the square from -1 to 1 in x and y; [`hexagons`] is their dual.
pub(super) fn triangle_rows(rows: usize, across: &dyn Fn(f64) -> usize) -> Mesh {
    let mut positions: Vec<Point> = Vec::new();
    let mut faces = Ragged::new();
    let mut below = 0..0;
    for k in 0..=rows {
        let u = (2.0 * k as f64 - rows as f64) / rows as f64;
        let first = positions.len() as u32;
        positions.extend(row(across(u).max(2), k % 2 == 1).into_iter().map(|v| [u, v, 0.0]));
        let above = first..positions.len() as u32;
        if k > 0 {
            stitch(&positions, below, above.clone(), &mut faces);
        }
        below = above;
    }
    Mesh { positions, faces, ..Mesh::default() }
}

/// Coordinates from -1 to 1: `n` equally spaced, or both ends and the midpoints between the `n`.
fn row(n: usize, shifted: bool) -> Vec<f64> {
    let at = |k: f64| (2.0 * k - (n - 1) as f64) / (n - 1) as f64;
    if shifted {
        let inner = (1..n).map(|k| at(k as f64 - 0.5));
        std::iter::once(-1.0).chain(inner).chain([1.0]).collect()
    } else {
        (0..n).map(|k| at(k as f64)).collect()
    }
}

/// Triangles between two rows, each with the shorter of two possible diagonals.
fn stitch(positions: &[Point], below: Range<u32>, above: Range<u32>, faces: &mut Ragged) {
    let v = |vertex: u32| positions[vertex as usize][1];
    let (mut low, mut high) = (below.start, above.start);
    while low + 1 < below.end || high + 1 < above.end {
        let along_below = if low + 1 == below.end {
            false
        } else if high + 1 == above.end {
            true
        } else {
            (v(low + 1) - v(high)).abs() <= (v(high + 1) - v(low)).abs()
        };
        if along_below {
            faces.push(&[low, high, low + 1]);
            low += 1;
        } else {
            faces.push(&[low, high, high + 1]);
            high += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_have_the_numbers_that_links_hold() {
        let Mesh { positions, .. } = hexagons(2, |_| 2, |x, y| [x, y, 0.0]);
        // The centres of six triangles, then six midpoints and four corners, by the faces they are of.
        let count_on_border = |p: &Point| p.iter().filter(|x| x.abs() == 1.0).count();
        let on_border: Vec<usize> = positions.iter().map(count_on_border).collect();
        assert_eq!(on_border, [0, 0, 0, 0, 0, 0, 1, 1, 2, 1, 2, 1, 1, 1, 2, 2]);
    }
}
