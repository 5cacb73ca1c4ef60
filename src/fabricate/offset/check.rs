//! Checks whether an offset can be built: how far beams and panels are from flat, distances from
//! the requested one, axes from the normals, and at which distance an edge flips.

use super::system::across_edge;
use crate::fabricate::panel::plane_distance;
use crate::fabricate::surface::PanelSurface;
use crate::math::Vec3;
use crate::scene::OffsetKind;

/// The numbers of one beam; zero for a bridge or an edge without length, along which there is none.
#[derive(Clone, Copy, Debug, Default)]
pub struct BeamCheck {
    /// Largest distance of its four corners from their least-squares plane.
    pub warp: f64,
    /// The angle between `P_e n_i` and `P_e n_j`.
    pub twist_deg: f64,
    /// The smaller and the larger height of its two ends.
    pub height: [f64; 2],
    /// `k` in the length `l (1 - d k)` of its edge in the offset by `d`.
    pub shrinking: f64,
}

/// The numbers of one node.
#[derive(Clone, Copy, Debug, Default)]
pub struct NodeCheck {
    /// Largest absolute value of its distance errors.
    pub distance_error: f64,
    /// The angle between its axis and `N_i`; zero if its panels have no area.
    pub lean_deg: f64,
    /// Whether its lean is checked. At the rim of a coarse mesh it is large and harmless.
    pub is_inner: bool,
}

/// The numbers of an offset by the distance `d`, lengths in the unit of the mesh.
#[derive(Clone, Debug, Default)]
pub struct OffsetCheck {
    /// Largest beam warp.
    pub warp: f64,
    /// Largest beam twist.
    pub twist_deg: f64,
    /// Largest deviation from the requested distance: `d (|n| - 1)`, `d (n . N_f - 1)` at a corner,
    /// or `d (|P_e n| - 1)`.
    pub distance_error: f64,
    /// Least and largest distance of beams.
    pub edge_distance: [f64; 2],
    /// Largest angle between a node axis and `N_i`.
    pub lean_deg: f64,
    /// As `lean_deg`, over inner vertices, whose lean is checked.
    pub inner_lean_deg: f64,
    /// Largest deviation of a panel of the offset from flat.
    pub offset_flatness: f64,
    /// The distances, inwards and outwards, at which the first edge of the offset flips; none
    /// without limit.
    pub safe_distance: [Option<f64>; 2],
    /// The numbers of every beam, by edge.
    pub beams: Vec<BeamCheck>,
    /// The numbers of every node, by vertex; none at a vertex of no panel.
    pub nodes: Vec<Option<NodeCheck>>,
}

impl OffsetCheck {
    fn add_error(&mut self, v: u32, error: f64) {
        if let Some(node) = &mut self.nodes[v as usize] {
            node.distance_error = node.distance_error.max(error.abs());
        }
    }
}

/// Checks the offset by `distance` with these axes (`#V`).
pub fn check(
    surface: &PanelSurface,
    axes: &[Vec3<f64>],
    kind: OffsetKind,
    distance: f64,
) -> OffsetCheck {
    let empty = [f64::INFINITY, f64::NEG_INFINITY];
    let mut found = OffsetCheck {
        edge_distance: if surface.beams().next().is_some() { empty } else { [0.0; 2] },
        nodes: vec![None; axes.len()],
        ..OffsetCheck::default()
    };
    for &v in surface.faces.indices() {
        found.nodes[v as usize] = Some(NodeCheck { is_inner: true, ..NodeCheck::default() });
    }
    let rim = surface.edges.iter().filter(|edge| edge.is_rim());
    for v in rim.flat_map(|edge| edge.ends) {
        if let Some(node) = &mut found.nodes[v as usize] {
            node.is_inner = false;
        }
    }
    let widen = |range: &mut [f64; 2], value: f64| {
        *range = [range[0].min(value), range[1].max(value)];
    };
    let mut slopes: [f64; 2] = [0.0; 2];
    for edge in &surface.edges {
        let t = surface.direction(edge);
        if t == Vec3::zero() {
            found.beams.push(BeamCheck::default());
            continue;
        }
        let [n, m] = edge.ends.map(|v| axes[v as usize]);
        let (p, q) = (across_edge(n, t), across_edge(m, t));
        let heights = [p.length(), q.length()].map(|height| height * distance.abs());
        for (height, v) in heights.into_iter().zip(edge.ends) {
            widen(&mut found.edge_distance, height);
            if kind == OffsetKind::Edge {
                found.add_error(v, height - distance.abs());
            }
        }
        let twist = libm::atan2(p.cross(q).length(), p.dot(q)).to_degrees();
        found.twist_deg = found.twist_deg.max(twist);
        let k = -t.dot(m - n) / surface.length(edge);
        widen(&mut slopes, k);
        let beam = BeamCheck {
            warp: beam_warp(surface, edge.ends, axes, distance),
            twist_deg: twist,
            height: [heights[0].min(heights[1]), heights[0].max(heights[1])],
            shrinking: k,
        };
        found.warp = found.warp.max(beam.warp);
        found.beams.push(beam);
    }
    for (face, f) in surface.faces.iter().zip(0..) {
        let normal = surface.normal(f);
        for &v in face.iter().filter(|_| normal != Vec3::zero()) {
            if kind == OffsetKind::Face {
                found.add_error(v, distance * normal.dot(axes[v as usize]) - distance);
            }
        }
    }
    for ((axis, normal), v) in axes.iter().zip(&surface.normals).zip(0..) {
        if *normal == Vec3::zero() {
            continue;
        }
        if kind == OffsetKind::Corner {
            found.add_error(v, distance.abs() * axis.length() - distance.abs());
        }
        let angle = lean(*axis, *normal);
        found.lean_deg = found.lean_deg.max(angle);
        if let Some(node) = &mut found.nodes[v as usize] {
            node.lean_deg = angle;
            if node.is_inner {
                found.inner_lean_deg = found.inner_lean_deg.max(angle);
            }
        }
    }
    let errors = found.nodes.iter().flatten().map(|node| node.distance_error);
    found.distance_error = errors.fold(0.0, f64::max);
    // Larger limits are due to rounding in `k`: there is none.
    let far = 1e6 * surface.mean_edge();
    let inverse = |k: f64| (k != 0.0).then(|| 1.0 / k).filter(|limit| limit.abs() < far);
    found.safe_distance = [inverse(slopes[0]), inverse(slopes[1])];
    found.offset_flatness = flatness(surface, axes, distance);
    found
}

/// The test that exact axes do not pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inexact {
    /// Around some vertex, the panels moved by the distance do not meet in one point.
    NoPoint,
    /// The distance error at this vertex is above the tolerance.
    Distance(u32),
    /// The warp of the beam between these vertices is.
    Warp([u32; 2]),
    /// They lean much more than the fit.
    Lean,
}

/// The distance errors, then the beam warps, of these axes (`#V`) above `tolerance`; a vertex can occur once
/// for each of its elements.
pub(super) fn errors(
    surface: &PanelSurface,
    axes: &[Vec3<f64>],
    kind: OffsetKind,
    depth: f64,
    tolerance: f64,
) -> Vec<Inexact> {
    let is_kept = |length: f64| (depth * (length - 1.0)).abs() <= tolerance;
    let axis = |v: u32| axes[v as usize];
    let moved: Vec<u32> = match kind {
        OffsetKind::Corner => (0..axes.len() as u32)
            .filter(|&v| surface.normals[v as usize] != Vec3::zero() && !is_kept(axis(v).length()))
            .collect(),
        OffsetKind::Face => {
            let of_face = |(face, f)| {
                let normal = surface.normal(f);
                let moved = move |v: &u32| normal != Vec3::zero() && !is_kept(normal.dot(axis(*v)));
                <[u32]>::iter(face).copied().filter(moved)
            };
            surface.faces.iter().zip(0..).flat_map(of_face).collect()
        }
        OffsetKind::Edge => {
            let ends = surface.beams().flat_map(|(edge, t)| edge.ends.map(|v| (v, t)));
            ends.filter(|&(v, t)| !is_kept(across_edge(axis(v), t).length()))
                .map(|(v, _)| v)
                .collect()
        }
    };
    let is_flat = |ends: [u32; 2]| beam_warp(surface, ends, axes, depth) <= tolerance;
    let warped = surface.real_edges().map(|edge| edge.ends).filter(|&ends| !is_flat(ends));
    moved.into_iter().map(Inexact::Distance).chain(warped.map(Inexact::Warp)).collect()
}

/// The largest angle between an axis and the surface normal, in degrees.
pub(super) fn most_lean(surface: &PanelSurface, axes: &[Vec3<f64>]) -> f64 {
    let of_panels =
        axes.iter().zip(&surface.normals).filter(|(_, normal)| **normal != Vec3::zero());
    of_panels.map(|(axis, normal)| lean(*axis, *normal)).fold(0.0, f64::max)
}

/// The angle between an axis and the surface normal, in degrees.
fn lean(axis: Vec3<f64>, normal: Vec3<f64>) -> f64 {
    libm::atan2(axis.cross(normal).length(), axis.dot(normal)).to_degrees()
}

/// The largest distance of the corners of a beam from their least-squares plane.
fn beam_warp(surface: &PanelSurface, [i, j]: [u32; 2], axes: &[Vec3<f64>], depth: f64) -> f64 {
    let (v, w) = (surface.at(i), surface.at(j));
    let corners = [v, w, w + axes[j as usize] * depth, v + axes[i as usize] * depth];
    plane_distance(&corners)
}

/// The largest deviation of a panel of the offset from flat.
fn flatness(surface: &PanelSurface, axes: &[Vec3<f64>], distance: f64) -> f64 {
    let corner = |&v: &u32| surface.at(v) + axes[v as usize] * distance;
    let of_panel = |face: &[u32]| plane_distance(&face.iter().map(corner).collect::<Vec<_>>());
    surface.faces.iter().map(of_panel).fold(0.0, f64::max)
}
