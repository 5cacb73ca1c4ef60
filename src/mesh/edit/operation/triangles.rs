//! Triangles from faces, and quads from triangles: neighbours are paired greedily by cost, then by
//! local exchanges.

use super::declaration::{OperationError, Task};
use crate::math::{
    Vec3, angle_between, argsort, ears_in_space, is_seen_from_mean, key_of_number, polygon_corners,
    polygon_sides, twice_vector_area,
};
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;
use std::collections::BTreeSet;

/// Cuts quads along the shorter diagonal that lies inside and is not yet an edge. If there is none, and
/// for faces with more corners, adds a fan around the centre; or, where the centre does not see the
/// whole face, cuts along diagonals, if none of them is an edge.
pub(super) fn from_faces(task: &Task<'_>) -> Result<Edited, OperationError> {
    if task.mesh.faces.iter().all(|face| face.len() == 3) {
        return Err(OperationError::Expected("a face with more than three corners"));
    }
    let at = |v: u32| Vec3::from(task.mesh.positions[v as usize]);
    let mut rebuild = Rebuild::new(task.mesh);
    let mut diagonals = BTreeSet::new();
    for (f, face) in (0..).zip(task.mesh.faces.iter()) {
        let (cuts, centre) = match *face {
            [_, _, _] => {
                rebuild.face(face, &[f]);
                continue;
            }
            [a, b, c, d] => {
                let cuts = [[[a, b, c], [a, c, d]], [[b, c, d], [b, d, a]]];
                let normal = twice_vector_area(face.iter().map(|&v| at(v)));
                let bends = |[first, second]: [[u32; 3]; 2]| {
                    let normals = [first, second].map(|t| twice_vector_area(t.map(at)));
                    normals.iter().any(|n| n.dot(normal) < 0.0)
                };
                let [ac, bd] = [[a, c], [b, d]].map(|[p, q]| (at(q) - at(p)).length());
                match cuts.map(bends) {
                    [true, false] => (vec![cuts[1].to_vec()], vec![b, d]),
                    [false, true] => (vec![cuts[0].to_vec()], vec![a, c]),
                    _ if bd < ac => (vec![cuts[1].to_vec(), cuts[0].to_vec()], face.to_vec()),
                    _ => (cuts.map(Vec::from).to_vec(), face.to_vec()),
                }
            }
            _ => {
                let corners: Vec<Vec3<f64>> = face.iter().map(|&v| at(v)).collect();
                let is_whole = is_seen_from_mean(&corners);
                let ears = || ears_in_space(&corners).into_iter().map(|t| t.map(|k| face[k]));
                (if is_whole { Vec::new() } else { vec![ears().collect()] }, face.to_vec())
            }
        };
        // A second edge between the same vertices would join separate faces.
        let inner = |triangles: &[[u32; 3]]| -> BTreeSet<[u32; 2]> {
            let all = triangles.iter().flat_map(|t| polygon_sides(t)).map(ascending);
            let outer: BTreeSet<[u32; 2]> = polygon_sides(face).map(ascending).collect();
            all.filter(|ends| !outer.contains(ends)).collect()
        };
        let is_free = |[p, q]: &[u32; 2]| {
            task.topology.body_edge(*p, *q).is_none() && !diagonals.contains(&[*p, *q])
        };
        match cuts.into_iter().find(|cut| inner(cut).iter().all(is_free)) {
            Some(triangles) => {
                diagonals.extend(inner(&triangles));
                triangles.iter().for_each(|t| rebuild.face(t, &[f]));
            }
            None => {
                // Without a free diagonal a quad with a notch is seen whole from the middle of the inner one.
                let middle = rebuild.vertex(&centre);
                for side in polygon_sides(face) {
                    rebuild.face(&[side[0], side[1], middle], &[f]);
                }
            }
        }
    }
    Ok(rebuild.finish())
}

fn ascending([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Two triangles that can become one quad.
struct Pair {
    faces: [u32; 2],
    quad: [u32; 4],
    /// Sum of the deviations of the corners from right angles and of the fold angle, in degrees.
    cost: f64,
}

pub(super) fn to_quads(task: &Task<'_>) -> Result<Edited, OperationError> {
    let pairs = pairs(task, task.sizes[0]);
    if pairs.is_empty() {
        return Err(OperationError::Expected("two triangles side by side that make a quad"));
    }
    let chosen = matched(&pairs, task.mesh.faces.len());
    let mut rebuild = Rebuild::new(task.mesh);
    for (f, face) in (0..).zip(task.mesh.faces.iter()) {
        match chosen[f as usize].map(|pair| &pairs[pair as usize]) {
            None => rebuild.face(face, &[f]),
            Some(Pair { faces: [first, second], quad, .. }) if *first == f => {
                rebuild.face(quad, &[*first, *second]);
            }
            Some(_) => {}
        }
    }
    Ok(rebuild.finish())
}

/// Returns all pairs whose quad has no corner of more than `most` degrees.
fn pairs(task: &Task<'_>, most: f64) -> Vec<Pair> {
    let Task { mesh, topology, .. } = task;
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    let mut pairs = Vec::new();
    for (ends, faces) in topology.edges().iter().zip(topology.edge_faces().iter()) {
        let &[f, g] = faces else { continue };
        let [Some((a, b, c)), Some((_, a_too, d))] = [f, g].map(|face| {
            let &[x, y, z] = mesh.faces.row(face as usize) else { return None };
            let turned = [(x, y, z), (y, z, x), (z, x, y)];
            turned.into_iter().find(|(_, _, opposite)| !ends.contains(opposite))
        }) else {
            continue;
        };
        // Skip opposite orientations, and triangles on the same vertices.
        if a_too != a || c == d {
            continue;
        }
        let quad = [a, d, b, c];
        let corners = polygon_corners(&quad).map(|[before, here, after]| {
            let [back, out] = [before, after].map(|v| at(v) - at(here));
            angle_between(back, out).map(f64::to_degrees)
        });
        let corners: Option<Vec<f64>> = corners.collect();
        let normals = [[a, b, c], [b, a, d]].map(|t| twice_vector_area(t.map(at)));
        // A triangle without area, or with a side without length, has no partner.
        let (Some(corners), Some(fold)) = (corners, angle_between(normals[0], normals[1])) else {
            continue;
        };
        // Sum of the angles of both triangles, which exceeds 180 degrees in a non-convex quad.
        let reach = |v: u32| {
            let part = |from: u32, to: u32| {
                let [p, q] = [at(from) - at(v), at(to) - at(v)];
                angle_between(p, q).map_or(0.0, f64::to_degrees)
            };
            part(c, if v == a { b } else { a }) + part(if v == a { b } else { a }, d)
        };
        let widest = [a, b].into_iter().map(reach).fold(0.0, f64::max);
        if corners.iter().all(|corner| *corner <= most) && widest <= most {
            let cost = corners.iter().map(|corner| (corner - 90.0).abs()).sum::<f64>();
            pairs.push(Pair { faces: [f, g], quad, cost: cost + fold.to_degrees() });
        }
    }
    pairs
}

/// Returns the pair of each face. A face left over by the greedy pass takes a neighbour whose
/// partner finds another one (an augmenting path).
fn matched(pairs: &[Pair], faces: usize) -> Vec<Option<u32>> {
    let mut of_face: Vec<Vec<u32>> = vec![Vec::new(); faces];
    let mut chosen: Vec<Option<u32>> = vec![None; faces];
    for p in argsort(pairs.iter().map(|pair| key_of_number(pair.cost))) {
        let pair = &pairs[p as usize];
        pair.faces.iter().for_each(|&face| of_face[face as usize].push(p));
        if pair.faces.iter().all(|&face| chosen[face as usize].is_none()) {
            pair.faces.iter().for_each(|&face| chosen[face as usize] = Some(p));
        }
    }
    let other = |p: u32, face: u32| {
        let [f, g] = pairs[p as usize].faces;
        if f == face { g } else { f }
    };
    let mut again = true;
    while std::mem::take(&mut again) {
        for face in 0..faces as u32 {
            if chosen[face as usize].is_some() {
                continue;
            }
            let ways = of_face[face as usize].iter().find_map(|&p| {
                let taken = other(p, face);
                let Some(old) = chosen[taken as usize] else { return Some((p, None)) };
                let left = other(old, taken);
                let to = of_face[left as usize].iter().find(|&&q| {
                    let end = other(q, left);
                    end != face && chosen[end as usize].is_none()
                });
                to.map(|&q| (p, Some(q)))
            });
            if let Some((p, q)) = ways {
                for pair in q.into_iter().chain([p]) {
                    let faces = pairs[pair as usize].faces;
                    faces.iter().for_each(|&face| chosen[face as usize] = Some(pair));
                }
                again = true;
            }
        }
    }
    chosen
}
