//! Runs the operator of a kind.

use crate::support::random::Points;
use shape_up::constraint::{Kind, KindVisitor, Projection, Reference};
use shape_up::math::{LANES, Lanes, Vec3};
use shape_up::mesh::{Mesh, Point, Ragged, Surface};
use std::rc::Rc;

/// Projects as plain scalars, or with [`Lanes`] if there are as many point sets as lanes.
pub(crate) struct Project<'a> {
    pub(crate) rest: &'a [Points],
    pub(crate) points: &'a mut [Points],
}

impl KindVisitor for Project<'_> {
    type Output = ();
    fn visit<P: Projection>(self, operator: &P) {
        let mut operator = operator.clone();
        let surface = || Rc::new(strip(&self.rest[0]));
        operator.bind(&Reference { surface: &surface, pose: None });
        let mut rest = self.rest.to_vec();
        rest.iter_mut().for_each(|rest| operator.prepare(rest));
        if let [points] = self.points {
            let v = points.clone();
            return operator.project(&rest[0], &v, points);
        }
        let pack = |sets: &[Points]| -> Vec<Vec3<Lanes>> {
            (0..sets[0].len())
                .map(|k| {
                    let mut packed = Vec3::zero();
                    (0..LANES).for_each(|i| packed.set_lane(i, sets[i][k]));
                    packed
                })
                .collect()
        };
        let (rest, v) = (pack(&rest), pack(self.points));
        let mut projected = v.clone();
        operator.project(&rest, &v, &mut projected);
        for (i, points) in self.points.iter_mut().enumerate() {
            points.iter_mut().zip(&projected).for_each(|(to, from)| *to = from.lane(i));
        }
    }
}

/// The surface for operators that refer to one: a triangle strip through the rest points, a segment
/// between two, or one point.
fn strip(rest: &[Vec3<f64>]) -> Surface {
    let positions: Vec<Point> = rest.iter().map(|r| (*r).into()).collect();
    let mut mesh = Mesh::default();
    match rest.len() as u32 {
        1 => {}
        2 => mesh.curves = Ragged::from_iter([[0, 1]]),
        n => mesh.faces = Ragged::from_iter((2..n).map(|k| [k - 2, k - 1, k])),
    }
    Surface::new(&positions, &mesh)
}

/// The projection of one constraint.
pub(crate) fn project(kind: &Kind, rest: &Points, points: &Points) -> Points {
    let mut result = [points.clone()];
    kind.visit(Project { rest: std::slice::from_ref(rest), points: &mut result });
    let [result] = result;
    result
}
