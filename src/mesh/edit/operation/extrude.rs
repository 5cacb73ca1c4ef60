//! A row of quads along a boundary.

use super::declaration::{OperationError, Task};
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;
use std::collections::BTreeMap;

/// A boundary side of a face.
struct Open {
    face: u32,
    /// In the direction of the face.
    ends: [u32; 2],
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
    let sides = open_sides(task);
    if sides.is_empty() {
        return Err(OperationError::Expected("an edge of the boundary, both ends selected"));
    }
    // Where boundaries touch, each fan of faces gets its own vertex; the key is the vertex and the
    // first face of the fan.
    let mut places: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let mut away: Vec<(u32, Vec<Vec3<f64>>)> = Vec::new();
    let mut corners = Vec::with_capacity(sides.len());
    for &Open { face, ends, outward } in &sides {
        corners.push(ends.map(|v| {
            let corner = [v, first_around(task, v, face)];
            let place = *places.entry(corner).or_insert(away.len() as u32) as usize;
            if place == away.len() {
                away.push((v, Vec::new()));
            }
            away[place].1.push(outward);
            place
        }));
    }
    let mut rebuild = Rebuild::new(task.mesh);
    let lift = Vec3::from(task.up) * up;
    let mut outer = Vec::with_capacity(away.len());
    for (v, directions) in &away {
        let position = Vec3::from(task.mesh.positions[*v as usize]) + lift;
        outer.push(rebuild.vertex_at((position + mitre(directions) * outward).into(), *v));
    }
    rebuild.keep(task.all_faces())?;
    for (Open { face, ends: [a, b], .. }, corners) in sides.iter().zip(corners) {
        let [over_a, over_b] = corners.map(|place| outer[place]);
        rebuild.face(&[*b, *a, over_a, over_b], &[*face]);
    }
    Ok(rebuild.finish())
}

/// Returns the first of the faces connected to `face` across edges at `v`.
fn first_around(task: &Task<'_>, v: u32, face: u32) -> u32 {
    let Task { mesh, topology, .. } = task;
    let mut reached = vec![face];
    let mut at = 0;
    while let Some(&face) = reached.get(at) {
        at += 1;
        let sides = crate::math::polygon_sides(mesh.faces.row(face as usize));
        for edge in sides.filter(|side| side.contains(&v)).filter_map(|[a, b]| topology.edge(a, b))
        {
            for &other in topology.edge_faces().row(edge as usize) {
                if !reached.contains(&other) {
                    reached.push(other);
                }
            }
        }
    }
    reached.into_iter().min().unwrap_or(face)
}

/// Returns the displacement to distance 1 from each side at a vertex, of length 2 at most.
fn mitre(directions: &[Vec3<f64>]) -> Vec3<f64> {
    let mut sum = Vec3::zero();
    directions.iter().for_each(|&direction| sum += direction);
    let Some(along) = sum.length_and_direction().1 else { return Vec3::zero() };
    let reach = directions.iter().map(|d| d.dot(along)).fold(1.0, f64::min);
    along * (1.0 / reach.max(0.5))
}

fn open_sides(task: &Task<'_>) -> Vec<Open> {
    let Task { mesh, topology, .. } = task;
    let is_picked = task.picked_vertices();
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    let mut sides = Vec::new();
    for ((&[a, b], faces), e) in topology.edges().iter().zip(topology.edge_faces().iter()).zip(0..)
    {
        let (&[face], true) = (faces, is_picked[a as usize] && is_picked[b as usize]) else {
            continue;
        };
        let corners = mesh.faces.row(face as usize);
        let ends = if topology.edge_ascends(e)[0] { [a, b] } else { [b, a] };
        let normal = twice_vector_area(corners.iter().map(|&v| at(v)));
        let across = (at(ends[1]) - at(ends[0])).cross(normal);
        let outward = across.direction_or_zero();
        sides.push(Open { face, ends, outward });
    }
    sides
}
