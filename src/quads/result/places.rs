//! Places that the panels cannot follow, because the surface has details there smaller than a panel.

use crate::math::Vec3;

/// The most points that are looked at: of more, every so many.
const MOST: usize = 2000;

/// Gathers points that are nearer to each other than `near`, directly or over others, and returns the
/// mean of each group, the largest group first.
pub(in crate::quads) fn places(points: &[Vec3<f64>], near: f64) -> Vec<Vec3<f64>> {
    let every = points.len().div_ceil(MOST).max(1);
    let points: Vec<Vec3<f64>> = points.iter().copied().step_by(every).collect();
    let mut group: Vec<usize> = (0..points.len()).collect();
    for i in 0..points.len() {
        for j in 0..i {
            if group[i] != group[j] && (points[i] - points[j]).length() < near {
                let (from, to) = (group[i].max(group[j]), group[i].min(group[j]));
                group.iter_mut().filter(|one| **one == from).for_each(|one| *one = to);
            }
        }
    }
    let mut sums: Vec<(usize, Vec3<f64>)> = vec![(0, Vec3::zero()); points.len()];
    for (&group, &point) in group.iter().zip(&points) {
        sums[group].0 += 1;
        sums[group].1 += point;
    }
    sums.retain(|(count, _)| *count > 0);
    sums.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    sums.into_iter().map(|(count, sum)| sum * (1.0 / count as f64)).collect()
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
}
