//! A row of quads along a boundary.

use super::declaration::{OperationError, Task};
use crate::math::{Vec3, polygon_sides, twice_vector_area};
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;
use crate::mesh::{Topology, components, sides_of_holes};
use std::collections::{BTreeMap, BTreeSet};
use std::slice;

/// A side shorter than this fraction of its face has no direction, a face thinner than it no plane.
const NONE: f64 = 1e-9;

/// A boundary side of a face.
struct Open {
    /// Of all faces, those that are left as they are last.
    face: u32,
    /// In the direction of the face.
    ends: [u32; 2],
    /// The fan of faces at each end. Where boundaries touch, a vertex has several.
    fans: [u32; 2],
    /// Outward direction in the plane of the face, of unit length or zero.
    outward: Vec3<f64>,
}

/// Offsets the boundary outward, in the planes of the adjacent faces, by the first size, and up by
/// the second. Offsets at corners are mitred, so that the new edges have the requested distance.
pub(super) fn apply(task: &Task<'_>) -> Result<Edited, OperationError> {
    let [outward, up] = [task.sizes[0], task.sizes[1]];
    if outward == 0.0 && up == 0.0 {
        return Err(OperationError::Expected("a length that is not zero"));
    }
    let topology = task.whole_topology();
    if topology.boundary_loops().is_empty() {
        return Err(OperationError::NoBoundary);
    }
    let sides = open_sides(task, &topology);
    if sides.is_empty() {
        return Err(OperationError::Expected("an edge of the boundary, both ends selected"));
    }
    let mut away: BTreeMap<u32, Vec<Vec3<f64>>> = BTreeMap::new();
    for Open { fans, outward, .. } in &sides {
        fans.iter().for_each(|&fan| away.entry(fan).or_default().push(*outward));
    }
    let away: BTreeMap<u32, Vec3<f64>> =
        away.into_iter().map(|(fan, directions)| (fan, mitre(&directions) * outward)).collect();
    let mut rebuild = Rebuild::new(task.mesh);
    let lift = Vec3::from(task.up) * up;
    // Each fan at a vertex gets a vertex of its own.
    let mut outer: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    for (v, fan) in sides.iter().flat_map(|side| side.ends.into_iter().zip(side.fans)) {
        let position = Vec3::from(task.mesh.positions[v as usize]) + lift + away[&fan];
        outer.entry([v, fan]).or_insert_with(|| rebuild.vertex_at(position.into(), v));
    }
    rebuild.keep(task.all_faces())?;
    for Open { face, ends: [a, b], fans: [of_a, of_b], .. } in sides {
        let [over_a, over_b] = [[a, of_a], [b, of_b]].map(|corner| outer[&corner]);
        let is_of_mesh = (face as usize) < task.mesh.faces.len();
        rebuild
            .face(&[b, a, over_a, over_b], if is_of_mesh { slice::from_ref(&face) } else { &[] });
    }
    Ok(rebuild.finish())
}

/// Returns the displacement to distance 1 from each side at a vertex, of length 2 at most.
fn mitre(directions: &[Vec3<f64>]) -> Vec3<f64> {
    let mut sum = Vec3::zero();
    directions.iter().for_each(|&direction| sum += direction);
    let Some(along) = sum.length_and_direction().1 else { return Vec3::zero() };
    let known = directions.iter().filter(|direction| **direction != Vec3::zero());
    let reach = known.map(|d| d.dot(along)).fold(1.0, f64::min);
    along * (1.0 / reach.max(0.5))
}

/// Returns the picked sides, without those of windows in a face. Both ends of one without a direction are
/// of one fan, so that they go where its neighbours do.
fn open_sides(task: &Task<'_>, topology: &Topology) -> Vec<Open> {
    let mesh = task.mesh;
    let is_picked = task.picked_vertices();
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    // Corners are numbered one face after another; those of faces that share an edge are joined.
    let mut at_ends: Vec<Option<[u32; 2]>> = vec![None; topology.edges().len()];
    let mut joined: Vec<[u32; 2]> = Vec::new();
    let mut planes = Vec::new();
    let mut first = 0;
    for face in mesh.all_faces() {
        let mut squares = 0.0;
        for (k, [a, b]) in (0..).zip(polygon_sides(face)) {
            squares += (at(b) - at(a)).length_squared();
            let Some(edge) = topology.edge(a, b) else { continue };
            let corners = ordered(a < b, [first + k, first + (k + 1) % face.len() as u32]);
            if let Some(known) = at_ends[edge as usize].replace(corners) {
                joined.extend([0, 1].map(|end| [known[end], corners[end]]));
            }
        }
        let normal = twice_vector_area(face.iter().map(|&v| at(v)));
        let is_plane = normal.length_and_direction().0 > NONE * squares;
        planes.push((if is_plane { normal } else { Vec3::zero() }, squares));
        first += face.len() as u32;
    }
    let windows = mesh.untouched.iter().flat_map(|face| sides_of_holes(face, &mesh.positions));
    let windows: BTreeSet<[u32; 2]> = windows.collect();
    let mut sides = Vec::new();
    for ((&ends, faces), e) in topology.edges().iter().zip(topology.edge_faces().iter()).zip(0..) {
        let (&[face], true) = (faces, ends.iter().all(|&v| is_picked[v as usize])) else {
            continue;
        };
        let (mut normal, squares) = planes[face as usize];
        let is_ahead = topology.edge_ascends(e)[0];
        let corners = at_ends[e as usize].expect("it is a side of that face");
        let [ends, corners] = [ends, corners].map(|both| ordered(is_ahead, both));
        if windows.contains(&ends) {
            continue;
        }
        if normal == Vec3::zero() {
            // It lies in the plane of the faces beside it.
            let beside = ends.iter().flat_map(|&v| topology.vertex_faces().row(v as usize));
            beside.for_each(|&face| normal += planes[face as usize].0);
        }
        let along = at(ends[1]) - at(ends[0]);
        let is_long = along.length_squared() > NONE * NONE * squares;
        let across = if is_long { along.cross(normal) } else { Vec3::zero() };
        let outward = across.direction_or_zero();
        if outward == Vec3::zero() {
            joined.push(corners);
        }
        sides.push(Open { face, ends, fans: corners, outward });
    }
    let fans = components(first as usize, joined.iter().map(|pair| &pair[..]));
    for side in &mut sides {
        side.fans = side.fans.map(|corner| fans[corner as usize]);
    }
    sides
}

/// The two in their order, or turned.
fn ordered(is_ahead: bool, [a, b]: [u32; 2]) -> [u32; 2] {
    if is_ahead { [a, b] } else { [b, a] }
}
