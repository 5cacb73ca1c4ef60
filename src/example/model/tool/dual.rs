//! The dual of a surface: a polygon for each vertex.

use crate::math::polygon_corners;
use crate::mesh::{Mesh, Point, Ragged};

/// The dual of a manifold surface. Its vertices are the centroids of the faces, in their order,
/// then the midpoints of the boundary edges. Each vertex becomes the polygon of the faces around
/// it, in the order of the vertices and with the orientation of the faces. At the boundary the
/// polygon also has the midpoints of the two boundary edges, and the vertex itself if `is_corner`.
pub(crate) fn dual(mesh: &Mesh, is_corner: impl Fn(u32) -> bool) -> Mesh {
    let mean = |face: &[u32]| -> Point {
        let sum = face.iter().fold([0.0; 3], |sum: Point, &v| {
            let p = mesh.positions[v as usize];
            std::array::from_fn(|i| sum[i] + p[i])
        });
        sum.map(|x| x / face.len() as f64)
    };
    let mut positions: Vec<Point> = mesh.faces.iter().map(mean).collect();
    let mut wedges: Vec<Vec<Wedge>> = vec![Vec::new(); mesh.positions.len()];
    for (face, corners) in (0..).zip(mesh.faces.iter()) {
        for [before, here, next] in polygon_corners(corners) {
            wedges[here as usize].push(Wedge { face, next, before });
        }
    }
    let mut middles: Vec<([u32; 2], u32)> = Vec::new();
    let mut middle = |a: u32, b: u32, positions: &mut Vec<Point>| {
        let ends = [a.min(b), a.max(b)];
        if let Some(&(_, vertex)) = middles.iter().find(|(known, _)| *known == ends) {
            return vertex;
        }
        let vertex = positions.len() as u32;
        positions.push(mean(&ends));
        middles.push((ends, vertex));
        vertex
    };
    let mut faces = Ragged::new();
    for (v, around) in (0..).zip(&wedges) {
        // At a boundary vertex, start with the wedge whose `next` no other wedge ends at.
        let open = around.iter().find(|w| around.iter().all(|other| other.before != w.next));
        let Some(first) = open.or(around.first()) else { continue };
        let mut polygon = Vec::new();
        if open.is_some() {
            polygon.push(middle(v, first.next, &mut positions));
        }
        let mut wedge = first;
        loop {
            polygon.push(wedge.face);
            match around.iter().find(|other| other.next == wedge.before) {
                Some(next) if next.face != first.face => wedge = next,
                _ => break,
            }
        }
        if open.is_some() {
            polygon.push(middle(v, wedge.before, &mut positions));
            if is_corner(v) {
                polygon.push(positions.len() as u32);
                positions.push(mesh.positions[v as usize]);
            }
        }
        faces.push(&polygon);
    }
    Mesh { positions, faces, ..Mesh::default() }
}

/// A face at one of its vertices, between the next corner and the one before.
#[derive(Clone, Copy)]
struct Wedge {
    face: u32,
    next: u32,
    before: u32,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example::model::tool::grid;

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
