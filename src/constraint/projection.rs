//! The trait of projection operators, and the projection of a chunk of constraints.

use super::declaration::Info;
use crate::math::{Lane, Vec3};
use crate::mesh::Surface;
use std::rc::Rc;

/// One projection operator `P_i` (paper section 2.1, Eq. 2, and section 3).
pub trait Projection: Clone + PartialEq + std::fmt::Debug + 'static {
    /// The declaration of the kind.
    const INFO: Info;

    /// Whether [`Projection::project`] reads the rest points; if not, it gets none.
    const READS_REST: bool = false;

    /// Whether the scene's other pose, if there is one, provides the rest points. True for kinds
    /// whose rest shape is intrinsic: independent of its location.
    const USES_POSE: bool = false;

    /// Whether each constraint keeps the previous projection if the new one is farther, even
    /// without the scene's `monotone` guard. For kinds whose projections can be so far from the
    /// closest point that the total energy would rise by more than a few digits.
    const GUARDED: bool = false;

    /// Gives the operator the reference geometry. Called once, before anything else.
    fn bind(&mut self, reference: &Reference<'_>) {
        let _ = reference;
    }

    /// Converts the centred rest points of one constraint to the form that [`Projection::project`]
    /// reads: three numbers for each point, of any meaning. Called once per constraint, at the
    /// start.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        let _ = rest;
    }

    /// The number of points of one constraint that have a partner, for kinds that pair points by
    /// their centred rest positions and act on these only. None if the kind acts on all points.
    fn paired(&self, rest: &[Vec3<f64>]) -> Option<usize> {
        let _ = rest;
        None
    }

    /// The closed form, for one constraint per lane: writes the closest points that have the shape
    /// to `projected`. Returns false if it is inaccurate in some lane; the output is then not used.
    /// `v` are the `n` points, centred according to [`Info::centring`], `rest` the `n` rest points
    /// `V'`, centred likewise, after [`Projection::prepare`].
    ///
    /// The result need not be centred: the caller centres it before scattering. The closed form is
    /// equivariant under scaling: it has no absolute thresholds.
    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool;

    /// Replaces the points `v` of one constraint by the closest points that have the shape. Slower,
    /// but finite and accurate for every finite input, including degenerate ones. Called if the
    /// closed form is inaccurate; not implemented if that is always accurate.
    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let _ = (rest, v);
        unreachable!("this closed form is always accurate");
    }

    /// Runs step I for one chunk: by the closed form if it is accurate in all lanes, else lane by
    /// lane.
    #[inline(always)]
    fn project<S: Lane>(&self, rest: &[Vec3<S>], v: &[Vec3<S>], projected: &mut [Vec3<S>]) {
        project_with(
            |rest, v, projected| self.closed_form(rest, v, projected),
            &|rest, v| self.project_robust(rest, v),
            (rest, v, projected),
        );
    }

    /// The shape fitted to the uncentred points `v`, for drawing. None if the projected points show
    /// it.
    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        let _ = v;
        None
    }
}

/// Rest points, points and their projections.
type Chunk<'a, S> = (&'a [Vec3<S>], &'a [Vec3<S>], &'a mut [Vec3<S>]);

/// See [`Projection::project_robust`].
type Robust<'a> = &'a dyn Fn(&[Vec3<f64>], &mut [Vec3<f64>]);

/// Runs step I with this closed form or, if it is inaccurate, lane by lane.
#[inline(always)]
pub(super) fn project_with<S: Lane>(
    closed_form: impl Fn(&[Vec3<S>], &[Vec3<S>], &mut [Vec3<S>]) -> bool,
    robust: Robust<'_>,
    (rest, v, projected): Chunk<'_, S>,
) {
    if !closed_form(rest, v, projected) {
        lane_by_lane(&closed_form, robust, (rest, v, projected));
    }
}

/// The closed form of some kind: rest points, points, and the output.
type ClosedForm<'a, S> = &'a dyn Fn(&[Vec3<S>], &[Vec3<S>], &mut [Vec3<S>]) -> bool;

/// Projects lane by lane: by the closed form if it is accurate for the lane, else robustly. The
/// closed form is called with the lane copied to all lanes, so that no kind needs a second, scalar
/// instance; such a lane gets the same bits as in a chunk that is accurate throughout.
#[cold]
#[inline(never)]
fn lane_by_lane<S: Lane>(
    closed_form: ClosedForm<'_, S>,
    robust: Robust<'_>,
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
            robust(&lane(rest), &mut result);
            projected.iter_mut().zip(&result).for_each(|(to, from)| to.set_lane(i, *from));
        }
    }
}

/// A fitted shape, drawn over the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fitted {
    /// A circle in space.
    Circle {
        /// Centre.
        centre: Vec3<f64>,
        /// Unit normal of its plane.
        normal: Vec3<f64>,
        /// Radius, positive and finite.
        radius: f64,
    },
    /// A sphere.
    Sphere {
        /// Centre.
        centre: Vec3<f64>,
        /// Radius, positive and finite.
        radius: f64,
    },
}

/// Largest radius that is drawn, relative to the extent of the points; beyond, the shape is
/// practically a line or a plane there.
const LARGEST_DRAWN: f64 = 4.0;

impl Fitted {
    /// The numbers that the view reads: 0 for a circle or 1 for a sphere, centre, normal, radius.
    pub fn numbers(&self) -> [f64; 8] {
        match *self {
            Fitted::Circle { centre: c, normal: n, radius } => {
                [0.0, c.x, c.y, c.z, n.x, n.y, n.z, radius]
            }
            Fitted::Sphere { centre: c, radius } => [1.0, c.x, c.y, c.z, 0.0, 0.0, 1.0, radius],
        }
    }

    /// Whether its radius is at most [`LARGEST_DRAWN`] times the extent of its points.
    pub(super) fn is_of_the_size_of(&self, points: &[Vec3<f64>]) -> bool {
        let (Fitted::Circle { radius, .. } | Fitted::Sphere { radius, .. }) = *self;
        let extent = points.iter().map(|&p| (p - points[0]).length()).fold(0.0, f64::max);
        radius <= LARGEST_DRAWN * extent
    }
}

/// A position or a gradient, padded to two 128-bit registers.
pub type Row = [f64; 4];

/// Geometry that an operator may use besides its own points.
#[derive(Clone, Copy)]
pub struct Reference<'a> {
    /// The rest surface, built on demand, in the coordinates of uncentred points.
    pub surface: &'a dyn Fn() -> Rc<Surface>,
    /// The nodes in another pose, used as rest points by kinds with
    /// [`super::Projection::USES_POSE`].
    pub pose: Option<&'a [Row]>,
}
