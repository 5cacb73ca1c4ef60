//! Where a node disc sits on the end of a fin, and the outline of the fin with it.
//!
//! In the plane of a fin, `r` is the distance from the node perpendicular to the axis, and `z` the
//! height along the axis as seen in the plane, from the surface to the far side of the fin. A fin
//! that leans by the angle `d` from the axis, because its beam is warped, is tilted through the disc:
//! a point of the plate at `z`, and at most half the thickness `T` from its middle plane, has the
//! height `z cos d +- (T/2) sin d` along the axis. Hence a seat at the height `Z` is cut down to
//! `z = (Z - (T/2) |sin d|) / cos d`, and the tenon through a disc of thickness `T` ends at
//! `z = (Z + T + (T/2) |sin d|) / cos d`.

use super::fin::{BeamPlane, Fin};
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::Vec3;
use crate::math::plane::{Point2, dot};

/// The axis of a node as a fin sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lean {
    /// Along the fin, away from the node and perpendicular to the axis.
    pub along: Vec3<f64>,
    /// Cosine of the angle between the axis and the plane of the fin.
    pub cosine: f64,
    /// How far the plane moves to the left of `along`, seen from outside, for each unit of height
    /// along the outward axis: the tangent of that angle.
    pub drift: f64,
    /// The axis in the plane of the fin, normalised, over the edge and its upward direction.
    flat: Point2,
}

impl Lean {
    /// The axis at an end of a fin; none if the axis lies along it, or there is no fin.
    pub(super) fn of(
        surface: &PanelSurface,
        axes: &[Vec3<f64>],
        edge: u32,
        end: usize,
    ) -> Option<Lean> {
        let plane = BeamPlane::of(surface, axes, edge);
        let BeamPlane { along: t, up: b, .. } = plane;
        let axis = unit(axes[surface.edges[edge as usize].ends[end] as usize]);
        let flat = plane.flat(axis);
        let cosine = dot(flat, flat).sqrt();
        let sign = if end == 0 { 1.0 } else { -1.0 };
        let along = unit(t * flat[1] - b * flat[0]) * sign;
        if cosine <= 0.0 || along == Vec3::zero() {
            return None;
        }
        // The axis within the plane, of height `cosine` over the node.
        let within = (t * flat[0] + b * flat[1]) * (1.0 / cosine);
        let drift = within.dot(axis.cross(along)) / cosine;
        Some(Lean { along, cosine, drift, flat: flat.map(|x| x / cosine) })
    }
}

/// An end of a fin in the coordinates `r` and `z`.
#[derive(Clone, Copy, Debug)]
pub(super) struct FinEnd {
    pub lean: Lean,
    /// The `r` at which the fin ends.
    pub back: f64,
    /// The height of its far side over the node.
    pub height: f64,
    /// The `r` at which its far side ends at the other node.
    pub reach: f64,
    /// Slopes of the far side and of the edge of the surface.
    slopes: [f64; 2],
    /// The node, and the directions of `r` and `z`, in the coordinates of the outline.
    node: Point2,
    out: Point2,
    up: Point2,
    /// The thickness of the plate.
    thickness: f64,
}

/// The seat of a disc, in the coordinates `r` and `z` of an end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seat {
    /// The height of the shoulder on which the disc lies.
    pub shoulder: f64,
    /// The height at which the tenon ends.
    pub tip: f64,
    /// Where the tenon begins and ends.
    pub tenon: [f64; 2],
    /// Where the shoulder ends.
    pub rim: f64,
}

impl FinEnd {
    /// The end of a fin at the node `edge.ends[end]`.
    pub(super) fn new(
        (surface, axes): (&PanelSurface, &[Vec3<f64>]),
        (edge, end): (u32, usize),
        fin: &Fin,
        height: f64,
        thickness: f64,
    ) -> Option<FinEnd> {
        let lean = Lean::of(surface, axes, edge, end)?;
        let own = &surface.edges[edge as usize];
        let length = surface.length(own);
        let [x, y] = lean.flat;
        let out = if end == 0 { [y, -x] } else { [-y, x] };
        let up = [x, y].map(|x| height.signum() * x);
        let nodes = [[0.0; 2], [length, 0.0]];
        let node = nodes[end];
        let seen = |[x, y]: Point2| {
            let step = [x - node[0], y - node[1]];
            [dot(step, out), dot(step, up)]
        };
        // Sides 1 and 3 of the outline are the ends; the far side is between them.
        let side = if fin.ends[0] == own.ends[end] { 1 } else { 3 };
        let [own_corner, other_corner] =
            [side, 4 - side].map(|side| seen(fin.outline[if side == 1 { 2 } else { 3 }]));
        let slope = |[p, q]: [Point2; 2]| (q[1] - p[1]) / (q[0] - p[0]);
        let far = slope([own_corner, other_corner]);
        let near = slope([[0.0; 2], seen(nodes[1 - end])]);
        Some(FinEnd {
            lean,
            back: own_corner[0],
            height: own_corner[1] - far * own_corner[0],
            reach: other_corner[0],
            slopes: [far, near],
            node,
            out,
            up,
            thickness,
        })
    }

    /// How much the height of a point along the axis differs within the thickness, to each side.
    fn tilt(&self) -> f64 {
        0.5 * self.thickness * self.lean.drift.abs() * self.lean.cosine
    }

    /// The height along the axis up to which there is material on the far side at `r`.
    pub(super) fn level(&self, r: f64) -> f64 {
        self.lean.cosine * (self.height + self.slopes[0] * r) - self.tilt()
    }

    /// The seat on a disc at the height `level` along the axis.
    pub(super) fn seat(&self, level: f64, tenon: [f64; 2], rim: f64) -> Seat {
        let Lean { cosine, .. } = self.lean;
        let shoulder = (level - self.tilt()) / cosine;
        let tip = (level + self.thickness + self.tilt()) / cosine;
        Seat { shoulder, tip, tenon, rim }
    }

    /// The least height of the fin below a seat.
    pub(super) fn neck(&self, seat: &Seat) -> f64 {
        let below = |r: f64| seat.shoulder - self.slopes[1] * r;
        below(self.back).min(below(seat.rim))
    }

    /// A point in the coordinates of the outline.
    fn put(&self, [r, z]: Point2) -> Point2 {
        [0, 1].map(|x| self.node[x] + r * self.out[x] + z * self.up[x])
    }

    /// The corners from the end of the fin along its seat to its far side.
    fn profile(&self, seat: &Seat) -> Vec<Point2> {
        let Seat { shoulder, tip, tenon: [from, to], rim } = *seat;
        let far = self.height + self.slopes[0] * rim;
        let mut corners = Vec::new();
        if from > self.back {
            corners.extend([[self.back, shoulder], [from, shoulder]]);
        }
        corners.extend([[from, tip], [to, tip], [to, shoulder]]);
        // The lowest fin of a node needs no step where its shoulder ends.
        if far - shoulder > 1e-6 * self.thickness {
            corners.push([rim, shoulder]);
        }
        corners.push([rim, far]);
        corners.into_iter().map(|corner| self.put(corner)).collect()
    }

    /// How far a seat reaches along the edge from its first node: least and largest coordinate.
    pub(super) fn extent(&self, seat: &Seat) -> [f64; 2] {
        let far = self.height + self.slopes[0] * seat.rim;
        let [a, b] = [seat.shoulder, far].map(|z| self.put([seat.rim, z])[0]);
        [a.min(b), a.max(b)]
    }
}

/// The outline of a fin with these seats at its sides 1 and 3.
pub(super) fn seated(fin: &Fin, ends: [Option<(&FinEnd, &Seat)>; 2]) -> Vec<Point2> {
    let [first, second, third, fourth] = fin.outline;
    let profile = |end: Option<(&FinEnd, &Seat)>, corner: Point2| {
        end.map_or_else(|| vec![corner], |(end, seat)| end.profile(seat))
    };
    let mut outline = vec![first, second];
    outline.extend(profile(ends[0], third));
    outline.extend(profile(ends[1], fourth).into_iter().rev());
    outline
}
