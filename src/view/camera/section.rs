//! A plane that cuts the model open: the far side is neither drawn nor picked.

use crate::view::model::ViewError;
use glam::{Vec3, Vec4};

/// The half space that is kept: points whose component along `normal` is at most `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Unit normal, pointing out of the kept side.
    pub normal: Vec3,
    /// Position of the plane along the normal, relative to the view's centre.
    pub offset: f32,
}

impl Section {
    /// Creates a section across an axis of the file (0 to 2), at a fraction `part` of the box. It
    /// keeps the side before the plane along the axis, or the other one if `is_turned`.
    ///
    /// # Errors
    /// An axis that does not exist.
    pub fn across(
        axis: usize,
        part: f32,
        is_turned: bool,
        [low, high]: [Vec3; 2],
    ) -> Result<Section, ViewError> {
        let Some(&along) = Vec3::AXES.get(axis) else {
            let index = u32::try_from(axis).unwrap_or(u32::MAX);
            return Err(ViewError::Index { what: "axes", index, count: Vec3::AXES.len() });
        };
        let at = low.lerp(high, part.clamp(0.0, 1.0)).dot(along);
        Ok(if is_turned {
            Section { normal: -along, offset: -at }
        } else {
            Section { normal: along, offset: at }
        })
    }

    /// Returns the distance of a point from the plane, negative where it is cut off.
    pub fn within(&self, point: Vec3) -> f32 {
        self.offset - point.dot(self.normal)
    }

    /// Returns normal and offset as four numbers.
    pub fn numbers(&self) -> Vec4 {
        self.normal.extend(self.offset)
    }

    /// Clips a mesh; returns its points, and the triangles between them.
    pub fn kept(&self, positions: &[Vec3], triangles: &[[u32; 3]]) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let mut points = positions.to_vec();
        let mut left = Vec::with_capacity(triangles.len());
        for &triangle in triangles {
            let corners = triangle.map(|vertex| positions[vertex as usize]);
            if corners.iter().all(|&corner| self.within(corner) >= 0.0) {
                left.push(triangle);
                continue;
            }
            let first = points.len() as u32;
            points.extend(clipped(&corners, |point| self.within(point)));
            left.extend((first + 2..points.len() as u32).map(|last| [first, last - 1, last]));
        }
        (points, left)
    }

    /// Returns the intersection of the plane with a triangle; none if there is none.
    pub fn through(&self, corners: [Vec3; 3]) -> Option<[Vec3; 2]> {
        let sides = [0, 1, 2].map(|i| [corners[i], corners[(i + 1) % 3]]);
        let mut met = sides.into_iter().filter_map(|[a, b]| {
            let (from, to) = (self.within(a), self.within(b));
            ((from >= 0.0) != (to >= 0.0)).then(|| a.lerp(b, from / (from - to)))
        });
        Some([met.next()?, met.next()?])
    }

    /// Returns the part of a segment that is kept; none if all of it is cut off.
    pub fn cut(&self, [a, b]: [Vec3; 2]) -> Option<[Vec3; 2]> {
        let (from, to) = (self.within(a), self.within(b));
        if from < 0.0 && to < 0.0 {
            return None;
        }
        let middle = || a.lerp(b, from / (from - to));
        Some([if from < 0.0 { middle() } else { a }, if to < 0.0 { middle() } else { b }])
    }
}

/// Returns the part of a convex polygon where the linear function `within` is not negative.
pub fn clipped(corners: &[Vec3], within: impl Fn(Vec3) -> f32) -> Vec<Vec3> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (i, &from) in corners.iter().enumerate() {
        let to = corners[(i + 1) % corners.len()];
        let (here, there) = (within(from), within(to));
        if here >= 0.0 {
            kept.push(from);
        }
        if (here >= 0.0) != (there >= 0.0) {
            kept.push(from.lerp(to, here / (here - there)));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: [Vec3; 2] = [Vec3::splat(-1.0), Vec3::new(3.0, 1.0, 1.0)];

    #[test]
    fn it_lies_a_part_of_the_way_through_the_model() {
        let section = Section::across(0, 0.25, false, BOX).unwrap();
        assert_eq!(section.within(Vec3::new(-1.0, 9.0, 9.0)), 1.0);
        assert_eq!(section.within(Vec3::new(3.0, 0.0, 0.0)), -3.0);
        let turned = Section::across(0, 0.25, true, BOX).unwrap();
        assert_eq!(turned.within(Vec3::new(3.0, 0.0, 0.0)), 3.0);
        assert!(Section::across(3, 0.5, false, BOX).is_err());
    }

    #[test]
    fn a_mesh_loses_what_is_beyond_the_plane() {
        let section = Section::across(0, 0.25, false, BOX).unwrap();
        let points = [Vec3::NEG_X, Vec3::X, Vec3::Y - Vec3::X, Vec3::X * 2.0, Vec3::ONE];
        let (kept, triangles) = section.kept(&points, &[[0, 1, 2], [1, 3, 4]]);
        let area = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|vertex| kept[vertex as usize]);
            (b - a).cross(c - a).length() * 0.5
        };
        // A corner of half the length and half the height is cut off a triangle of area 1.
        assert_eq!(triangles.into_iter().map(area).sum::<f32>(), 0.75);
        assert!(section.kept(&points, &[[1, 3, 4]]).1.is_empty());
    }

    #[test]
    fn segments_and_polygons_end_at_the_plane() {
        let section = Section::across(0, 0.25, false, BOX).unwrap();
        let ends = [Vec3::NEG_X, Vec3::X * 3.0];
        assert_eq!(section.cut(ends), Some([Vec3::NEG_X, Vec3::ZERO]));
        assert_eq!(section.cut([ends[1], ends[0]]), Some([Vec3::ZERO, Vec3::NEG_X]));
        assert_eq!(section.cut([Vec3::X, ends[1]]), None);
        let corners = [Vec3::NEG_X, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::new(-1.0, 1.0, 0.0)];
        let kept = clipped(&corners, |point| section.within(point));
        assert_eq!(kept, [Vec3::NEG_X, Vec3::ZERO, Vec3::Y, Vec3::new(-1.0, 1.0, 0.0)]);
        let triangle = [corners[0], corners[1], corners[3]];
        assert_eq!(section.through(triangle), Some([Vec3::ZERO, Vec3::Y * 0.5]));
        assert_eq!(section.through([Vec3::X, Vec3::ONE, ends[1]]), None);
        assert!(clipped(&corners[1..3], |point| section.within(point)).is_empty());
    }
}
