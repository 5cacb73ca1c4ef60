//! Which part of a surface each part of its cover lies on.

use crate::math::{Vec3, mean, sort_by_number};
use crate::mesh::{Point, Surface};
use std::collections::{BTreeMap, BTreeSet};

/// Returns for each of several parts, given by their faces, the part of the old faces, as of `part_of`,
/// that is nearer than `near` to most of its vertices. Ties, as of a strip one panel wide at an open seam:
/// the least sum of distances to the centres of its faces. Still ties, as of layers at one place: one not
/// yet given to another part. None for a part without faces.
pub(super) fn parts_under(
    positions: &[Point],
    parts: &[Vec<&[u32]>],
    surface: &Surface,
    near: f64,
    part_of: impl Fn(u32) -> Option<u32>,
) -> Vec<Option<u32>> {
    let at_most_vertices = |faces: &[&[u32]]| -> Vec<u32> {
        let vertices: BTreeSet<u32> = faces.iter().copied().flatten().copied().collect();
        let mut counts: BTreeMap<u32, usize> = BTreeMap::new();
        for v in vertices {
            let found = surface.faces_near(positions[v as usize], near);
            let olds: BTreeSet<u32> = found.into_iter().filter_map(&part_of).collect();
            olds.into_iter().for_each(|old| *counts.entry(old).or_default() += 1);
        }
        let most = counts.values().copied().max();
        counts.into_iter().filter(|(_, count)| Some(*count) == most).map(|(old, _)| old).collect()
    };
    let at_centres = |olds: Vec<u32>, faces: &[&[u32]]| -> Vec<u32> {
        let corners = |face: &[u32]| mean(face.iter().map(|&v| Vec3::from(positions[v as usize])));
        let centres: Vec<Point> = faces.iter().map(|face| corners(face).into()).collect();
        let distance = |centre: Point, part: u32| {
            let is_own = |old: u32| part_of(old) == Some(part);
            surface.closest_triangle_of(centre, f64::INFINITY, is_own).map(|(_, distance)| distance)
        };
        let sum = |&part: &u32| centres.iter().filter_map(|&centre| distance(centre, part)).sum();
        let sums: Vec<f64> = olds.iter().map(sum).collect();
        // Distances to layers at one place differ by rounding.
        let most = sums.iter().copied().fold(f64::INFINITY, f64::min) + near * faces.len() as f64;
        olds.into_iter().zip(sums).filter(|(_, sum)| *sum <= most).map(|(old, _)| old).collect()
    };
    let candidates = parts.iter().map(|faces| match at_most_vertices(faces) {
        olds if olds.len() > 1 => at_centres(olds, faces),
        olds => olds,
    });
    let candidates: Vec<Vec<u32>> = candidates.collect();
    // Those without a choice take theirs first.
    let mut order: Vec<usize> = (0..parts.len()).collect();
    sort_by_number(&mut order, |&new| candidates[new].len() as u64);
    let mut under = vec![None; parts.len()];
    let mut taken: BTreeSet<u32> = BTreeSet::new();
    for new in order {
        let olds = &candidates[new];
        let own = olds.iter().find(|old| !taken.contains(*old)).or(olds.first());
        under[new] = own.copied();
        taken.extend(own);
    }
    under
}

#[cfg(test)]
mod tests {
    use crate::mesh::{Edited, Mesh};

    /// Appends quads with the lowest corner `at`, with sides `dx` and `dy`, that share their vertices.
    fn append(mesh: &mut Mesh, at: [f64; 2], [dx, dy]: [f64; 2], [columns, rows]: [u32; 2]) {
        let first = mesh.positions.len() as u32;
        for (j, i) in (0..=rows).flat_map(|j| (0..=columns).map(move |i| (j, i))) {
            mesh.positions.push([at[0] + dx * f64::from(i), at[1] + dy * f64::from(j), 0.0]);
        }
        for (j, i) in (0..rows).flat_map(|j| (0..columns).map(move |i| (j, i))) {
            let a = first + (columns + 1) * j + i;
            mesh.faces.push(&[a, a + 1, a + columns + 2, a + columns + 1]);
        }
    }

    /// They came from the part around them if that was first in the file.
    #[test]
    fn panels_in_a_slot_as_narrow_as_they_come_from_what_fills_it() {
        // Two faces around the slot.
        let corners =
            [[0, 0], [6, 0], [6, 2], [5, 2], [5, 1], [1, 1], [1, 2], [0, 2], [6, 3], [0, 3]];
        let faces: [&[u32]; 2] = [&[0, 1, 2, 3, 4, 5, 6, 7], &[7, 6, 3, 2, 8, 9]];
        for wall_first in [true, false] {
            let with_band = |columns: u32| {
                let mut mesh = Mesh::default();
                let band = |mesh: &mut Mesh| {
                    append(mesh, [1.0, 1.0], [4.0 / f64::from(columns), 1.0], [columns, 1]);
                };
                if !wall_first {
                    band(&mut mesh);
                }
                let first = mesh.positions.len() as u32;
                let place = |[x, y]: [u32; 2]| [f64::from(x), f64::from(y), 0.0];
                mesh.positions.extend(corners.map(place));
                for face in faces {
                    let face: Vec<u32> = face.iter().map(|v| first + v).collect();
                    mesh.faces.push(&face);
                }
                if wall_first {
                    band(&mut mesh);
                }
                mesh
            };
            let origins = Edited::covering(&with_band(2), &with_band(4)).origins;
            let expected = if wall_first { [0, 1, 2, 2, 3, 3] } else { [0, 0, 1, 1, 2, 3] };
            assert_eq!(origins.faces.indices(), expected);
            assert!(origins.vertices.iter().all(Option::is_some), "{:?}", origins.vertices);
        }
    }

    /// All came from one layer if both are as large.
    #[test]
    fn each_of_two_layers_at_one_place_has_its_own_panels() {
        // Two sheets of the same size, and a small one on a large one, in both orders.
        let [small, large] = [([1.0, 1.0], 2.0), ([0.0, 0.0], 4.0)];
        for layers in [[large, large], [small, large], [large, small]] {
            let sheets = |[columns, rows]: [u32; 2]| {
                let mut mesh = Mesh::default();
                for (at, side) in layers {
                    let steps = [columns, rows].map(|count| side / f64::from(count));
                    append(&mut mesh, at, steps, [columns, rows]);
                }
                mesh
            };
            let origins = Edited::covering(&sheets([2, 2]), &sheets([4, 3])).origins;
            let of_layers = origins.faces.indices().iter().map(|face| face / 4);
            assert!(of_layers.eq((0..24).map(|panel| panel / 12)), "{layers:?}");
            // The first one stays: the panels came from it.
            let [mut cover, panels] = [sheets([2, 2]), sheets([4, 3])];
            cover.faces = cover.faces.iter().take(4).collect();
            let shift = cover.positions.len() as u32;
            cover.positions.extend(&panels.positions);
            for panel in panels.faces.iter().skip(12) {
                cover.faces.push(&panel.iter().map(|v| v + shift).collect::<Vec<_>>());
            }
            let origins = Edited::covering(&sheets([2, 2]), &cover).origins;
            let of_layers = origins.faces.indices().iter().map(|face| face / 4);
            assert!(of_layers.eq((0..16).map(|face| u32::from(face >= 4))), "{layers:?}");
        }
    }
}
