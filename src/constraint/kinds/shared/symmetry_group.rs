//! A mirror plane or a rotation axis, and the pairing of points that are images of each other.

use crate::math::{NearestPoints, UnitPolygon, Vec3, argsort, key_of_number};

/// The symmetries of a mirror plane or of an n-fold axis through the origin.
#[derive(Clone, Debug)]
pub(crate) enum SymmetryGroup {
    /// The plane with this unit normal.
    Mirror(Vec3<f64>),
    /// The axis along this unit vector, and the cosine and sine of each rotation.
    Axis(Vec3<f64>, UnitPolygon),
}

impl SymmetryGroup {
    /// The number of symmetries, including the identity.
    pub(crate) fn order(&self) -> usize {
        match self {
            SymmetryGroup::Mirror(_) => 2,
            SymmetryGroup::Axis(_, turns) => turns.len(),
        }
    }

    /// Returns the image of `v` under symmetry `k`: the first one applied `k` times.
    pub(crate) fn image(&self, k: usize, v: Vec3<f64>) -> Vec3<f64> {
        match self {
            SymmetryGroup::Mirror(_) if k == 0 => v,
            SymmetryGroup::Mirror(normal) => v - *normal * (2.0 * normal.dot(v)),
            SymmetryGroup::Axis(axis, turns) => {
                let [cosine, sine] = turns[k];
                let along = *axis * axis.dot(v);
                along + (v - along) * cosine + axis.cross(v) * sine
            }
        }
    }

    /// Returns the component of a translation that moves the plane or the axis.
    fn across(&self, v: Vec3<f64>) -> Vec3<f64> {
        match self {
            SymmetryGroup::Mirror(normal) => *normal * normal.dot(v),
            SymmetryGroup::Axis(axis, _) => v - *axis * axis.dot(v),
        }
    }

    /// Returns for each point the index of its first image: the point nearest to its image under
    /// the first symmetry. None if that is farther away than `tolerance` times the greatest
    /// distance of a point from the origin, or if repeating this does not lead back to the point.
    ///
    /// The plane or axis starts at the origin. It is then shifted by the median offset of the
    /// nearest points from the images; a median is robust to points without a partner.
    pub(crate) fn pairs(&self, points: &[Vec3<f64>], tolerance: f64) -> Vec<Option<usize>> {
        let extent = points.iter().fold(0.0f64, |m, p| m.max(p.length_and_direction().0));
        if extent == 0.0 {
            return vec![None; points.len()];
        }
        let points: Vec<_> =
            points.iter().map(|p| Vec3::new(p.x / extent, p.y / extent, p.z / extent)).collect();
        let tree = NearestPoints::new(&points);
        let mut shift = Vec3::zero();
        let mut nearest = Vec::new();
        for _ in 0..ROUNDS {
            nearest.clear();
            for (i, p) in points.iter().enumerate() {
                let image = self.image(1, *p) + shift;
                let j = tree.nearest(image, i);
                nearest.push((j, points[j] - image));
            }
            let off = self.across(median(nearest.iter().map(|(_, off)| *off)));
            if off.length() <= 0.01 * tolerance {
                break;
            }
            shift += off;
        }
        let next: Vec<_> =
            nearest.into_iter().map(|(j, off)| (off.length() <= tolerance).then_some(j)).collect();
        let comes_back = |i: usize| {
            let end = (0..self.order()).try_fold(i, |at, _| next[at]);
            next[i].filter(|_| end == Some(i))
        };
        (0..points.len()).map(comes_back).collect()
    }
}

/// The most shifts of the plane or axis.
const ROUNDS: usize = 10;

/// Returns the median of each coordinate.
fn median(vectors: impl Iterator<Item = Vec3<f64>> + Clone) -> Vec3<f64> {
    let middle = |coordinate: fn(Vec3<f64>) -> f64| {
        let all: Vec<f64> = vectors.clone().map(coordinate).collect();
        all[argsort(all.iter().map(|&x| key_of_number(x)))[all.len() / 2] as usize]
    };
    Vec3::new(middle(|v| v.x), middle(|v| v.y), middle(|v| v.z))
}

#[cfg(test)]
mod tests {
    use super::SymmetryGroup;
    use crate::math::{UnitPolygon, Vec3};

    #[test]
    fn images_are_found_next_to_points_without_a_partner() {
        let mirror = SymmetryGroup::Mirror(Vec3::new(1.0, 0.0, 0.0));
        let right = (0..40).map(|i| {
            let i = f64::from(i);
            Vec3::new(0.1 + 0.02 * i, (i * i) % 7.0 / 7.0, (i * 3.0) % 11.0 / 11.0)
        });
        let mut points: Vec<_> = right.flat_map(|p| [p, mirror.image(1, p)]).collect();
        // A point on the plane, and two without a partner.
        points.extend([
            Vec3::new(0.0, 0.5, 0.5),
            Vec3::new(0.7, 2.0, 0.0),
            Vec3::new(0.9, 2.0, 0.3),
        ]);
        for offset in [0.0, 0.02] {
            let moved: Vec<_> =
                points.iter().map(|p| (*p + Vec3::new(offset, 0.0, 0.0)) * 1e200).collect();
            let found = mirror.pairs(&moved, 1e-3);
            for (i, found) in found[..80].iter().enumerate() {
                assert_eq!(*found, Some(i ^ 1));
            }
            assert_eq!(found[80..], [Some(80), None, None]);
        }
    }

    #[test]
    fn a_ring_goes_round_and_its_middle_stays() {
        let axis = SymmetryGroup::Axis(Vec3::new(0.0, 0.0, 1.0), UnitPolygon::new(6));
        let mut points: Vec<_> = (0..6).map(|k| axis.image(k, Vec3::new(1.0, 0.2, 0.0))).collect();
        points.push(Vec3::new(0.0, 0.0, 1.0));
        let found: Vec<_> = axis.pairs(&points, 1e-3).into_iter().flatten().collect();
        assert_eq!(found, [1, 2, 3, 4, 5, 0, 6]);
        // With five of six points no cycle closes.
        assert_eq!(axis.pairs(&points[1..6], 1e-3), [None; 5]);
    }
}
