//! Places that the panels cannot follow, because the surface has details there smaller than a panel.

use crate::math::{Vec3, mean};
use std::collections::BTreeMap;

/// Gathers points that are nearer to each other than `near`, directly or over others, and returns the
/// mean of each group, the largest group first.
pub(in crate::quads) fn places(points: &[Vec3<f64>], near: f64) -> Vec<Vec3<f64>> {
    // Those that are in no group yet.
    let mut left = cells(points, near);
    let mut take = |cell: [i64; 3], is_taken: &dyn Fn(usize) -> bool| -> Vec<usize> {
        let cell = left.get_mut(&cell);
        cell.map_or_else(Vec::new, |cell| cell.extract_if(.., |k| is_taken(*k)).collect())
    };
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for first in 0..points.len() {
        let mut group = take(cell_of(points[first], near), &|k| k == first);
        let mut at = 0;
        while let Some(&k) = group.get(at) {
            at += 1;
            for beside in cells_around(points[k], near) {
                let is_near = |other: usize| (points[other] - points[k]).length() < near;
                group.extend(take(beside, &is_near));
            }
        }
        group.sort_unstable();
        groups.push(group);
    }
    groups.retain(|group| !group.is_empty());
    groups.sort_by_key(|group| std::cmp::Reverse(group.len()));
    groups.into_iter().map(|group| mean(group.into_iter().map(|k| points[k]))).collect()
}

/// Returns for each point the places that are nearer to it than `near`.
pub(in crate::quads) fn places_near(
    points: &[Vec3<f64>],
    places: &[Vec3<f64>],
    near: f64,
) -> impl Iterator<Item = Vec<usize>> {
    let cells = cells(places, near);
    points.iter().map(move |&point| {
        let around = cells_around(point, near).filter_map(|cell| cells.get(&cell)).flatten();
        around.copied().filter(|&k| (places[k] - point).length() < near).collect()
    })
}

/// Points by the cells of this size in which they are.
fn cells(points: &[Vec3<f64>], size: f64) -> BTreeMap<[i64; 3], Vec<usize>> {
    let mut cells: BTreeMap<_, Vec<usize>> = BTreeMap::new();
    for (k, &point) in points.iter().enumerate() {
        cells.entry(cell_of(point, size)).or_default().push(k);
    }
    cells
}

fn cell_of(point: Vec3<f64>, size: f64) -> [i64; 3] {
    <[f64; 3]>::from(point).map(|x| (x / size).floor() as i64)
}

/// The cell of a point and those beside it.
fn cells_around(point: Vec3<f64>, size: f64) -> impl Iterator<Item = [i64; 3]> {
    let [x, y, z] = cell_of(point, size);
    (0..27).map(move |k| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_points_are_one_place() {
        let at = |x: f64| Vec3::new(x, 0.0, 0.0);
        let found = places(&[at(0.0), at(9.0), at(1.0), at(2.0)], 1.5);
        assert_eq!(found, [at(1.0), at(9.0)]);
        assert!(places(&[], 1.0).is_empty());
    }

    /// Of many points every so many was looked at: small places beside a large one were not counted.
    #[test]
    fn every_place_counts_however_many_points_are_at_another() {
        let large = (0..3000).map(|k| Vec3::new(f64::from(k % 100), f64::from(k / 100), 0.0));
        let small = (1..=40).map(|k| Vec3::new(0.0, 0.0, 10.0 * f64::from(k)));
        let points: Vec<_> = large.chain(small).collect();
        let found = places(&points, 2.5);
        assert_eq!((found.len(), found[0]), (41, Vec3::new(49.5, 14.5, 0.0)));
    }
}
