//! The space above and below a triangle in which nothing is nearer than the triangle itself.
//!
//! Let `p` be at height `d` above a triangle, and its foot at least `a` inside one side. Let
//! another triangle lie wholly beyond that side, and rise from it by an angle of at most `theta`
//! towards `p`. It is not nearer than the triangle if `p` is below the plane that halves the angle
//! between the two, `d tan(theta / 2) <= a`. What meets the triangle in a corner can lie beyond neither side
//! of the corner, but beyond a line across it. On a surface of small folds all this together leaves
//! few points for which other triangles must be looked at.

use super::triangle::{Corners, Over, Planes, splat};
use crate::math::{Lane, Vec3};

/// For the points above a triangle, and for those below it.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct TriangleSafeRegion {
    /// `tan(theta / 2)` of all that is beyond the sides ab, bc, ca.
    beyond_sides: [[f32; 3]; 2],
    /// Of all that is beyond the corners a, b, c, times what the sum of the distances inside
    /// their two sides is larger than the distance inside the line across.
    beyond_corners: [[f32; 3]; 2],
    /// The heights up to which this is all that there is. Negative where nothing is known.
    heights: [f32; 2],
}

/// The two sides that meet in each corner.
const MEETING: [[usize; 2]; 3] = [[2, 0], [0, 1], [1, 2]];

impl TriangleSafeRegion {
    /// With nothing else around, as far as that is known.
    pub(crate) fn up_to(height: f64) -> TriangleSafeRegion {
        let nothing = [[0.0; 3]; 2];
        let heights = [rounded_down(height); 2];
        TriangleSafeRegion { beyond_sides: nothing, beyond_corners: nothing, heights }
    }

    /// Shrinks by what the triangle `other` makes nearer to it than the triangle of this clearing,
    /// which has these `planes` and `corners`. Below the height `far`, the other one does not matter.
    pub(crate) fn clear_of(
        &mut self,
        planes: &Planes,
        corners: &Corners,
        other: &Corners,
        far: f64,
    ) {
        let over = other.at.map(|corner| over_exactly(planes, corners, corner));
        let normals = planes.side_normals();
        let across = MEETING.map(|[i, j]| (normals[i] + normals[j]).length());
        for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
            let heights = over.map(|over| sign * over.height);
            if heights.iter().all(|&height| height <= 0.0) {
                continue;
            }
            // Beyond several of them, the one from which it rises least counts.
            let mut least = (f64::INFINITY, 0.0, &mut self.heights[side]);
            let lines = self.beyond_sides[side].iter_mut().chain(&mut self.beyond_corners[side]);
            for (k, known) in lines.enumerate() {
                let (out, times) = match k {
                    0..3 => (over.map(|over| over.out[k]), 1.0),
                    _ => {
                        let [i, j] = MEETING[k - 3];
                        let times = across[k - 3];
                        (over.map(|over| (over.out[i] + over.out[j]) / times), times)
                    }
                };
                if out.iter().all(|&out| out >= 0.0) {
                    let rise = |i: usize| half_tangent(heights[i], out[i]);
                    let rise = Lane::max(rise(0), Lane::max(rise(1), rise(2)));
                    if rise < least.0 {
                        least = (rise, times, known);
                    }
                }
            }
            let (rise, times, known) = least;
            if rise < f64::INFINITY {
                *known = known.max(rounded_up(rise * times));
            } else {
                *known = known.min(rounded_down(far));
            }
        }
    }

    /// Whether a point that is `over` the triangle is in the clearing.
    #[inline(always)]
    pub(crate) fn holds(&self, over: Over) -> bool {
        let side = usize::from(over.height < 0.0);
        let height = over.height.abs();
        let inside = over.out.map(|out| -out);
        let beyond_sides = &self.beyond_sides[side];
        let beyond_corners = &self.beyond_corners[side];
        let below_side = |k: usize| height * f64::from(beyond_sides[k]) <= inside[k];
        let below_corner = |k: usize| {
            let [i, j] = MEETING[k];
            height * f64::from(beyond_corners[k]) <= inside[i] + inside[j]
        };
        (height <= f64::from(self.heights[side]))
            & (below_side(0) & below_side(1) & below_side(2))
            & (below_corner(0) & below_corner(1) & below_corner(2))
    }
}

/// Where a corner of another triangle is; without rounding where it is a corner of both.
fn over_exactly(planes: &Planes, corners: &Corners, corner: Vec3<f64>) -> Over {
    let mut over = planes.over(splat(corner));
    for k in (0..3).filter(|&k| corners.at[k] == corner) {
        over.height = 0.0;
        MEETING[k].into_iter().for_each(|side| over.out[side] = 0.0);
    }
    over
}

/// `tan(theta / 2)` of the angle by which something this high and this far away rises.
fn half_tangent(height: f64, away: f64) -> f64 {
    if height > 0.0 { height / (away + (away * away + height * height).sqrt()) } else { 0.0 }
}

fn rounded_up(x: f64) -> f32 {
    (x * (1.0 + 1e-6)) as f32
}

/// Of a height; none where there are no normal numbers of `f32` for it.
fn rounded_down(x: f64) -> f32 {
    let small = f64::from(f32::MIN_POSITIVE);
    if x > small { Lane::min(x * (1.0 - 1e-6), f64::from(f32::MAX)) as f32 } else { -1.0 }
}
