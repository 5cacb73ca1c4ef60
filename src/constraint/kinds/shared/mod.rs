//! Parts shared by several operators; among them projection lane by lane, for operators whose
//! control flow depends on the points.

pub(super) mod pitot;
mod symmetry_group;

pub(crate) use symmetry_group::SymmetryGroup;

use crate::math::{Lane, Vec3};

/// Calls `project` for each lane until it returns false; true if it never does. A lane equal to the
/// previous one, such as the padding of a batch, is copied.
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
