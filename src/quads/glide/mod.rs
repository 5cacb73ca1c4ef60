//! Vertices glide along the surface until the panels are nearer to circles: a local step to the
//! circles that fit the panels best, a global one back to the surface, as in the paper (section 3.1)
//! but with nothing else asked. What lies on the surface costs nothing; later moves off it do.

mod walk;

use super::extract::{Node, Place};
use super::grid_map::{Side, Triangulation};
use crate::math::{CircleFit, Vec3, centre, twice_vector_area};
use walk::walk;

/// Number of steps.
const STEPS: usize = 20;
/// No edge becomes shorter than this fraction of its length.
const SHORTEST: f64 = 0.5;
/// No panel turns, nor shrinks, so that its area along its old normal is less than this fraction.
const LEAST_AREA: f64 = 0.3;
/// Rounds in which the vertices of panels that are too small go back.
const ROUNDS: usize = 10;

/// Lets the nodes of faces glide. Those on the boundary and on features stay.
pub(super) fn glide(surface: &Triangulation, nodes: &mut [Node], faces: &[Vec<usize>]) {
    let holds = holds(surface, nodes);
    let first = first_triangles(surface);
    let mut moved: Vec<Node> = nodes.to_vec();
    for _ in 0..STEPS {
        let mut sums = vec![(Vec3::zero(), 0.0); nodes.len()];
        for face in faces {
            let mut points: Vec<Vec3<f64>> =
                face.iter().map(|&node| moved[node].position).collect();
            let middle = centre(&mut points);
            let mut on_circle = vec![Vec3::zero(); points.len()];
            let has_circle = CircleFit::project(&points, &mut on_circle);
            for (k, &node) in face.iter().enumerate() {
                let goal = if has_circle { on_circle[k] } else { points[k] };
                sums[node].0 += goal + middle;
                sums[node].1 += 1.0;
            }
        }
        for (k, (sum, count)) in sums.into_iter().enumerate() {
            if !holds[k] && count > 0.0 {
                let start = triangle(&first, &moved[k]);
                let (triangle, position) = walk(surface, start, sum * (1.0 / count));
                moved[k] = Node { place: Place::Inside(triangle), position, ..moved[k] };
            }
        }
    }
    for _ in 0..ROUNDS {
        let mut back: Vec<usize> = Vec::new();
        for face in faces.iter().filter(|face| is_worse(nodes, &moved, face)) {
            back.extend(face.iter().filter(|&&node| moved[node].position != nodes[node].position));
        }
        if back.is_empty() {
            nodes.copy_from_slice(&moved);
            return;
        }
        back.iter().for_each(|&node| moved[node] = nodes[node]);
    }
}

/// Whether a face has shrunk too much, as a whole or at an edge.
fn is_worse(before: &[Node], after: &[Node], face: &[usize]) -> bool {
    let area = |nodes: &[Node]| twice_vector_area(face.iter().map(|&node| nodes[node].position));
    let old = area(before);
    let shrinks = area(after).dot(old) < LEAST_AREA * old.dot(old);
    let length = |nodes: &[Node], k: usize| {
        let [a, b] = [face[k], face[(k + 1) % face.len()]];
        (nodes[b].position - nodes[a].position).length()
    };
    let is_moved = face.iter().any(|&node| before[node].position != after[node].position);
    is_moved
        && (shrinks || (0..face.len()).any(|k| length(after, k) < SHORTEST * length(before, k)))
}

/// Whether each node stays: on the boundary, or on a feature.
pub(super) fn holds(surface: &Triangulation, nodes: &[Node]) -> Vec<bool> {
    let mut on_feature = vec![false; surface.positions.len()];
    for side in surface.sides().filter(|&side| surface.is_feature(side)) {
        (0..2).for_each(|k| on_feature[surface.corner(side.triangle, side.side + k)] = true);
    }
    let stays = |node: &Node| {
        node.boundary
            || match node.place {
                Place::Vertex(v) => on_feature[v],
                Place::Side(side) => surface.is_feature(side),
                Place::Inside(_) => false,
            }
    };
    nodes.iter().map(stays).collect()
}

/// The first triangle at each vertex.
fn first_triangles(surface: &Triangulation) -> Vec<usize> {
    let mut first = vec![usize::MAX; surface.positions.len()];
    for (t, corners) in surface.triangles.iter().enumerate().rev() {
        corners.iter().for_each(|&v| first[v] = t);
    }
    first
}

/// A triangle that contains a node; `first` is that of each vertex.
fn triangle(first: &[usize], node: &Node) -> usize {
    match node.place {
        Place::Inside(triangle) | Place::Side(Side { triangle, .. }) => triangle,
        Place::Vertex(v) => first[v],
    }
}
