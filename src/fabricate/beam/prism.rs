//! Prisms: straight beams of rectangular section. Each end is cut by two planes through the node
//! axis, one towards each neighbour, so that the cuts at a node match. The upper faces meet without
//! a step exactly if the offset keeps the height of beams constant.

use super::fin::BeamPlane;
use super::node::{Node, degrees_between};
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::Vec3;

/// Beams closer to a straight angle than this are cut square instead of mitred.
const BUTT_DEG: f64 = 5.0;

/// The end of a beam at a node.
#[derive(Clone, Copy, Debug)]
pub struct EndCut {
    /// Vectors from the axis to the left and the right end of the cut, perpendicular to the axis,
    /// in the unit of the mesh. Left and right are seen from outside, looking along the beam from
    /// the node.
    pub corners: [Vec3<f64>; 2],
    /// The angle about the axis between the beam and the cut on its left and its right; 90 is
    /// square.
    pub mitre_deg: [f64; 2],
    /// The angle between the axis and the beam; 90 is upright.
    pub tilt_deg: f64,
    /// The step between the upper faces of this beam and of the next one counterclockwise.
    pub step: f64,
}

/// A beam as a solid.
#[derive(Clone, Debug)]
pub struct Prism {
    /// Lower corners, then upper corners: `[left, axis, right]` at the first node and
    /// `[right, axis, left]` at the second, counterclockwise seen from outside.
    pub corners: [Vec3<f64>; 12],
    /// The lengths of its lower edges on the left and the right, and of the axis line.
    pub lengths: [f64; 3],
}

/// The cuts of beams of this width at a node, one for each of its beams.
pub fn end_cuts(
    surface: &PanelSurface,
    axes: &[Vec3<f64>],
    node: &Node,
    width: f64,
) -> Vec<EndCut> {
    let a = node.axis;
    let n = node.spokes.len();
    let up = |edge: u32| BeamPlane::of(surface, axes, edge).up;
    let ups: Vec<_> = node.spokes.iter().map(|spoke| up(spoke.edge)).collect();
    // Perpendicular to the axis, for the mitres.
    let lefts: Vec<_> = node
        .spokes
        .iter()
        .zip(&ups)
        .map(|(spoke, b)| {
            let left = b.cross(spoke.along);
            left - a * left.dot(a)
        })
        .collect();
    let mut cuts =
        vec![
            EndCut { corners: [Vec3::zero(); 2], mitre_deg: [90.0; 2], tilt_deg: 90.0, step: 0.0 };
            n
        ];
    let half = 0.5 * width;
    // A beam along the axis of its node has no left.
    let square = |left: Vec3<f64>| match left.length_squared() {
        0.0 => left,
        squared => left * (half / squared),
    };
    for k in 0..n {
        let next = (k + 1) % n;
        let (p, q) = (lefts[k], lefts[next]);
        // c . p = w/2 and c . q = -w/2.
        let (pp, qq, pq) = (p.length_squared(), q.length_squared(), p.dot(q));
        let determinant = pp * qq - pq * pq;
        let least = libm::sin(BUTT_DEG.to_radians());
        let corner = (n > 1 && determinant > least * least * pp * qq).then(|| {
            let (x, y) = (half * (qq + pq) / determinant, -half * (pp + pq) / determinant);
            p * x + q * y
        });
        cuts[k].corners[0] = corner.unwrap_or_else(|| square(p));
        cuts[next].corners[1] = corner.unwrap_or_else(|| -square(q));
        let height = |c: Vec3<f64>, b: Vec3<f64>| -c.dot(b) / a.dot(b);
        let step = corner.map(|c| (height(c, ups[k]) - height(c, ups[next])).abs());
        cuts[k].step = step.filter(|step| step.is_finite()).unwrap_or(0.0);
    }
    for (cut, spoke) in cuts.iter_mut().zip(&node.spokes) {
        let level = unit(spoke.along - a * spoke.along.dot(a));
        cut.mitre_deg = cut.corners.map(|corner| degrees_between(unit(corner), level));
        cut.tilt_deg = degrees_between(a, spoke.along);
    }
    cuts
}

/// The prism of an edge between the cuts at its two nodes; `height` is in the unit of the mesh,
/// negative inwards. None if the cuts leave nothing of it.
pub fn prism(
    surface: &PanelSurface,
    axes: &[Vec3<f64>],
    edge: u32,
    cuts: [&EndCut; 2],
    height: f64,
) -> Option<Prism> {
    let own = &surface.edges[edge as usize];
    let t = surface.direction(own);
    let b = BeamPlane::of(surface, axes, edge).up;
    let at = own.ends.map(|v| surface.at(v));
    let tilted = own.ends.map(|v| axes[v as usize]);
    let corner = |end: usize, c: Vec3<f64>, z: f64| {
        let a = unit(tilted[end]);
        let rise = (tilted[end] * z - c).dot(b) / a.dot(b);
        at[end] + c + a * rise
    };
    // Left and right are swapped as seen from the second node.
    let outline = |z: f64| {
        let [first, second] = cuts.map(|cut| cut.corners);
        [
            corner(0, first[0], z),
            corner(0, Vec3::zero(), z),
            corner(0, first[1], z),
            corner(1, second[0], z),
            corner(1, Vec3::zero(), z),
            corner(1, second[1], z),
        ]
    };
    let (low, high) = (outline(0.0_f64.min(height)), outline(0.0_f64.max(height)));
    let lengths = |corners: &[Vec3<f64>; 6]| {
        [(0, 5), (2, 3), (1, 4)].map(|(i, j): (usize, usize)| (corners[j] - corners[i]).dot(t))
    };
    let is_whole =
        [low, high].iter().all(|corners| lengths(corners).iter().all(|length| *length > 0.0));
    let mut corners = [Vec3::zero(); 12];
    corners[..6].copy_from_slice(&low);
    corners[6..].copy_from_slice(&high);
    is_whole.then(|| Prism { corners, lengths: lengths(&low) })
}

impl Prism {
    /// The faces over [`Prism::corners`], counterclockwise seen from outside the beam.
    pub fn faces() -> Vec<Vec<u32>> {
        let mut faces = vec![(0..6).rev().collect(), (6..12).collect()];
        faces.extend((0..6_u32).map(|k| vec![k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k]));
        faces
    }
}
