//! The beams around a node.

use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::{Vec3, angle_between, key_of_number, sort_by_number};

/// A beam as seen from one of its nodes.
#[derive(Clone, Copy, Debug)]
pub struct Spoke {
    /// Its edge.
    pub edge: u32,
    /// The node at its other end.
    pub to: u32,
    /// The unit vector along it, away from the node.
    pub along: Vec3<f64>,
    /// Its angle about the axis from the first beam, in degrees, counterclockwise seen from
    /// outside.
    pub azimuth_deg: f64,
    /// Its angle above the plane perpendicular to the axis, in degrees.
    pub elevation_deg: f64,
}

/// A vertex with beams.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its vertex.
    pub vertex: u32,
    /// The unit vector along its axis, outwards.
    pub axis: Vec3<f64>,
    /// The unit vector perpendicular to the axis from which azimuths count.
    pub across: Vec3<f64>,
    /// Its beams, counterclockwise seen from outside. At the rim the first has no panel on its
    /// right; at an inner node it leads to the vertex with the lowest index.
    pub spokes: Vec<Spoke>,
    /// The edge of each beam and its place among them, sorted by edge.
    places: Vec<(u32, usize)>,
}

impl Node {
    /// The angle in degrees from each beam to the next; they add up to 360.
    pub fn gaps_deg(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.spokes.len()).map(|k| self.gap_deg(k))
    }

    /// The angle in degrees from a beam to the next one.
    pub(super) fn gap_deg(&self, k: usize) -> f64 {
        let next = self.spokes.get(k + 1).map_or(360.0, |next| next.azimuth_deg);
        next - self.spokes[k].azimuth_deg
    }

    /// The index of a beam among those of the node.
    pub fn spoke_index(&self, edge: u32) -> Option<usize> {
        let found = self.places.binary_search_by_key(&edge, |(own, _)| *own).ok()?;
        Some(self.places[found].1)
    }
}

/// The nodes of a surface with these axes (`#V`); none at a vertex without an axis or without an
/// edge of positive length.
pub fn nodes(surface: &PanelSurface, axes: &[Vec3<f64>]) -> Vec<Option<Node>> {
    let mut edges: Vec<Vec<u32>> = vec![Vec::new(); axes.len()];
    for (edge, e) in surface.edges.iter().zip(0..) {
        if surface.direction(edge) != Vec3::zero() {
            edge.ends.iter().for_each(|&v| edges[v as usize].push(e));
        }
    }
    (0..).zip(edges).map(|(v, edges)| node(surface, axes[v as usize], v, &edges)).collect()
}

fn node(surface: &PanelSurface, axis: Vec3<f64>, v: u32, edges: &[u32]) -> Option<Node> {
    let axis = unit(axis);
    if axis == Vec3::zero() || edges.is_empty() {
        return None;
    }
    let spoke = |&e: &u32| {
        let edge = &surface.edges[e as usize];
        let away = edge.ends[0] == v;
        let to = edge.ends[usize::from(away)];
        let along = surface.direction(edge) * if away { 1.0 } else { -1.0 };
        // The panels on the left and on the right, as seen from the node.
        let [left, right] = if away { edge.panels } else { [edge.panels[1], edge.panels[0]] };
        (Spoke { edge: e, to, along, azimuth_deg: 0.0, elevation_deg: 0.0 }, left, right)
    };
    let found: Vec<_> = edges.iter().map(spoke).collect();
    let first = found
        .iter()
        .min_by_key(|(spoke, left, right)| (left.is_none() || right.is_some(), spoke.to))?;
    let start = first.0.along;
    let across = start - axis * start.dot(axis);
    let x = unit(if across == Vec3::zero() {
        axis.cross(Vec3::new(axis.y, axis.z, axis.x))
    } else {
        across
    });
    let y = axis.cross(x);
    let first_edge = first.0.edge;
    let mut spokes: Vec<Spoke> = found.into_iter().map(|(spoke, ..)| spoke).collect();
    for spoke in &mut spokes {
        let (c, s) = (spoke.along.dot(x), spoke.along.dot(y));
        let rise = spoke.along.dot(axis);
        spoke.elevation_deg = libm::atan2(rise, (c * c + s * s).sqrt()).to_degrees();
        let turn = libm::atan2(s, c).to_degrees();
        spoke.azimuth_deg = match turn {
            _ if spoke.edge == first_edge => 0.0,
            turn if turn < 0.0 => turn + 360.0,
            turn => turn,
        };
    }
    sort_by_number(&mut spokes, |spoke| u64::from(spoke.to));
    sort_by_number(&mut spokes, |spoke| key_of_number(spoke.azimuth_deg));
    sort_by_number(&mut spokes, |spoke| u64::from(spoke.edge != first_edge));
    let mut places: Vec<_> = spokes.iter().map(|spoke| spoke.edge).zip(0..).collect();
    places.sort_unstable();
    Some(Node { vertex: v, axis, across: x, spokes, places })
}

/// The angle between two unit vectors, in degrees; 0 if one is zero.
pub(super) fn degrees_between(a: Vec3<f64>, b: Vec3<f64>) -> f64 {
    angle_between(a, b).map_or(0.0, f64::to_degrees)
}
