//! Symmetry (an application named in paper section 6): vertices averaged over a symmetry group,
//! that of a mirror plane or an n-fold axis.

use crate::constraint::kinds::shared::{SymmetryGroup, separate_lanes};
use crate::constraint::parameter::Direction;
use crate::constraint::{Arity, Form, Info, Param, ParamValue, Projection};
use crate::math::{Lane, UnitPolygon, Vec3};
use serde::{Deserialize, Deserializer, Serialize};

/// The set of vertices is its own mirror image, or its own image under rotation by a full turn over
/// `fold`. Only the direction of the plane or axis is given: its position is fitted.
///
/// Images are found at rest: the image of a vertex is the vertex nearest to its transformed
/// position, and no farther from that than 1e-3 of the size of the rest shape. Vertices without a
/// partner are free; of several at one rest position all but one may be. A vertex that is its own
/// image stays on the plane or axis.
///
/// The projection is linear: the mean over the symmetries of the transformed points, around the
/// mean of all that have a partner.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Symmetry {
    /// The normal of the mirror plane.
    mirror: Direction,
    /// The axis of the rotation; if given, it replaces the mirror plane.
    axis: Option<Direction>,
    /// The order of the rotational symmetry.
    #[serde(deserialize_with = "whole")]
    fold: u32,
}

impl Default for Symmetry {
    fn default() -> Self {
        let mirror = Direction::new(MIRROR).expect("it is not zero");
        Symmetry { mirror, axis: None, fold: 2 }
    }
}

/// The default normal of the mirror plane.
const MIRROR: [f64; 3] = [1.0, 0.0, 0.0];

/// The least and the greatest fold.
const FOLDS: [f64; 2] = [2.0, 360.0];

/// Greatest distance of a partner from the image at rest, relative to the size of the rest shape.
const TOLERANCE: f64 = 1e-3;

impl Projection for Symmetry {
    const INFO: Info = Info {
        id: "symmetry",
        label: "Symmetry",
        summary: "The vertices are the mirror image of each other, or the same after a rotation.",
        arity: Arity::AtLeast(2),
        colour: [180, 70, 110],
        params: &[
            Param {
                default: ParamValue::Vector(MIRROR),
                forms: &[Form::Vector],
                ..Param::direction("mirror", "Normal of the mirror")
            },
            Param::direction("axis", "Axis instead of a mirror"),
            Param::number("fold", "Order of the rotation", "", 2.0, FOLDS),
        ],
        ..Info::PLAIN
    };

    const READS_REST: bool = true;

    /// Stores the index of the first image of each vertex, then the role of the vertex.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        let next = self.group().pairs(rest, TOLERANCE);
        for i in 0..rest.len() {
            rest[i] = match next[i] {
                None => Vec3::new(i as f64, FREE, 0.0),
                Some(first) => {
                    let mut others = std::iter::successors(Some(first), |&j| next[j]);
                    let is_least = others.find(|&j| j <= i) == Some(i);
                    Vec3::new(first as f64, if is_least { LEAST } else { IMAGE }, 0.0)
                }
            };
        }
    }

    fn paired(&self, rest: &[Vec3<f64>]) -> Option<usize> {
        Some(self.group().pairs(rest, TOLERANCE).iter().flatten().count())
    }

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let group = self.group();
        // Each constraint has its own pairing, so each lane is projected separately.
        separate_lanes(rest, v, projected, |lane, projected| {
            average(&group, lane, rest, v, projected);
            true
        })
    }
}

/// Roles of a vertex: without a partner, the least index of its orbit, or another member of it.
const FREE: f64 = 0.0;
const LEAST: f64 = 1.0;
const IMAGE: f64 = 2.0;

/// Writes the mean over the symmetries in one lane.
fn average<S: Lane>(
    group: &SymmetryGroup,
    lane: usize,
    rest: &[Vec3<S>],
    v: &[Vec3<S>],
    projected: &mut [Vec3<S>],
) {
    let role = |i: usize| rest[i].y.lane(lane);
    let next = |i: usize| rest[i].x.lane(lane) as usize;
    let (mut sum, mut count) = (Vec3::zero(), 0.0);
    for i in (0..v.len()).filter(|&i| role(i) != FREE) {
        sum += v[i].lane(lane);
        count += 1.0;
    }
    let mean = if count > 0.0 { sum * (1.0 / count) } else { sum };
    let order = group.order();
    for i in 0..v.len() {
        if role(i) == FREE {
            projected[i].set_lane(lane, v[i].lane(lane));
        } else if role(i) == LEAST {
            let mut at = i;
            let mut turned_back = Vec3::zero();
            for k in 0..order {
                turned_back += group.image((order - k) % order, v[at].lane(lane) - mean);
                at = next(at);
            }
            let own = turned_back * (1.0 / order as f64);
            for k in 0..order {
                projected[at].set_lane(lane, mean + group.image(k, own));
                at = next(at);
            }
        }
    }
}

impl Symmetry {
    fn group(&self) -> SymmetryGroup {
        match self.axis {
            None => SymmetryGroup::Mirror(self.mirror.unit()),
            Some(axis) => SymmetryGroup::Axis(axis.unit(), UnitPolygon::new(self.fold as usize)),
        }
    }
}

/// Deserialises a whole number of turns.
fn whole<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u32, D::Error> {
    let [least, greatest] = FOLDS;
    let number = f64::deserialize(deserializer)?;
    if (least..=greatest).contains(&number) && number == number.round() {
        return Ok(number as u32);
    }
    Err(serde::de::Error::custom(format_args!(
        "found {number}, expected a whole number from {least} to {greatest}"
    )))
}
