//! The trait of a projection operator, and how a chunk of constraints is projected with one.

use super::declaration::Info;
use super::fitted::Fitted;
use super::reference::Reference;
use super::target_shape::TargetShape;
use crate::math::{Lane, Vec3};

/// One projection operator `P_i` (paper section 2.1, Eq. 2, and section 3).
pub trait Projection: Clone + PartialEq + std::fmt::Debug + 'static {
    /// The declaration of the kind.
    const INFO: Info;

    /// Whether [`Projection::project`] reads the rest points; without, it gets none.
    const READS_REST: bool = false;

    /// Whether its rest points are those of the scene's other pose, if it has one: of kinds whose rest shape is
    /// what vertices have together, wherever they are.
    const TAKES_POSE: bool = false;

    /// Whether each constraint keeps the previous projection where the new one is farther, also in a scene
    /// that does not ask for it: where projections are so far from the closest at times that the total
    /// energy would rise by more than a few digits.
    const GUARDED: bool = false;

    /// Whether the projection is the closest point of the set, with these parameters; [`Info::exact`] is
    /// about the default ones.
    fn is_exact(&self) -> bool {
        Self::INFO.exact
    }

    /// The places for which it is what somebody usually wants: hosts choose it beforehand there.
    const USUAL_FOR: &'static [TargetShape] = &[];

    /// Gives the operator what it may look up besides its own points. Called once, before anything
    /// else.
    fn bind(&mut self, reference: &Reference<'_>) {
        let _ = reference;
    }

    /// Brings the centred rest points of one constraint into the form in which
    /// [`Projection::project`] wants them: three numbers for each point, whatever they mean. Called
    /// once per constraint, before all projections.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        let _ = rest;
    }

    /// How many points of one constraint it acts on, where the centred rest points decide that: those that
    /// have a partner among them. None where it acts on all.
    fn paired(&self, rest: &[Vec3<f64>]) -> Option<usize> {
        let _ = rest;
        None
    }

    /// The closed form, for one constraint or for several side by side: writes the closest points
    /// that have the shape to `projected`. False when it is not accurate in every lane; what it
    /// wrote is then not used. `v` are the points, centred as [`Info::centring`] says, `rest` the
    /// rest points `V'`, centred likewise, after [`Projection::prepare`], `n` of each.
    ///
    /// The result need not be centred: whoever scatters it centres it again. It is equivariant
    /// under scaling: no absolute thresholds.
    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool;

    /// Replaces the points `v` of one constraint by the closest points that have the shape: slower,
    /// and finite and accurate for every finite input, degenerate ones included. Called where the
    /// closed form is not accurate; an operator whose closed form always is has none.
    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let _ = (rest, v);
        unreachable!("the closed form of this kind is accurate for every input");
    }

    /// Step I for one chunk of constraints: the closed form where it is accurate, else each lane
    /// by itself.
    #[inline(always)]
    fn project<S: Lane>(&self, rest: &[Vec3<S>], v: &[Vec3<S>], projected: &mut [Vec3<S>]) {
        project_with(
            |rest, v, projected| self.closed_form(rest, v, projected),
            &|rest, v| self.project_robust(rest, v),
            (rest, v, projected),
        );
    }

    /// The shape that fits the points `v` (in their place, not centred), to be drawn. None where the
    /// projection itself says all there is to see.
    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        let _ = v;
        None
    }
}

/// Rest points, points and their projections.
type Chunk<'a, S> = (&'a [Vec3<S>], &'a [Vec3<S>], &'a mut [Vec3<S>]);

/// See [`Projection::project_robust`].
type Robust<'a> = &'a dyn Fn(&[Vec3<f64>], &mut [Vec3<f64>]);

/// Step I with this closed form, and where it is not accurate each lane by itself.
#[inline(always)]
pub(super) fn project_with<S: Lane>(
    closed_form: impl Fn(&[Vec3<S>], &[Vec3<S>], &mut [Vec3<S>]) -> bool,
    careful: Robust<'_>,
    (rest, v, projected): Chunk<'_, S>,
) {
    if !closed_form(rest, v, projected) {
        lane_by_lane(&closed_form, careful, (rest, v, projected));
    }
}

/// A closed form of some kind: of rest points, points, and where their projections go.
type ClosedForm<'a, S> = &'a dyn Fn(&[Vec3<S>], &[Vec3<S>], &mut [Vec3<S>]) -> bool;

/// Projects each lane by itself: by the closed form, with the lane in the place of all, so that no
/// kind has a second one that is compiled for a single lane, and otherwise carefully. A lane whose
/// closed form is accurate gets the same bits as in a chunk where all are.
#[cold]
#[inline(never)]
fn lane_by_lane<S: Lane>(
    closed_form: ClosedForm<'_, S>,
    careful: Robust<'_>,
    (rest, v, projected): Chunk<'_, S>,
) {
    let mut results = vec![Vec3::zero(); v.len()];
    for i in 0..S::WIDTH {
        let everywhere =
            |points: &[Vec3<S>]| points.iter().map(|p| Vec3::splat(p.lane(i))).collect();
        let (all_rest, all): (Vec<_>, Vec<_>) = (everywhere(rest), everywhere(v));
        if S::WIDTH > 1 && closed_form(&all_rest, &all, &mut results) {
            projected.iter_mut().zip(&results).for_each(|(to, from)| to.set_lane(i, from.lane(i)));
        } else {
            let lane = |points: &[Vec3<S>]| points.iter().map(|p| p.lane(i)).collect::<Vec<_>>();
            let mut result = lane(v);
            careful(&lane(rest), &mut result);
            projected.iter_mut().zip(&result).for_each(|(to, from)| to.set_lane(i, *from));
        }
    }
}
