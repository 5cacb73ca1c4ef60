//! Vertices at one place, up to rounding.

use super::{Mesh, Point, diagonal};
use crate::math::{Vec3, argsort, key_of_number, polygon_sides};

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
    let is_placed = |v: u32| mesh.unplaced.binary_search(&v).is_err();
    let placed = first.iter().filter(|&&v| is_placed(v));
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
    // With cells of twice the tolerance, all points within the tolerance are in at most 8 cells.
    // Adding zero turns -0 into +0.
    let cell = |x: f64| (x / (2.0 * tolerance)).floor() + 0.0;
    let cell_of = |p: Point| p.map(cell);
    let by_cell = |a: [f64; 3], b: [f64; 3]| {
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
    };
    let cell_at = |v: u32| cell_of(positions[v as usize]);
    let order = sorted_by_cell(positions.iter().copied().map(cell_of).collect());
    let begin = |near: [f64; 3]| order.partition_point(|&v| by_cell(cell_at(v), near).is_lt());
    // The vertices of each cell that are not merged so far, from the place where it begins in
    // `order`, and their number.
    let mut apart = vec![0; positions.len()];
    let mut counts = vec![0; positions.len()];
    let mut first: Vec<u32> = (0..positions.len() as u32).collect();
    for (vertex, &here) in positions.iter().enumerate() {
        let [low, high] = [-tolerance, tolerance].map(|by| here.map(|x| cell(x + by)));
        let mut nearest = vertex as u32;
        for corner in 0..8 {
            let near: [f64; 3] =
                std::array::from_fn(|i| if corner >> i & 1 == 0 { low[i] } else { high[i] });
            let begin = begin(near);
            // Without such a cell this is the next one, whose vertices are too far away.
            let count = counts.get(begin).copied().unwrap_or(0);
            for &other in apart.iter().skip(begin).take(count) {
                let away = Vec3::from(positions[other as usize]) - Vec3::from(here);
                if groups[other as usize] == groups[vertex] && away.length() <= tolerance {
                    nearest = nearest.min(other);
                }
            }
        }
        first[vertex] = nearest;
        if nearest as usize == vertex {
            let begin = begin(cell_of(here));
            apart[begin + counts[begin]] = nearest;
            counts[begin] += 1;
        }
    }
    first
}

/// Returns the indices of cells sorted by (x, y, z, index), by stable sorts by z, then y, then x.
fn sorted_by_cell(cells: Vec<[f64; 3]>) -> Vec<u32> {
    let mut order: Vec<u32> = (0..cells.len() as u32).collect();
    for axis in [2, 1, 0] {
        let keys = order.iter().map(|&v| key_of_number(cells[v as usize][axis]));
        order = argsort(keys).into_iter().map(|place| order[place as usize]).collect();
    }
    order
}
