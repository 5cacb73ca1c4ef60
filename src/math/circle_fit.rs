//! The circle that fits centred points in space (paper section 3.1). The normal of its plane is the
//! eigenvector of the smallest eigenvalue of their scatter matrix; within the plane it is the
//! circle of Thomas and Chan, see [`Round`].
//!
//! [`CircleFit`] is the closed form, in lanes. [`crate::math::PrincipalRound`] is accurate where it is
//! not.

use crate::math::{Lane, Round, RoundWithin, Scatter, Vec3};

/// A circle fitted in closed form.
#[derive(Clone, Copy, Debug)]
pub struct CircleFit<S> {
    /// Unit normal of the plane, of either sign.
    pub normal: Vec3<S>,
    /// The circle in that plane.
    pub round: Round<S>,
}

impl<S: Lane> CircleFit<S> {
    /// Fits mean-centred points. Returns `None` if the closed form is not accurate in every lane:
    /// nearly collinear or coincident points, more than one best plane, a point at the centre.
    #[inline(always)]
    pub fn of(points: &[Vec3<S>]) -> Option<Self> {
        let (circle, mut good) = CircleFit::through(points, |_, _| {});
        for p in points {
            circle.round.step_off_centre(circle.in_plane(*p), &mut good);
        }
        good.all_greater(S::zero()).then_some(circle)
    }

    /// Writes the closest points of the fitted circle to `projected`. Returns false if
    /// [`CircleFit::of`] would return `None`.
    #[inline(always)]
    pub fn project(points: &[Vec3<S>], projected: &mut [Vec3<S>]) -> bool {
        let (circle, mut good) = CircleFit::through(points, |k, w| projected[k] = w);
        for p in projected {
            *p += circle.round.step_off_centre(*p, &mut good);
        }
        good.all_greater(S::zero())
    }

    /// As [`CircleFit::project`], with a radius within limits: `clamp` returns the nearest one.
    /// Returns the unit normal of the plane, the circle in it, and one in the lanes where all is
    /// accurate, else zero.
    // Not inlined, so that circles without limits keep their registers.
    #[inline(never)]
    pub fn project_within(
        points: &[Vec3<S>],
        projected: &mut [Vec3<S>],
        clamp: impl Fn(S) -> S,
    ) -> (Vec3<S>, RoundWithin<S>, S) {
        let (CircleFit { normal, round }, mut good) =
            CircleFit::through(points, |k, w| projected[k] = w);
        let circle = RoundWithin::of(projected, round, normal, clamp, Vec3::zero(), &mut good);
        for p in projected {
            *p += circle.step_off_centre(*p, &mut good);
        }
        (normal, circle, good)
    }

    /// Returns the fit, and one in the lanes where it is accurate, else zero. `in_plane` receives
    /// the projection of every point into the plane.
    #[inline(always)]
    fn through(points: &[Vec3<S>], mut in_plane: impl FnMut(usize, Vec3<S>)) -> (Self, S) {
        let scatter = Scatter::of(points);
        let n = scatter.unit.smallest_eigenvector();
        let mut h = Vec3::zero();
        for (k, p) in points.iter().enumerate() {
            let w = *p - n.vector * n.vector.dot(*p);
            h += w * w.length_squared();
            in_plane(k, w);
        }
        let h = h * S::splat(0.5 / points.len() as f64);

        // In the plane the scatter has trace t = 1 - l and adjugate t I - M. M h is the 3x3
        // product, since h is orthogonal to n.
        let t = S::one() - n.value;
        let a = h * t - scatter.unit.times(h);
        let determinant = scatter.unit.adjugate().trace() - n.value * t;
        let round = Round::new(a, determinant * scatter.mean_square, t * scatter.mean_square);
        let good = round.accurate(n.accurate * scatter.in_range);
        (CircleFit { normal: n.vector, round }, good)
    }

    #[inline(always)]
    fn in_plane(&self, v: Vec3<S>) -> Vec3<S> {
        v - self.normal * self.normal.dot(v)
    }

    /// Returns the height of `v` above the plane, and the displacement from its foot point to the
    /// closest point of the circle.
    #[inline(always)]
    pub fn height_and_step(&self, v: Vec3<S>) -> (S, Vec3<S>) {
        let height = self.normal.dot(v);
        (height, self.round.step(v - self.normal * height))
    }
}

#[cfg(test)]
mod tests {
    use super::CircleFit;
    use crate::math::{PrincipalRound, Vec3, centre};

    /// All quads made from a square of side two by moving each corner by `step`, or not at all,
    /// along one coordinate.
    fn quads(step: f64) -> impl Iterator<Item = [Vec3<f64>; 4]> {
        (0..4_usize.pow(4)).map(move |k| {
            let mut quad = [[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [1.0, -1.0, 0.0]];
            for (i, corner) in quad.iter_mut().enumerate() {
                if let Some(x) = corner.get_mut(k / 4_usize.pow(i as u32) % 4) {
                    *x += step;
                }
            }
            quad.map(Vec3::from)
        })
    }

    #[test]
    fn the_closed_form_agrees_with_principal_axes() {
        for step in [1e-6, 0.01, 0.3] {
            for (k, mut quad) in quads(step).enumerate() {
                centre(&mut quad);
                let circle = CircleFit::of(&quad).expect("the heights are far below the width");
                let mut principal = quad;
                let slow = PrincipalRound::rotate(&mut principal, 2, |radius| radius);
                for (v, w) in quad.into_iter().zip(principal) {
                    let (height, step_to) = circle.height_and_step(v);
                    let (slow_height, slow_step) = slow.height_and_step(w);
                    assert!((height.abs() - slow_height.abs()).abs() < 1e-12, "{step}, {k}");
                    assert!((step_to.length() - slow_step.length()).abs() < 1e-12, "{step}, {k}");
                    let closest = circle.in_plane(v) + step_to;
                    let slow_closest = Vec3::new(w.x, w.y, 0.0) * slow.axes.scale + slow_step;
                    let slow_closest = slow.axes.direction(slow_closest);
                    assert!((closest - slow_closest).length() < 1e-12, "{step}, {k}");
                    let reached = v - circle.normal * height + step_to;
                    assert!((reached - closest).length() < 1e-15, "{step}, {k}");
                }
            }
        }
    }

    #[test]
    fn says_when_there_is_no_closed_form() {
        let line = [-1.0, -0.25, 0.25, 1.0].map(|x| Vec3::new(x, 2.0 * x, -x));
        let one_place = [Vec3::zero(); 4];
        let tetrahedron =
            [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]]
                .map(Vec3::from);
        for points in [line, one_place, tetrahedron] {
            assert!(CircleFit::of(&points).is_none(), "{points:?}");
        }
        let cross = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [0.0, 0.0]];
        assert!(CircleFit::of(&cross.map(|[x, y]| Vec3::new(x, y, 0.0))).is_none());
    }
}
