//! Lanes that go separate ways: for operators whose work depends on where the points are.

use crate::math::{Lane, Vec3};

/// Lets `project` write the projections of each lane, whose number it gets, until it returns false;
/// true if it never does. A lane that repeats the one before, as lanes do that only fill up a
/// batch, is copied.
#[inline(always)]
pub(crate) fn separate_lanes<S: Lane>(
    rest: &[Vec3<S>],
    v: &[Vec3<S>],
    projected: &mut [Vec3<S>],
    mut project: impl FnMut(usize, &mut [Vec3<S>]) -> bool,
) -> bool {
    (0..S::WIDTH).all(|lane| {
        let repeats = |p: &Vec3<S>| p.lane(lane) == p.lane(lane - 1);
        if lane > 0 && v.iter().all(repeats) && rest.iter().all(repeats) {
            projected.iter_mut().for_each(|p| p.set_lane(lane, p.lane(lane - 1)));
            return true;
        }
        project(lane, projected)
    })
}
