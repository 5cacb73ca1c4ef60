//! Repair of extracted cells: faces that are not quads become quads, without new vertices as far as
//! possible.
//!
//! Around flipped triangles lines of the grid are lost, and faces are larger there. Those of an even
//! number of sides are divided. The others come in pairs, since every edge has two sides: they are
//! joined with the quads between two of them, which gives an even one.

mod joined;
mod panels;
mod quadrangulate;
mod trim;

use super::extract::Node;
use joined::join_odd;
use panels::Panels;
use quadrangulate::quadrangulate;
pub(super) use trim::trim;

/// Faces after repair.
#[derive(Clone, Debug, Default)]
pub(super) struct Repaired {
    /// Counterclockwise, as indices of nodes.
    pub(super) faces: Vec<Vec<usize>>,
    /// The faces that were replaced, as they were before.
    pub(super) replaced: Vec<Vec<usize>>,
}

/// Replaces faces that are not quads. Those that cannot be replaced remain.
///
/// `is_trimmed` says of which faces any number of corners is right: those at a boundary that cuts
/// the grid. `nodes` receives a node on the boundary if its number of edges is odd.
pub(super) fn repair(
    nodes: &mut Vec<Node>,
    faces: Vec<Vec<usize>>,
    is_trimmed: impl Fn(&[usize]) -> bool,
) -> Repaired {
    let mut panels = Panels::of(faces);
    let mut replaced = Vec::new();
    let divide = |panels: &mut Panels, nodes: &[Node], replaced: &mut Vec<Vec<usize>>| {
        let to_replace = |panels: &Panels, index: usize| {
            let face = panels.face(index)?;
            (face.len() != 4 && !is_trimmed(face)).then_some(index)
        };
        let wrong: Vec<usize> = panels.indices().filter_map(|i| to_replace(panels, i)).collect();
        for index in wrong {
            replace(panels, nodes, index, replaced);
        }
    };
    divide(&mut panels, nodes, &mut replaced);
    join_odd(&mut panels, nodes, &is_trimmed, &mut replaced);
    divide(&mut panels, nodes, &mut replaced);
    Repaired { faces: panels.into_faces(), replaced }
}

/// Replaces a face by quads, if that is possible.
fn replace(panels: &mut Panels, nodes: &[Node], index: usize, replaced: &mut Vec<Vec<usize>>) {
    let Some(face) = panels.take(index) else { return };
    let at = |node: usize| nodes[node].position;
    match quadrangulate(&face, at, |a, b| !panels.has_edge(a, b)) {
        Some(quads) => {
            quads.into_iter().for_each(|quad| panels.add(quad.to_vec()));
            replaced.push(face);
        }
        None => panels.add(face),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::quads::extract::Place;
    use crate::quads::result::{Shape, verify};

    /// Nodes on a grid of points, `columns` in a row.
    fn grid(columns: usize, rows: usize) -> Vec<Node> {
        let node = |k: usize| Node {
            place: Place::Inside(0),
            position: Vec3::new((k % columns) as f64, (k / columns) as f64, 0.0),
            point: [0, 0],
            boundary: false,
            corner: false,
        };
        (0..columns * rows).map(node).collect()
    }

    /// Repairs faces of a disk, and checks that they are quads of the same disk.
    fn check(mut nodes: Vec<Node>, faces: &[&[usize]]) -> (Vec<Node>, Repaired) {
        let disk = Shape { euler: 1, loops: 1, parts: 1 };
        let faces: Vec<Vec<usize>> = faces.iter().map(|face| face.to_vec()).collect();
        assert_eq!(verify(&faces, disk, |_| true).1, []);
        let repaired = repair(&mut nodes, faces, |_| false);
        assert_eq!(verify(&repaired.faces, disk, |face| face.len() == 4).1, []);
        (nodes, repaired)
    }

    #[test]
    fn a_face_of_eight_sides_becomes_three_quads() {
        // Three squares of a row without the edges between them, and the row above.
        let faces: [&[usize]; 4] =
            [&[0, 1, 2, 3, 7, 6, 5, 4], &[4, 5, 9, 8], &[5, 6, 10, 9], &[6, 7, 11, 10]];
        let (_, repaired) = check(grid(4, 3), &faces);
        assert_eq!(repaired.faces.len(), 6);
        assert_eq!(repaired.replaced, [faces[0].to_vec()]);
    }

    #[test]
    fn a_triangle_and_a_pentagon_are_joined_over_the_quads_between() {
        let faces: [&[usize]; 3] = [&[0, 1, 5], &[1, 2, 6, 5], &[2, 3, 8, 7, 6]];
        let mut nodes = grid(4, 3);
        nodes[8].position = Vec3::new(3.5, 1.5, 0.0);
        let (nodes, repaired) = check(nodes, &faces);
        assert_eq!((nodes.len(), repaired.faces.len()), (12, 3));
    }

    #[test]
    fn two_triangles_that_become_a_quad_are_a_place_that_was_repaired() {
        let (_, repaired) = check(grid(3, 2), &[&[0, 1, 4, 3], &[1, 2, 5], &[1, 5, 4]]);
        assert_eq!((repaired.faces.len(), repaired.replaced.len()), (2, 1));
    }

    #[test]
    fn a_single_triangle_gets_a_node_on_the_boundary() {
        let faces: [&[usize]; 3] = [&[0, 1, 5], &[1, 2, 6, 5], &[2, 3, 7, 6]];
        let (nodes, repaired) = check(grid(4, 2), &faces);
        assert_eq!((nodes.len(), repaired.faces.len()), (9, 3));
    }
}
