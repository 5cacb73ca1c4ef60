//! Polygons over a square: mostly hexagons, with pentagons and heptagons where the number of cells
//! across changes. They are the dual of rows of triangles.

use crate::mesh::{Mesh, Point, Ragged, Topology, around};
use std::collections::BTreeMap;
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
    let at_corner = |v: u32| {
        let [u, v, _] = triangles.positions[v as usize];
        u.abs() == 1.0 && v.abs() == 1.0
    };
    let mut cells = dual(&triangles, at_corner);
    cells.positions.iter_mut().for_each(|p| *p = point(p[0], p[1]));
    cells
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

/// The dual of a manifold surface. Its vertices are the centroids of the faces, in their order,
/// then the midpoints of the boundary edges. Each vertex becomes the polygon of the faces around
/// it, in the order of the vertices and with the orientation of the faces. At the boundary the
/// polygon also has the midpoints of the two boundary edges, and the vertex itself if `is_corner`.
fn dual(mesh: &Mesh, is_corner: impl Fn(u32) -> bool) -> Mesh {
    let mean = |face: &[u32]| -> Point {
        let sum = face.iter().fold([0.0; 3], |sum: Point, &v| {
            let p = mesh.positions[v as usize];
            std::array::from_fn(|i| sum[i] + p[i])
        });
        sum.map(|x| x / face.len() as f64)
    };
    let mut positions: Vec<Point> = mesh.faces.iter().map(mean).collect();
    let topology = Topology::new(mesh);
    let mut middles: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let mut middle = |a: u32, b: u32, positions: &mut Vec<Point>| {
        let ends = [a.min(b), a.max(b)];
        *middles.entry(ends).or_insert_with(|| {
            positions.push(mean(&ends));
            positions.len() as u32 - 1
        })
    };
    let mut faces = Ragged::new();
    for v in 0..mesh.positions.len() as u32 {
        let steps = around(mesh, &topology, v).unwrap_or_default();
        let (Some(first), Some(last)) = (steps.first(), steps.last()) else { continue };
        let is_open = first.out != last.back;
        let mut polygon = Vec::new();
        if is_open {
            polygon.push(middle(v, first.out, &mut positions));
        }
        polygon.extend(steps.iter().map(|step| step.face));
        if is_open {
            polygon.push(middle(v, last.back, &mut positions));
            if is_corner(v) {
                polygon.push(positions.len() as u32);
                positions.push(mesh.positions[v as usize]);
            }
        }
        faces.push(&polygon);
    }
    Mesh { positions, faces, ..Mesh::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::quads::grid;

    #[test]
    fn the_dual_of_a_grid_is_a_grid_with_narrow_borders() {
        let mesh = grid([3, 2], |x, y| [x, y, 0.0]);
        let corners = [0, 3, 8, 11];
        let dual = dual(&mesh, |v| corners.contains(&v));
        // 6 faces, 10 boundary edges, 4 corners.
        assert_eq!((dual.positions.len(), dual.faces.len()), (20, 12));
        assert!(dual.faces.iter().all(|face| face.len() == 4));
        let mut area = 0.0;
        for face in dual.faces.iter() {
            for k in 0..face.len() {
                let [a, b] = [face[k], face[(k + 1) % face.len()]];
                let ([ax, ay, _], [bx, by, _]) =
                    (dual.positions[a as usize], dual.positions[b as usize]);
                area += 0.5 * (ax * by - ay * bx);
            }
        }
        assert!((area - 4.0).abs() < 1e-12, "{area}");
    }
}
