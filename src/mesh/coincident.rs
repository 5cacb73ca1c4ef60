//! Vertices at one place, up to rounding.

use super::{Mesh, Point, diagonal};
use crate::math::{Cells, Vec3, polygon_sides};

/// Upper bound on the welding distance, as a fraction of the diagonal of the bounding box.
const TOLERANCE: f64 = 1e-6;
/// Upper bound on it as a fraction of the shortest edge, so that no edge vanishes.
const OF_SHORTEST_EDGE: f64 = 0.1;

/// Returns the welding distance of `mesh`; `None` if no edge has a length.
pub(super) fn tolerance(mesh: &Mesh) -> Option<f64> {
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    let sides = mesh.faces.iter().flat_map(polygon_sides);
    let squared = sides.map(|[a, b]| (at(b) - at(a)).length_squared());
    let shortest = squared.filter(|squared| *squared > 0.0).reduce(f64::min)?.sqrt();
    let diagonal = diagonal(&mesh.body_of(&mesh.positions));
    Some((TOLERANCE * diagonal).min(OF_SHORTEST_EDGE * shortest))
}

/// Returns for each vertex the first one of its group within `tolerance` that does not itself lie on
/// an earlier one. Vertices of no group, and those that are not in the file, lie on none: where the
/// latter are is a guess.
pub(crate) fn first_of_group(
    mesh: &Mesh,
    group: impl Fn(u32) -> Option<u32>,
    tolerance: f64,
) -> Vec<u32> {
    let mut first: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    let placed = first.iter().filter(|&&v| !mesh.is_unplaced(v));
    let (vertices, groups): (Vec<u32>, Vec<u32>) =
        placed.filter_map(|&v| Some((v, group(v)?))).unzip();
    let positions: Vec<Point> = vertices.iter().map(|&v| mesh.positions[v as usize]).collect();
    for (&v, nearest) in vertices.iter().zip(first_within(&positions, &groups, tolerance)) {
        first[v as usize] = vertices[nearest as usize];
    }
    first
}

/// Returns for each vertex whether a face has two corners at its place, where `first` is of
/// [`first_of_group`]: merged there, the face would lose an edge.
pub(super) fn within_face(mesh: &Mesh, first: &[u32]) -> Vec<bool> {
    let mut within_face = vec![false; mesh.positions.len()];
    for face in mesh.faces.iter() {
        let mut at: Vec<u32> = face.iter().map(|&v| first[v as usize]).collect();
        at.sort_unstable();
        let twice = at.windows(2).filter(|pair| pair[0] == pair[1]);
        twice.for_each(|pair| within_face[pair[0] as usize] = true);
    }
    first.iter().map(|&first| within_face[first as usize]).collect()
}

/// Returns for each position the first one of its group within `tolerance` that is not itself
/// merged.
fn first_within(positions: &[Point], groups: &[u32], tolerance: f64) -> Vec<u32> {
    // Those that are not merged so far.
    let mut apart = Cells::new(tolerance);
    let first = |(vertex, &here): (usize, &Point)| {
        let here = Vec3::from(here);
        let is_own = |&(other, distance): &(u32, f64)| {
            groups[other as usize] == groups[vertex] && distance <= tolerance
        };
        let first = apart.near(here).filter(is_own).map(|(other, _)| other).min();
        if first.is_none() {
            apart.add(here, vertex as u32);
        }
        first.unwrap_or(vertex as u32)
    };
    positions.iter().enumerate().map(first).collect()
}
