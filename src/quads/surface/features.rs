//! Creases of a surface: edges that turn, in sets long enough to be meant.

use super::edges::Edges;
use super::input::as_mesh;
use super::refine::Line;
use crate::math::Vec3;
use crate::mesh::{Topology, crease_edges};
use crate::quads::Side;

/// Marks the sides on the boundary, and those on creases: edges between triangles whose normals turn
/// by more than `crease` degrees, in connected sets of at least the length `shortest`: `#T by 3`.
pub(super) fn lines(
    positions: &[Vec3<f64>],
    triangles: &[[usize; 3]],
    crease: Option<f64>,
    shortest: f64,
) -> Vec<[Line; 3]> {
    let edges = Edges::new(triangles);
    let mesh = as_mesh(positions, triangles);
    // Both number edges in the order of their ends.
    let is_crease = crease.map(|degrees| crease_edges(&mesh, &Topology::new(&mesh), degrees));
    let line = |(e, sides): (usize, &Vec<Side>)| match (sides.len(), &is_crease) {
        (1, _) => Line::Boundary,
        (2, Some(is_crease)) if is_crease[e] => Line::Crease,
        _ => Line::None,
    };
    let mut line: Vec<Line> = edges.sides.iter().enumerate().map(line).collect();
    let mut at_vertex: Vec<Vec<usize>> = vec![Vec::new(); positions.len()];
    for (e, _) in line.iter().enumerate().filter(|&(_, &line)| line == Line::Crease) {
        edges.ends[e].iter().for_each(|&v| at_vertex[v].push(e));
    }
    let mut seen = vec![false; line.len()];
    for first in 0..line.len() {
        if line[first] != Line::Crease || seen[first] {
            continue;
        }
        seen[first] = true;
        let (mut set, mut next, mut length) = (vec![first], 0, 0.0);
        while let Some(&e) = set.get(next) {
            next += 1;
            let [a, b] = edges.ends[e];
            length += (positions[a] - positions[b]).length();
            for &other in at_vertex[a].iter().chain(&at_vertex[b]) {
                if !std::mem::replace(&mut seen[other], true) {
                    set.push(other);
                }
            }
        }
        if length < shortest {
            set.into_iter().for_each(|e| line[e] = Line::None);
        }
    }
    edges.of_side.iter().map(|sides| sides.map(|e| line[e])).collect()
}
