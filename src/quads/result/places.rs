//! Places that the panels cannot follow, because the surface has details there smaller than a panel.

use crate::math::{Cells, Vec3, mean, sort_by_number};

/// Places nearer to each other than this many panels are one.
pub(in crate::quads) const NEAR: f64 = 2.5;

/// Gathers points that are nearer to each other than `near`, directly or over others, and returns the
/// mean of each group, the largest group first.
pub(in crate::quads) fn places(points: &[Vec3<f64>], near: f64) -> Vec<Vec3<f64>> {
    // Those that are in no group yet.
    let mut left = cells(points, near);
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for &first in points {
        let mut group = left.take(first);
        let mut at = 0;
        while let Some(&k) = group.get(at) {
            at += 1;
            group.extend(left.take(points[k]));
        }
        group.sort_unstable();
        groups.push(group);
    }
    groups.retain(|group| !group.is_empty());
    // The largest first.
    sort_by_number(&mut groups, |group| !(group.len() as u64));
    groups.into_iter().map(|group| mean(group.into_iter().map(|k| points[k]))).collect()
}

/// Returns for each point the places that are nearer to it than `near`.
pub(in crate::quads) fn places_near(
    points: &[Vec3<f64>],
    places: &[Vec3<f64>],
    near: f64,
) -> impl Iterator<Item = Vec<usize>> {
    let cells = cells(places, near);
    let of_point = move |&point: &Vec3<f64>| {
        let near = cells.near(point).filter(|(_, distance)| *distance < near);
        near.map(|(place, _)| place).collect()
    };
    points.iter().map(of_point)
}

fn cells(points: &[Vec3<f64>], reach: f64) -> Cells<usize> {
    let mut cells = Cells::new(reach);
    points.iter().enumerate().for_each(|(k, &point)| cells.add(point, k));
    cells
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
