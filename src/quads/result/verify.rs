//! Whether the faces are a surface like the input: the result is checked itself, not the map from
//! which it comes.

use crate::mesh::components;
use crate::quads::fault::ResultFault;
use std::collections::{BTreeMap, BTreeSet};

/// The shape of a surface as far as deformations keep it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::quads) struct Shape {
    /// Vertices minus edges plus faces.
    pub(in crate::quads) euler: i64,
    /// Number of boundary loops.
    pub(in crate::quads) loops: usize,
    /// Number of connected parts.
    pub(in crate::quads) parts: usize,
}

/// The shape of faces, and what keeps them from being a surface: numbers of edges and of vertices.
struct Found {
    shape: Shape,
    edges: usize,
    vertices: usize,
}

/// Checks faces against those of the input. `fits` says whether a face may have its number of
/// corners.
pub(in crate::quads) fn verify<F: AsRef<[usize]>>(
    faces: &[F],
    expected: Shape,
    fits: impl Fn(&[usize]) -> bool,
) -> (Shape, Vec<ResultFault>) {
    let repeats = |face: &[usize]| {
        let mut corners = face.to_vec();
        corners.sort_unstable();
        corners.windows(2).any(|pair| pair[0] == pair[1])
    };
    let wrong = |face: &&F| !fits(face.as_ref()) || repeats(face.as_ref());
    let found = examine(faces);
    let mut faults = Vec::new();
    let mut count = |count: usize, fault: fn(usize) -> ResultFault| {
        if count > 0 {
            faults.push(fault(count));
        }
    };
    count(faces.iter().filter(wrong).count(), |count| ResultFault::Face { count });
    count(found.edges, |count| ResultFault::Edge { count });
    count(found.vertices, |count| ResultFault::Vertex { count });
    if found.shape.loops != expected.loops {
        faults.push(ResultFault::Loops { expected: expected.loops, found: found.shape.loops });
    }
    if found.shape.euler != expected.euler {
        faults.push(ResultFault::Euler { expected: expected.euler, found: found.shape.euler });
    }
    // A torus would otherwise be no faces at all, which have as many loops and the same Euler number.
    if found.shape.parts != expected.parts {
        faults.push(ResultFault::Parts { expected: expected.parts, found: found.shape.parts });
    }
    (found.shape, faults)
}

impl Shape {
    /// The shape of faces that are a surface.
    pub(in crate::quads) fn of<F: AsRef<[usize]>>(faces: &[F]) -> Shape {
        examine(faces).shape
    }
}

fn examine<F: AsRef<[usize]>>(faces: &[F]) -> Found {
    // Each side as its lower end, its higher end, and whether it ascends.
    let mut sides: Vec<(usize, usize, bool)> = Vec::new();
    // At each corner the nodes before and after it, counterclockwise around it.
    let mut corners: Vec<(usize, usize, usize)> = Vec::new();
    for face in faces {
        let face = face.as_ref();
        let count = face.len();
        for k in 0..count {
            let (a, b) = (face[k], face[(k + 1) % count]);
            sides.push((a.min(b), a.max(b), a < b));
            corners.push((a, b, face[(k + count - 1) % count]));
        }
    }
    sides.sort_unstable();
    let (mut edges, mut wrong_edges) = (0, 0);
    let mut outer: Vec<(usize, usize)> = Vec::new();
    for same in sides.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)) {
        edges += 1;
        match *same {
            [(a, b, ascends)] => outer.push(if ascends { (a, b) } else { (b, a) }),
            [(_, _, first), (_, _, second)] if first != second => {}
            _ => wrong_edges += 1,
        }
    }
    corners.sort_unstable();
    let (mut vertices, mut wrong_vertices) = (0, 0);
    for around in corners.chunk_by(|x, y| x.0 == y.0) {
        vertices += 1;
        if !is_fan(around) {
            wrong_vertices += 1;
        }
    }
    let euler = vertices - edges + faces.len() as i64;
    let shape = Shape { euler, loops: loops(outer), parts: parts(faces) };
    Found { shape, edges: wrong_edges, vertices: wrong_vertices }
}

/// Number of parts whose faces share vertices.
fn parts<F: AsRef<[usize]>>(faces: &[F]) -> usize {
    let faces: Vec<Vec<u32>> =
        faces.iter().map(|face| face.as_ref().iter().map(|&node| node as u32).collect()).collect();
    let count = faces.iter().flatten().max().map_or(0, |&last| last as usize + 1);
    let part_of = components(count, faces.iter().map(Vec::as_slice));
    let mut parts: Vec<u32> = faces.iter().flatten().map(|&v| part_of[v as usize]).collect();
    parts.sort_unstable();
    parts.dedup();
    parts.len()
}

/// Whether the corners at a vertex, with the next and the last node of their faces, follow each other
/// in one fan.
fn is_fan(around: &[(usize, usize, usize)]) -> bool {
    // The corner whose face comes next counterclockwise begins where this one ends.
    let mut begins = BTreeMap::new();
    for (corner, &(_, first, _)) in around.iter().enumerate() {
        begins.entry(first).or_insert(corner);
    }
    let ends: BTreeSet<usize> = around.iter().map(|&(_, _, last)| last).collect();
    let start = around.iter().position(|(_, first, _)| !ends.contains(first)).unwrap_or(0);
    let (mut at, mut walked) = (start, 1);
    while let Some(&next) = begins.get(&around[at].2) {
        if next == start || walked > around.len() {
            break;
        }
        at = next;
        walked += 1;
    }
    walked == around.len()
}

/// Number of loops of directed boundary sides.
fn loops(mut sides: Vec<(usize, usize)>) -> usize {
    sides.sort_unstable();
    let mut walked = vec![false; sides.len()];
    let mut count = 0;
    for first in 0..sides.len() {
        let mut at = first;
        let mut is_new = false;
        while !walked[at] {
            walked[at] = true;
            is_new = true;
            let end = sides[at].1;
            let from = sides.partition_point(|side| side.0 < end);
            let next = (from..sides.len()).take_while(|&k| sides[k].0 == end);
            match next.into_iter().find(|&k| !walked[k]) {
                Some(next) => at = next,
                None => break,
            }
        }
        count += usize::from(is_new);
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_quad(face: &[usize]) -> bool {
        face.len() == 4
    }

    #[test]
    fn a_cube_and_a_cube_without_lid_are_surfaces() {
        let cube =
            [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
        let closed = Shape { euler: 2, loops: 0, parts: 1 };
        assert_eq!(verify(&cube, closed, is_quad), (closed, Vec::new()));
        let open = Shape { euler: 1, loops: 1, parts: 1 };
        assert_eq!(verify(&cube[1..], open, is_quad), (open, Vec::new()));
        let (_, faults) = verify(&cube[1..], closed, is_quad);
        assert_eq!(faults.len(), 2);
        let turned = [[0, 1, 2, 3], cube[1], cube[2], cube[3], cube[4], cube[5]];
        let (_, faults) = verify(&turned, closed, is_quad);
        assert!(faults.contains(&ResultFault::Edge { count: 4 }), "{faults:?}");
    }

    #[test]
    fn quads_that_touch_in_a_vertex_and_triangles_are_named() {
        let disk = Shape { euler: 1, loops: 1, parts: 1 };
        let bow = [vec![0, 1, 2, 3], vec![0, 4, 5, 6]];
        let (_, faults) = verify(&bow, disk, is_quad);
        assert!(faults.contains(&ResultFault::Vertex { count: 1 }), "{faults:?}");
        let (_, faults) = verify(&[[0, 1, 2]], disk, is_quad);
        assert_eq!(faults, [ResultFault::Face { count: 1 }]);
    }

    #[test]
    fn no_faces_are_no_torus_and_two_parts_are_not_one() {
        let torus = Shape { euler: 0, loops: 0, parts: 1 };
        let nothing: [[usize; 4]; 0] = [];
        let missing = ResultFault::Parts { expected: 1, found: 0 };
        assert_eq!(verify(&nothing, torus, is_quad).1, [missing]);
        let two = [[0, 1, 2, 3], [4, 5, 6, 7]];
        let apart = Shape { euler: 2, loops: 2, parts: 1 };
        assert_eq!(verify(&two, apart, is_quad).1, [ResultFault::Parts { expected: 1, found: 2 }]);
    }
}
