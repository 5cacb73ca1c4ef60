//! Fins: beams cut from flat sheet. In the plane of the edge and the upward direction `b` of the
//! beam, the outline is `(0, 0), (l, 0), (l + h t.n_j, h b.n_j), (h t.n_i, h b.n_i)`. Each end is
//! moved back parallel to its axis so that the plates of a node do not overlap.

use super::node::Node;
use crate::fabricate::offset::across_edge;
use crate::fabricate::panel::is_simple;
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::plane::{Point2, distance};
use crate::math::{Vec3, cosine_and_sine_of_degrees};

/// The plane of the beam along an edge, in which its fin is laid flat.
#[derive(Clone, Copy, Debug)]
pub struct BeamPlane {
    /// The first node of the edge.
    pub origin: Vec3<f64>,
    /// The unit vector along the edge; zero if it has no length.
    pub along: Vec3<f64>,
    /// The upward direction `P_e (n_i + n_j)`, normalised; zero if there is none.
    pub up: Vec3<f64>,
}

impl BeamPlane {
    /// The plane of an edge with these node axes (`#V`).
    pub fn of(surface: &PanelSurface, axes: &[Vec3<f64>], edge: u32) -> BeamPlane {
        let own = &surface.edges[edge as usize];
        let [n, m] = own.ends.map(|v| axes[v as usize]);
        let along = surface.direction(own);
        let up = unit(across_edge(n + m, along));
        BeamPlane { origin: surface.at(own.ends[0]), along, up }
    }

    /// A point of the outline of a fin, in space.
    pub fn in_space(&self, [x, y]: Point2) -> Vec3<f64> {
        self.origin + self.along * x + self.up * y
    }

    /// The part of a vector in the plane, along the edge and upwards.
    pub fn flat(&self, vector: Vec3<f64>) -> Point2 {
        [vector.dot(self.along), vector.dot(self.up)]
    }
}

/// A fin laid flat, in the unit of the mesh.
#[derive(Clone, Debug)]
pub struct Fin {
    /// Corners, counterclockwise. Sides: the edge of the surface, the end at `ends[0]`, the side
    /// away from the surface, the end at `ends[1]`.
    pub outline: [Point2; 4],
    /// The nodes at sides 1 and 3 of the outline.
    pub ends: [u32; 2],
    /// How far the ends at the first and the second node of the edge are cut back along the edge.
    pub cut_back: [f64; 2],
    /// The angle between the edge and the axis at its first and its second node, on the side of the
    /// fin, in degrees.
    pub end_deg: [f64; 2],
    /// Largest change of a distance between corners when the fin is laid flat.
    pub flattening_error: f64,
    /// The outline with the seats of node discs; that without them, if there are none.
    pub cut: Vec<Point2>,
}

/// The room that the end of a fin leaves at a node, in the unit of the mesh.
#[derive(Clone, Copy, Debug)]
pub struct EndRoom {
    /// Plates of this thickness do not overlap there.
    pub thickness: f64,
    /// The end is further from the axis by this.
    pub play: f64,
}

/// Distance from the axis at which the plate of beam `k` ends so that plates of this thickness do
/// not overlap: half the thickness over the tangent of half the smaller angle to a neighbour.
/// Infinite if a neighbour has the same direction, whatever the thickness.
pub fn cut_back(node: &Node, k: usize, thickness: f64) -> f64 {
    let n = node.spokes.len();
    let smaller = node.gap_deg(k).min(node.gap_deg((k + n - 1) % n));
    if smaller >= 180.0 {
        return 0.0;
    }
    let [cosine, sine] = cosine_and_sine_of_degrees(0.5 * smaller);
    if sine > 0.0 { 0.5 * thickness * cosine / sine } else { f64::INFINITY }
}

/// The fin of an edge between its two nodes; `height` (negative inwards) is in the unit of the mesh.
///
/// # Errors
/// The reason in words if there is no fin.
pub fn fin(
    surface: &PanelSurface,
    axes: &[Vec3<f64>],
    nodes: [&Node; 2],
    edge: u32,
    height: f64,
    room: [EndRoom; 2],
) -> Result<Fin, &'static str> {
    let own = &surface.edges[edge as usize];
    let (plane, length) = (BeamPlane::of(surface, axes, edge), surface.length(own));
    let tilted = own.ends.map(|v| axes[v as usize]);
    if plane.along == Vec3::zero() || plane.up == Vec3::zero() {
        return Err("its edge has no length");
    }
    // Each axis in the plane of the fin.
    let flat = tilted.map(|axis| plane.flat(axis));
    if length + height * (flat[1][0] - flat[0][0]) <= 0.0 {
        return Err("the axes of its nodes cross within its height");
    }
    let mut back = [0.0; 2];
    for k in 0..2 {
        let place = nodes[k].spoke_index(edge).ok_or("its edge has no length")?;
        let [x, y] = flat[k];
        let sine = y / (x * x + y * y).sqrt();
        if sine <= 1e-3 {
            return Err("the axis of a node lies along it");
        }
        back[k] = (cut_back(nodes[k], place, room[k].thickness) + room[k].play) / sine;
    }
    let base = [[back[0], 0.0], [length - back[1], 0.0]];
    let top = [0, 1].map(|k| [base[k][0] + height * flat[k][0], height * flat[k][1]]);
    if base[1][0] <= base[0][0] || top[1][0] <= top[0][0] {
        return Err("it is cut away at its nodes");
    }
    let [i, j] = own.ends;
    let (outline, ends) = match height > 0.0 {
        true => ([base[0], base[1], top[1], top[0]], [j, i]),
        false => ([base[1], base[0], top[0], top[1]], [i, j]),
    };
    if !is_simple(&outline) {
        return Err("laid flat it crosses itself");
    }
    let spatial = [0, 1].map(|k| surface.at(own.ends[k]));
    let corners = [
        (spatial[0], [0.0, 0.0]),
        (spatial[1], [length, 0.0]),
        (spatial[1] + tilted[1] * height, [length + height * flat[1][0], height * flat[1][1]]),
        (spatial[0] + tilted[0] * height, [height * flat[0][0], height * flat[0][1]]),
    ];
    let mut flattening_error: f64 = 0.0;
    for (k, &(p, own)) in corners.iter().enumerate() {
        for &(q, other) in &corners[..k] {
            let change = ((p - q).length() - distance(own, other)).abs();
            flattening_error = flattening_error.max(change);
        }
    }
    let side = height.signum();
    let end_deg = [
        libm::atan2(flat[0][1], side * flat[0][0]).to_degrees(),
        libm::atan2(flat[1][1], -side * flat[1][0]).to_degrees(),
    ];
    Ok(Fin { outline, ends, cut_back: back, end_deg, flattening_error, cut: outline.to_vec() })
}
