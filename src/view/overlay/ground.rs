//! A grid on the ground below the mesh. Its lines are at round coordinates of the file, a round
//! length apart, and so show the size of things.

use crate::math::round_down;
use crate::view::camera::UpAxis;
use glam::{DVec3, Vec3};

/// Minimum number of squares along the longer side of the mesh.
const LEAST: f64 = 6.0;
/// Margin of the grid around the mesh, as a fraction of the longer side of the mesh.
const BEYOND: f64 = 0.22;

/// The lines of a grid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ground {
    /// Spacing of the lines, in the unit of the file.
    pub step: f64,
    /// Ends of each line, relative to the view's centre.
    pub lines: Vec<[Vec3; 2]>,
}

impl Ground {
    /// Creates the grid at the height `floor` around the box from `low` to `high`, in file coordinates;
    /// `centre` is that of the view. It has no lines if the box has no size.
    pub fn new([low, high]: [DVec3; 2], floor: f64, up: UpAxis, centre: DVec3) -> Ground {
        let [right, away, sky] = up.axes().map(|axis| axis.as_dvec3());
        let size = high - low;
        let longer = size.dot(right.abs()).max(size.dot(away.abs()));
        let step = round_down(longer / LEAST);
        if step == 0.0 {
            return Ground::default();
        }
        let span = |axis: DVec3| {
            let axis = axis.abs();
            let from = ((low.dot(axis) - BEYOND * longer) / step).floor();
            let to = ((high.dot(axis) + BEYOND * longer) / step).ceil();
            (axis, from as i64, to as i64)
        };
        let mut lines = Vec::new();
        let (across, along) = (span(right), span(away));
        for ((axis, from, to), (other, first, last)) in [(across, along), (along, across)] {
            for k in from..=to {
                let at = axis * (k as f64 * step) + sky * floor - centre;
                let ends = [first, last].map(|end| (at + other * (end as f64 * step)).as_vec3());
                lines.push(ends);
            }
        }
        Ground { step, lines }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_at_round_coordinates_around_and_below_the_mesh() {
        for (up, flat, sky) in [(UpAxis::Z, [0, 1], 2), (UpAxis::Y, [0, 2], 1)] {
            let mut high = DVec3::splat(21.7);
            high[sky] = 4.0;
            let low = DVec3::splat(0.3);
            let centre = DVec3::new(10.0, 7.0, 3.0);
            let ground = Ground::new([low, high], 0.1, up, centre);
            assert_eq!(ground.step, 2.0);
            let ends: Vec<DVec3> =
                ground.lines.iter().flatten().map(|end| end.as_dvec3() + centre).collect();
            for end in &ends {
                assert!((end[sky] - 0.1).abs() < 1e-6);
                for axis in flat {
                    assert!((end[axis] / 2.0 - (end[axis] / 2.0).round()).abs() < 1e-6);
                }
            }
            for axis in flat {
                assert!(ends.iter().any(|end| end[axis] < 0.3));
                assert!(ends.iter().any(|end| end[axis] > 21.7));
            }
            assert!(ground.lines.len() > 20 && ground.lines.len() < 60);
        }
    }

    #[test]
    fn one_point_has_no_ground() {
        let point = DVec3::splat(2.0);
        assert_eq!(Ground::new([point; 2], 0.0, UpAxis::Z, point), Ground::default());
    }
}
